// The program, taught point by point, as a table, a text and a timeline.

import { html, nothing, svg } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";
import { ref } from "../vendor/lit-html/directives/ref.js";
import { blockedReason, memoize, rowsIn } from "../state/selectors.js";
import { PROGRAM_ENDINGS, currentLine, rowAt, stepsIn } from "../state/teach.js";
import { ROW_PX, startRowDrag } from "../input/row_drag.js";
import { files as storedFiles } from "./files.js";
import { saveAs } from "../parts/download.js";
import { sentence } from "../i18n/problem_text.js";
import { blocks } from "../views/blocks.js";
import { wizard } from "../views/wizard.js";
import { blockedLine, problemLine } from "../views/problem.js";
import { formatDuration } from "../i18n/i18n.js";

/** @typedef {import("../views/context.js").Context} Context */
/** @typedef {import("../state/teach.js").Row} Row */

/** @type {readonly import("../state/teach.js").Mode[]} */
const MODES = ["table", "blocks", "text", "time"];
/** @type {readonly import("../state/types.js").Schemas["MovingMode"][]} */
const PATHS = ["movj", "movl", "jump"];
/** The most rows rendered of a long program. */
const SEEN = 40;

const timed = memoize(stepsIn);
const badIn = memoize((/** @type {readonly Row[]} */ rows, /** @type {Context["page"]["teach"]["report"]} */ report) => new Set(report?.problems.map(({ line }) => rowAt(rows, line))));

/** @param {Context} context */
export function teach(context) {
  const { page, t, act } = context;
  const { text, mode, report, path } = page.teach;
  const why = blockedReason(page);
  const rows = rowsIn(text);
  const modeChoice = html`
    <fieldset class="segments">
      <legend class="unseen">${t("teach.view")}</legend>
      ${MODES.map((choice) => html`<label><input type="radio" name="teach-mode" value=${choice} .checked=${live(choice === mode)} @change=${() => act.send({ type: "teach_mode", mode: choice })}><span>${t(`teach.${choice}`)}</span></label>`)}
    </fieldset>`;
  const views = { blocks: () => blocks(context), table: () => table(context, rows), text: () => area(context), time: () => timeline(context) };
  return html`
    <section class="card" aria-labelledby="teach-title">
      <h2 id="teach-title">${t("teach")} <small>${page.teach.name}${report?.once_s ? ` · ${formatDuration(t, report.once_s)}` : ""}</small></h2>
      <div class="row">
        <button id="capture" type="button" class="strong" ?disabled=${why === "no_connection" || why === "no_arm"} @click=${() => act.teach.capture()}>${t("teach.capture")}</button>
        <fieldset class="segments">
          <legend class="unseen">${t("target.path")}</legend>
          ${PATHS.map((choice) => html`<label><input type="radio" name="teach-path" value=${choice} .checked=${live(choice === path)} @change=${() => act.send({ type: "teach_path", path: choice })}><span>${choice.toUpperCase()}</span></label>`)}
        </fieldset>
      </div>
      <div class="row" ?hidden=${mode === "blocks"}>
        <button id="teach-record" type="button" class="small" aria-pressed=${page.teach.recorded === null ? "false" : "true"} ?disabled=${!page.station?.arm} @click=${() => void act.teach.recorder.toggle()}>${page.teach.recorded === null ? t("teach.record") : t("teach.record.end", { count: page.teach.recorded })}</button>
        <button id="teach-suction-on" type="button" class="small" @click=${() => act.teach.insert({ suction: true, pause: 0.3 })}>${t("teach.suction_on")}</button>
        <button id="teach-suction-off" type="button" class="small" @click=${() => act.teach.insert({ suction: false, pause: 0.3 })}>${t("teach.suction_off")}</button>
        <button id="teach-pause" type="button" class="small" @click=${() => act.teach.insert({ pause: 1 })}>${t("teach.pause")}</button>
      </div>
      ${page.teach.recorded === null ? nothing : html`<p id="teach-recording" class="status" data-tone="warn" role="status">${t("teach.record.hint")}</p>`}
      ${wizard(context)}
      ${modeChoice}
      ${views[mode]()}
      ${edits(context, rows)}
      ${problems(context, rows)}
    </section>
    ${runs(context, rows)}
    ${files(context)}${storedFiles(context, true)}`;
}

