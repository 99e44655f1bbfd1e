import assert from "node:assert/strict";
import { test } from "node:test";

import { NO_LOOK, askedThing, lookBlockedReason, reduceLook, spotInPicture, thingsOf, transferBlockedReason } from "./look.js";
import { homography, onSheet } from "../vision/geometry.js";

/** A camera straight above, 400 mm high: a pixel is a millimetre. */
const view = () => {
  const size = /** @type {const} */ ([640, 480]);
  const corners = [[0, 0], [1, 0], [1, 1], [0, 1]];
  const toPixels = homography(corners.map((at) => [at, [-at[1] * (100 / 640), -at[0] * (100 / 640)]]));
  const toSheet = homography(corners.map((at) => [[-at[1] * (100 / 640), -at[0] * (100 / 640)], at]));
  return { size, lens: 0, toPixels, toSheet, camera_mm: [200, 0, 400], typical_mm: 0.1, markers: 4 };
};
const marker = (id) => ({ id, corners: [[230, 250], [250, 250], [250, 270], [230, 270]] });
const seen = (troubles = []) => ({ view: view(), markers: [marker(2), marker(7)], blob: null, troubles });
const looks = (seen, heights = {}) => ({ ...NO_LOOK, camera: "on", seen, heights });

test("objects are the markers that are not the sheet's, at their heights", () => {
  const [flat] = thingsOf(looks(seen()));
  assert.equal(flat.name, "marker 7");
  assert.equal(flat.height_mm, null);
  assert.ok(Math.abs(flat.x_mm - 180) < 0.01 && Math.abs(flat.y_mm - 80) < 0.01 && Math.abs(flat.turn_deg) < 0.01);
  // 40 mm nearer to a camera 400 mm away, it is a tenth closer to below the camera.
  const [high] = thingsOf(looks(seen(), { "marker 7": 40 }));
  assert.ok(Math.abs(high.x_mm - 182) < 0.01 && Math.abs(high.y_mm - 72) < 0.01);
});

test("what a person clicks is drawn where it was clicked, at any height of the surface", () => {
  for (const surface_mm of [0, 6, 40]) {
    const [x_mm, y_mm] = onSheet(view(), [230, 250], surface_mm);
    const [u, v] = spotInPicture({ ...looks(seen()), surface_mm, spot: { x_mm, y_mm } });
    assert.ok(Math.hypot(u - 230, v - 250) < 1e-6, `${surface_mm} mm: ${u}, ${v}`);
  }
});

test("another height of the surface needs another click", () => {
  const clicked = { ...looks(seen()), spot: { x_mm: 200, y_mm: 0 }, is_above: true };
  const { surface_mm, spot, is_above } = reduceLook(clicked, { type: "look_surface", surface_mm: 6 });
  assert.deepEqual([surface_mm, spot, is_above], [6, null, false]);
});

test("the height of a marker follows from its size, if it is as large as printed", () => {
  // 20 mm seem 22 mm where the camera is a tenth farther away than the marker.
  const size = (side) => ({ id: 7, corners: [[230, 250], [230 + side, 250], [230 + side, 250 + side], [230, 250 + side]] });
  const [flat, high] = [20, 22].map((side) => thingsOf(looks({ ...seen(), markers: [size(side)] }))[0].measured_mm);
  assert.ok(flat < 0.01 && Math.abs(high - 400 / 11) < 0.01, `${flat}, ${high}`);
});

test("a moved sheet, hidden corners and blur prevent that anything moves; glare and a moved camera do not", () => {
  const page = (troubles) => ({ look: looks(seen(troubles)), connection: "closed", station: null, draw: { paper: null }, around: null });
  for (const trouble of ["sheet_moved", "few_corners", "blurred"]) assert.equal(lookBlockedReason(page([trouble])), `look.${trouble}`);
  for (const troubles of [[], ["glare"], ["camera_moved"]]) assert.equal(lookBlockedReason(page(troubles)), "blocked.no_connection");
});

test("nothing is picked up or put down while the arm moves, or before a state shows that it was sent somewhere", () => {
  const page = (moving, is_sent = false) => ({
    look: { ...looks(seen()), is_sent }, connection: "open", me: 7, role: "control", draw: { paper: { z_mm: 0, slope_x: 0, slope_y: 0 } }, jobs: { starting: false },
    station: { link: { phase: "up" }, trust: { trusted: true }, arm: { moving }, lease: { client: 7 } },
  });
  assert.equal(transferBlockedReason(page(false)), null);
  assert.equal(transferBlockedReason(page(true)), "blocked.moving");
  assert.equal(transferBlockedReason(page(false, true)), "blocked.moving");
  // A click in the picture may send a moving arm elsewhere.
  assert.equal(lookBlockedReason(page(true, true)), null);
});

test("a program is answered only about the marker that it asks for, once its height is known", () => {
  const asks = (name) => ({ job: { question: { asks: "place", name } } });
  assert.equal(askedThing({ look: looks(seen()), station: asks("marker 7") }), null);
  const look = looks(seen(), { "marker 7": 10 });
  assert.equal(askedThing({ look, station: asks("marker 7") })?.marker, 7);
  assert.equal(askedThing({ look, station: asks("marker 8") }), null);
  assert.equal(askedThing({ look: looks(seen(["sheet_moved"]), { "marker 7": 10 }), station: asks("marker 7") }), null);
});

test("a picture that comes after the camera was switched off is ignored, and programs are no longer answered", () => {
  const off = reduceLook({ ...NO_LOOK, camera: "on", answers: true }, { type: "look_camera", camera: "off" });
  assert.equal(off.answers, false);
  assert.equal(reduceLook(off, { type: "look_seen", seen: seen(), rate: 10 }).seen, null);
});
