// Starts a browser for the tests.
import { existsSync } from "node:fs";
import { chromium } from "playwright-core";

export const CHROMIUM = process.env.CHROMIUM ?? "/usr/bin/chromium";
/** Chromium without windows, a separate package in Debian: tests take half the CPU time. It does not show notifications. */
const SHELL = `${CHROMIUM}-headless-shell`;
// WebGL is drawn by the processor, so that it runs everywhere, or with CARD=1 by a graphics card. All else is drawn without WebGL:
// a page that the processor draws by way of it takes ten times as long.
const ARGS = ["--no-sandbox", "--disable-background-networking", "--disable-features=LocalNetworkAccessChecks", ...(process.env.CARD ? [] : ["--disable-gpu", "--enable-unsafe-swiftshader"])];
/** However busy the machine is. */
const PATIENCE_MS = Number(process.env.PATIENCE_MS ?? 120_000);

/** A browser: Chromium's shell if it is installed, otherwise Chromium. @param {readonly string[]} [more] */
export async function launch(executablePath = existsSync(SHELL) ? SHELL : CHROMIUM, more = []) {
  if (!existsSync(executablePath)) throw new Error(`there is no Chromium at ${executablePath}: install it, on Debian with apt-get install chromium, or set CHROMIUM to its path`);
  return chromium.launch({ executablePath, args: [...ARGS, ...more] });
}

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
