import assert from "node:assert/strict";
import { test } from "node:test";

import { placesOf } from "./lines.js";

test("a line belongs to the innermost step around it, or to the name it defines", () => {
  const text = `title = "x"
[points]
aside = { x = 1, y = 2, z = 3 }
"left tray" = { x = 1, y = 2, z = 3 }
[[steps]]
go = "aside"
[[steps]]
choose = "?"
[[steps.when]]
answer = "a"
[[steps.when.steps]]
pause = 1
[[steps.when]]
answer = "b"
[[steps.when.steps]]
pause = 1
[[steps.when.steps]]

[[steps]]
[steps.on_missed]
by = "seen"`;
  const places = placesOf(text).map((it) => it.join("."));
  assert.deepEqual(places, [
    "title", "points", "points.aside", "points.left tray", "steps.0", "steps.0.go", "steps.1", "steps.1.choose", "steps.1.when.0", "steps.1.when.0.answer", "steps.1.when.0.steps.0", "steps.1.when.0.steps.0.pause",
    "steps.1.when.1", "steps.1.when.1.answer", "steps.1.when.1.steps.0", "steps.1.when.1.steps.0.pause", "steps.1.when.1.steps.1", "steps.1.when.1.steps.1", "steps.2", "steps.2.on_missed", "steps.2.on_missed.by",
  ]);
});
