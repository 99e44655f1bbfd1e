// Blockly as the editor of a program. This module is loaded when the blocks are opened: Blockly has over half a megabyte.

import Blockly from "../vendor/blockly/blockly.js";
import english from "../vendor/blockly/en.js";
import chinese from "../vendor/blockly/zh-hans.js";
import german from "../vendor/blockly/de.js";
import { beginBlock, blockOfProgram, kindsOf, nameOf, NAME, offersOf, PROGRAM, programOf, taken, typeIn, VALUE } from "./convert.js";
import { ExactNumber, OfferMenu, OpenDropdown } from "./fields.js";
import { GROUPS, groupOf, wordOf } from "./labels.js";
import { isTable, shapeAt } from "./rows.js";

/** Blockly's own texts; those of a language that is not here are English. @type {Record<string, Record<string, string>>} */
const BLOCKLY_TEXTS = { zh: chinese, de: german };

/** @typedef {import("./shapes.js").Shapes} Shapes */
/** @typedef {import("./shapes.js").Schema} Schema */
/** @typedef {import("./convert.js").Kind} Kind */
/** @typedef {import("./convert.js").Block} State */
/** @typedef {import("./rows.js").Row} Row */
/** @typedef {import("./lines.js").Place} Place */
/** @typedef {import("blockly/core").BlockSvg & { rows: Row[] }} Block */
/** @typedef {import("../i18n/i18n.js").Language} Language */
/** @typedef {import("../i18n/i18n.js").Translate} Translate */

/**
 * @typedef {object} Outside
 * @property {Shapes} shapes
 * @property {Language} language
 * @property {Translate} t
 * @property {(program: Record<string, unknown>) => void} changed The blocks are another program now.
 * @property {(row: number | null) => void} chosen A block of this step of the program was selected.
 * @property {() => Record<string, number> | null} here Where the arm is, as a point.
 */

const COLOURS = { moves: "#0b5cad", grips: "#0a6b3d", repeats: "#8a4b00", asks: "#7a2a86", sets: "#4c5b69", names: "#9c2f4d", more: "#3d4a55" };
const MOST_WIDE = 28;

/** The renderer of Scratch, with its styles where the page's security policy allows them. */
class Renderer extends Blockly.zelos.Renderer {
  makeConstants_() {
    return new Constants();
  }
}
class Constants extends Blockly.zelos.ConstantProvider {
  /** @param {Document | ShadowRoot} root @param {string} selector */
  injectCSS_(root, selector) {
    if (styled.has(selector)) return;
    styled.add(selector);
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(this.getCSS_(selector).join("\n"));
    root.adoptedStyleSheets = [sheet, ...root.adoptedStyleSheets];
  }
}
/** @type {Set<string>} */ const styled = new Set();
Blockly.blockRendering.register("dobot", Renderer);

/**
 * To highlight a connection, Blockly reorders its siblings in the next frame. A block that a key has selected since then may be
 * among them, and loses the focus when it is moved: give it back in the same frame, before the next key.
 */
const { highlight } = Blockly.RenderedConnection.prototype;
Blockly.RenderedConnection.prototype.highlight = function () {
  /** @type {Element | null} */ let focused = null;
  requestAnimationFrame(() => (focused = document.activeElement));
  highlight.call(this);
  requestAnimationFrame(() => focused !== document.activeElement && /** @type {SVGElement | null} */ (focused)?.focus({ preventScroll: true }));
};

