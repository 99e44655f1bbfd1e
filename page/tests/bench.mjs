// A virtual arm, a station and a browser, as a person has them; and what the arm was told.
import { once } from "node:events";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { createConnection, createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";
import { end, start } from "./program.mjs";

const CHROMIUM = process.env.CHROMIUM ?? "/usr/bin/chromium";
const PACKET_LEN = 42;
// Drawn by the processor, so that it runs everywhere.
const WEBGL = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

/** Ten floats for each packet to the arm, and when it passed. */
class Told {
  #rest = Buffer.alloc(0);
  packets = [];

  take(bytes) {
    this.#rest = Buffer.concat([this.#rest, bytes]);
    while (this.#rest.length >= PACKET_LEN) {
      const floats = Array.from({ length: 10 }, (_, n) => this.#rest.readFloatLE(1 + 4 * n));
      this.packets.push({ at: performance.now(), floats });
      this.#rest = this.#rest.subarray(PACKET_LEN);
    }
  }

  /** The Cartesian targets from a packet on: x, y and z. */
  targets(from = 0) {
    return this.packets.slice(from).filter(({ floats: [state] }) => state === 3).map(({ floats }) => floats.slice(2, 5));
  }

  /** The jog packets from one on: `joint 3`, `linear 0` for a release. Those of the laser are none. */
  jogs(from = 0) {
    return this.packets.slice(from).filter(({ floats: [state, axis] }) => (state === 2 || state === 7) && axis < 9)
      .map(({ at, floats: [state, axis] }) => ({ at, text: `${state === 2 ? "joint" : "linear"} ${axis}` }));
  }
}

const TYPES = { html: "text/html", css: "text/css", js: "text/javascript" };

/** With FILES=disk the page is that of the folder, so that nothing has to be built after a change of it. */
async function serveFromDisk(context, station) {
  if (process.env.FILES !== "disk") return;
  await context.route((url) => url.href.startsWith(station) && !url.pathname.startsWith("/api/"), async (route) => {
    const { pathname } = new URL(route.request().url());
    const name = pathname === "/" ? "/index.html" : pathname;
    const body = await readFile(new URL(`../files${name}`, import.meta.url)).catch(() => null);
    if (!body) return route.continue();
    const headers = { ...(await route.fetch({ url: station })).headers(), "content-type": `${TYPES[name.split(".").at(-1)] ?? "text/plain"}; charset=utf-8`, "content-length": String(body.length) };
    return route.fulfill({ body, headers });
  });
}

/** Everything that a test needs; `end` ends it. With `virtual` the arm is the station's own, whose world it tells; nothing taps it. */
export async function open({ viewport = { width: 1440, height: 900 }, webgl = false, virtual = false, options = {} } = {}) {
  const folder = await mkdtemp(join(tmpdir(), "dobot-page-"));
  const arm = virtual ? null : await start(["arm", "--tcp", "127.0.0.1:0", "--personality", "firmware-1.1"], /^tcp:127\.0\.0\.1:(\d+)/);
  const told = new Told();
  const tap = createServer((station) => {
    const way = createConnection({ port: Number(arm?.found), host: "127.0.0.1", noDelay: true });
    station.setNoDelay(true);
    station.on("data", (bytes) => told.take(bytes));
    station.pipe(way).pipe(station);
    for (const one of [station, way]) one.on("error", () => {});
  });
  tap.listen(0, "127.0.0.1");
  await once(tap, "listening");
  const to = virtual ? ["--virtual"] : ["--arm", `tcp:127.0.0.1:${tap.address().port}`];
  const station = await start(
    ["up", ...to, "--dialect", "firmware-1.1", "--http", "127.0.0.1:0", "--raw", "off", "--data", folder],
    /page +(http:\S+)/,
  );
  const browser = await chromium.launch({ executablePath: CHROMIUM, args: ["--no-sandbox", "--disable-background-networking", "--disable-features=LocalNetworkAccessChecks", ...(webgl ? WEBGL : ["--disable-gpu", "--disable-3d-apis"])] });
  const context = await browser.newContext({ viewport, ...options });
  await serveFromDisk(context, station.found);
  const page = await context.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(error));
  await page.goto(station.found);
  return {
    page, told, errors, context, station,
    /** What the station answers at a path of the API. */
    ask: async (path) => (await fetch(new URL(path, station.found))).json(),
    async end() {
      await browser.close();
      await end(station.child, "SIGINT");
      if (arm) await end(arm.child, "SIGINT");
      tap.close();
      await rm(folder, { recursive: true });
    },
  };
}

/** Confirms the pose and takes control, as a person does. */
export async function takeControl(page) {
  await page.click("#confirm-pose");
  await page.click("#sure-yes");
  await page.click("#take");
  await page.waitForFunction(() => document.querySelector("#holder").textContent === "You have control.");
  await page.waitForFunction(() => !document.querySelector("[data-axis=x_plus]").disabled);
}

/** A number of the pose. */
export async function pose(page, name) {
  return Number(await page.textContent(`[data-pose=${name}]`));
}

/** Waits until the arm rests. */
export async function rest(page) {
  await page.waitForFunction(() => document.querySelector("#moving").textContent === "at rest");
}

/** Presses the mouse button over a jog button. */
export async function press(page, axis) {
  await page.hover(`[data-axis=${axis}]:visible`);
  await page.mouse.down();
}

/** Waits until a number of the pose has changed by so much, either way. */
export async function moved(page, name, by) {
  const from = await pose(page, name);
  const has = ([name, from, by]) => Math.abs(Number(document.querySelector(`[data-pose=${name}]`).textContent) - from) >= by;
  await page.waitForFunction(has, [name, from, by]);
}

/** Which jog button lies at the middle of this one, if it was not moved. */
export async function buttonAt(page, { x, y, width, height }) {
  const at = [x + width / 2, y + height / 2];
  return page.evaluate(([x, y]) => document.elementFromPoint(x, y)?.closest("button")?.dataset.axis, at);
}
