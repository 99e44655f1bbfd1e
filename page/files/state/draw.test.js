import assert from "node:assert/strict";
import test from "node:test";
import { translator } from "../i18n/i18n.js";
import { accepted, formatNames, isGcode, NO_DRAW, reduceDraw, withFieldNames } from "./draw.js";

const FORMATS = /** @type {import("./draw.js").Formats} */ ([
  { name: "SVG", extensions: ["svg", "svgz"], mime_type: "image/svg+xml", contents: "page" },
  { name: "HP-GL", extensions: ["plt"], mime_type: "application/vnd.hp-hpgl", contents: "shapes" },
]);

test("files are selected and named by the formats that the station lists", () => {
  const { formats } = reduceDraw(NO_DRAW, { type: "formats", formats: FORMATS });
  assert.equal(accepted(formats), ".svg,.svgz,.plt");
  assert.equal(formatNames(formats), "SVG, HP-GL");
});

test("an error names the field of the page, and an option without a field by its own name", () => {
  const t = translator("en");
  assert.equal(withFieldNames(t, "tool.speed is 2000 mm/s; it takes 0 to 1000 mm/s"), "“Speed” is 2000 mm/s; it takes 0 to 1000 mm/s");
  assert.equal(withFieldNames(t, "`place.fit`, instead of `place.scale`, is smaller"), "“scale to fit”, instead of “Scale”, is smaller");
  assert.equal(withFieldNames(t, "tool.kerf is 7 mm"), "tool.kerf is 7 mm");
});

test("what G-code is for can be chosen for files of G-code only", () => {
  const formats = /** @type {import("./draw.js").Formats} */ ([...FORMATS, { name: "G-code", extensions: ["gcode", "nc"], mime_type: "text/x-gcode", contents: "lines" }]);
  const named = (/** @type {string} */ name) => ({ ...NO_DRAW, formats, file: /** @type {File} */ ({ name }) });
  assert.ok(isGcode(named("part.NC")));
  assert.ok(!isGcode(named("part.svg")));
  assert.ok(!isGcode(named("nc")));
  assert.ok(!isGcode({ ...named("part.nc"), what: "text" }));
  assert.ok(!isGcode(NO_DRAW));
});