/** @param {HTMLElement} host @param {Outside} outside */
export function createWorkspace(host, { shapes, language, t, changed, chosen, here }) {
  const kinds = kindsOf(shapes);
  const word = (/** @type {string} */ key) => wordOf(language, key);
  let loading = false;
  /** The program that the blocks are, as text. */
  let shown = "";
  /** The blocks after the last change that was reported or shown. */
  let known = "";
  /** Marks of the last report, to remove them. @type {string[]} */ let marked = [];
  /** @type {string | null} */ let selectedId = null;

  Blockly.setLocale({ ...english, ...BLOCKLY_TEXTS[language] });
  for (const [type, kind] of kinds) defineBlock(type, kind);
  const workspace = Blockly.inject(host, {
    css: false, sounds: false, renderer: "dobot", comments: false, disable: false, collapse: true, trashcan: false, horizontalLayout: true, toolbox: toolbox(),
    theme: Blockly.Theme.defineTheme("dobot", {
      name: "dobot", base: Blockly.Themes.Zelos,
      blockStyles: Object.fromEntries(Object.entries(COLOURS).map(([group, colourPrimary]) => [group, { colourPrimary, colourSecondary: colourPrimary, colourTertiary: "#15202b" }])),
      categoryStyles: Object.fromEntries(Object.entries(COLOURS).map(([group, colour]) => [group, { colour }])),
      componentStyles: { workspaceBackgroundColour: "var(--paper)", toolboxBackgroundColour: "var(--card)", toolboxForegroundColour: "var(--ink)", flyoutBackgroundColour: "var(--card)", flyoutForegroundColour: "var(--ink)", flyoutOpacity: 0.97, scrollbarColour: "var(--quiet)" },
    }),
    move: { scrollbars: true, drag: true, wheel: true }, zoom: { wheel: true, pinch: true, startScale: 0.7, minScale: 0.3, maxScale: 1.5 },
  });
  // The page undoes changes of the text.
  workspace.MAX_UNDO = 0;
  workspace.addChangeListener(heard);

  // --- Kinds of blocks ----------------------------------------------------------------------------------

  /** @param {string} type @param {Kind} kind */
  function defineBlock(type, kind) {
    Blockly.Blocks[type] = {
      /** @this {Block} */
      init() {
        this.rows = [];
        this.setStyle(kind.is === "program" ? "more" : groupOf(type));
        this.setTooltip(kind.verb ? about([kind.verb.verb], kind) : shapes.definition(kind.schema).description ?? "");
        this.setInputsInline(true);
        const check = kind.is === "step" ? "step " : type;
        if (kind.is !== "program") {
          this.setPreviousStatement(true, check);
          this.setNextStatement(true, check);
        } else this.hat = "cap";
      },
      /** @this {Block} */
      saveExtraState() {
        return { rows: this.rows };
      },
      /** @this {Block} @param {{ rows: Row[] }} state */
      loadExtraState({ rows }) {
        this.rows = rows;
        fill(this, type, kind);
      },
    };
  }

  /** The description of a key in the schema. @param {readonly string[]} path @param {Kind} kind */
  function about(path, kind) {
    const parent = shapeAt(shapes, shapes.of(kind.schema), path.slice(0, -1));
    for (const each of parent.kind === "either" ? parent.of : [parent]) {
      const found = each.kind === "table" ? each.keys.get(path.at(-1) ?? "")?.description : undefined;
      if (found) return found;
    }
    return "";
  }

  /** Builds the rows of a block: a line for each key, and an opening for each list. @param {Block} block @param {string} type @param {Kind} kind */
  function fill(block, type, kind) {
    const schema = kind.is === "entry" ? { type: "object", properties: { [VALUE]: kind.schema } } : kind.schema;
    const shape = shapes.of(schema);
    // The key whose value stands beside the block's name; of an entry it is the whole value.
    const first = kind.verb ? kind.verb.verb : kind.is === "item" ? shapes.table(kind.schema).required[0] : VALUE;
    const rows = [...block.rows.filter(({ path }) => path[0] === first), ...block.rows.filter(({ path }) => path[0] !== first)];
    const head = block.appendDummyInput("head").appendField(word(type.startsWith("step ") ? /** @type {string} */ (kind.verb?.verb) : type));
    if (kind.is === "entry") head.appendField(new Blockly.FieldTextInput(""), NAME);
    let line = head;
    /** @type {string | undefined} */ let root = first;
    for (const { path, form } of rows) {
      const own = kind.is === "entry" ? path.slice(1) : path;
      const [key] = own;
      const isNew = key !== root;
      root = key;
      if (form === "list" || form === "map") {
        const of = shapeAt(shapes, shape, path);
        const lists = of.kind === "either" ? of.of : [of];
        const list = lists.find((each) => each.kind === form);
        const input = block.appendStatementInput(nameOf(path));
        if (list?.kind === "list" || list?.kind === "map") input.setCheck(typeIn(shapes, list));
        if (own.length > 1 || key !== first) input.appendField(wordsOf(own));
        line = input;
        root = undefined;
        continue;
      }
      if (isNew && kind.is !== "entry") line = block.appendEndRowInput(nameOf(path));
      if (own.length > 1 && isNew) line.appendField(word(/** @type {string} */ (key)));
      if (own.length > 1 || (own.length && key !== first)) line.appendField(word(/** @type {string} */ (own.at(-1))));
      line.appendField(field(form, shapeAt(shapes, shape, path), about(path, kind)), nameOf(path));
    }
    if (offersOf(shapes, kind, block.rows).length && !block.isInFlyout) block.getInput("head")?.appendField(new OfferMenu(() => offers(block, kind), (index) => take(block, kind, index), t("blocks.more")));
    // Each input begins a line, also below the first.
    if (block.inputList.length > 1 && block.inputList[1]?.type !== Blockly.inputs.inputTypes.STATEMENT) block.moveInputBefore(block.appendEndRowInput("end").name, block.inputList[1]?.name ?? null);
  }

  /** The words of a path. @param {readonly string[]} path */
  const wordsOf = (path) => path.filter((key) => key !== VALUE).map(word).join(" ");

  /** @param {Row["form"]} form @param {import("./shapes.js").Shape} shape @param {string} tooltip @returns {import("blockly/core").Field} */
  function field(form, shape, tooltip) {
    /** @type {import("blockly/core").Field} */ let made;
    const parts = shape.kind === "either" ? shape.of : [shape];
    const choice = parts.find((each) => each.kind === "choice");
    const text = parts.find((each) => each.kind === "text");
    if (form === "number") made = new ExactNumber(0);
    else if (form === "switch") made = new Blockly.FieldCheckbox(true);
    else if (form === "choice" && choice?.kind === "choice") made = new Blockly.FieldDropdown(choice.values.map((value) => [word(value), value]));
    else if (form === "text" && text?.kind === "text" && text.names.length) made = new OpenDropdown(() => namesOf(text.names));
    else made = new Blockly.FieldTextInput("");
    if (made instanceof Blockly.FieldTextInput) made.setSpellcheck(false);
    made.maxDisplayLength = MOST_WIDE;
    if (tooltip) made.setTooltip(tooltip);
    return made;
  }

  /** The names that the program defines. @param {readonly string[]} maps @returns {[string, string][]} */
  function namesOf(maps) {
    const block = programBlock();
    return maps.flatMap((map) => chain(block?.getInputTargetBlock(nameOf([map])) ?? null).map((entry) => String(entry.getFieldValue(NAME)))).map((name) => [name, name]);
  }

  // --- More and fewer keys --------------------------------------------------------------------------------

  /** @param {Block} block @param {Kind} kind @returns {[string, string][]} */
  const offers = (block, kind) => offersOf(shapes, kind, block.rows).map((offer, index) => {
    const { type, path, value } = offer;
    const words = wordsOf(path);
    const form = isTable(value) ? Object.keys(value).map(word).join(", ") : typeof value === "number" ? t("blocks.number") : value === "" ? t("blocks.name") : Array.isArray(value) ? t("blocks.several") : word(String(value));
    return [type === "add" ? `+ ${words}` : type === "remove" ? `− ${words}` : `${words}${words ? ": " : ""}${form}`, String(index)];
  });

  /** Takes an offer: the block is replaced by the one that has more, or less. @param {Block} block @param {Kind} kind @param {number} index */
  function take(block, kind, index) {
    const offer = offersOf(shapes, kind, block.rows)[index];
    const saved = /** @type {State | null} */ (Blockly.serialization.blocks.save(block, { addCoordinates: true }));
    if (!offer || !saved) return;
    const above = block.previousConnection?.targetConnection ?? null;
    const { x, y } = block.getRelativeToSurfaceXY();
    Blockly.Events.setGroup(true);
    block.dispose(false);
    const made = /** @type {Block} */ (Blockly.serialization.blocks.append(/** @type {any} */ ({ ...taken(shapes, kind, saved, offer), x, y }), workspace, { recordUndo: true }));
    if (above && made.previousConnection) above.connect(made.previousConnection);
    if (kind.is === "program") settle(made);
    Blockly.Events.setGroup(false);
    Blockly.common.setSelected(made);
  }

  // --- The toolbox ----------------------------------------------------------------------------------------

  function toolbox() {
    const types = [...kinds.keys()].filter((type) => type !== PROGRAM);
    const contents = Object.keys(GROUPS).map((group) => ({
      kind: "category", name: t(`blocks.${/** @type {import("./labels.js").Group} */ (group)}`), categorystyle: group,
      contents: [...GROUPS[/** @type {import("./labels.js").Group} */ (group)], ...(group === "more" ? types.filter((type) => groupOf(type) === "more") : [])].map((type) => ({ kind: "block", ...beginBlock(shapes, type, /** @type {Kind} */ (kinds.get(type))) })),
    }));
    return { kind: "categoryToolbox", contents: contents.filter((category) => category.contents.length) };
  }

  // --- Changes ----------------------------------------------------------------------------------------------

  const programBlock = () => /** @type {Block | undefined} */ (workspace.getTopBlocks(false).find((block) => block.type === PROGRAM));

  /** The blocks from one on, downwards. @param {import("blockly/core").Block | null} block */
  function chain(block) {
    /** @type {Block[]} */ const all = [];
    for (let next = block; next; next = next.getNextBlock()) all.push(/** @type {Block} */ (next));
    return all;
  }

  /** @param {import("blockly/core").Events.Abstract} event */
  function heard(event) {
    if (loading) return;
    if (event.type === Blockly.Events.SELECTED) {
      const id = /** @type {string | null} */ (/** @type {any} */ (event).newElementId ?? null);
      if (id !== null || host.contains(document.activeElement)) selectedId = id;
      const block = workspace.getBlockById(id ?? "");
      const place = block ? placeOfBlock(/** @type {Block} */ (block)) : null;
      if (place) chosen(place[0] === "steps" && typeof place[1] === "number" ? place[1] : null);
    }
    if (event.isUiEvent) return;
    if (event.type === Blockly.Events.BLOCK_CREATE) for (const id of /** @type {any} */ (event).ids ?? []) nameNew(/** @type {Block | null} */ (workspace.getBlockById(id)));
    if (event.type === Blockly.Events.BLOCK_CHANGE) renameUses(/** @type {any} */ (event));
    if (!workspace.isDragging()) report();
  }

  /** Gives a new entry a name of its own, and a new point the place where the arm is. @param {Block | null} block */
  function nameNew(block) {
    if (!block || kinds.get(block.type)?.is !== "entry") return;
    const all = workspace.getBlocksByType(block.type).filter((other) => other !== block).map((other) => other.getFieldValue(NAME));
    if (block.getFieldValue(NAME) !== "" && !all.includes(block.getFieldValue(NAME))) return;
    const was = block.getFieldValue(NAME);
    const base = (was || word(block.type)).replace(/ ?\d+$/, "");
    let number = was ? 2 : 1;
    while (all.includes(`${base}${number}`)) number += 1;
    block.setFieldValue(`${base}${number}`, NAME);
    const place = was ? null : here();
    for (const [key, value] of Object.entries(place ?? {})) block.getField(nameOf([VALUE, key]))?.setValue(value);
  }

  /** A name that changes, changes where it is used. @param {{ name?: string, blockId?: string, oldValue?: unknown, newValue?: unknown }} event */
  function renameUses({ name, blockId, oldValue, newValue }) {
    const entry = workspace.getBlockById(blockId ?? "");
    const map = name === NAME && entry ? placeOfBlock(/** @type {Block} */ (entry))?.[0] : null;
    if (typeof map !== "string" || !oldValue || namesOf([map]).some(([known]) => known === oldValue)) return;
    for (const block of workspace.getAllBlocks(false)) {
      const kind = kinds.get(block.type);
      if (!kind) continue;
      const shape = shapes.of(kind.is === "entry" ? { type: "object", properties: { [VALUE]: kind.schema } } : kind.schema);
      for (const { path, form } of /** @type {Block} */ (block).rows) {
        const of = shapeAt(shapes, shape, path);
        const uses = form === "text" && (of.kind === "either" ? of.of : [of]).some((each) => each.kind === "text" && each.names.includes(map));
        if (uses && block.getFieldValue(nameOf(path)) === oldValue) block.setFieldValue(newValue, nameOf(path));
      }
    }
  }

  function read() {
    const block = programBlock();
    const saved = block && /** @type {State | null} */ (Blockly.serialization.blocks.save(block));
    return saved ? programOf(saved) : null;
  }

  function report() {
    const found = read();
    if (!found) return;
    for (const block of workspace.getAllBlocks(false)) /** @type {Block} */ (block).setWarningText(null, "twice");
    for (const { id, name } of found.twice) /** @type {Block | null} */ (workspace.getBlockById(id ?? ""))?.setWarningText(t("blocks.twice", { name }), "twice");
    for (const block of workspace.getTopBlocks(false)) fade(/** @type {Block} */ (block), block.type !== PROGRAM);
    const now = keyOf(found.program);
    known = now;
    if (found.twice.length || now === shown) return;
    shown = now;
    changed(found.program);
  }

  /** Blocks that are not in the program look so. @param {Block} block @param {boolean} isLoose */
  const fade = (block, isLoose) => void block.getSvgRoot().classList.toggle("is-loose", isLoose);

  /** Removes loose blocks that are in the program again, as after an undo. */
  function removeReturned() {
    const contentOf = (/** @type {Block} */ block) => JSON.stringify(Blockly.serialization.blocks.save(block, { addNextBlocks: false })).replace(/"id":"[^"]*"/g, "");
    const inside = new Set(programBlock()?.getDescendants(false).map((block) => contentOf(/** @type {Block} */ (block))));
    for (const block of workspace.getTopBlocks(false).flatMap(chain)) if (block.type !== PROGRAM && inside.has(contentOf(block))) block.dispose(true);
  }

  /** @param {Block} block */
  function settle(block) {
    block.setDeletable(false);
    block.setMovable(false);
  }

  // --- Places of blocks -----------------------------------------------------------------------------------

  /** The place of a block in the program, or null. @param {Block} block @returns {Place | null} */
  function placeOfBlock(block) {
    if (block.type === PROGRAM) return [];
    const parent = /** @type {Block | null} */ (block.getSurroundParent());
    const above = parent && placeOfBlock(parent);
    const input = parent?.inputList.find((it) => it.connection && chain(it.connection.targetBlock()).includes(block));
    if (!parent || !above || !input) return null;
    /** @type {string[]} */ const path = JSON.parse(input.name);
    const last = kinds.get(block.type)?.is === "entry" ? String(block.getFieldValue(NAME)) : chain(input.connection?.targetBlock() ?? null).indexOf(block);
    return [...above, ...path, last];
  }

  /** The innermost block at a place. @param {Place} place */
  function blockAt(place) {
    let found = /** @type {Block | undefined} */ (programBlock()), rest = place;
    while (found) {
      /** @type {{ block: Block, left: Place } | null} */ let inner = null;
      for (const input of found.inputList) {
        if (!input.connection) continue;
        const path = JSON.parse(input.name);
        if (!path.every((/** @type {string} */ key, /** @type {number} */ n) => rest[n] === key)) continue;
        const at = rest[path.length];
        const block = chain(input.connection.targetBlock()).find((it, n) => (typeof at === "number" ? n === at : it.getFieldValue(NAME) === at));
        if (block) inner = { block, left: rest.slice(path.length + 1) };
      }
      if (!inner) return found;
      ({ block: found, left: rest } = inner);
    }
    return null;
  }

  return {
    /** The program that the blocks are. */
    program: () => read()?.program ?? null,

    /** Shows a program, unless the blocks are it already, or have a change that is not reported yet and comes back with the text. Loose blocks stay. @param {Record<string, unknown>} program */
    show(program) {
      const key = keyOf(program);
      const old = programBlock();
      if (old && (key === shown || keyOf(read()?.program) !== known)) return;
      loading = true;
      Blockly.Events.disable();
      try {
        if (old && typeof program.title === "string" && keyOf({ ...read()?.program, title: program.title }) === key) {
          // The first change gives the program a title, while its field is still open.
          old.setFieldValue(program.title, nameOf(["title"]));
          shown = key;
          return;
        }
        const { x, y } = old?.getRelativeToSurfaceXY() ?? { x: 20, y: 20 };
        old?.dispose(false);
        settle(/** @type {Block} */ (Blockly.serialization.blocks.append(/** @type {any} */ ({ ...blockOfProgram(shapes, program), x, y }), workspace)));
        removeReturned();
        shown = key;
        if (!old) workspace.scroll(0, 0);
      } finally {
        known = keyOf(read()?.program);
        Blockly.Events.enable();
        loading = false;
      }
      marked = [];
    },

    /** Marks the blocks with problems. @param {readonly { place: Place, message: string }[]} problems */
    mark(problems) {
      for (const id of marked) {
        const block = /** @type {Block | null} */ (workspace.getBlockById(id));
        block?.setWarningText(null, "problem");
        block?.getSvgRoot().classList.remove("is-bad");
      }
      /** @type {Map<Block, string[]>} */ const found = new Map();
      for (const { place, message } of problems) {
        const block = blockAt(place);
        if (block) found.set(block, [...found.get(block) ?? [], message]);
      }
      for (const [block, messages] of found) {
        block.setWarningText(messages.join("\n"), "problem");
        block.getSvgRoot().classList.add("is-bad");
      }
      marked = [...found.keys()].map(({ id }) => id);
    },

    /** Highlights the step that runs. @param {Place | null} place */
    run: (place) => workspace.highlightBlock(place ? blockAt(place)?.id ?? null : null),

    /** Whether a place can be put into the selected block. */
    takesPlace: () => positionRows().length === 3,
    /** Puts a place into the selected block. @param {Record<string, number>} place */
    retake(place) {
      for (const { path } of positionRows()) selected()?.setFieldValue(place[/** @type {string} */ (path.at(-1))], nameOf(path));
    },
    remove() {
      const block = selected();
      if (block?.isDeletable()) block.checkAndDelete();
    },
    /** @param {1 | -1} way */
    zoom: (way) => workspace.zoomCenter(way),
    resize: () => Blockly.svgResize(workspace),
    dispose: () => workspace.dispose(),
  };

  /** The selected block; the buttons of the page take the focus, and with it Blockly's own selection. */
  function selected() {
    return /** @type {Block | null} */ (workspace.getBlockById(selectedId ?? ""));
  }

  /** The rows x, y and z of the first position in the selected block. */
  function positionRows() {
    const rows = selected()?.rows ?? [];
    const x = rows.find(({ path }) => path.at(-1) === "x" && ["go", "pick", "place", VALUE, "at"].includes(path.at(-2) ?? ""));
    const parent = x && nameOf(x.path.slice(0, -1));
    return rows.filter(({ path, form }) => form === "number" && nameOf(path.slice(0, -1)) === parent && ["x", "y", "z"].includes(path.at(-1) ?? ""));
  }
}

/** A program as a text that does not depend on the order of keys. @param {unknown} value @returns {string} */
export function keyOf(value) {
  if (Array.isArray(value)) return `[${value.map(keyOf).join()}]`;
  if (isTable(value)) return `{${Object.keys(value).sort().map((key) => `${JSON.stringify(key)}:${keyOf(value[key])}`).join()}}`;
  return typeof value === "bigint" ? `${value}` : JSON.stringify(value);
}
