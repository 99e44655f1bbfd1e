// A hand in front of the camera: the camera is asked for when the view opens and off when it closes. A worker looks at the pictures;
// what the hand means goes to the station marked as a hand's, at most ten times a second. Without a hand nothing is sent.

import { createStream, gestureAt } from "../input/pad_packets.js";
import { blockedReason, mountedTool } from "../state/selectors.js";
import { createHand } from "../vision/hand.js";
import { isSecure, refusalOf, stopTracks } from "./media.js";

/** @typedef {ReturnType<typeof createHands>} HandsRequests */
/** @typedef {import("../vision/hands_worker.js").FromWorker} FromWorker */

const WIDTH = 320;
/** The least time between two pictures, and between two packets. */
const PICTURE_MS = 40, PACKET_MS = 100;
/** States after which a hand may still be in control: it may be lost for a moment. @type {ReadonlySet<import("../vision/hand.js").Meaning["state"]>} */
const KEEPS_CONTROL = new Set(["controls", "none", "unsure"]);

/** @param {import("../state/store.js").Store} store @param {import("./http.js").Http} http @param {import("./socket.js").Socket} socket @param {() => void} stop */
export function createHands(store, http, socket, stop) {
  const set = (/** @type {Partial<import("../state/hands.js").Hands>} */ set) => store.send({ type: "hands_set", set });
  const video = document.createElement("video");
  video.id = "hands-video";
  video.muted = video.playsInline = true;
  /** @type {MediaStream | null} */ let stream = null;
  /** @type {Worker | null} */ let worker = null;
  /** @type {number | undefined} */ let timer;
  let openings = 0, look = createHand();
  /** Where the arm was when the hand took control. @type {{ x_mm: number, y_mm: number, z_mm: number } | null} */ let begin = null;
  /** What to send next. @type {import("../vision/hand.js").Movement | null} */ let movement = null;
  let sent_ms = -Infinity;

  const packets = createStream({ store, socket, sense: "hand", refused: (detail) => (drop(), set({ refused: detail })), next() {
    const { page } = store, now_ms = performance.now();
    const scale = page.facts?.tools.find(({ kind }) => kind === mountedTool(page))?.gesture;
    if (!begin || !movement || !scale || now_ms - sent_ms < PACKET_MS) return null;
    const { left_mm, up_mm, closed } = movement;
    [movement, sent_ms] = [null, now_ms];
    return gestureAt({ x_mm: begin.x_mm, y_mm: begin.y_mm + left_mm, z_mm: begin.z_mm + up_mm }, closed, scale);
  } });

  /** Sends nothing more. */
  function lose() {
    [begin, movement] = [null, null];
    packets.end();
  }

  /** Takes control from the hand: it has to be opened again. */
  function drop() {
    lose();
    look = createHand();
  }

  /** @param {import("../vision/hand.js").Picture} picture */
  function looked(picture) {
    const meaning = look(picture);
    set({ state: meaning.state, share: Math.floor(meaning.share * 10), closed: meaning.movement?.closed ?? false });
    if (meaning.state === "stop") {
      lose();
      stop();
    }
    movement = meaning.movement;
    const arm = store.page.station?.arm;
    if (!KEEPS_CONTROL.has(meaning.state)) lose();
    if (!movement || !arm) return;
    if (blockedReason(store.page) !== null) return drop();
    if (begin) return packets.more();
    // Only the picture in which a hand takes control has no movement.
    if (movement.left_mm !== 0 || movement.up_mm !== 0) return;
    begin = { x_mm: arm.x_mm, y_mm: arm.y_mm, z_mm: arm.z_mm };
    set({ refused: null });
    packets.begin();
  }

  async function take() {
    if (!worker) return;
    if (!video.videoWidth) return void (timer = setTimeout(take, PICTURE_MS));
    const at_ms = performance.now(), height = Math.round((WIDTH * video.videoHeight) / video.videoWidth);
    const picture = await createImageBitmap(video, { resizeWidth: WIDTH, resizeHeight: height });
    worker?.postMessage({ picture, at_ms }, [picture]);
  }

  /** @param {FromWorker} message */
  function handle(message) {
    if ("failed" in message) return end({ view: "refused", refused: message.failed });
    if ("ready" in message) set({ view: "on" });
    else {
      looked({ at_ms: message.at_ms, hands: message.hands, aspect: video.videoWidth / video.videoHeight });
      return void (timer = setTimeout(take, Math.max(0, PICTURE_MS - (performance.now() - message.at_ms))));
    }
    void take();
  }

  async function open() {
    openings += 1;
    const mine = openings;
    /** @type {string[] | undefined} */ const installed = await http.json("api/v1/extras");
    if (mine !== openings) return;
    if (!installed?.includes("hands")) return set({ view: "not_installed" });
    if (!isSecure()) return set({ view: "refused", refused: "insecure" });
    set({ view: "asking", refused: null });
    try {
      const own = await navigator.mediaDevices.getUserMedia({ video: { width: { ideal: WIDTH } }, audio: false });
      if (mine !== openings) return stopTracks(own);
      stream = own;
      own.getVideoTracks()[0].onended = () => end({ view: "refused", refused: "unplugged" });
      video.srcObject = own;
      await video.play();
      look = createHand();
      worker = new Worker(new URL("../vision/hands_worker.js", import.meta.url));
      worker.onmessage = ({ data }) => handle(data);
      worker.onerror = ({ message }) => end({ view: "refused", refused: message });
      worker.postMessage({ files: new URL("extras/hands/", location.href).href });
      set({ view: "loading" });
    } catch (error) {
      if (mine === openings) end({ view: "refused", refused: refusalOf(error) });
    }
  }

  /** @param {Partial<import("../state/hands.js").Hands>} why */
  function end(why) {
    openings += 1;
    clearTimeout(timer);
    lose();
    worker?.terminate();
    stopTracks(stream);
    [worker, stream, video.srcObject] = [null, null, null];
    set({ state: "none", share: 0, closed: false, ...why });
  }

  const close = () => end({ view: "closed", refused: null });
  store.subscribe((page, message) => {
    if (message.type === "stop_pressed" || message.type === "closed") drop();
    if (message.type === "tab" && page.tab !== "move" && page.hands.view !== "closed") close();
  });
  return { video, open, close };
}
