import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";

import { LANGUAGES, TEXTS, loadLanguage, translator } from "./i18n.js";

await Promise.all(Object.keys(LANGUAGES).map(loadLanguage));
import { problemText } from "./problem_text.js";

const problem = (kind, detail, hint) => ({ type: `/api/v1/problems/${kind}`, title: "a title", detail, hint });

test("each problem type of the API has a text in each language", async () => {
  const api = await readFile(new URL("../api.d.ts", import.meta.url), "utf8");
  const kinds = new Set([...api.matchAll(/- `([a-z-]+)`: /g)].map(([, kind]) => kind));
  assert.ok(kinds.size > 60, `${kinds.size} types`);
  for (const texts of Object.values(TEXTS)) assert.deepEqual([...kinds].filter((kind) => !(`problem.${kind}` in texts)), []);
});

test("no text of a problem names a command for a terminal", () => {
  const t = translator("en");
  assert.equal(problemText(t, problem("no-lease", "control is free", "take control: `dobot lease take` or `POST /api/v1/lease`")), "You do not have control.");
  assert.equal(problemText(t, problem("policy", "z would be -70 mm", "see the rules: `dobot policy`")), "The safety policy does not allow this: z would be -70 mm.");
  for (const texts of Object.values(TEXTS)) {
    for (const [key, text] of Object.entries(texts)) if (key.startsWith("problem.")) assert.doesNotMatch(text, /`|dobot|--|api\//, key);
  }
});

test("a hint without a command is shown, and an unknown type is shown as the station says it", () => {
  const t = translator("en");
  assert.equal(problemText(t, problem("bad-drawing", "it has no lines", "choose another file")), "It cannot be drawn: it has no lines. Choose another file.");
  assert.equal(problemText(t, problem("of-the-future", "the moon is up")), "A title: the moon is up.");
});

test("lengths have two decimals at most; addresses and small amounts stay as they are", () => {
  const t = translator("en");
  assert.equal(problemText(t, problem("command", "distance from pivot to wrist is 845.0306 mm; the arm allows 60 to 295 mm: 550.0306 mm too far")), "The arm cannot do this: distance from pivot to wrist is 845.03 mm; the arm allows 60 to 295 mm: 550.03 mm too far.");
  assert.equal(problemText(t, problem("ending", "192.168.1.700 is 0.0004 mm off")), "The station is shutting down: 192.168.1.700 is 0.0004 mm off.");
});
