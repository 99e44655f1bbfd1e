// The sketch draws on canvases; here they only write down what they are told.
import assert from "node:assert/strict";
import { before, test } from "node:test";
import { boundsOf, lookOfPasses, viewOf } from "./appearance.js";
import { sample } from "./sample.test.js";
import { Sketch } from "./sketch.js";
import { readTimeline } from "./timeline.js";

const THEME = { sheet: "white", travel: "gray", tool: "black", words: "gray" };
const FRAME = { width: 400, height: 300, ratio: 2 };

/** A canvas whose context keeps its calls, as in `["lineTo", x, y]`. */
function canvas() {
  const calls = [];
  const context = new Proxy({ calls }, {
    get: (fields, name) => fields[name] ?? ((...values) => calls.push([name, ...values])),
  });
  return { width: 0, height: 0, calls, getContext: () => context };
}

before(() => {
  globalThis.document = { createElement: canvas };
});

function sketchOf(timeline) {
  return new Sketch(timeline, lookOfPasses(timeline), viewOf(boundsOf(timeline), FRAME), THEME);
}

const read = (file) => readTimeline(JSON.stringify(file));
const named = (calls, name) => calls.filter(([it]) => it === name).map(([, ...values]) => values);

/** A drawing of so many lines, up and down. */
function long(lines) {
  const file = sample();
  const rows = Array.from({ length: lines + 1 }, (_, row) => row);
  file.duration_s = lines;
  file.moves = { kinds: ["draw"], kind: [0], pass: [0], from_s: [0] };
  file.path = {
    t_s: rows,
    x_mm: rows.map((row) => 200 + (row % 2)),
    y_mm: rows.map((row) => (row / lines) * 100),
    z_mm: rows.map(() => 0),
    ink: rows.map((row) => Number(row > 0)),
    error_mm: rows.map(() => 0),
  };
  return read(file);
}

/** How often `advance` is called until nothing is missing. */
function slices(sketch, row) {
  for (let count = 1; count < 100; count += 1) if (sketch.advance(row)) return count;
  assert.fail(`row ${row} is never reached`);
}

test("canvases have the pixels of the device", () => {
  const { all } = sketchOf(read(sample()));
  assert.deepEqual([all.canvas.width, all.canvas.height], [800, 600]);
});

test("ink is drawn from the start of a line to its end, and only up to the current moment", () => {
  const sketch = sketchOf(read(sample()));
  assert.equal(sketch.advance(1), true);
  assert.deepEqual(named(sketch.ink.canvas.calls, "lineTo"), []);
  sketch.advance(3);
  const [from, to] = [[sketch.x[1], sketch.y[1]], [sketch.x[2], sketch.y[2]]];
  assert.deepEqual(named(sketch.ink.canvas.calls, "moveTo"), [from]);
  assert.deepEqual(named(sketch.ink.canvas.calls, "lineTo"), [to]);
});

test("travel moves are dashed and omit the ink", () => {
  const sketch = sketchOf(read(sample()));
  sketch.advance(0);
  const { calls } = sketch.ways.canvas;
  assert.deepEqual(named(calls, "setLineDash")[0], [[5, 5]]);
  assert.deepEqual(named(calls, "lineTo"), [[sketch.x[1], sketch.y[1]], [sketch.x[3], sketch.y[3]]]);
});

test("a dot is a line that is long enough to be visible", () => {
  const file = sample();
  file.path.ink[2] = 2;
  const sketch = sketchOf(read(file));
  sketch.advance(3);
  const [[x, y]] = named(sketch.ink.canvas.calls, "lineTo");
  assert.ok(x > sketch.x[2] && x < sketch.x[2] + 0.1, `${x} is not just right of ${sketch.x[2]}`);
  assert.equal(y, sketch.y[2]);
});

test("a long drawing is drawn in slices, each line once", () => {
  const sketch = sketchOf(long(20_000));
  assert.ok(slices(sketch, 20_000) > 1);
  assert.equal(named(sketch.ink.canvas.calls, "lineTo").length, 20_000);
  assert.equal(named(sketch.all.canvas.calls, "lineTo").length, 20_000);
});

test("seeking back starts from an earlier picture, not from the first line", () => {
  const sketch = sketchOf(long(20_000));
  slices(sketch, 20_000);
  const { calls } = sketch.ink.canvas;
  const before = calls.length;
  slices(sketch, 19_000);
  const back = calls.slice(before);
  const again = named(back, "lineTo").length;
  assert.equal(named(back, "clearRect").length, 1);
  assert.equal(named(back, "drawImage").length, 1);
  assert.ok(again > 0 && again < 7000, `${again} lines were drawn again`);
});

test("the tool is filled while it leaves ink, and otherwise a ring", () => {
  const sketch = sketchOf(read(sample()));
  sketch.advance(3);
  const fills = (inks) => {
    const { calls, getContext } = canvas();
    sketch.showTool(getContext(), { row: 1, x_mm: 210, y_mm: 0, z_mm: 0, inks, kind: "draw", pass: 0 });
    return named(calls, "fill").length;
  };
  assert.deepEqual([fills(true), fills(false)], [1, 0]);
});
