// Programs as blocks, built with a real pointer, and judged on the text, on the table and on where the arm goes.
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { after, afterEach, before, test } from "node:test";
import { open, passed, rest, takeControl, waitForAnswer } from "./bench.mjs";

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
const blockOf = (words, canvas = CANVAS, n = 0, on = page) =>
  on.waitForFunction(([words, canvas, n]) => {
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
  await page.waitForFunction(() => document.querySelectorAll(".step").length === 2);
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

/** Goes to the blocks of the program with the keyboard. */
async function tabToBlocks() {
  for (let n = 0; n < 40 && !(await page.evaluate(() => document.activeElement?.closest(".blocks-host"))); n += 1) await page.keyboard.press("Tab");
  await page.keyboard.press("w");
}

/** Presses a key until what has the focus in the next frame is announced with these words. */
async function keyTo(key, words) {
  const announced = () => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => done(document.activeElement?.getAttribute("aria-label") ?? ""))));
  for (let n = 0; n < 30 && !(await announced()).includes(words); n += 1) await page.keyboard.press(key);
  assert.ok((await announced()).includes(words), await announced());
}

/** Lets the page draw no frame until its `letDraw`, as while it is busy. */
const holdFrames = () => page.evaluate(() => {
  const held = [], { requestAnimationFrame } = window;
  window.requestAnimationFrame = (frame) => held.push(frame);
  window.letDraw = (isReversed) => {
    window.requestAnimationFrame = requestAnimationFrame;
    for (const frame of isReversed ? held.reverse() : held) frame(performance.now());
  };
});

test("a key that is typed while the text of the previous one comes back is kept", async () => {
  await type('[[steps]]\ngo = { x = 210, y = 0, z = 40 }\n\n[[steps]]\nspeed = { percent = 20 }\n');
  await blockOf("speed");
  let answer;
  await page.route("**/merge", (route) => void (answer = () => route.continue()), { times: 1 });
  const field = await page.locator(`${CANVAS} [data-id] .blocklyEditableField`, { hasText: "20" }).last().boundingBox();
  await page.mouse.click(field.x + field.width / 2, field.y + field.height / 2);
  await page.waitForSelector(".blocklyHtmlInput");
  await page.keyboard.press("Control+A");
  await page.keyboard.press("3");
  while (!answer) await passed(page, 0.1);
  // The next key is in its field, and the editor says so after the page has drawn the text with its title.
  await holdFrames();
  await page.keyboard.press("5");
  await answer();
  await waitForText("title = ");
  await page.evaluate(() => window.letDraw(true));
  await page.keyboard.press("Enter");
  await waitForText("percent = 35");
});

test("keys that are typed before the page draws the next frame act on the same block", async () => {
  await type('[[steps]]\ngo = { x = 210, y = 0, z = 40 }\n\n[[steps]]\nspeed = { percent = 20 }\n');
  await tabToBlocks();
  await keyTo("ArrowDown", "speed %");
  await holdFrames();
  for (const key of ["m", "ArrowUp", "Enter"]) await page.keyboard.press(key);
  await page.evaluate(() => window.letDraw());
  await page.waitForFunction(() => { const it = localStorage.getItem("dobot.program"); return it.indexOf("speed =") < it.indexOf("go ="); });
  await keyTo("ArrowUp", "End steps");
  await holdFrames();
  // Away from the end of the steps, which is to be brought to the front, and back, and away.
  for (const key of ["ArrowUp", "ArrowDown", "ArrowUp"]) await page.keyboard.press(key);
  await page.evaluate(() => window.letDraw());
  await page.keyboard.press("Delete");
  await page.waitForFunction(() => !localStorage.getItem("dobot.program").includes("go ="));
});

test("with the keyboard alone a block is moved, its field is typed, and it is removed", async () => {
  await type('[[steps]]\ngo = { x = 210, y = 0, z = 40 }\n\n[[steps]]\nspeed = { percent = 20 }\n');
  await tabToBlocks();
  await keyTo("ArrowDown", "speed %");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await page.waitForSelector(".blocklyHtmlInput");
  await page.keyboard.press("Control+A");
  await page.keyboard.press("3");
  // The text follows each key, and gets a title; the field stays open.
  await waitForText('title = ');
  await page.keyboard.press("5");
  await page.keyboard.press("Enter");
  await waitForText("percent = 35");
  await keyTo("ArrowUp", "speed %");
  await page.keyboard.press("m");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => { const it = localStorage.getItem("dobot.program"); return it.indexOf("speed =") < it.indexOf("go ="); });
  await page.keyboard.press("Delete");
  await page.waitForFunction(() => !localStorage.getItem("dobot.program").includes("speed"));
  assert.equal(await page.isVisible("#stopped"), false);
});

