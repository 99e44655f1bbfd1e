// Questions of a running program, answered with a real pointer and keys, judged on where the arm was sent.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { open, rest, takeControl } from "./bench.mjs";

let bench, page, traffic;

before(async () => {
  bench = await open({ speed: 4 });
  ({ page, traffic } = bench);
  await takeControl(page);
  await rest(page);
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

const PROGRAM = `title = "sides"
[[steps]]
go = { x = 220, y = 0, z = 40 }
[[steps]]
choose = "Which side?"
[[steps.when]]
answer = "left"
[[steps.when.steps]]
go = { x = 200, y = 80, z = 40 }
[[steps.when]]
answer = "right"
[[steps.when.steps]]
go = { x = 200, y = -80, z = 40 }
[[steps]]
go = { from = "cube" }
`;

async function post(path, body) {
  const answer = await fetch(new URL(`api/v1/${path}`, bench.url), { method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify(body) });
  assert.ok(answer.ok, await answer.clone().text());
  return answer.json();
}

const ys = (from) => traffic.targets(from).map((it) => Math.round(it[1]));

test("a question is shown with its answers, and the arm goes where the answer leads", async () => {
  const { job } = await post("programs/jobs", { program: { text: PROGRAM } });
  await page.click("#tab-jobs");
  await page.click(`[data-job="${job.job}"] [data-act=start]`);
  await page.waitForSelector("#job-question button");
  assert.equal(await page.textContent("#job-asks"), "Which side?");
  assert.deepEqual(await page.locator("#job-question button").allTextContents(), ["left", "right"]);
  const from = traffic.packets.length;
  await page.click("#job-question >> text=right");
  await page.waitForSelector("#job-question input");
  assert.deepEqual(ys(from), [-80]);
});

test("a position is typed, one that the arm may not go to is refused with the reason, and the arm goes to the other", async () => {
  assert.match(await page.textContent("#job-asks"), /cube/);
  const from = traffic.packets.length;
  await page.fill("#job-question [name=x]", "900");
  await page.click("#job-question [type=submit]");
  await page.waitForFunction(() => /mm/.test(document.querySelector("#problem")?.textContent ?? ""));
  assert.deepEqual(ys(from), []);
  for (const [axis, value] of [["x", 210], ["y", 40], ["z", 20]]) await page.fill(`#job-question [name=${axis}]`, String(value));
  await page.keyboard.press("Enter");
  await page.waitForSelector("#job-question", { state: "detached" });
  await page.waitForFunction(() => document.querySelector("#no-job"));
  assert.deepEqual(ys(from), [40]);
});
