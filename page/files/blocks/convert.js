// A program as blocks, and back. Blocks are plain data here: the JSON that Blockly loads and saves.

import { fromRaw, isTable, listOf, put, rowsOf, shapeAt } from "./rows.js";
import { HERE } from "./shapes.js";

/** @typedef {import("./shapes.js").Shapes} Shapes */
/** @typedef {import("./shapes.js").Shape} Shape */
/** @typedef {import("./shapes.js").Schema} Schema */
/** @typedef {import("./rows.js").Row} Row */
/** @typedef {import("./rows.js").Path} Path */
/** @typedef {{ type: string, id?: string, extraState?: { rows: Row[] }, fields?: Record<string, unknown>, inputs?: Record<string, { block?: Block }>, next?: { block?: Block } }} Block */
/** What a block is for: the program, a step, a table in a list, or a named entry. @typedef {{ is: "program" | "step" | "item" | "entry", schema: Schema, verb?: import("./shapes.js").Verb }} Kind */
/** A program cannot hold two values of one name. @typedef {{ id: string | undefined, name: string }} Twice */

export const PROGRAM = "program";
const STEP = "step ";
const ITEM = "item ";
const ENTRY = "entry ";
/** The field with the name of an entry. */
export const NAME = "name";
/** The key of an entry's value in its rows. */
export const VALUE = "value";

/** The name of a field or an input. @param {Path} path */
export const nameOf = (path) => JSON.stringify(path);

/** All kinds of blocks, by type, for a program of this schema. @param {Shapes} shapes @returns {Map<string, Kind>} */
export function kindsOf(shapes) {
  /** @type {Map<string, Kind>} */ const kinds = new Map([[PROGRAM, { is: "program", schema: shapes.program }]]);
  for (const verb of shapes.verbs) kinds.set(STEP + verb.verb, { is: "step", schema: shapes.step, verb });
  const visit = (/** @type {Schema} */ schema) => {
    const shape = shapes.of(schema);
    if (shape.kind === "either") for (const each of shapes.definition(schema).anyOf) visit(each);
    if (shape.kind === "table") for (const each of shape.keys.values()) inner(each);
    if (shape.kind === "list" || shape.kind === "map") inner(schema);
  };
  const inner = (/** @type {Schema} */ schema) => {
    const shape = shapes.of(schema);
    if (shape.kind !== "list" && shape.kind !== "map") return visit(schema);
    const type = typeIn(shapes, shape);
    if (type !== STEP && !kinds.has(type)) {
      kinds.set(type, { is: shape.kind === "map" ? "entry" : "item", schema: shape.of });
      visit(shape.of);
    }
  };
  visit(shapes.program);
  visit(shapes.step);
  return kinds;
}

/** The type of the blocks in a list or map; of steps its beginning. @param {Shapes} shapes @param {{ kind: "list" | "map", of: Schema }} shape */
export function typeIn(shapes, { kind, of }) {
  const name = shapes.nameOf(of);
  if (kind === "map") return ENTRY + name;
  return shapes.definition(of) === shapes.definition(shapes.step) ? STEP : ITEM + name;
}

/** The rows that every program has, also without a value. */
const ALWAYS = ["title", "points", "steps"];

/** A program as one block. @param {Shapes} shapes @param {Record<string, unknown>} program @returns {Block} */
export function blockOfProgram(shapes, program) {
  const shape = shapes.table(shapes.program);
  const always = Object.fromEntries(ALWAYS.filter((key) => shape.keys.has(key)).map((key) => [key, shapes.begin(shapes.of(/** @type {Schema} */ (shape.keys.get(key))))]));
  const rows = rowsOf(shapes, shape, { ...always, ...program }, []);
  return blockOf(shapes, PROGRAM, rows.map((row) => (Object.hasOwn(program, row.path[0] ?? "") ? row : { ...row, optional: true })));
}

/** A table of a list as a block. @param {Shapes} shapes @param {{ kind: "list" | "map", of: Schema }} shape @param {Record<string, unknown>} table @returns {Block} */
function blockOfItem(shapes, shape, table) {
  const type = typeIn(shapes, shape);
  return blockOf(shapes, type === STEP ? STEP + shapes.verbOf(table).verb : type, Object.keys(table).length ? rowsOf(shapes, shapes.of(shape.of), table, []) : []);
}

/** A step as a block. @param {Shapes} shapes @param {Record<string, unknown>} step */
export const blockOfStep = (shapes, step) => blockOfItem(shapes, { kind: "list", of: shapes.step }, step);

/** A named value as a block. @param {Shapes} shapes @param {Schema} schema @param {string} name @param {unknown} value @returns {Block} */
export function blockOfEntry(shapes, schema, name, value) {
  const block = blockOf(shapes, typeIn(shapes, { kind: "map", of: schema }), rowsOf(shapes, shapes.of(schema), value, [VALUE]));
  return { ...block, fields: { ...block.fields, [NAME]: name } };
}

