// The browser of the tests: one for all files that `run.mjs` runs, and one of its own for a file that is run alone.
import { existsSync } from "node:fs";
import { chromium } from "playwright-core";

const CHROMIUM = process.env.CHROMIUM ?? "/usr/bin/chromium";
/** Where the browser for all files is. */
const SHARED = process.env.BROWSER_ENDPOINT;
// WebGL is drawn by the processor, so that it runs everywhere, or with CARD=1 by a graphics card. All else is drawn without WebGL:
// a page that the processor draws by way of it takes ten times as long.
const ARGS = ["--no-sandbox", "--disable-background-networking", "--disable-features=LocalNetworkAccessChecks", ...(process.env.CARD ? [] : ["--disable-gpu", "--enable-unsafe-swiftshader"])];
/** However busy the machine is. */
const PATIENCE_MS = Number(process.env.PATIENCE_MS ?? 120_000);

function options(executablePath, more = []) {
  if (!existsSync(executablePath)) throw new Error(`there is no Chromium at ${executablePath}: install it, on Debian with apt-get install chromium, or say where it is with CHROMIUM=PATH`);
  return { executablePath, args: [...ARGS, ...more] };
}

/** Starts the browser for all files. */
export const serve = async () => chromium.launchServer(options(CHROMIUM));

/** A browser; with arguments of its own, one that is not shared. @param {readonly string[]} [more] */
export const launch = async (executablePath = CHROMIUM, more = []) => (SHARED && more.length === 0 ? chromium.connect(SHARED) : chromium.launch(options(executablePath, more)));

/** Ends what a file has opened: its pages are gone before what they talk to is. */
export async function leave(browser) {
  await Promise.all(browser.contexts().map((context) => context.close()));
  await browser.close();
}

/** A visitor who has seen nothing of this browser yet. Without `webgl` there is none, and the stage is drawn in two dimensions, which costs little. */
export async function visitor(browser, { webgl = false, ...options } = {}) {
  // A service worker would load pages past the files of `FILES=disk`.
  const context = await browser.newContext({ serviceWorkers: "block", ...options });
  context.setDefaultTimeout(PATIENCE_MS);
  if (!webgl) await context.addInitScript(hideWebgl);
  await context.addInitScript(countFrames);
  return context;
}

/** Waits until the page has drawn all that it has to draw. */
export async function drawn(page) {
  // Sizes and what comes into sight are told with a frame.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  await page.waitForFunction(() => window.frames_asked === 0, undefined, { polling: 20 });
}

/** Counts the frames that the page has asked for and that have not come yet, and those that it will ask for after a wait. */
function countFrames() {
  const [request, cancel] = [window.requestAnimationFrame.bind(window), window.cancelAnimationFrame.bind(window)];
  const [later, never] = [window.setTimeout.bind(window), window.clearTimeout.bind(window)];
  const asked = new Set(), timers = new Map();
  const told = () => (window.frames_asked = asked.size);
  told();
  window.requestAnimationFrame = (action) => {
    const frame = request((now_ms) => {
      asked.delete(frame);
      told();
      action(now_ms);
    });
    asked.add(frame);
    told();
    return frame;
  };
  window.cancelAnimationFrame = (frame) => {
    asked.delete(frame);
    told();
    cancel(frame);
  };
  window.setTimeout = (action, ...all) => {
    if (action.name !== "frameTimer") return later(action, ...all);
    const timer = later(() => {
      asked.delete(action);
      action();
      told();
    }, ...all);
    timers.set(timer, action);
    asked.add(action);
    told();
    return timer;
  };
  window.clearTimeout = (timer) => {
    asked.delete(timers.get(timer));
    timers.delete(timer);
    told();
    never(timer);
  };
}

function hideWebgl() {
  delete window.WebGL2RenderingContext;
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
    return kind.startsWith("webgl") ? null : getContext.call(this, kind, ...more);
  };
}