/** @param {Context} context @param {readonly Row[]} rows */
function table({ page, t, act }, rows) {
  const { chosen, first, report, carried } = page.teach;
  if (!rows.length) return html`<p class="drop quiet">${t("teach.empty")}</p>`;
  const steps = timed(rows, report);
  const runs = rowAt(rows, currentLine(page.teach, page.station?.job));
  const bad = badIn(rows, report);
  const from = Math.max(0, Math.min(first - 5, rows.length - SEEN));
  const scroll = (/** @type {Event} */ event) => act.send({ type: "teach_scrolled", first: Math.floor(/** @type {Element} */ (event.target).scrollTop / ROW_PX) });
  const key = (/** @type {KeyboardEvent} */ event) => {
    const way = /** @type {Record<string, number>} */ ({ ArrowUp: -1, ArrowDown: 1 })[event.key];
    if (event.key === "Delete") act.teach.remove();
    // The focused row: the frame may be older than the key.
    const row = /** @type {HTMLElement | null} */ (/** @type {Element} */ (event.target).closest("[data-row]"))?.dataset.row ?? chosen;
    if (!way || row === null) return;
    event.preventDefault();
    const next = Math.max(0, Math.min(rows.length - 1, Number(row) + way));
    // When the row is there, it has the focus.
    const focus = () => requestAnimationFrame(() => requestAnimationFrame(() => document.getElementById(`step-${next}`)?.focus()));
    if (event.altKey) return void act.teach.move(Number(row), next).then(focus);
    act.send({ type: "teach_chosen", row: next });
    focus();
  };
  /** Class of a row under the dragged one. @param {number} row */
  const under = (row) => (carried?.from === row ? "is-carried" : carried?.to !== row ? "" : carried.from < row ? "takes-below" : "takes-above");
  const sized = (/** @type {Element | undefined} */ list) => list && /** @type {HTMLElement} */ (list).style.setProperty("height", `${rows.length * ROW_PX}px`);
  const placed = (/** @type {Element | undefined} */ list) => list && /** @type {HTMLElement} */ (list).style.setProperty("transform", `translateY(${from * ROW_PX}px)`);
  return html`
    <div id="steps" class="steps-seen" @scroll=${scroll} @keydown=${key} @pointerdown=${(/** @type {PointerEvent} */ event) => startRowDrag(event, rows.length, rowDrag(act))} role="listbox" aria-label=${t("teach.table")} tabindex="-1">
      <div ${ref(sized)}><div ${ref(placed)}>
        ${rows.slice(from, from + SEEN).map(({ says }, n) => {
          const row = from + n;
          return html`<button type="button" role="option" id="step-${row}" class="step ${bad.has(row) ? "is-bad" : ""} ${runs === row ? "is-running" : ""} ${under(row)}" data-row=${row} aria-selected=${row === chosen ? "true" : "false"}
            @click=${() => act.send({ type: "teach_chosen", row })}><span class="number">${row + 1}</span><span class="says" title=${says}>${steps[row]?.label}</span><span class="time">${steps[row]?.takes_s ? `${steps[row].takes_s.toFixed(1)} s` : ""}</span><span class="grip" title=${t("teach.drag")} aria-hidden="true"></span></button>`;
        })}
      </div></div>
    </div>
    <p class="unseen" id="teach-moved" role="status">${page.teach.moved ? t("teach.moved", { step: page.teach.moved.to + 1, steps: page.teach.moved.of }) : ""}</p>`;
}

/** Callbacks of a row drag. @param {Context["act"]} act @returns {import("../input/row_drag.js").RowDrag} */
const rowDrag = (act) => ({
  over: (from, to) => act.send({ type: "teach_carried", carried: { from, to } }),
  drop(from, to) {
    act.send({ type: "teach_carried", carried: null });
    void act.teach.move(from, to);
  },
  cancel: () => act.send({ type: "teach_carried", carried: null }),
});

