// The stage alone in a browser, served with the headers that a station sends.
import { once } from "node:events";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { PerspectiveCamera, Vector3 } from "three";
import { LENS_DEG, place, preset } from "../files/stage/camera.js";
import { CUP } from "../files/stage/sample.test.js";
import { launch, leave, visitor } from "./browser.mjs";

const SIZE = { width: 700, height: 490 };
const POLICY = "default-src 'none'; script-src 'self'; style-src 'self'; img-src data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
const TYPES = { html: "text/html", css: "text/css", js: "text/javascript" };

async function answer(request, response) {
  const path = new URL(request.url, "http://here").pathname;
  const file = path.startsWith("/harness/") ? new URL(`.${path}`, import.meta.url) : new URL(`../files${path}`, import.meta.url);
  const bytes = await readFile(file).catch(() => null);
  if (!bytes) return response.writeHead(404).end();
  const type = TYPES[path.split(".").at(-1)] ?? "text/plain";
  return response.writeHead(200, { "content-type": `${type}; charset=utf-8`, "content-security-policy": POLICY }).end(bytes);
}

/** A browser with the stage; `webgl` says whether it has WebGL. */
export async function openStage({ viewport = SIZE, webgl = true, ...options } = {}) {
  const server = createServer(answer).listen(0, "127.0.0.1");
  await once(server, "listening");
  const browser = await launch();
  const context = await visitor(browser, { webgl, viewport, ...options });
  await context.addInitScript(keepContext);
  const page = await context.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error" && !message.text().includes("favicon")) errors.push(message.text());
  });
  await page.goto(`http://127.0.0.1:${server.address().port}/harness/index.html`);
  await page.waitForFunction(() => "stage" in window);
  await page.evaluate((shape) => window.show({ shape, status_s: 0.08 }), CUP);
  if (webgl) await page.waitForSelector("#stage[data-shown='3d']");
  return {
    page, errors,
    async end() {
      await leave(browser);
      server.close();
    },
  };
}

/** Keeps the last WebGL context: without a graphics card its canvas is not in the page. */
function keepContext() {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
    const context = getContext.call(this, kind, ...more);
    if (kind === "webgl2") window.gl = context;
    return context;
  };
}

/** Where a preset of the camera shows the tip of a tool of 40 mm, in pixels. */
export function onScreen(name, { x_mm, y_mm, z_mm }, { width, height } = SIZE) {
  const seen = preset(name, width / height, [0, 0, 0]);
  const camera = new PerspectiveCamera(LENS_DEG, width / height, 20, 6000);
  camera.up.set(0, 0, 1);
  camera.position.set(...place(seen));
  camera.lookAt(...seen.at_mm);
  camera.updateMatrixWorld();
  const { x, y } = new Vector3(x_mm, y_mm, z_mm - 40).project(camera);
  return { x: ((x + 1) / 2) * width, y: ((1 - y) / 2) * height };
}

/** An arm that reported this at a second. */
export function reported(at_s, base_deg = 20, rear_deg = 30, fore_deg = 45, servo_deg = 0) {
  return { at_s, base_deg, rear_deg, fore_deg, servo_deg, suction: false, gripper_deg: 0 };
}
