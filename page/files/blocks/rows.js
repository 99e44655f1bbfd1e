// A table of a program as the rows of a block, and back. A value that does not have the form that the schema allows, or has no
// place in it, is a row with its text: nothing is dropped.

import { parse, stringify } from "../vendor/smol-toml/index.js";

/** @typedef {import("./shapes.js").Shape} Shape */
/** @typedef {import("./shapes.js").Shapes} Shapes */
/** @typedef {import("./shapes.js").Table} Table */
/** @typedef {readonly string[]} Path */
/** The form in which a value is shown: in a field, as blocks, or as text. @typedef {"number" | "switch" | "text" | "choice" | "texts" | "map" | "list" | "raw"} Form */
/** A row of a block: where its value is, and its form. An `optional` row without blocks stands for nothing. @typedef {{ path: Path, form: Form, optional?: boolean }} Row */

/** @param {unknown} value @returns {value is Record<string, unknown>} */
export const isTable = (value) => typeof value === "object" && value !== null && !Array.isArray(value) && !(value instanceof Date);

/** A text that a field of one line shows as it is. @param {unknown} value */
// eslint-disable-next-line no-control-regex
const isLine = (value) => typeof value === "string" && !/[\u0000-\u001f\u007f\u2028\u2029]/.test(value);
/** @param {unknown} value */
const isNumber = (value) => typeof value === "number" && Number.isFinite(value);
const SEPARATOR = ", ";
/** @param {string} text */
export const listOf = (text) => text.split(",").map((it) => it.trim()).filter((it) => it !== "");

/** A value as TOML on one line. @param {unknown} value */
export const rawOf = (value) => stringify({ value: [[value]] }).trim().replace(/^value = \[ \[ /, "").replace(/ \] \]$/, "");

/** A value from its TOML; a text that is none is itself the value. @param {string} text @returns {unknown} */
export function fromRaw(text) {
  try {
    const { value, ...more } = parse(`value = ${text}`, { integersAsBigInt: "asNeeded" });
    return Object.keys(more).length ? text : value;
  } catch {
    return text;
  }
}

/** The part of a shape that a value has the form of, or null. @param {Shape} shape @param {unknown} value @returns {Exclude<Shape, { kind: "either" }> | null} */
function formOf(shape, value) {
  switch (shape.kind) {
    case "number":
      return isNumber(value) && (!shape.whole || Number.isInteger(value)) ? shape : null;
    case "switch":
      return typeof value === "boolean" ? shape : null;
    case "text":
      return isLine(value) ? shape : null;
    case "choice":
      return shape.values.includes(/** @type {string} */ (value)) ? shape : null;
    case "texts": {
      const same = Array.isArray(value) && value.every(isLine) && listOf(value.join(SEPARATOR));
      return same && value.length === same.length && same.every((it, n) => it === value[n]) ? shape : null;
    }
    case "table":
      return isTable(value) && Object.keys(value).length ? shape : null;
    case "map":
      return isTable(value) ? shape : null;
    case "list":
      return Array.isArray(value) && value.every(isTable) ? shape : null;
    case "either":
      for (const each of shape.of) {
        const found = formOf(each, value);
        if (found) return found;
      }
      return null;
    default:
      return null;
  }
}

/** The rows of a value, with the value of each. @param {Shapes} shapes @param {Shape} shape @param {unknown} value @param {Path} path @returns {(Row & { value: unknown, shape: Shape })[]} */
export function rowsOf(shapes, shape, value, path) {
  const found = formOf(shape, value);
  if (!found || found.kind === "free") return [{ path, form: "raw", value: rawOf(value), shape: { kind: "free" } }];
  if (found.kind !== "table") return [{ path, form: found.kind, value: found.kind === "texts" ? /** @type {string[]} */ (value).join(SEPARATOR) : value, shape: found }];
  const table = /** @type {Record<string, unknown>} */ (value);
  return keysIn(found, table).flatMap((key) => {
    const schema = found.keys.get(key);
    return rowsOf(shapes, schema ? shapes.of(schema) : { kind: "free" }, table[key], [...path, key]);
  });
}

/** The keys of a table: those of the schema in its order, then the others. @param {Table} shape @param {Record<string, unknown>} table */
function keysIn({ keys }, table) {
  return [...[...keys.keys()].filter((key) => Object.hasOwn(table, key)), ...Object.keys(table).filter((key) => !keys.has(key))];
}

/** The schema at a path within a shape, if it has one. @param {Shapes} shapes @param {Shape} shape @param {Path} path @returns {Shape} */
export function shapeAt(shapes, shape, path) {
  const [key, ...rest] = path;
  if (key === undefined) return shape;
  for (const each of shape.kind === "either" ? shape.of : [shape]) {
    const schema = each.kind === "table" ? each.keys.get(key) : undefined;
    if (schema) return shapeAt(shapes, shapes.of(schema), rest);
  }
  return { kind: "free" };
}

/** Puts a value at a path of a table. @param {Record<string, any>} table @param {Path} path @param {unknown} value */
export function put(table, path, value) {
  let inner = table;
  path.forEach((key, n) => {
    const next = n === path.length - 1 ? value : Object.hasOwn(inner, key) ? inner[key] : {};
    // A key of this name is a key like any other.
    Object.defineProperty(inner, key, { value: next, enumerable: true, writable: true, configurable: true });
    inner = inner[key];
  });
}