/** @param {Context} context */
const area = ({ page, t, act }) => html`
  <textarea id="teach-text" rows="16" spellcheck="false" aria-label=${t("teach.text")} .value=${live(page.teach.text)} @input=${(/** @type {Event} */ event) => act.send({ type: "teach_text", text: /** @type {HTMLTextAreaElement} */ (event.target).value })}></textarea>`;

/** @param {Context} context */
function timeline({ page, t, act }) {
  const steps = timed(rowsIn(page.teach.text), page.teach.report);
  const whole_s = steps.reduce((sum, { takes_s }) => sum + takes_s, 0);
  if (!whole_s) return html`<p class="drop quiet">${t("teach.untimed")}</p>`;
  let at_s = 0;
  const bars = steps.map(({ takes_s, label }, row) => {
    const from = (1000 * at_s) / whole_s;
    at_s += takes_s;
    const width = (1000 * takes_s) / whole_s;
    // Hairline bars are not visible.
    if (width < 0.4) return nothing;
    return svg`<rect class=${row === page.teach.chosen ? "bar is-chosen" : "bar"} x=${from} y="4" width=${Math.max(0.3, width - 0.8)} height="44" @click=${() => act.send({ type: "teach_chosen", row })}><title>${row + 1}: ${label} (${takes_s.toFixed(1)} s)</title></rect>`;
  });
  return html`
    <svg id="teach-time" class="times" viewBox="0 0 1000 52" preserveAspectRatio="none" role="img" aria-label=${t("teach.time")}>${bars}</svg>
    <p class="quiet ends"><span>0 s</span><span>${formatDuration(t, whole_s)}</span></p>`;
}

/** @param {Context} context @param {readonly Row[]} rows */
function edits({ page, t, act }, rows) {
  const { chosen, past, future } = page.teach;
  const none = chosen === null || chosen >= rows.length;
  return html`
    <div class="row">
      <button id="teach-undo" type="button" class="small" ?disabled=${!past.length} @click=${() => act.send({ type: "teach_undo" })}>${t("teach.undo")}</button>
      <button id="teach-redo" type="button" class="small" ?disabled=${!future.length} @click=${() => act.send({ type: "teach_redo" })}>${t("teach.redo")}</button>
      <button id="teach-up" type="button" class="small" ?disabled=${none || chosen === 0} aria-label=${t("teach.up")} @click=${() => chosen !== null && void act.teach.move(chosen, chosen - 1)}>↑</button>
      <button id="teach-down" type="button" class="small" ?disabled=${none || chosen === rows.length - 1} aria-label=${t("teach.down")} @click=${() => chosen !== null && void act.teach.move(chosen, chosen + 1)}>↓</button>
      <button id="teach-retake" type="button" class="small" ?disabled=${none} @click=${() => act.teach.retake()}>${t("teach.retake")}</button>
      <button id="teach-remove" type="button" class="small" ?disabled=${none} @click=${() => act.teach.remove()}>${t("teach.remove")}</button>
    </div>`;
}

/** The problems of the program, each with a button that selects its step. @param {Context} context @param {readonly Row[]} rows */
function problems(context, rows) {
  const { page, t, act } = context;
  const { report, refused, text } = page.teach;
  const found = text.trim() ? report?.problems ?? [] : [];
  return html`
    <div id="teach-problems" role="status">
      ${refused ? html`<p class="status" data-tone="bad">${problemLine(context, refused)}</p>` : nothing}
      ${found.slice(0, 20).map(({ line, message, remedy }) => {
        const row = rowAt(rows, line);
        return html`<p class="status" data-tone="bad">${row === null ? (line ? t("teach.line", { line }) : "") : html`<button type="button" class="small problem" @click=${() => act.send({ type: "teach_chosen", row })}>${t("teach.step", { step: row + 1 })}</button>`} ${sentence(message)}. ${remedy ? `${sentence(remedy)}.` : ""}</p>`;
      })}
      ${found.length > 20 ? html`<p class="quiet">${t("teach.more", { count: found.length - 20 })}</p>` : nothing}
    </div>`;
}

