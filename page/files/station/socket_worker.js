// The WebSocket to the station, in a thread of its own: drawing the page delays no message of a held button.

import { REPEATED, REPEAT_MS, createKeepAlive } from "./keep_alive.js";

/** @typedef {{ number: number, open: { url: string, protocols: string[] } } | { number: number, close: true } | { number: number, pcm: ArrayBuffer } | { number: number, beat: number } | { number: number, text: string, id: number, hold: import("./keep_alive.js").Hold | null, ends: boolean }} ToWorker */
/** @typedef {{ number: number, type: "open" } | { number: number, type: "message", data: string } | { number: number, type: "close", code: number, reason: string } | { number: number, type: "released", id: number }} FromWorker */

/** @type {WebSocket | undefined} */ let socket;
/** The number of the connection; messages about earlier ones are of no use. */
let current = 0;

const keepAlive = createKeepAlive((text) => socket?.readyState === WebSocket.OPEN && socket.send(text));
setInterval(() => keepAlive.tick(performance.now()), REPEAT_MS / 2);

/** @param {FromWorker} message */
const post = (message) => postMessage(message);

/** @param {number} number @param {{ url: string, protocols: string[] }} to */
function open(number, { url, protocols }) {
  current = number;
  const mine = socket = new WebSocket(url, protocols);
  mine.addEventListener("open", () => post({ number, type: "open" }));
  mine.addEventListener("message", ({ data }) => {
    // Nobody waits for these answers, and a page that is busy has no time for them.
    if (JSON.parse(data).id !== REPEATED) post({ number, type: "message", data });
  });
  mine.addEventListener("close", ({ code, reason }) => {
    if (mine === socket) keepAlive.end();
    post({ number, type: "close", code, reason });
  });
}

addEventListener("message", (/** @type {MessageEvent<ToWorker>} */ { data }) => {
  if ("open" in data) return open(data.number, data.open);
  if (data.number !== current || !socket) return;
  if ("close" in data) {
    keepAlive.end();
    return socket.close();
  }
  if ("beat" in data) return keepAlive.beat(data.beat, performance.now());
  if ("pcm" in data) return void (socket.readyState === WebSocket.OPEN && socket.send(data.pcm));
  if (data.ends) keepAlive.end();
  if (data.hold === null) socket.readyState === WebSocket.OPEN && socket.send(data.text);
  else if (!keepAlive.press(data.hold, data.text, performance.now())) post({ number: data.number, type: "released", id: data.id });
});
