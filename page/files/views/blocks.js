// The program as blocks, for people who do not type. The editor is loaded when the view opens, and kept until the language changes.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { ref } from "../vendor/lit-html/directives/ref.js";
import { parse } from "../vendor/smol-toml/index.js";
import { placesOf } from "../blocks/lines.js";
import { memoize } from "../state/selectors.js";
import { currentLine } from "../state/teach.js";
import { sentence } from "../i18n/problem_text.js";

/** @typedef {import("./context.js").Context} Context */
/** @typedef {ReturnType<typeof import("../blocks/workspace.js").createWorkspace>} Workspace */
/** @typedef {{ host: HTMLElement, language: string, workspace: Workspace | null, failed: boolean, context: Context }} Editor */

/** @type {Editor | null} */ let editor = null;

/** The program of a text, or the reason why it is none. */
const programIn = memoize((/** @type {string} */ text) => {
  try {
    return { program: parse(text, { integersAsBigInt: "asNeeded" }), reason: "" };
  } catch (error) {
    return { program: null, reason: error instanceof Error ? error.message.split("\n")[0] ?? "" : String(error) };
  }
});
const placesIn = memoize(placesOf);

/** @param {Context} context */
export function blocks(context) {
  const { page, t, act } = context;
  const { reason, program } = programIn(page.teach.text);
  const attach = (/** @type {Element | undefined} */ element) => element && open(/** @type {HTMLElement} */ (element), context);
  const asked = (/** @type {(workspace: Workspace) => void} */ action) => editor?.workspace && action(editor.workspace);
  const keys = (/** @type {KeyboardEvent} */ event) => {
    const way = undoKey(event);
    if (!way) return;
    event.preventDefault();
    event.stopPropagation();
    act.send({ type: way });
  };
  return html`
    <div id="blocks" class="blocks">
      ${program ? nothing : html`<p class="status" data-tone="bad">${t("blocks.no_toml", { reason })}</p>`}
      <div class="blocks-host" ?inert=${!program} ${ref(attach)} @keydown=${{ handleEvent: keys, capture: true }}></div>
      ${editor?.failed ? html`<p class="status" data-tone="bad">${t("blocks.failed")}</p>` : nothing}
      <div class="row">
        <button id="blocks-here" type="button" class="small" @click=${() => asked((it) => retake(it, context))}>${t("blocks.here")}</button>
        <button id="blocks-remove" type="button" class="small" @click=${() => asked((it) => it.remove())}>${t("teach.remove")}</button>
        <button id="blocks-out" type="button" class="small" aria-label=${t("blocks.out")} @click=${() => asked((it) => it.zoom(-1))}>−</button>
        <button id="blocks-in" type="button" class="small" aria-label=${t("blocks.in")} @click=${() => asked((it) => it.zoom(1))}>+</button>
      </div>
      <p class="quiet">${t("blocks.hint")}</p>
    </div>`;
}

/** @param {KeyboardEvent} event */
function undoKey({ key, ctrlKey, metaKey, shiftKey, target }) {
  if (!(ctrlKey || metaKey) || /** @type {Element | null} */ (target)?.matches("input, textarea")) return null;
  if (key.toLowerCase() === "z") return shiftKey ? "teach_redo" : "teach_undo";
  return key.toLowerCase() === "y" ? "teach_redo" : null;
}

/** @param {Workspace} workspace @param {Context} context */
function retake(workspace, { act }) {
  const place = act.teach.here();
  if (place) workspace.retake(place);
}

/** Puts the editor where the view has its place, and shows it the program. @param {HTMLElement} element @param {Context} context */
function open(element, context) {
  const { language } = context.page;
  if (editor && editor.language !== language) {
    editor.workspace?.dispose();
    editor.host.remove();
    editor = null;
  }
  if (!editor) {
    editor = { host: document.createElement("div"), language, workspace: null, failed: false, context };
    void load(editor);
  }
  editor.context = context;
  if (editor.host.parentElement !== element) {
    element.append(editor.host);
    editor.workspace?.resize();
  }
  show(editor);
}

/** @param {Editor} opened */
async function load(opened) {
  try {
    styles();
    const [{ createWorkspace }, { Shapes }, schema] = await Promise.all([import("../blocks/workspace.js"), import("../blocks/shapes.js"), opened.context.act.teach.schema()]);
    if (opened !== editor) return;
    const { t, act } = opened.context;
    opened.workspace = createWorkspace(opened.host, {
      shapes: new Shapes(schema), language: opened.context.page.language, t,
      changed: (program) => void act.teach.merge(program),
      chosen: (row) => act.send({ type: "teach_chosen", row }),
      here: () => act.teach.here(),
    });
    new ResizeObserver(() => opened.workspace?.resize()).observe(opened.host);
    show(opened);
  } catch (error) {
    opened.failed = true;
    console.error(error);
  }
  opened.context.act.send({ type: "teach_mode", mode: "blocks" });
}

/** The style sheets of the editor: links, as the page's security policy asks for. */
function styles() {
  for (const path of ["../vendor/blockly/blockly.css", "../blocks/blocks.css"]) {
    const href = new URL(path, import.meta.url).href;
    if (document.querySelector(`link[href="${href}"]`)) continue;
    const link = document.createElement("link");
    link.rel = "stylesheet";
    link.href = href;
    document.head.append(link);
  }
}

/** What the editor was shown last. @type {{ text: string, report: unknown, line: number | null, workspace: Workspace } | null} */
let last = null;

/** @param {Editor} opened */
function show({ workspace, context }) {
  if (!workspace) return;
  const { teach, station } = context.page;
  const line = currentLine(teach, station?.job);
  // Edits that are on their way to the text come back with it.
  const isLate = context.act.teach.isMerging();
  if (last?.workspace === workspace && last.text === teach.text && last.report === teach.report && last.line === line && !isLate) return;
  const { program } = programIn(teach.text);
  if (!program || isLate) return;
  last = { text: teach.text, report: teach.report, line, workspace };
  workspace.show(program);
  const places = placesIn(teach.text);
  workspace.mark((teach.report?.problems ?? []).filter(({ file, line: at }) => file == null && at != null).map(({ line: at, message }) => ({ place: places[/** @type {number} */ (at) - 1] ?? [], message: sentence(message) })));
  workspace.run(line === null ? null : places[line - 1] ?? null);
}
