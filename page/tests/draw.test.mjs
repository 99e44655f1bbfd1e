// Drawing: a file is dropped, placed, planned and drawn, judged on the ink of the virtual arm.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { openDraw } from "./bench.mjs";

let bench, page;

before(async () => {
  bench = await openDraw();
  ({ page } = bench);
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

const SVG = `<svg xmlns="http://www.w3.org/2000/svg" width="30mm" height="30mm" viewBox="0 0 30 30"><path d="M5 5H25V25H5Z" stroke="black" fill="none"/></svg>`;
const get = async (path) => (await fetch(`${bench.url}api/v1/${path}`)).json();

/** Drops a file on the page, as a person does from the desktop. */
async function drop(name, text) {
  const files = await page.evaluateHandle(([name, text]) => {
    const files = new DataTransfer();
    files.items.add(new File([text], name));
    return files;
  }, [name, text]);
  await page.dispatchEvent("#panel", "dragover", { dataTransfer: files });
  await page.dispatchEvent("#panel", "drop", { dataTransfer: files });
}

const waitForText = (part) => page.waitForFunction((part) => document.querySelector("#draw-status")?.textContent.includes(part), part);
const value = async (name) => Number(await page.inputValue(`#draw-${name}`));

/** How far the ink goes: the least and the most of X, and of Y. */
async function ink() {
  const { strokes } = await get("world");
  const points = strokes.flatMap(({ points_mm }) => points_mm);
  const ends = (axis) => [Math.min(...points.map((it) => it[axis])), Math.max(...points.map((it) => it[axis]))];
  return points.length ? [ends(0), ends(1)] : null;
}

test("a dropped program opens under Teach", async () => {
  await drop("loop.toml", '[[steps]]\ngo = { x = 200, y = 0, z = 20 }\n');
  await page.waitForSelector("#teach-title:has-text('loop.toml')");
  await page.click("#tab-draw");
});

test("a dropped file is planned, moved by hand, and drawn at its place", async () => {
  await drop("square.svg", SVG);
  await waitForText("Takes ");
  await page.locator("#sheet-move").evaluate((it) => it.scrollIntoView({ block: "center" }));
  const box = await page.locator("#sheet-move").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 - 40, box.y + box.height / 2 + 10, { steps: 6 });
  await page.mouse.up();
  const [x, y] = [await value("x"), await value("y")];
  assert.ok(y > 10, `dragged to the left, so that Y is more than 0: ${y}`);
  assert.ok(x < 210, `dragged down, so that X is less than before: ${x}`);
  await waitForText("Planning…");
  await waitForText("Takes ");
  await page.click("#draw-start");
  await page.waitForSelector("#job-name:text('square.svg')");
  await page.waitForSelector("#job", { state: "detached", timeout: 60_000 });
  const [xs, ys] = await ink();
  for (const [found, wanted] of [[xs[0], x - 10], [xs[1], x + 10], [ys[0], y - 10], [ys[1], y + 10]]) assert.ok(Math.abs(found - wanted) < 0.6, `${found} is not near ${wanted}`);
});

test("a file that is not a drawing is reported, and nothing can be started", async () => {
  await drop("letter.svg", "Dear all,");
  await page.waitForSelector("#draw-status[data-tone=bad]");
  assert.match(await page.textContent("#draw-status"), /xml/i);
  assert.ok(await page.isDisabled("#draw-start"));
});

test("a file of 100 MB is refused with a remedy, and the page continues", async () => {
  await page.evaluate(() => {
    const files = new DataTransfer();
    files.items.add(new File([new Uint8Array(100_000_000)], "huge.png"));
    document.getElementById("panel").dispatchEvent(new DragEvent("drop", { dataTransfer: files, bubbles: true, cancelable: true }));
  });
  await waitForText("huge.png has 100 MB");
  await drop("square.svg", SVG);
  await waitForText("Takes ");
});

test("a place out of reach is reported, and the drawing can be moved back", async () => {
  await page.fill("#draw-x", "500");
  await page.waitForSelector("#draw-status[data-tone=bad]");
  assert.ok(await page.isDisabled("#draw-start"));
  await page.fill("#draw-x", "");
  await waitForText("Takes ");
});

test("a plan that takes too long is cancelled, and the statuses arrive as usual meanwhile", async () => {
  const dots = Array.from({ length: 60_000 }, (_, n) => `<path d="M${(n % 245) * 0.4} ${Math.floor(n / 245) * 0.4}h.2" stroke="#${String(n % 1000).padStart(3, "0")}"/>`).join("");
  await drop("long.svg", `<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">${dots}</svg>`);
  await page.waitForSelector("#draw-cancel");
  await page.waitForFunction(() => performance.getEntriesByType("resource").some(({ name }) => /drawings\/\d+$/.test(name)));
  const { link } = await get("state");
  assert.ok(link.statuses_per_s > 11, `${link.statuses_per_s} statuses in a second`);
  await page.click("#draw-cancel");
  await waitForText("Planning cancelled");
  await page.check("input[name=draw-what][value=text]", { force: true });
  await page.fill("#draw-text", "Hello");
  await waitForText("Takes ");
});

test("a long text is wrapped, framed by a border, and signed", async () => {
  /** Plans anew after a change; returns how large the drawing is on the sheet, and its strokes. */
  const planned = async (change) => {
    await change();
    await waitForText("Planning…");
    await waitForText("Takes ");
    const size = (name) => page.getAttribute("#sheet-move", name).then(Number);
    return { width: await size("width"), height: await size("height"), strokes: Number(/(\d+) strokes/.exec(await page.textContent("#draw-status"))[1]) };
  };
  const plain = await planned(async () => {
    await page.check("#draw-title ~ .segments input[value=text]", { force: true });
    await page.fill("#draw-text", "one two three four");
  });
  const wrapped = await planned(() => page.fill("#draw-wrap", "50"));
  assert.ok(wrapped.width <= 54.5 && plain.width > wrapped.width, `${wrapped.width} of ${plain.width} mm wide`);
  assert.ok(wrapped.height > 1.5 * plain.height, `${wrapped.height} of ${plain.height} mm high`);
  const framed = await planned(() => page.click("label:has(#draw-border)"));
  assert.ok(framed.width > wrapped.width + 5 && framed.strokes > wrapped.strokes);
  const signed = await planned(() => page.fill("#draw-sign", "Anna"));
  assert.ok(signed.strokes > framed.strokes, `${signed.strokes} of ${framed.strokes} strokes`);
  await page.fill("#draw-wrap", "wide");
  await page.waitForSelector("#draw-wrap[aria-invalid=true]");
});