/** A new block of a type, as it comes from the toolbox. @param {Shapes} shapes @param {string} type @param {Kind} kind @returns {Block} */
export function beginBlock(shapes, type, { is, schema, verb }) {
  if (is === "program") return blockOfProgram(shapes, {});
  if (verb) return blockOfStep(shapes, shapes.beginStep(verb));
  if (is === "entry") return blockOfEntry(shapes, schema, "", shapes.begin(shapes.of(schema)));
  const shape = shapes.table(schema);
  const lists = [...shape.keys].filter(([, of]) => shapes.of(of).kind === "list").map(([key]) => [key, []]);
  return blockOf(shapes, type, rowsOf(shapes, shape, { .../** @type {object} */ (shapes.begin(shape)), ...Object.fromEntries(lists) }, []));
}

/** @param {Shapes} shapes @param {string} type @param {ReturnType<typeof rowsOf>} rows @returns {Block} */
function blockOf(shapes, type, rows) {
  /** @type {NonNullable<Block["fields"]>} */ const fields = {};
  /** @type {NonNullable<Block["inputs"]>} */ const inputs = {};
  for (const { path, value, shape } of rows) {
    if (shape.kind === "map") inputs[nameOf(path)] = stacked(Object.entries(/** @type {object} */ (value)).map(([name, inner]) => blockOfEntry(shapes, shape.of, name, inner)));
    else if (shape.kind === "list") inputs[nameOf(path)] = stacked(/** @type {Record<string, unknown>[]} */ (value).map((inner) => blockOfItem(shapes, shape, inner)));
    else fields[nameOf(path)] = value;
  }
  return { type, extraState: { rows: rows.map(({ path, form, optional }) => ({ path, form, ...(optional && { optional }) })) }, fields, inputs };
}

/** Blocks below each other. @param {Block[]} blocks @returns {{ block?: Block }} */
function stacked(blocks) {
  const below = blocks.reduceRight((/** @type {Block | undefined} */ next, block) => (next ? { ...block, next: { block: next } } : block), undefined);
  return below ? { block: below } : {};
}

/** @param {{ block?: Block } | undefined} input @returns {Block[]} */
export function blocksIn(input) {
  /** @type {Block[]} */ const blocks = [];
  for (let block = input?.block; block; block = block.next?.block) blocks.push(block);
  return blocks;
}

/** The program of a block, and the names that it has twice. @param {Block} block @returns {{ program: Record<string, unknown>, twice: Twice[] }} */
export function programOf(block) {
  /** @type {Twice[]} */ const twice = [];
  return { program: tableOf(block, twice), twice };
}

/** @param {Block} block @param {Twice[]} twice @returns {Record<string, any>} */
function tableOf({ extraState, fields = {}, inputs = {} }, twice) {
  /** @type {Record<string, any>} */ const table = {};
  for (const { path, form, optional } of extraState?.rows ?? []) {
    const name = nameOf(path);
    const value = form === "map" ? entriesOf(inputs[name], twice) : form === "list" ? blocksIn(inputs[name]).map((inner) => tableOf(inner, twice)) : valueOf(form, fields[name]);
    const isEmpty = value === "" || (typeof value === "object" && value !== null && Object.keys(value).length === 0);
    if (!optional || !isEmpty) put(table, path, value);
  }
  return table;
}

/** @param {{ block?: Block } | undefined} input @param {Twice[]} twice */
function entriesOf(input, twice) {
  /** @type {Record<string, unknown>} */ const entries = {};
  for (const block of blocksIn(input)) {
    const name = String(block.fields?.[NAME] ?? "");
    if (Object.hasOwn(entries, name)) twice.push({ id: block.id, name });
    put(entries, [name], tableOf(block, twice)[VALUE]);
  }
  return entries;
}

/** @param {Row["form"]} form @param {unknown} field */
function valueOf(form, field) {
  switch (form) {
    case "raw":
      return fromRaw(String(field));
    case "texts":
      return listOf(String(field));
    case "switch":
      return field === true || field === "TRUE";
    case "number":
      return Number(field);
    default:
      return field;
  }
}

/** A change of which rows a block has: a key more or less, or another form of its value. @typedef {{ type: "add" | "remove" | "form", path: Path, value?: unknown }} Offer */

/** What may be added to a block, removed from it or changed in it. @param {Shapes} shapes @param {Kind} kind @param {readonly Row[]} rows @returns {Offer[]} */
export function offersOf(shapes, { is, schema, verb }, rows) {
  if (is === "entry") return offersAt(shapes, schema, [VALUE], rows);
  const { keys } = shapes.table(schema);
  const fixed = verb && verb.verb !== HERE ? [verb.verb] : [];
  const allowed = verb ? [...fixed, ...verb.beside] : [...keys.keys()];
  return allowed.flatMap((key) => offersOfKey(shapes, /** @type {Schema} */ (keys.get(key)), [key], rows, !fixed.includes(key) && (is !== "program" || !ALWAYS.includes(key))));
}

