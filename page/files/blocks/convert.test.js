// Each program is the same as blocks: nothing that a text may hold is lost, and every key of the schema has its place.
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { test } from "node:test";

import { parse, stringify } from "../vendor/smol-toml/index.js";
import { beginBlock, blockOfProgram, blockOfStep, blocksIn, kindsOf, nameOf, offersOf, programOf, taken } from "./convert.js";
import { BLOCK_WORDS, LANGUAGES, loadLanguage } from "../i18n/i18n.js";
import { GROUPS } from "./labels.js";
import { fromRaw, rawOf } from "./rows.js";
import { Shapes } from "./shapes.js";

const schema = JSON.parse(await readFile(new URL("../program.schema.json", import.meta.url), "utf8"));
const shapes = new Shapes(schema);
const kinds = kindsOf(shapes);
const EXAMPLES = new URL("../../../examples/programs/", import.meta.url);

/** Without the prototypes of the parser. */
const plain = (value) => (Array.isArray(value) ? value.map(plain) : value && typeof value === "object" && !(value instanceof Date) ? Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, plain(inner)])) : value);
const read = (text) => plain(parse(text, { integersAsBigInt: "asNeeded" }));
/** As Blockly saves and loads it. */
const kept = (block) => JSON.parse(JSON.stringify(block));
const throughBlocks = (program) => {
  const { program: made, twice } = programOf(kept(blockOfProgram(shapes, program)));
  assert.deepEqual(twice, []);
  return plain(made);
};

/** Numbers of a seed (mulberry32): a failure comes again. */
function randomOf(seed) {
  const next = () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
  return { below: (n) => Math.floor(next() * n), chance: (p) => next() < p, pick: (list) => list[Math.floor(next() * list.length)] };
}

const TEXTS = ["", "aside", "a, b", " x ", "left tray", "红", "two\nlines", '"quoted"', "50", "true", "__proto__", "a = 1", "#no comment", "😀"];
const ODD = [0, 7, -2.5, 1e21, Infinity, 9007199254740993n, true, "text", "", "two\nlines", [], [1, "x", { a: 1 }], [[]], [{}], {}, { a: { b: [] } }, new Date("2020-05-27T07:32:00Z")];

/** A value that the schema allows. */
function valueOf(random, shape, depth) {
  switch (shape.kind) {
    case "number":
      return shape.whole ? random.below(2000) - 1000 : random.pick([random.below(600) - 300, (random.below(60000) - 30000) / 100]);
    case "switch":
      return random.chance(0.5);
    case "text":
      return random.pick(TEXTS);
    case "choice":
      return random.pick(shape.values);
    case "texts":
      return Array.from({ length: 1 + random.below(3) }, () => random.pick(TEXTS));
    case "either":
      return valueOf(random, random.pick(shape.of), depth);
    case "map":
      return Object.fromEntries(Array.from({ length: random.below(3) }, () => [random.pick(TEXTS), valueOf(random, shapes.of(shape.of), depth)]));
    case "list":
      return depth > 3 ? [] : Array.from({ length: random.below(4) }, () => (shapes.nameOf(shape.of) === "Step" ? stepOf(random, depth + 1) : valueOf(random, shapes.of(shape.of), depth + 1)));
    case "table":
      return Object.fromEntries([...shape.keys].filter(([key]) => shape.required.includes(key) || random.chance(0.4)).map(([key, of]) => [key, random.chance(0.03) ? random.pick(ODD) : valueOf(random, shapes.of(of), depth)]));
    default:
      return random.pick(ODD);
  }
}

function stepOf(random, depth) {
  const { keys } = shapes.table(shapes.step);
  const { verb, beside } = random.pick(shapes.verbs);
  const chosen = [...(keys.has(verb) ? [verb] : []), ...beside.filter(() => random.chance(0.4))];
  const step = Object.fromEntries(chosen.map((key) => [key, valueOf(random, shapes.of(keys.get(key)), depth)]));
  // What no program may have: a key that is unknown, one of another action, a value of another form.
  if (random.chance(0.1)) step[random.pick(["colour", "steps.steps", "", "__proto__x", ...keys.keys()])] = random.pick(ODD);
  return step;
}

test("every example program is the same after it was blocks", async () => {
  const names = (await readdir(EXAMPLES)).filter((name) => name.endsWith(".toml"));
  assert.ok(names.length > 5);
  for (const name of names) {
    const program = read(await readFile(new URL(name, EXAMPLES), "utf8"));
    assert.deepEqual(throughBlocks(program), program, name);
    assert.ok(!JSON.stringify(blockOfProgram(shapes, program)).includes('"raw"') || name === "drawing.toml", `${name} has a part that is shown as text only`);
  }
});