/** @param {Context} context @param {readonly Row[]} rows */
function runs(context, rows) {
  const { page, t, act } = context;
  const why = blockedReason(page);
  const own = page.teach.ran !== null && page.station?.job?.job === page.teach.ran.job;
  const busy = page.station?.job?.phase === "running";
  const off = !rows.length || (why !== null && !(own && why === "job_runs")) || (page.teach.report?.problems.length ?? 1) > 0;
  return html`
    <section class="card" aria-labelledby="teach-run-title">
      <h2 id="teach-run-title">${t("teach.run")}</h2>
      <div class="row">
        <button id="teach-once" type="button" class="strong" ?disabled=${off || busy} @click=${() => act.teach.run(false, null)}>${t("teach.once")}</button>
        <button id="teach-loop" type="button" ?disabled=${off || busy} @click=${() => act.teach.run(false, "forever")}>${t("teach.loop")}</button>
        <button id="teach-step" type="button" class="small" ?disabled=${off || busy} @click=${() => act.teach.step()}>${t("teach.one_step")}</button>
        <button id="teach-from" type="button" class="small" ?disabled=${off || busy || page.teach.chosen === null} @click=${() => act.teach.run(true, null)}>${t("teach.from")}</button>
        ${own && page.station?.job && page.station.job.phase !== "done" ? html`<button id="teach-end" type="button" class="small" @click=${() => act.jobs.end(page.station?.job?.job ?? 0)}>${t("teach.end")}</button>` : nothing}
      </div>
      ${own && page.station?.job?.program ? html`<p class="quiet" id="teach-cycle">${t("teach.cycles", { cycles: page.station.job.program.cycles_done, step: Math.min(page.station.job.program.step + 1, page.station.job.program.steps), steps: page.station.job.program.steps })}</p>` : nothing}
      ${why && !(own && why === "job_runs") ? html`<p class="quiet">${blockedLine(context)}</p>` : nothing}
    </section>`;
}

/** @param {Context} context */
function files({ page, t, act }) {
  const choose = (/** @type {Event} */ event) => {
    const field = /** @type {HTMLInputElement} */ (event.target);
    const file = field.files?.[0];
    if (file) void act.teach.open(file);
    field.value = "";
  };
  const save = () => saveAs(new Blob([page.teach.text], { type: "text/plain" }), page.teach.name);
  const exportAs = async (/** @type {"xml" | "play"} */ to) => {
    const text = await act.teach.exported(to);
    if (text !== null) saveAs(new Blob([text], { type: "text/plain" }), to === "xml" ? "PlayBackPoints.xml" : page.teach.name.replace(/\.[^.]*$/, ".play"));
  };
  return html`
    <section class="card" aria-labelledby="teach-files-title">
      <h2 id="teach-files-title">${t("teach.files")}</h2>
      <div class="row">
        <button id="teach-save" type="button" class="small" ?disabled=${!page.teach.text} @click=${save}>${t("teach.save")}</button>
        <input id="teach-file" type="file" accept=${[...PROGRAM_ENDINGS, "text/plain"].join(",")} hidden aria-label=${t("teach.open")} @change=${choose}>
        <button id="teach-open" type="button" class="small" @click=${() => document.getElementById("teach-file")?.click()}>${t("teach.open")}</button>
        <button id="teach-keep" type="button" class="small" ?disabled=${!page.teach.text} @click=${() => act.files.keepProgram(page.teach.text, page.teach.name)}>${t("files.keep")}</button>
        <button id="teach-xml" type="button" class="small" ?disabled=${!page.teach.text} @click=${() => void exportAs("xml")}>.xml</button>
        <button id="teach-play" type="button" class="small" ?disabled=${!page.teach.text} @click=${() => void exportAs("play")}>.play</button>
        <button id="teach-new" type="button" class="small" ?disabled=${!page.teach.text} @click=${() => act.send({ type: "teach_text", text: "", name: "program.toml", chosen: null })}>${t("teach.new")}</button>
      </div>
      <p class="quiet">${t("teach.files.hint")}</p>
    </section>`;
}
