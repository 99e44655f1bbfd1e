// What a program may consist of, read from its JSON schema: the kinds of blocks are made from it.

/** @typedef {Record<string, any>} Schema */
/** A table with its keys, in the order of the schema. @typedef {{ kind: "table", name: string, keys: ReadonlyMap<string, Schema>, required: readonly string[], examples: readonly any[], forms: readonly (readonly string[])[] }} Table */
/** @typedef {{ kind: "number", whole: boolean, begin: number } | { kind: "switch" } | { kind: "text", names: readonly string[] } | { kind: "choice", values: readonly string[] } | { kind: "texts" } | Table
 * | { kind: "map", of: Schema } | { kind: "list", of: Schema } | { kind: "either", of: readonly Shape[] } | { kind: "free" }} Shape */
/** A step key that selects the action, and the keys beside it. @typedef {{ verb: string, beside: readonly string[] }} Verb */

/** The action of a step that has no verb. */
export const HERE = "here";

/** Reads the parts of a program's schema. */
export class Shapes {
  #root;
  /** @type {Map<Schema, Shape>} */ #known = new Map();

  /** @param {Schema} schema */
  constructor(schema) {
    this.#root = schema;
    /** @type {Schema} */ this.program = schema;
    /** @type {Schema} */ this.step = { $ref: "#/$defs/Step" };
    /** @type {readonly Verb[]} */ this.verbs = schema.$defs.Step["x-verbs"];
  }

  /** The definition that a schema refers to, without `null`: a key that is null is a key that is not there. @param {Schema} schema @returns {Schema} */
  definition(schema) {
    if (schema.$ref) return this.definition(this.#root.$defs[schema.$ref.split("/").at(-1)]);
    const some = (schema.anyOf ?? []).filter((/** @type {Schema} */ it) => it.type !== "null");
    return some.length === 1 ? this.definition(some[0]) : schema;
  }

  /** The name under which a schema is defined, or its type. @param {Schema} schema @returns {string} */
  nameOf(schema) {
    if (schema.$ref) return schema.$ref.split("/").at(-1);
    const some = (schema.anyOf ?? []).filter((/** @type {Schema} */ it) => it.type !== "null");
    return some.length === 1 ? this.nameOf(some[0]) : [schema.type].flat().filter((it) => it !== "null").join("_");
  }

  /** @param {Schema} schema @returns {Shape} */
  of(schema) {
    const known = this.#known.get(schema);
    if (known) return known;
    const shape = this.#read(schema);
    this.#known.set(schema, shape);
    return shape;
  }

  /** A definition as a table. @param {Schema} schema @returns {Table} */
  table(schema) {
    const shape = this.of(schema);
    if (shape.kind !== "table") throw new Error(`${this.nameOf(schema)} is not a table in the schema`);
    return shape;
  }

  /** @param {Schema} schema @returns {Shape} */
  #read(schema) {
    const found = this.definition(schema);
    const types = [found.type].flat().filter((it) => it !== "null");
    const choices = found.oneOf ?? (found.const === undefined ? null : [found]);
    if (choices?.every((/** @type {Schema} */ it) => typeof it.const === "string")) return { kind: "choice", values: choices.map((/** @type {Schema} */ it) => it.const) };
    if (found.anyOf) return { kind: "either", of: found.anyOf.map((/** @type {Schema} */ it) => this.of(it)) };
    switch (types[0]) {
      case "number":
      case "integer":
        return { kind: "number", whole: types[0] === "integer", begin: schema.default ?? found.default ?? found.minimum ?? 0 };
      case "boolean":
        return { kind: "switch" };
      case "string":
        return { kind: "text", names: schema["x-names"] ?? found["x-names"] ?? [] };
      case "array":
        return this.of(found.items).kind === "table" ? { kind: "list", of: found.items } : { kind: "texts" };
      case "object":
        if (found.properties) return { kind: "table", name: this.nameOf(schema), keys: new Map(Object.entries(found.properties)), required: found.required ?? [], examples: found.examples ?? [], forms: found["x-forms"] ?? [] };
        return typeof found.additionalProperties === "object" ? { kind: "map", of: found.additionalProperties } : { kind: "free" };
      default:
        return { kind: "free" };
    }
  }

  /** What a value of this shape begins with, before a person changes it. @param {Shape} shape @returns {any} */
  begin(shape) {
    switch (shape.kind) {
      case "number":
        return shape.begin;
      case "switch":
        return true;
      case "text":
        return "";
      case "choice":
        return shape.values[0];
      case "texts":
      case "list":
        return [];
      case "either":
        return this.begin(/** @type {Shape} */ (shape.of[0]));
      case "table": {
        if (shape.examples.length) return structuredClone(shape.examples[0]);
        const keys = shape.required.length ? shape.required : [...shape.keys.keys()].slice(0, 1);
        return Object.fromEntries(keys.map((key) => [key, this.begin(this.of(/** @type {Schema} */ (shape.keys.get(key))))]));
      }
      default:
        return {};
    }
  }

  /** A new step with this verb; its lists of steps are there, empty. @param {Verb} verb */
  beginStep({ verb, beside }) {
    const { keys } = this.table(this.step);
    const keyed = (/** @type {string} */ key) => this.of(/** @type {Schema} */ (keys.get(key)));
    const lists = beside.filter((key) => keyed(key).kind === "list");
    const first = verb === HERE ? beside.slice(0, 1) : [verb];
    return Object.fromEntries([...first, ...lists].map((key) => [key, this.begin(keyed(key))]));
  }

  /** The verb of a step: the first key that is one. @param {Record<string, unknown>} step @returns {Verb} */
  verbOf(step) {
    return /** @type {Verb} */ (this.verbs.find(({ verb }) => verb in step) ?? this.verbs.find(({ verb }) => verb === HERE));
  }
}
