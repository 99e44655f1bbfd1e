// Programs as blocks, built with a real pointer, and judged on the text, on the table and on where the arm goes.
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { after, afterEach, before, test } from "node:test";
import { open, passed, rest, takeControl } from "./bench.mjs";

let bench, page, traffic;
/** What the browser refused: the page's security policy must allow all that the blocks do. */
const refused = [];

before(async () => {
  bench = await open({ viewport: { width: 1280, height: 900 }, speed: 4 });
  ({ page, traffic } = bench);
  page.on("console", (message) => /Content Security Policy/.test(message.text()) && refused.push(message.text()));
  await takeControl(page);
  await rest(page);
  await page.click("#tab-teach");
});
after(() => bench.end());
afterEach(() => {
  assert.deepEqual(bench.errors, []);
  assert.deepEqual(refused, []);
});

/** The blocks of the program, not those of the toolbox. */
const CANVAS = ".blocklyBlockCanvas:not(.blocklyFlyout *)";
const view = (mode) => page.check(`[name=teach-mode][value=${mode}]`, { force: true });
const text = () => page.evaluate(() => localStorage.getItem("dobot.program") ?? "");
const waitForText = (part) => page.waitForFunction((part) => (localStorage.getItem("dobot.program") ?? "").includes(part), part);
/** Puts a text into the program, by its field. */
async function type(program) {
  await view("text");
  await page.fill("#teach-text", program);
  await view("blocks");
  await page.waitForSelector(`${CANVAS} > [data-id]`);
}

/** The corner of a block whose rows say this, where it can be taken; with `n`, of another one. */
const blockOf = (words, canvas = CANVAS, n = 0) =>
  page.waitForFunction(([words, canvas, n]) => {
    const own = (block) => [...block.querySelectorAll("text")].filter((it) => it.closest("[data-id]") === block).map((it) => it.textContent.replaceAll("\u00a0", " ").trim()).join(" ");
    const block = [...document.querySelectorAll(`${canvas} [data-id]`)].filter((it) => own(it).startsWith(words))[n];
    const path = block?.querySelector(":scope > .blocklyPath")?.getBoundingClientRect();
    return path && path.width > 0 && { x: path.x, y: path.y, width: path.width, height: path.height };
  }, [words, canvas, n]).then((it) => it.jsonValue());

/** Drags with real pointer events, as a person does. */
async function drag(from, to) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 10, from.y + 12, { steps: 3 });
  await page.mouse.move(to.x, to.y, { steps: 12 });
  await page.mouse.up();
}

/** Drags a new block from the toolbox to a place. */
async function add(group, words, to) {
  const { x, y, width, height } = await page.locator(`.blocklyToolboxCategory >> text="${group}"`).boundingBox();
  await page.mouse.click(x + width / 2, y + height / 2);
  const from = await blockOf(words, ".blocklyFlyout");
  await drag({ x: from.x + 8, y: from.y + 8 }, to);
}

/** Types into a field of a block. */
async function write(words, field, value) {
  const from = await blockOf(words);
  const box = await page.evaluate(([x, y, field]) => {
    const block = document.elementFromPoint(x, y).closest("[data-id]");
    const fields = [...block.querySelectorAll(".blocklyEditableField")].filter((it) => it.closest("[data-id]") === block);
    const { x: left, y: top, width, height } = fields[field].getBoundingClientRect();
    return { x: left + width / 2, y: top + height / 2 };
  }, [from.x + 6, from.y + 8, field]);
  await page.mouse.click(box.x, box.y);
  await page.waitForSelector(".blocklyHtmlInput");
  await page.keyboard.press("Control+A");
  await page.keyboard.type(value);
  await page.keyboard.press("Enter");
}