/** @param {readonly Row[]} rows @param {Path} path */
const under = (rows, path) => rows.filter((row) => path.every((key, n) => row.path[n] === key));

/** @param {Shapes} shapes @param {Schema} schema @param {Path} path @param {readonly Row[]} rows @param {boolean} isFree whether it may be removed @returns {Offer[]} */
function offersOfKey(shapes, schema, path, rows, isFree) {
  if (!under(rows, path).length) return [{ type: "add", path, value: shapes.begin(shapes.of(schema)) }];
  return [...offersAt(shapes, schema, path, rows), ...(isFree ? [{ type: /** @type {const} */ ("remove"), path }] : [])];
}

/** What a value that is there may become, and what may stand in it. @param {Shapes} shapes @param {Schema} schema @param {Path} path @param {readonly Row[]} rows @returns {Offer[]} */
function offersAt(shapes, schema, path, rows) {
  const shape = shapes.of(schema);
  const all = shape.kind === "either" ? shape.of : [shape];
  const there = under(rows, path);
  const inner = there.filter((row) => row.path.length > path.length).map((row) => /** @type {string} */ (row.path[path.length]));
  const own = there.find((row) => row.path.length === path.length)?.form;
  /** @type {Offer[]} */ const forms = [], keys = [];
  for (const each of all) {
    if (each.kind !== "table") {
      if (all.length > 1 && each.kind !== own) forms.push({ type: "form", path, value: shapes.begin(each) });
      continue;
    }
    const examples = each.examples.filter((example) => !Object.keys(example).some((key) => inner.includes(key)));
    // A definition with `x-forms` has all examples of the others, too.
    if (all.length > 1 || each.forms.length) forms.push(...examples.filter((example) => !forms.some(({ value }) => sameKeys(value, example))).map((value) => ({ type: /** @type {const} */ ("form"), path, value })));
    if (!inner.length) continue;
    const form = each.forms.find((it) => it.some((key) => inner.includes(key))) ?? (each.forms.length ? [] : [...each.keys.keys()]);
    if (!inner.some((key) => each.keys.has(key))) continue;
    for (const key of form) keys.push(...offersOfKey(shapes, /** @type {Schema} */ (each.keys.get(key)), [...path, key], rows, !each.required.includes(key) && new Set(inner).size > 1));
    break;
  }
  return [...forms, ...keys];
}

/** @param {unknown} a @param {unknown} b */
const sameKeys = (a, b) => isTable(a) && isTable(b) && Object.keys(a).join() === Object.keys(b).join();

/** The block after an offer was taken: its rows follow from its changed value. @param {Shapes} shapes @param {Kind} kind @param {Block} block @param {Offer} offer @returns {Block} */
export function taken(shapes, kind, block, { type, path, value }) {
  const { type: was, id, next } = block;
  const rows = (block.extraState?.rows ?? []).filter((row) => !path.every((key, n) => row.path[n] === key));
  const at = (block.extraState?.rows ?? []).findIndex((row) => path.every((key, n) => row.path[n] === key));
  const schema = kind.is === "entry" ? { type: "object", properties: { [VALUE]: kind.schema } } : kind.schema;
  const made = type === "remove" ? [] : rowsOf(shapes, shapeAt(shapes, shapes.of(schema), path), value, path);
  const added = blockOf(shapes, was, made);
  const all = [...rows];
  all.splice(at < 0 ? placeOf(shapes, schema, rows, path) : at, 0, ...(added.extraState?.rows ?? []));
  return { type: was, ...(id && { id }), extraState: { rows: all }, fields: { ...kept(block.fields, path), ...added.fields }, inputs: { ...kept(block.inputs, path), ...added.inputs }, ...(next && { next }) };
}

/** Fields or inputs without those under a path. @template T @param {Record<string, T> | undefined} named @param {Path} path @returns {Record<string, T>} */
function kept(named = {}, path) {
  const isUnder = (/** @type {string} */ name) => name !== NAME && path.every((key, n) => JSON.parse(name)[n] === key);
  return Object.fromEntries(Object.entries(named).filter(([name]) => !isUnder(name)));
}

/** Where a new row goes: behind the keys before it in the schema. @param {Shapes} shapes @param {Schema} schema @param {readonly Row[]} rows @param {Path} path */
function placeOf(shapes, schema, rows, path) {
  const order = (/** @type {Path} */ of) => of.map((key, n) => {
    const shape = shapeAt(shapes, shapes.of(schema), of.slice(0, n));
    const table = shape.kind === "either" ? shape.of.find((each) => each.kind === "table" && each.keys.has(key)) : shape;
    return table?.kind === "table" ? [...table.keys.keys()].indexOf(key) : -1;
  });
  const own = order(path);
  const isBefore = (/** @type {Path} */ other) => {
    const theirs = order(other);
    const n = own.findIndex((place, at) => place !== theirs[at]);
    return n < 0 || (theirs[n] ?? -1) < /** @type {number} */ (own[n]);
  };
  return rows.filter((row) => isBefore(row.path)).length;
}
