// How exactly a camera's pictures are measured, with rendered photos (`crates/calibrate/examples/photos`).
import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { MARKER_MM } from "../files/state/look.js";
import { heightOfMarker, onSheet, placeOfMarker } from "../files/vision/geometry.js";
import { crossesIn } from "../files/vision/crosses.js";
import { CROSSES, LEAST_CROSSES } from "../files/vision/drawn_crosses.js";
import { createLook } from "../files/vision/look.js";
import { readPhoto, renderPhotos } from "./photos.mjs";

const COUNT = Number(process.env.PHOTOS_COUNT ?? 6);
let folder;

before(() => {
  folder = mkdtempSync(join(tmpdir(), "photos-"));
});
after(() => rmSync(folder, { recursive: true }));

const share = (values, part) => values.toSorted((a, b) => a - b)[Math.floor((values.length - 1) * part)];

test("objects are found within 0.5 mm for half of the photos and 1 mm for 95 of 100", () => {
  const errors_mm = [], turns_deg = [], blobs_mm = [], heights_mm = [];
  for (const photo of renderPhotos(folder, "look", COUNT)) {
    const { picture, truth } = readPhoto(photo);
    const { view, markers, blob } = createLook(truth.sheet).look(picture, 0);
    const [object, block] = truth.objects;
    const marker = markers.find(({ id }) => id === object.marker);
    assert.ok(view && marker, photo);
    const { x_mm, y_mm, turn_deg } = placeOfMarker(view, marker, object.height_mm);
    errors_mm.push(Math.hypot(x_mm - object.x_mm, y_mm - object.y_mm));
    turns_deg.push(Math.abs(((turn_deg - object.turn_deg + 540) % 360) - 180));
    heights_mm.push(Math.abs(heightOfMarker(view, marker, MARKER_MM) - object.height_mm));
    assert.ok(blob, photo);
    const [x, y] = onSheet(view, blob, block.height_mm);
    blobs_mm.push(Math.hypot(x - block.x_mm, y - block.y_mm));
  }
  const [half, most] = [0.5, 0.95].map((part) => share(errors_mm, part));
  console.log(`markers: ${half.toFixed(2)} mm, ${most.toFixed(2)} mm (50, 95 of 100), turned ${share(turns_deg, 0.95).toFixed(2)} degrees; colours: ${share(blobs_mm, 0.5).toFixed(2)}, ${share(blobs_mm, 0.95).toFixed(2)} mm`);
  console.log(`heights: ${share(heights_mm, 0.5).toFixed(1)}, ${share(heights_mm, 0.95).toFixed(1)} mm`);
  assert.ok(share(heights_mm, 0.95) < 5);
  assert.ok(half <= 0.5 && most <= 1, `${half}, ${most}`);
  assert.ok(share(turns_deg, 0.95) < 1.5);
  assert.ok(share(blobs_mm, 0.95) < 3);
});

test("the crosses that an arm drew are found within 0.3 mm for 95 of 100", () => {
  const errors_mm = [];
  for (const photo of renderPhotos(folder, "crosses", Math.ceil(COUNT / 3), "1024x768")) {
    const { picture, truth } = readPhoto(photo);
    const found = crossesIn(picture, truth.sheet, CROSSES);
    assert.ok(found.filter(Boolean).length >= 20, `${photo}: ${found.filter(Boolean).length} of 25`);
    found.forEach((at, n) => at && errors_mm.push(Math.hypot(at[0] - truth.crosses[n].at_mm[0], at[1] - truth.crosses[n].at_mm[1])));
  }
  console.log(`crosses: ${share(errors_mm, 0.5).toFixed(2)} mm, ${share(errors_mm, 0.95).toFixed(2)} mm (50, 95 of 100 of ${errors_mm.length})`);
  assert.ok(share(errors_mm, 0.95) <= 0.3);
});

test("a photo without corners gives no crosses, and one without crosses none", () => {
  const [covered] = renderPhotos(folder, "covered", 1).map(readPhoto);
  assert.equal(crossesIn(covered.picture, covered.truth.sheet, CROSSES), null);
  const [still] = renderPhotos(folder, "still", 1).map(readPhoto);
  assert.ok(crossesIn(still.picture, still.truth.sheet, CROSSES).filter(Boolean).length < LEAST_CROSSES);
});

for (const [set, expected] of [["blurred", "blurred"], ["glare", "glare"], ["covered", "few_corners"]]) {
  test(`a photo that is ${set} is reported as ${expected}`, () => {
    for (const photo of renderPhotos(folder, set, 2)) {
      const { picture, truth } = readPhoto(photo);
      assert.ok(createLook(truth.sheet).look(picture).troubles.includes(expected), photo);
    }
  });
}

test("a moved sheet is not a moved camera, and a still picture is neither", () => {
  const [still, other] = renderPhotos(folder, "still", 2).map(readPhoto);
  const [shifted] = renderPhotos(folder, "shifted", 1).map(readPhoto);
  const [elsewhere] = renderPhotos(folder, "look", 1).map(readPhoto);
  const eye = createLook(still.truth.sheet);
  for (const photo of [still, other]) assert.deepEqual(eye.look(photo.picture).troubles, []);
  assert.deepEqual(eye.look(shifted.picture).troubles, ["sheet_moved"]);
  assert.deepEqual(eye.look(elsewhere.picture).troubles, ["camera_moved"]);
  eye.forget();
  assert.deepEqual(eye.look(shifted.picture).troubles, []);
  assert.deepEqual(eye.look(still.picture).troubles, ["sheet_moved"]);
});

test("ten pictures a second take less than one core", () => {
  const [{ picture, truth }] = renderPhotos(folder, "still", 1).map(readPhoto);
  const eye = createLook(truth.sheet);
  eye.look(picture);
  const before = process.cpuUsage();
  for (let n = 0; n < 10; n += 1) eye.look(picture);
  const { user, system } = process.cpuUsage(before);
  console.log(`${((user + system) / 1e4).toFixed(0)} ms a picture`);
  assert.ok(user + system < 1e6);
});
