// A WebSocket in a thread of its own, which keeps a held button pressed while the page is busy for a moment.

/** @typedef {import("./socket_worker.js").FromWorker} FromWorker */
/** @typedef {import("./socket_worker.js").ToWorker} ToWorker */
/**
 * @typedef {object} Connection
 * @property {() => boolean} isOpen
 * @property {(text: string, id: number, hold: import("./keep_alive.js").Hold | null, ends: boolean) => void} send
 * @property {() => void} beat
 * @property {(pcm: ArrayBuffer) => void} sendAudio
 * @property {() => void} close
 */

/** Starts the thread, which is needed once: it opens one connection after the other. */
export function createThreadedSocket() {
  // Classic and module workers alike are loaded from the station, which may not be there later.
  const worker = new Worker(new URL("socket_worker.js", import.meta.url), { type: "module" });
  let number = 0;

  /**
   * Opens a connection.
   * @param {string} url @param {string[]} protocols
   * @param {{ opened: () => void, message: (data: string) => void, closed: (end: { code: number, reason: string }) => void, released: (id: number) => void }} handlers `released`: the button was released before this request
   * @returns {Connection}
   */
  return function connect(url, protocols, handlers) {
    const mine = number += 1;
    let isOpen = false;
    /** The hold of a button that was sent last, until a request ends it. @type {number | null} */ let held = null;
    const post = (/** @type {ToWorker} */ message) => worker.postMessage(message);
    /** Says that the page responds: the worker keeps a held button pressed. */
    const beat = () => held !== null && post({ number: mine, beat: held });
    const listen = (/** @type {MessageEvent<FromWorker>} */ { data }) => {
      if (data.number !== mine) return;
      beat();
      switch (data.type) {
        case "open":
          isOpen = true;
          return handlers.opened();
        case "message":
          return handlers.message(data.data);
        case "released":
          return handlers.released(data.id);
        case "close":
          isOpen = false;
          worker.removeEventListener("message", listen);
          return handlers.closed(data);
      }
    };
    worker.addEventListener("message", listen);
    post({ number: mine, open: { url, protocols } });
    return {
      isOpen: () => isOpen,
      beat,
      send(text, id, hold, ends) {
        held = ends ? null : hold?.number ?? held;
        post({ number: mine, text, id, hold, ends });
      },
      sendAudio: (pcm) => worker.postMessage(/** @type {ToWorker} */ ({ number: mine, pcm }), [pcm]),
      close: () => post({ number: mine, close: true }),
    };
  };
}