test("the buttons below act on the selected block: it gets the place of the arm, and is removed", async () => {
  await type('title = "two"\n[[steps]]\ngo = { x = 210, y = 0, z = 40 }\n\n[[steps]]\nspeed = { percent = 20 }\n');
  const arm = (await bench.ask("api/v1/state")).arm;
  const go = await blockOf("go to");
  await page.mouse.click(go.x + 6, go.y + 10);
  await page.click("#blocks-here");
  await page.waitForFunction((z) => Math.abs(Number(/z = ([-\d.]+)/.exec(localStorage.getItem("dobot.program"))?.[1]) - z) < 0.011, arm.z_mm);
  const speed = await blockOf("speed");
  await page.mouse.click(speed.x + 6, speed.y + 10);
  await page.click("#blocks-remove");
  await page.waitForFunction(() => !localStorage.getItem("dobot.program").includes("speed"));
});

test("a finger drags a block to another place, types into a field, and removes a block with a button", async () => {
  const phone = await bench.visit({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const includes = (isSo, argument) => phone.waitForFunction(isSo, argument);
  await phone.tap("#tab-teach");
  await phone.setInputFiles("#teach-file", { name: "two.toml", mimeType: "text/plain", buffer: Buffer.from('title = "two"\n\n[[steps]]\ngo = { x = 210, y = 0, z = 40 }\n\n[[steps]]\nspeed = { percent = 20 }\n') });
  await phone.tap("[name=teach-mode][value=blocks]");
  await phone.waitForSelector(`${CANVAS} > [data-id]`);
  await phone.locator(".blocks-host").evaluate((it) => it.scrollIntoView({ block: "center" }));
  const cdp = await phone.context().newCDPSession(phone);
  const touch = (type, ...points) => cdp.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
  const [go, speed] = [await blockOf("go to", CANVAS, 0, phone), await blockOf("speed", CANVAS, 0, phone)];
  const from = [speed.x + 6, speed.y + 10], to = [go.x + 10, go.y + 8];
  await touch("touchStart", from);
  for (const share of [0.2, 0.4, 0.6, 0.8, 1]) await touch("touchMove", [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]);
  await touch("touchEnd");
  await includes(() => { const it = localStorage.getItem("dobot.program"); return it.indexOf("speed =") < it.indexOf("go ="); });
  const field = await phone.locator(`${CANVAS} [data-id] .blocklyEditableField`, { hasText: "20" }).last().boundingBox();
  await phone.touchscreen.tap(field.x + field.width / 2, field.y + field.height / 2);
  await phone.waitForSelector(".blocklyHtmlInput");
  await phone.keyboard.press("Control+A");
  await phone.keyboard.type("45");
  await phone.keyboard.press("Enter");
  await includes(() => localStorage.getItem("dobot.program").includes("percent = 45"));
  const again = await blockOf("speed", CANVAS, 0, phone);
  await phone.touchscreen.tap(again.x + 6, again.y + 10);
  await phone.tap("#blocks-remove");
  await includes(() => !localStorage.getItem("dobot.program").includes("speed"));
  await phone.context().close();
});

/** What the vendor's files say: base, rear arm, forearm and servo of each point, in degrees. */
const VENDOR = {
  "PlayBackPoints.xml": [[0, 30, 20, 0], [25.3125, 48.7, 52.25, -25.3], [-31.8, 36.686, 48.769, 31.8], [-10, 40, 30, 0]],
  "program.play": [[0, 45, 45, 0], [31.8, 36.686, 18.769, 0], [-20.5, 40.25, 30.125, 0], [0, 45, 45, 0]],
};

test("the vendor's programs open as blocks, and the arm goes to their angles", async () => {
  const folder = new URL("../../crates/teach/tests/data/", import.meta.url);
  for (const [name, angles] of Object.entries(VENDOR)) {
    await page.setInputFiles("#teach-file", { name, mimeType: "text/plain", buffer: await readFile(new URL(name, folder)) });
    await blockOf("go to", CANVAS, angles.length - 1);
    await page.waitForSelector("#teach-once:enabled");
    const from = traffic.packets.length;
    await page.click("#teach-once");
    await waitForAnswer(page, "api/v1/state", ({ job }) => job?.phase === "running");
    await waitForAnswer(page, "api/v1/state", ({ job, arm }) => !job && !arm.moving);
const sent = traffic.packets.slice(from).filter(({ floats: [state] }) => state === 6).map(({ floats }) => floats.slice(2, 6).map((deg) => Number(deg.toFixed(4))));
    assert.deepEqual(sent, angles);
  }
});

// Last: its second workspace has the words of another language.
test("every example program opens as blocks and stays the same text", async () => {
  const folder = new URL("../../examples/programs/", import.meta.url);
  for (const name of (await readdir(folder)).filter((it) => it.endsWith(".toml"))) {
    const program = await readFile(new URL(name, folder), "utf8");
    await type(program);
    const same = await page.evaluate(async (program) => {
      // The station serves its files in a folder that is named after their version.
      const version = document.querySelector("meta[name=dobot-page]")?.content;
      const files = version ? `/${version}/` : "/";
      const [{ createWorkspace, keyOf }, { Shapes }, { parse }, schema] = await Promise.all([...["blocks/workspace.js", "blocks/shapes.js", "vendor/smol-toml/index.js"].map((path) => import(files + path)), fetch(`${files}program.schema.json`).then((it) => it.json())]);
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
