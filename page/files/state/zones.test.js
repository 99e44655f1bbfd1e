import assert from "node:assert/strict";
import { test } from "node:test";

import { freeName, withZone } from "./zones.js";

const TEXT = '[table]\nz_mm = -60\n\n[keep_out]   # with names\n# lamp = { }\ncup = { cylinder = { x_mm = 1, y_mm = 2, radius_mm = 3, z_mm = [0, 9] } }\n\n[speed]\njoint_deg_s = 200\n';
const BOX = { box: { x_mm: [1, 2], y_mm: [3, 4], z_mm: [5, 6] } };
const LINE = "{ box = { x_mm = [1, 2], y_mm = [3, 4], z_mm = [5, 6] } }";

test("a new zone is a line below the header, and all other lines stay", () => {
  const text = withZone(TEXT, "shelf", BOX);
  assert.equal(text, TEXT.replace("# with names\n", `# with names\nshelf = ${LINE}\n`));
});

test("a zone that is there is changed where it stands, or taken away", () => {
  assert.match(withZone(TEXT, "cup", BOX), new RegExp(`# lamp = \\{ \\}\ncup = ${LINE.replace(/[[\]{}]/g, "\\$&")}\n\n\\[speed`));
  assert.equal(withZone(TEXT, "cup", null).includes("cylinder"), false);
});

test("a text without zones gets a table of them", () => {
  assert.match(withZone("[table]\nz_mm = -60\n", "shelf", BOX), /\[keep_out\]\nshelf = /);
});

test("what is written in another way is left to a person", () => {
  assert.equal(withZone(TEXT.replace("[speed]", "[keep_out.arch]\nbox = 1\n[speed]"), "arch", BOX), null);
  assert.equal(withZone(TEXT, "no name", BOX), null);
});

test("a free name is one that nobody has", () => {
  assert.equal(freeName(["zone_1", "cup"]), "zone_2");
});
