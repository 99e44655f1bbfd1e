// A person with a printed sheet, a camera and three cubes, who does what docs/senses.md says, judged by where the cubes are.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { SLOTS, TRAY_MM, openSorting, tellSorting } from "./sorting.mjs";
import { Hand } from "./story.mjs";

let bench;

before(async () => {
  bench = await openSorting({ speed: 4 });
});
after(() => bench?.end());

test("a person has one cube picked up and placed by what the camera sees, and a program sorts the others", async () => {
  const world = () => bench.ask("api/v1/world");
  const begun = await world();
  const cubes = ({ objects }) => Object.fromEntries(objects.filter(({ name }) => name.startsWith("marker")).map((it) => [it.name.split(" ")[1], it]));
  await tellSorting(new Hand(bench.page), bench, async (part) => {
    const now = await world();
    if (part === "found" || part === "measured") assert.deepEqual(cubes(now), cubes(begun), "looking moves nothing");
    if (part === "picked") assert.deepEqual(now.held, ["marker 7"]);
  });
  for (const [marker, { at_mm: [x, y], bottom_mm }] of Object.entries(cubes(await world()))) {
    const off_mm = Math.hypot(x - SLOTS[marker][0], y - SLOTS[marker][1]);
    // A click is as exact as a pixel of the screen, which shows about a millimetre; each program step is exact.
    assert.ok(off_mm < (marker === "7" ? 2.5 : 1) && Math.abs(bottom_mm - TRAY_MM) < 0.01, `marker ${marker} is ${off_mm} mm from its place, ${bottom_mm} mm above the table`);
  }
  const { events } = await world();
  assert.deepEqual(events.filter(({ event }) => event === "collided"), []);
  assert.ok(events.filter(({ event }) => event === "dropped").every(({ fell_mm }) => fell_mm < 1.5), JSON.stringify(events));
  const notices = await bench.ask("api/v1/notices").then((all) => all.notices ?? all);
  assert.ok(notices.some(({ type }) => type === "sensed"), "the click in the picture is marked as the camera's");
  assert.equal(notices.filter(({ type, text }) => type === "job_answered" && text.includes("camera: ")).length, 2);
  assert.deepEqual(bench.errors, []);
});
