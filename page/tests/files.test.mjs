// Stored files: kept when they are opened, where they were placed after a reload and on another computer, undone, deleted.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { contents, openDraw, waitForAnswer } from "./bench.mjs";

let bench, page;

before(async () => {
  bench = await openDraw();
  ({ page } = bench);
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

const SVG = (side = 20) => `<svg xmlns="http://www.w3.org/2000/svg" width="30mm" height="30mm" viewBox="0 0 30 30"><path d="M5 5h${side}v20H5Z" stroke="black" fill="none"/></svg>`;
const stored = async () => (await bench.ask("api/v1/files")).files;
const choose = (name, text, on = page) => on.setInputFiles("#draw-file", { name, mimeType: "image/svg+xml", buffer: Buffer.from(text) });
const planned = (on = page) => on.waitForFunction(() => document.querySelector("#draw-status")?.textContent.includes("Takes "));
/** Waits until the station stores what a test expects. */
async function until(isSo) {
  for (;;) {
    const files = await stored();
    if (isSo(files)) return files;
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
  }
}
const at = (file) => file?.options?.place.at;
const entry = (name) => `.files .entry:has(.name:text-is("${name}"))`;

/** Waits until a field shows this. */
const shows = (name, text) => page.waitForFunction(([name, text]) => document.querySelector(`#draw-${name}`).value === text, [name, text]);

/** Drags the drawing to the left, as a hand does. */
async function drag(by_px) {
  await page.locator("#sheet-move").evaluate((it) => it.scrollIntoView({ block: "center" }));
  const box = await page.locator("#sheet-move").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 - by_px, box.y + box.height / 2, { steps: 5 });
  await page.mouse.up();
}

test("a chosen file is stored with a picture, and its placement with it", async () => {
  await choose("square.svg", SVG());
  await planned();
  await page.waitForSelector(`${entry("square.svg")} svg.sketch path`);
  await drag(40);
  const y = Number(await page.inputValue("#draw-y"));
  assert.ok(y > 5, `${y}`);
  const [file] = await until(([file]) => at(file)?.[1] === y);
  assert.equal(file.name, "square.svg");
  // The height of the pen belongs to the paper of today.
  assert.equal(file.options.place.pen_down ?? null, null);
});

test("after a reload, and on another computer, the drawing is where it was placed", async () => {
  const y = await page.inputValue("#draw-y");
  await page.reload();
  await page.click("#tab-draw");
  await planned();
  assert.equal(await page.textContent("#draw-name"), "square.svg");
  assert.equal(await page.inputValue("#draw-y"), y);
  const other = await bench.visit();
  await other.click("#first-close");
  await other.click("#tab-draw");
  await other.click(`${entry("square.svg")} [data-act=open]`);
  await planned(other);
  assert.equal(await other.inputValue("#draw-y"), y);
  await other.context().close();
});

test("a drag is one step of undo, and the station stores what undo leaves", async () => {
  const y = await page.inputValue("#draw-y");
  await drag(-30);
  await page.fill("#draw-rotate", "90");
  await page.locator("#draw-rotate").blur();
  const moved = await page.inputValue("#draw-y");
  assert.notEqual(moved, y);
  await page.click("#draw-undo");
  await shows("rotate", "");
  await shows("y", moved);
  await page.click("#draw-undo");
  await shows("y", y);
  await page.waitForSelector("#draw-undo:disabled");
  await page.click("#draw-redo");
  await shows("y", moved);
  await page.click("#draw-undo");
  await until(([file]) => at(file)?.[1] === Number(y));
});

test("a file with the name of another one is a question", async () => {
  await choose("square.svg", SVG(10));
  await page.waitForSelector("#file-taken");
  await page.click("#file-keep-both");
  await page.waitForSelector(entry("square (2).svg"));
  await choose("square.svg", SVG(12));
  await page.waitForSelector("#file-taken");
  await page.click("#file-replace");
  await page.waitForSelector("#file-taken", { state: "detached" });
  await until((files) => files.length === 2 && files[0].revision > 2);
  assert.equal(await (await fetch(`${bench.url}api/v1/files/1/content`)).text(), SVG(12));
  await planned();
});

test("where two pages placed a drawing differently, the second one is asked", async () => {
  const [file] = await stored();
  const options = { ...file.options, place: { ...file.options.place, at: [205, -25] } };
  const answer = await fetch(`${bench.url}api/v1/files/${file.file}`, { method: "PUT", headers: { "content-type": "application/json" }, body: JSON.stringify({ revision: file.revision, options }) });
  assert.equal(answer.status, 200);
  await page.fill("#draw-x", "195");
  await page.waitForSelector("#file-theirs");
  assert.deepEqual(at((await stored())[0]), [205, -25]);
  await page.click("#theirs-use");
  await shows("y", "-25");
  await shows("x", "205");
  await planned();
});

test("a drawn job has picture, ink and time, its file the result, and it runs again", async () => {
  await planned();
  await page.click("#draw-start");
  await page.waitForSelector("#job-name:text('square.svg')");
  await page.waitForFunction(() => /^\d+ % square\.svg$/.test(document.title));
  await page.waitForSelector("#job", { state: "detached", timeout: 60_000 });
  await page.waitForFunction(() => document.title === "Dobot station");
  await page.click("#tab-jobs");
  await page.waitForSelector(".entry[data-job] svg.sketch path");
  // A rectangle of 12 by 20 mm.
  assert.equal(await page.textContent(".entry[data-job] .ink"), "0.06 m drawn");
  const [file] = await until(([file]) => file.last_job?.phase === "done");
  assert.ok(file.last_job.took_s > 0);
  await page.click(".entry[data-job] [data-act=again]");
  await waitForAnswer(page, "api/v1/jobs", (jobs) => jobs.length === 2 && jobs.every(({ phase }) => phase === "done"));
  await page.waitForSelector("#job", { state: "detached" });
});

test("files are searched, downloaded, and deleted after a question", async () => {
  await page.click("#tab-draw");
  await page.fill("#files-search", "(2)");
  await page.waitForSelector(entry("square.svg"), { state: "detached" });
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(`${entry("square (2).svg")} [data-act=download]`)]);
  assert.equal(download.suggestedFilename(), "square (2).svg");
  assert.equal(String(await contents(download)), SVG(10));
  await page.click(`${entry("square (2).svg")} [data-act=remove]`);
  assert.equal((await stored()).length, 2);
  await page.click(`${entry("square (2).svg")} [data-act=remove-yes]`);
  await page.waitForSelector("#files-none");
  assert.equal((await stored()).length, 1);
  await page.fill("#files-search", "");
});

