// A new user with a browser and no arm, who reads nothing: the story of the film that opens the README, judged on the arm.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { open } from "./bench.mjs";
import { Hand, tell } from "./story.mjs";

let bench;

before(async () => {
  bench = await open({ virtual: true });
});
after(() => bench.end());

test("a person jogs, teaches two points and loops them, stops, has a picture drawn, and learns why a target is refused", async () => {
  const state = () => bench.ask("api/v1/state");
  const begun = (await state()).arm;
  let before = begun;
  const parts = [];
  await tell(new Hand(bench.page), async (part) => {
    const { arm, job, stop } = await state();
    parts.push(part);
    switch (part) {
      case "jogged":
        assert.ok(arm.y_mm - begun.y_mm >= 39 && arm.z_mm - begun.z_mm >= 24, JSON.stringify(arm));
        break;
      case "looped":
        assert.equal(job.phase, "running");
        assert.ok(job.program.cycles_done >= 1, JSON.stringify(job));
        break;
      case "stopped":
        assert.ok(stop.at_rest && !arm.moving, JSON.stringify({ stop, arm }));
        break;
      case "drawn": {
        const { strokes } = await bench.ask("api/v1/world");
        const xs = strokes.flatMap(({ points_mm }) => points_mm).map(([, y]) => y);
        const width = Math.max(...xs) - Math.min(...xs);
        assert.ok(Math.abs(width - 87) < 2, `the ink of the boat is ${width} mm wide`);
        break;
      }
      case "released":
        assert.deepEqual([stop, arm.moving, arm.y_mm], [null, false, before.y_mm], "what was stopped does not go on by itself");
        break;
      case "planned":
        assert.equal(job, null, "nothing is drawn before a person starts it");
        break;
      default:
        assert.deepEqual([arm.x_mm, arm.moving], [before.x_mm, false], "what is refused moves nothing");
    }
    before = arm;
  });
  assert.deepEqual(parts, ["jogged", "looped", "stopped", "released", "planned", "drawn", "looked", "refused"]);
  const { arm } = await state();
  assert.ok(arm.x_mm > before.x_mm + 20, "the nearest place is one click away");
  assert.deepEqual(bench.errors, []);
});