test("any program is the same after it was blocks, also one with mistakes", () => {
  for (let seed = 1; seed <= 1000; seed += 1) {
    const random = randomOf(seed);
    const program = valueOf(random, shapes.table(shapes.program), 0);
    if (random.chance(0.2)) program[random.pick(["author", "points", "steps", "title"])] = random.pick(ODD);
    const made = throughBlocks(program);
    // The text of a program does not say in which order its keys are, nor whether 1 is 1.0.
    assert.deepEqual(read(stringify(made)), read(stringify(program)), `seed ${seed}`);
  }
});

test("every key of every step has a place in its block, and is offered there", () => {
  const { keys } = shapes.table(shapes.step);
  const seen = new Set();
  for (const verb of shapes.verbs) {
    const kind = kinds.get(`step ${verb.verb}`);
    const block = blockOfStep(shapes, shapes.beginStep(verb));
    assert.equal(block.type, `step ${verb.verb}`);
    for (const key of [verb.verb, ...verb.beside].filter((it) => keys.has(it))) {
      seen.add(key);
      const { rows } = block.extraState;
      const offer = offersOf(shapes, kind, rows).find(({ type, path }) => type === "add" && path.length === 1 && path[0] === key);
      const wide = offer ? taken(shapes, kind, block, offer) : block;
      const own = wide.extraState.rows.filter(({ path }) => path[0] === key);
      assert.ok(own.length && own.every(({ form }) => form !== "raw"), `${verb.verb}: ${key}`);
    }
  }
  assert.deepEqual([...keys.keys()].filter((key) => !seen.has(key)), []);
});

test("a key that is offered is added in its place and can be removed again", () => {
  for (const [type, kind] of kinds) {
    const begun = beginBlock(shapes, type, kind);
    for (const offer of offersOf(shapes, kind, begun.extraState.rows).filter((it) => it.type === "add")) {
      const wide = taken(shapes, kind, begun, offer);
      const at = nameOf(offer.path);
      assert.ok(offersOf(shapes, kind, wide.extraState.rows).some((it) => it.type === "remove" && nameOf(it.path) === at), `${type} ${at}`);
      assert.deepEqual(taken(shapes, kind, wide, { type: "remove", path: offer.path }), begun, `${type} ${at}`);
    }
  }
});

test("a place can be a name, coordinates, angles, or given later", () => {
  const kind = kinds.get("step go");
  let block = blockOfStep(shapes, { go: "aside", pause: 1 });
  for (const keys of [["x", "y", "z"], ["base", "rear", "fore"], ["from"], []]) {
    const offer = offersOf(shapes, kind, block.extraState.rows).find((it) => it.type === "form" && (keys.length ? Object.keys(it.value).join() === keys.join() : it.value === ""));
    block = taken(shapes, kind, block, offer);
    assert.deepEqual(block.extraState.rows.map(({ path }) => path.join(".")), [...(keys.length ? keys.map((key) => `go.${key}`) : ["go"]), "pause"]);
  }
});

test("two points of one name are reported, and blocks without the program do not count", () => {
  const block = blockOfProgram(shapes, { points: { a: { x: 1, y: 2, z: 3 }, b: { x: 1, y: 2, z: 3 } }, steps: [{ go: "a" }] });
  const [, b] = blocksIn(block.inputs[nameOf(["points"])]);
  b.fields.name = "a";
  assert.deepEqual(programOf(block).twice.map(({ name }) => name), ["a"]);
});

test("a value without a place is a line of TOML that can be edited", () => {
  for (const value of ODD) assert.deepEqual(plain(fromRaw(rawOf(value))), value instanceof Date ? fromRaw(rawOf(value)) : value, String(value));
  assert.equal(fromRaw("no TOML"), "no TOML");
});

test("the words on the blocks are those of keys and values that exist, and each type is in one group", async () => {
  await Promise.all(Object.keys(LANGUAGES).map(loadLanguage));
  const known = new Set([...kinds.keys(), "true", "false", "forever", "here"]);
  const visit = (node) => {
    if (!node || typeof node !== "object") return;
    if (node.properties) for (const key of Object.keys(node.properties)) known.add(key);
    if (typeof node.const === "string") known.add(node.const);
    for (const inner of Object.values(node)) visit(inner);
  };
  visit(schema);
  for (const [language, all] of Object.entries(BLOCK_WORDS)) assert.deepEqual(Object.keys(all).filter((key) => !known.has(key)), [], language);
  assert.deepEqual(Object.values(GROUPS).flat().filter((type) => !kinds.has(type)), []);
});
