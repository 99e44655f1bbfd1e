import assert from "node:assert/strict";
import { test } from "node:test";

import { drawingOf } from "./drawing_svg.js";

const world = (other) => ({ tool: { kind: { type: "pen", width_mm: 0.5 } }, paper: { from_mm: [150, -105], to_mm: [298, 105] }, strokes: [], burns: [], holes: [], ...other });

test("a drawing has the size of its paper and the orientation seen from behind the arm", () => {
  const svg = drawingOf(world({ strokes: [{ points_mm: [[200, 50], [250, 50], [250, -50]] }] }), "desk-1");
  // To the left of the arm is left, and ahead is up.
  assert.match(svg, /width="210mm" height="148mm" viewBox="-105 -298 210 148"/);
  assert.match(svg, /d="M-50 -200L-50 -250L50 -250"/);
  assert.match(svg, /stroke-width="0.5"/);
});

test("a point is a dot, a burn has its darkness, and without paper everything is in the picture", () => {
  const svg = drawingOf(world({ tool: { kind: { type: "laser" } }, paper: null, strokes: [{ points_mm: [[200, 0]] }], burns: [{ points_mm: [[200, 0], [220, 0]], power_w: 0.5, speed_mm_s: 1 }], holes: [{ at_mm: [210, 10] }] }), "desk-1");
  assert.match(svg, /d="M0 -200h0"/);
  assert.match(svg, /stroke-opacity="1"/);
  assert.match(svg, /viewBox="-15 -225 20 30"/);
});

test("a name is escaped as text, and an empty world is an empty sheet", () => {
  assert.match(drawingOf(world({ paper: null }), "<script>&"), /<title>&lt;script&gt;&amp;<\/title>/);
});