test("blocks are dragged into a program, a field is typed, and text and table follow; the arm goes there", async () => {
  await type(`# kept
[points]
left = { x = 200, y = 80, z = 40 } # measured

[[steps]]
go = "left"
path = "movj" # not over the cup
`);
  const go = await blockOf("go to");
  await add("Set", "speed", { x: go.x + 12, y: go.y + go.height + 6 });
  await waitForText("speed = { percent = 50 }");
  await write("speed", 0, "80");
  await waitForText("percent = 80");
  const now = await text();
  for (const comment of ["# kept", "# measured", "# not over the cup"]) assert.ok(now.includes(comment), now);
  assert.ok(now.indexOf('go = "left"') < now.indexOf("speed ="), now);
  await write("point left", 2, "-60");
  await waitForText("y = -60");
  await view("table");
  assert.deepEqual(await page.locator(".step").count(), 2);
  await view("blocks");
  const from = traffic.packets.length;
  await page.waitForFunction(() => !document.querySelector("#teach-once").disabled);
  await page.click("#teach-once");
  await traffic.next(from, ({ floats: [state] }) => state === 3);
  await page.waitForFunction(() => Math.abs(Number(document.querySelector("[data-pose=y_mm]").textContent) + 60) < 0.5);
  assert.deepEqual(new Set(traffic.targets(from).map((it) => it.map(Math.round).join())), new Set(["200,-60,40"]));
  await page.waitForFunction(() => document.querySelector("#no-job"));
});

test("a step is dragged to another place, and an undo in the page brings it back", async () => {
  await type('[[steps]]\ngo = { x = 210, y = 0, z = 40 }\n\n# slow\n[[steps]]\nspeed = { percent = 20 }\n');
  await waitForText("# slow");
  const before = await text();
  const [go, speed] = [await blockOf("go to"), await blockOf("speed")];
  await drag({ x: speed.x + 6, y: speed.y + 10 }, { x: go.x + 10, y: go.y + 12 });
  await page.waitForFunction(() => { const it = localStorage.getItem("dobot.program"); return it.includes("# slow") && it.indexOf("speed =") < it.indexOf("go ="); });
  await page.click("#teach-undo");
  await page.waitForFunction((before) => localStorage.getItem("dobot.program") === before, before);
  while ((await blockOf("speed")).y < (await blockOf("go to")).y) await passed(page, 0.1);
});

test("a step dragged out of the program is not in the text, and comes back only once", async () => {
  await type('[[steps]]\ngo = { x = 210, y = 0, z = 40 }\n\n[[steps]]\nspeed = { percent = 20 }\n');
  const speed = await blockOf("speed");
  await drag({ x: speed.x + 6, y: speed.y + 10 }, { x: speed.x + 250, y: speed.y + 120 });
  await page.waitForFunction(() => !localStorage.getItem("dobot.program").includes("speed"));
  await page.waitForSelector(".is-loose");
  await page.click("#teach-undo");
  await waitForText("speed");
  await page.waitForFunction(() => !document.querySelector(".is-loose"));
  await blockOf("speed");
});

test("an edit of the text changes the blocks, and a problem marks its block", async () => {
  await type('[[steps]]\ngo = { x = 210, y = 0, z = 40 }\n[[steps]]\nrepeat = 2\n[[steps.steps]]\ngo = { x = 900, y = 0, z = 0 }\n');
  await page.waitForFunction(() => document.querySelectorAll(".is-bad").length === 1);
  assert.match(await page.textContent(".is-bad"), /900/);
  await type('[[steps]]\npick = { x = 210, y = 0, z = 40 }\n');
  await blockOf("pick up at");
  await page.waitForFunction(() => !document.querySelector(".is-bad"));
});

test("every example program opens as blocks and stays the same text", async () => {
  const folder = new URL("../../examples/programs/", import.meta.url);
  for (const name of (await readdir(folder)).filter((it) => it.endsWith(".toml"))) {
    const program = await readFile(new URL(name, folder), "utf8");
    await type(program);
    const same = await page.evaluate(async (program) => {
      const [{ createWorkspace, keyOf }, { Shapes }, { parse }, schema] = await Promise.all([import("/blocks/workspace.js"), import("/blocks/shapes.js"), import("/vendor/smol-toml/index.js"), fetch("/program.schema.json").then((it) => it.json())]);
      const host = document.body.appendChild(document.createElement("div"));
      const workspace = createWorkspace(host, { shapes: new Shapes(schema), language: "zh", t: (key) => key, changed: () => {}, chosen: () => {}, here: () => null });
      workspace.show(parse(program));
      const made = keyOf(workspace.program());
      workspace.dispose();
      host.remove();
      return made === keyOf(parse(program));
    }, program);
    assert.ok(same, name);
    await page.waitForFunction((program) => localStorage.getItem("dobot.program") === program, program);
  }
});