test("a file that cannot be stored is drawn all the same, and the reason is shown", async () => {
  await page.route("**/api/v1/files", (route) => (route.request().method() === "POST" ? route.fulfill({ status: 507, contentType: "application/problem+json", body: JSON.stringify({ type: "/api/v1/problems/files-unusable", title: "the files cannot be read or written", status: 507, detail: "cannot write /data/files/2/content-1: no storage space" }) }) : route.continue()));
  await choose("other.svg", SVG(15));
  await page.waitForSelector("#files-problem");
  assert.match(await page.textContent("#files-problem"), /no storage space/);
  await planned();
  assert.ok(await page.isEnabled("#draw-start"));
  await page.unroute("**/api/v1/files");
});

test("a program is stored and opened again", async () => {
  await page.click("#tab-teach");
  await page.setInputFiles("#teach-file", { name: "wave.toml", mimeType: "text/plain", buffer: Buffer.from("title = \"Wave\"\n\n[[steps]]\ngo = { x = 200, y = 0, z = 50 }\n") });
  await page.click("#teach-keep");
  await page.waitForSelector(entry("wave.toml"));
  await page.click("#teach-new");
  await page.click(`${entry("wave.toml")} [data-act=open]`);
  await page.waitForFunction(() => !document.querySelector("#teach-keep")?.disabled);
  assert.equal((await stored()).find(({ name }) => name === "wave.toml").kind, "program");
});
