// Looks for hands in pictures beside the page, with MediaPipe's files, which the station serves once they are installed. A classic
// worker: they are scripts. Their own code for workers loads models as scripts, so here they find what they use of a page.

/** @typedef {{ files: string } | { picture: ImageBitmap, at_ms: number }} ToWorker */
/** @typedef {{ ready: true } | { failed: string } | { at_ms: number, hands: import("./hand.js").Hand[] }} FromWorker */
/** @typedef {{ multiHandLandmarks?: { x: number, y: number, z: number }[][], multiHandedness?: { score: number }[] }} Results */
/** @typedef {{ setOptions: (options: object) => void, onResults: (listener: (results: Results) => void) => void, initialize: () => Promise<void>, send: (input: { image: ImageBitmap }) => Promise<void> }} MediaPipe */

/** What only a classic worker has. */
const scripts = /** @type {{ importScripts: (address: string) => void }} */ (/** @type {unknown} */ (self));

/** An element: a canvas, or a script, which runs when it is added. @param {string} kind */
function createElement(kind) {
  if (kind === "canvas") return Object.assign(new OffscreenCanvas(1, 1), { style: {} });
  /** @type {Record<string, () => void>} */ const listeners = {};
  return { listeners, src: "", setAttribute(/** @type {string} */ name, /** @type {string} */ value) { Object.assign(this, { [name]: value }); }, addEventListener: (/** @type {string} */ name, /** @type {() => void} */ listener) => (listeners[name] = listener) };
}

/** @param {ReturnType<typeof createElement>} element */
function appendChild(element) {
  if (!("src" in element)) return;
  Object.assign(document, { currentScript: element });
  scripts.importScripts(element.src);
  Object.assign(document, { currentScript: null });
  setTimeout(() => element.listeners.load?.());
}

const body = { appendChild }, nothing = () => {};
Object.assign(self, { window: self, document: { currentScript: null, createElement, body, head: body, documentElement: body, addEventListener: nothing, removeEventListener: nothing, getElementById: () => null } });

/** @type {MediaPipe | undefined} */ let hands;
/** When the picture that is looked at was taken. */
let taken_ms = 0;
/** @param {FromWorker} message */
const post = (message) => postMessage(message);

/** @param {string} files their address, with a slash at its end */
async function start(files) {
  scripts.importScripts(`${files}hands.js`);
  const { Hands } = /** @type {{ Hands: new (options: { locateFile: (name: string) => string }) => MediaPipe }} */ (/** @type {unknown} */ (self));
  hands = new Hands({ locateFile: (name) => files + name });
  // Two, so that a second hand is noticed.
  hands.setOptions({ maxNumHands: 2, modelComplexity: 0, minDetectionConfidence: 0.7, minTrackingConfidence: 0.7 });
  hands.onResults(({ multiHandLandmarks = [], multiHandedness = [] }) => post({ at_ms: taken_ms, hands: multiHandLandmarks.map((points, n) => ({ score: multiHandedness[n]?.score ?? 0, points: points.map(({ x, y, z }) => /** @type {const} */ ([x, y, z])) })) }));
  await hands.initialize();
  post({ ready: true });
}

/** @param {ToWorker} message */
async function handle(message) {
  if ("files" in message) return start(message.files);
  taken_ms = message.at_ms;
  await hands?.send({ image: message.picture });
  message.picture.close();
}

addEventListener("message", ({ data }) => void handle(data).catch((error) => post({ failed: String(error) })));
