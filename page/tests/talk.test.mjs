// Hold to talk, with a microphone that plays a tone and a listener that this test is: judged by the sound that arrives and by the
// packets to the arm. It needs the page of the program: FILES=disk does not reach the thread of the microphone.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, before, test } from "node:test";
import { WebSocket } from "ws";
import { isStop, open, takeControl } from "./bench.mjs";

const HERTZ = 1000, RATE = 48_000;
let bench, page, traffic, folder, me, listener, requests = 0;
/** What the listener got: the samples of each piece, empty at the end of what is said. */
let said = [];
let polls = true;

/** A WAV file of three seconds of a tone. */
function tone(path) {
  const samples = Int16Array.from({ length: 3 * RATE }, (_, n) => 8000 * Math.sin((2 * Math.PI * HERTZ * n) / RATE));
  const head = Buffer.alloc(44);
  head.write("RIFF", 0);
  head.writeUInt32LE(36 + samples.byteLength, 4);
  head.write("WAVEfmt ", 8);
  for (const [at, value, size] of [[16, 16, 4], [20, 1, 2], [22, 1, 2], [24, RATE, 4], [28, 2 * RATE, 4], [32, 2, 2], [34, 16, 2]]) head.writeUIntLE(value, at, size);
  head.write("data", 36);
  head.writeUInt32LE(samples.byteLength, 40);
  writeFileSync(path, Buffer.concat([head, Buffer.from(samples.buffer)]));
}

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "talk-"));
  const sound = join(folder, "tone.wav");
  tone(sound);
  bench = await open({
    browserArgs: ["--use-fake-ui-for-media-stream", "--use-fake-device-for-media-stream", `--use-file-for-fake-audio-capture=${sound}`],
    scripts: ["window.asked = 0; const { mediaDevices } = navigator; const ask = mediaDevices.getUserMedia.bind(mediaDevices); mediaDevices.getUserMedia = (wish) => { window.asked += 1; return ask(wish); };"],
  });
  ({ page, traffic } = bench);
  await takeControl(page);
});
after(async () => {
  polls = false;
  listener?.close();
  await bench?.end();
  rmSync(folder, { recursive: true });
});
afterEach(() => assert.deepEqual(bench.errors, []));

/** Does what a listener does: fetches the sound. */
async function poll() {
  while (polls) {
    const answer = await fetch(new URL("api/v1/talk/audio", bench.url)).catch(() => null);
    if (!answer?.ok) return;
    for (const { client, pcm } of await answer.json()) said.push({ client, samples: [...new Int16Array(new Uint8Array(Buffer.from(pcm, "base64")).buffer)] });
  }
}

/** Says what was understood. */
async function understand(heard) {
  if (!listener) {
    listener = new WebSocket(new URL("api/v1/ws?states=0&name=listener", bench.url).href.replace("http", "ws"));
    await new Promise((resolve) => listener.once("open", resolve));
  }
  listener.send(JSON.stringify({ id: (requests += 1), request: { type: "heard", client: me, heard } }));
}

async function until(isSo) {
  while (!isSo()) await new Promise((resolve) => setImmediate(() => setTimeout(resolve, 20)));
}

/** Holds the button until this page has sent so many pieces. */
async function hold(pieces) {
  said = [];
  await page.locator("#talk-hold").scrollIntoViewIfNeeded();
  const box = await page.locator("#talk-hold").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await until(() => said.length >= pieces);
  await page.mouse.up();
  await until(() => said.at(-1)?.samples.length === 0);
}

const waitForText = (part) => page.waitForFunction((part) => document.querySelector("#talk-heard")?.textContent.includes(part), part);

test("without a listener the page says how to start one, and asks for no microphone", async () => {
  await page.click("#voice summary");
  await page.waitForFunction(() => document.querySelector("#talk-off")?.textContent.includes("dobot_arm.listen"));
  assert.equal(await page.evaluate(() => window.asked), 0);
});

test("with a listener the microphone is asked for once, and its sound arrives only while the button is held", async () => {
  void poll();
  await page.waitForFunction(() => document.querySelector("#talk-hold")?.disabled === false);
  assert.equal(await page.evaluate(() => window.asked), 1);
  assert.deepEqual(said, []);
  await hold(8);
  ({ client: me } = said[0]);
  const samples = said.flatMap((piece) => piece.samples);
  const part = (wave) => samples.reduce((sum, sample, n) => sum + sample * wave((2 * Math.PI * HERTZ * n) / 16_000), 0);
  const strength = (2 * Math.hypot(part(Math.sin), part(Math.cos))) / samples.length;
  const power = Math.sqrt((2 * samples.reduce((sum, sample) => sum + sample * sample, 0)) / samples.length);
  assert.ok(power > 500 && strength > 0.5 * power, `${strength} of ${power}`);
});

test("an order is shown before anything moves, and moves the arm after Go, marked as the microphone's", async () => {
  const from = traffic.packets.length;
  await understand({ what: "order", words: "left ten" });
  await waitForText("left ten");
  assert.deepEqual(traffic.targets(from), []);
  await page.click("#talk-go");
  const moved = await traffic.next(from, ({ floats: [state, , , y] }) => state === 3 && y > 9);
  assert.ok(Math.abs(moved.floats[3] - 10) < 0.5, String(moved.floats));
  assert.equal(await page.isVisible("#talk-go"), false);
  const notices = await bench.ask("api/v1/notices").then((all) => all.notices ?? all);
  assert.ok(notices.some(({ type, text }) => type === "sensed" && text.includes("microphone: left ten")));
});

test("a spoken Go moves the arm, a spoken No and a button forget the order", async () => {
  for (const forget of [() => understand({ what: "no" }), () => page.click("#talk-no")]) {
    const from = traffic.packets.length;
    await understand({ what: "order", words: "right five" });
    await waitForText("right five");
    await forget();
    await page.waitForFunction(() => document.querySelector("#talk-go") === null);
    await understand({ what: "go" });
    await understand({ what: "nothing" });
    await waitForText("No command was understood");
    assert.deepEqual(traffic.targets(from), []);
  }
  const from = traffic.packets.length;
  await understand({ what: "order", words: "right five" });
  await waitForText("right five");
  await understand({ what: "go" });
  assert.ok(await traffic.next(from, ({ floats: [state, , , y] }) => state === 3 && y < 6));
});

test("what is said for another page is no order here", async () => {
  listener.send(JSON.stringify({ id: (requests += 1), request: { type: "heard", client: me + 1000, heard: { what: "order", words: "up ten" } } }));
  await understand({ what: "nothing" });
  await waitForText("No command was understood");
  assert.equal(await page.isVisible("#talk-go"), false);
});

test("a stop forgets the order", async () => {
  await understand({ what: "order", words: "left five" });
  await waitForText("left five");
  const from = traffic.packets.length;
  await page.keyboard.press("Escape");
  assert.ok(await traffic.next(from, isStop));
  await page.waitForFunction(() => document.querySelector("#talk-go") === null);
});

test("the microphone is off after the view closes", async () => {
  await page.click("#tab-jobs");
  await page.click("#tab-move");
  assert.equal(await page.isVisible("#talk-hold"), false);
  said = [];
  await page.click("#voice summary");
  await page.waitForFunction(() => document.querySelector("#talk-hold")?.disabled === false);
  assert.equal(await page.evaluate(() => window.asked), 2);
  assert.deepEqual(said, []);
});
