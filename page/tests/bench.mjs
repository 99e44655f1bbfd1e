// Test bench: a virtual arm, a station, a browser, and the traffic to the arm.
import { EventEmitter, once } from "node:events";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { createConnection, createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout } from "node:timers/promises";
import { launch, leave, visitor } from "./browser.mjs";
import { end, start } from "./program.mjs";

const PACKET_LEN = 42;

/** Laser off, with which every stop begins. */
export const isStop = ({ floats: [state, axis] }) => state === 2 && axis === 14;
/** A jog button that is pressed. */
export const isJog = ({ floats: [state, axis] }) => (state === 2 || state === 7) && axis > 0 && axis < 9;

/** The packets to the arm: ten floats and a time each. */
class Traffic {
  #rest = Buffer.alloc(0);
  #came = new EventEmitter();
  packets = [];

  take(bytes) {
    this.#rest = Buffer.concat([this.#rest, bytes]);
    while (this.#rest.length >= PACKET_LEN) {
      const floats = Array.from({ length: 10 }, (_, n) => this.#rest.readFloatLE(1 + 4 * n));
      this.packets.push({ at: performance.now(), floats });
      this.#rest = this.#rest.subarray(PACKET_LEN);
    }
    this.#came.emit("packets");
  }

  /** Returns the first matching packet from an index on, or undefined after the timeout. */
  async next(from, isSo, within_ms = 10_000) {
    const signal = AbortSignal.timeout(within_ms);
    for (;;) {
      const found = this.packets.slice(from).find(isSo);
      if (found || signal.aborted) return found;
      await once(this.#came, "packets", { signal }).catch(() => {});
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

const TYPES = { html: "text/html", css: "text/css", js: "text/javascript", svg: "image/svg+xml" };
/** What the station says of its own files only. */
const OF_STATION = ["content-encoding", "transfer-encoding", "etag"];

/** With FILES=disk the page is that of the folder, so that nothing has to be built after a change of it. */
export async function serveFromDisk(context, station) {
  if (process.env.FILES !== "disk") return;
  const as = (await fetch(station)).headers;
  await context.route((url) => url.href.startsWith(station) && !url.pathname.startsWith("/api/"), async (route) => {
    const { pathname } = new URL(route.request().url());
    const name = pathname === "/" ? "/index.html" : pathname === "/fleet" ? "/fleet/index.html" : pathname;
    const body = await readFile(new URL(`../files${name}`, import.meta.url)).catch(() => null);
    if (!body) return route.continue();
    const common = [...as].filter(([name]) => !OF_STATION.includes(name));
    const headers = { ...Object.fromEntries(common), "cache-control": "no-store", "content-type": `${TYPES[name.split(".").at(-1)] ?? "text/plain"}; charset=utf-8`, "content-length": String(body.length) };
    return route.fulfill({ body, headers });
  });
}

/** A way to a station that can be slow or cut, and that stays where it is when the station begins anew at another port. */
async function createFront() {
  /** What is on its way while the way is cut arrives afterwards. @type {(() => void)[] | null} */
  let held = null;
  const way = {
    port: 0, delay_ms: 0,
    cut: () => (held ??= []),
    mend() {
      const all = held ?? [];
      held = null;
      for (const action of all) action();
    },
  };
  const later = (action) => void globalThis.setTimeout(() => (held ? held.push(action) : action()), way.delay_ms);
  const late = (from, to, change = (bytes) => bytes) => {
    from.on("data", (bytes) => later(() => to.writable && to.write(change(bytes))));
    for (const ending of ["end", "close", "error"]) from.on(ending, () => later(() => to.destroy()));
  };
  const server = createServer({ noDelay: true }, (client) => {
    const station = createConnection({ port: way.port, host: "127.0.0.1", noDelay: true });
    late(client, station, named);
    late(station, client);
  });
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = server.address();
  // A station answers to its own name only.
  const named = (bytes) => Buffer.from(bytes.toString("latin1").replaceAll(`127.0.0.1:${port}`, `127.0.0.1:${way.port}`), "latin1");
  return { server, way, url: `http://127.0.0.1:${port}/` };
}

/**
 * Everything that a test needs; `end` ends it. With `virtual` the arm is the station's own, whose world it tells; nothing taps it.
 * `speed` is for what only has to come about: the arm's time passes so many times as fast as a clock. A page that is late to say
 * that a button is still held, as on a busy machine, lets go of it; with `patient` it has a second, which is longer than it has.
 * `personality` is the arm's personality and the station's dialect, `executablePath` the browser.
 */
export async function open({ viewport = { width: 1130, height: 640 }, webgl = false, virtual = false, personality = "firmware-1.1", speed = 1, patient = true, options = {}, scripts = [], browserArgs = [], executablePath } = {}) {
  const folder = await mkdtemp(join(tmpdir(), "dobot-page-"));
  const arm = virtual ? null : await start(["arm", "--tcp", "127.0.0.1:0", "--personality", personality, "--time-factor", String(speed)], /^tcp:127\.0\.0\.1:(\d+)/);
  const traffic = new Traffic();
  const tap = createServer((station) => {
    const way = createConnection({ port: Number(arm?.found), host: "127.0.0.1", noDelay: true });
    station.setNoDelay(true);
    station.on("data", (bytes) => traffic.take(bytes));
    station.pipe(way).pipe(station);
    // A connection that is reset ends the other one, too: the arm takes the next client only when this one is gone.
    for (const [one, other] of [[station, way], [way, station]]) one.on("error", () => {}).on("close", () => other.end());
  });
  tap.listen(0, "127.0.0.1");
  await once(tap, "listening");
  // What the station's own virtual arm speaks, it knows.
  const to = virtual ? ["--virtual", "--time-factor", String(speed)] : ["--arm", `tcp:127.0.0.1:${tap.address().port}`, "--dialect", personality];
  const front = await createFront();
  const begin = async () => {
    const words = ["up", ...to, "--http", "127.0.0.1:0", "--raw", "off", "--data", folder];
    const begun = await start(words, /page +http:\S+:(\d+)/);
    front.way.port = Number(begun.found);
    return begun.child;
  };
  let child = await begin();
  /** How long a button counts as held of which nothing is heard; as a station has it without an argument. */
  async function setDeadMan(seconds) {
    const text = seconds ? `[jog]\ndead_man_s = ${seconds}\n` : "";
    const answer = await fetch(new URL("api/v1/policy", front.url), { method: "PUT", headers: { "content-type": "application/json" }, body: JSON.stringify({ text }) });
    if (!answer.ok) throw new Error(await answer.text());
  }
  if (patient) await setDeadMan(1);
  const browser = await launch(executablePath, browserArgs);
  const errors = [];
  /** One more visitor, whose page runs scripts of the test before its own. */
  async function visit(options, scripts = []) {
    const context = await visitor(browser, { webgl, ...options });
    for (const script of [scripts].flat()) await context.addInitScript(script);
    await serveFromDisk(context, front.url);
    const page = await context.newPage();
    page.on("pageerror", (error) => errors.push(error));
    await enter(page);
    return page;
  }
  /** Opens the page, or opens it anew. */
  async function enter(page) {
    await page.goto(front.url);
    await page.waitForFunction(() => document.querySelector("[data-pose=x_mm]")?.textContent !== "–");
  }
  const page = await visit({ viewport, ...options }, scripts);
  return {
    page, traffic, errors, visit, enter, setDeadMan, folder, url: front.url,
    /** Makes all that is said between browser and station late, both ways. */
    slow: (delay_ms) => (front.way.delay_ms = delay_ms),
    /** Lets nothing pass any more between browser and station, without an end of any connection; `mend` lets it pass. */
    cut: front.way.cut,
    mend: front.way.mend,
    /** Ends the arm, as if its cable was pulled out. */
    unplug: () => end(arm.child, "SIGKILL"),
    /** Kills the station, and begins another one with its data. */
    async restart(signal = "SIGKILL") {
      await end(child, signal);
      child = await begin();
    },
    /** What the station answers at a path of the API. */
    ask: async (path) => (await fetch(new URL(path, front.url))).json(),
    async end() {
      await leave(browser);
      front.server.close();
      await end(child, "SIGINT");
      if (arm) await end(arm.child, "SIGINT");
      tap.close();
      await rm(folder, { recursive: true });
    },
  };
}

/** Confirms the pose and takes control, as a person does. */
export async function takeControl(page) {
  // While the 3-D view loads, the page may lose its connection for a moment.
  await page.waitForSelector("#link-chip[data-tone=good]");
  await page.click("#confirm-pose");
  await page.click("#confirm-yes");
  await page.waitForSelector("#confirm-pose", { state: "detached" });
  await page.click("#take");
  await page.waitForFunction(() => document.querySelector("#holder").textContent === "You have control.");
  await page.waitForFunction(() => !document.querySelector("[data-axis=x_plus]").disabled);
}

/**
 * Types a place for the arm to go to, as a person does: one field after the other. With the first one the others get where
 * the arm is, in the next picture; what was typed before that would be put behind it.
 */
export async function typeTarget(page, place) {
  for (const [name, value] of Object.entries(place)) {
    await page.fill(`#target-${name}`, String(value));
    await page.waitForFunction(() => [...document.querySelectorAll("#target .fields input")].filter((it) => it !== document.activeElement).every((it) => it.value !== ""));
  }
}

/** A number of the pose. */
export async function pose(page, name) {
  return Number(await page.textContent(`[data-pose=${name}]`));
}

/** Waits until the arm rests. */
export async function rest(page) {
  await page.waitForFunction(() => document.querySelector("#moving").textContent === "at rest");
}

/** Waits until what the station answers at a path is so. (`waitForFunction` takes the promise of an async function for true.) */
export async function waitForAnswer(page, path, isSo) {
  for (let tries = 0; tries < 600; tries += 1) {
    const answer = await (await fetch(new URL(path, page.url()))).json();
    if (isSo(answer)) return answer;
    await setTimeout(50);
  }
  throw new Error(`${path} never answers what was waited for: ${isSo}`);
}

/** Waits for the content of a tab's panel: some panels are loaded when they are first shown. */
export async function panelIsShown(page, tab) {
  await page.waitForFunction((label) => {
    const panel = document.getElementById("panel");
    return panel.getAttribute("aria-labelledby") === label && panel.childElementCount > 0;
  }, `tab-${tab}`);
}

/** Opens the view Draw at a virtual arm with a pen. */
export async function openDraw() {
  const bench = await open({ virtual: true, speed: 8 });
  const { page, url } = bench;
  await fetch(`${url}api/v1/world`, { method: "PUT", headers: { "content-type": "application/json" }, body: JSON.stringify({ scene: "[pen]\ndown_z_mm = -40\n" }) });
  if (await page.isVisible("#confirm-pose")) {
    await page.click("#confirm-pose");
    await page.click("#confirm-yes");
  }
  await page.click("#first-close");
  await page.click("#tab-draw");
  return bench;
}

/** What is in a file that the page handed out. */
export async function contents(download) {
  return Buffer.concat(await (await download.createReadStream()).toArray());
}

/** Waits until so much of the station's time has passed. */
export async function passed(page, seconds) {
  const { at_s } = await waitForAnswer(page, "api/v1/state", () => true);
  await waitForAnswer(page, "api/v1/state", (it) => it.at_s > at_s + seconds);
}

/** Presses the mouse button over a jog button. */
export async function press(page, axis) {
  await page.hover(`[data-axis=${axis}]:visible`);
  await page.mouse.down();
}

/** Takes control of an arm and moves it with a button, until the arm tells that it has moved. */
export async function takeAndMove(page) {
  await page.click("#take");
  await page.waitForSelector("[data-axis=x_plus]:enabled");
  const before = await pose(page, "x_mm");
  await press(page, "x_plus");
  await page.waitForFunction((before) => Number(document.querySelector("[data-pose=x_mm]").textContent) > before + 2, before);
  await page.mouse.up();
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
