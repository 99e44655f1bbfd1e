// Calibration from one photo: the arm draws crosses, a person takes a photo of them, and the fit follows from where they are.

import { rawDegrees } from "../state/calibrate.js";
import { blockedReason } from "../state/selectors.js";
import { CROSSES, DIAGONAL_MM, LEAST_CROSSES } from "../vision/drawn_crosses.js";

/** @typedef {ReturnType<typeof createPhoto>} PhotoRequests */
/** @typedef {import("../vision/geometry.js").Pair} Pair */

/** How far above the paper the pen goes from one cross to the next. */
const LIFT_MM = 15;
/** The longer side of the picture that is looked at. */
const LONGEST_PX = 2048;

/** @param {import("../state/store.js").Store} store @param {import("./socket.js").Socket} socket */
export function createPhoto(store, socket) {
  const { send } = store;
  /** The commands that are under way, and what waits for their end. @type {Map<number, (done: boolean) => void>} */ const waiting = new Map();
  /** Commands that ended before their acceptance arrived. @type {Map<number, boolean>} */ const ended = new Map();
  /** Counts drawings: an earlier one goes no further. */
  let drawings = 0;

  store.subscribe((_, message) => {
    if (message.type === "stop_pressed" || message.type === "closed" || message.type === "calibrate_ended") {
      drawings += 1;
      for (const end of waiting.values()) end(false);
      waiting.clear();
    }
    if (message.type !== "notice" || (message.notice.type !== "command_done" && message.notice.type !== "command_failed")) return;
    const { command, type } = message.notice, end = waiting.get(command);
    if (end) end(type === "command_done");
    else ended.set(command, type === "command_done");
    waiting.delete(command);
  });

  /** Moves, and waits until the arm is there. @param {Pair} place @param {number} z_mm @param {"movj" | "movl"} mode @returns {Promise<boolean>} */
  async function move([x_mm, y_mm], z_mm, mode) {
    const arm = store.page.station?.arm;
    if (!arm) return false;
    const { rotation_deg, gripper_deg } = arm;
    const { reply, problem } = await socket.ask({ type: "command", command: { type: "move_to", x_mm, y_mm, z_mm, rotation_deg, mode, suction: false, gripper_deg, pause_s: 0 } });
    if (problem) send({ type: "problem", problem });
    if (reply?.type !== "accepted") return false;
    const before = ended.get(reply.command);
    ended.clear();
    return before ?? new Promise((resolve) => waiting.set(reply.command, resolve));
  }

  /** Draws one cross; returns the arm's angles at its middle. @param {Pair} place @param {number} z_mm @returns {Promise<readonly number[] | null>} */
  async function cross([x, y], z_mm) {
    if (!(await move([x, y], z_mm + LIFT_MM, "movj")) || !(await move([x, y], z_mm, "movl"))) return null;
    const { arm } = store.page.station ?? {};
    if (!arm) return null;
    const raw_deg = rawDegrees(arm);
    for (const [dx, dy] of [[DIAGONAL_MM, -DIAGONAL_MM], [DIAGONAL_MM, DIAGONAL_MM]]) for (const way of [1, -1, 0]) if (!(await move([x + way * dx, y + way * dy], z_mm, "movl"))) return null;
    return (await move([x, y], z_mm + LIFT_MM, "movl")) ? raw_deg : null;
  }

  /** The picture of a file, upright. @param {File} file */
  async function pictureOf(file) {
    const photo = await createImageBitmap(file, { imageOrientation: "from-image" });
    const scale = Math.min(1, LONGEST_PX / Math.max(photo.width, photo.height));
    const canvas = new OffscreenCanvas(Math.round(photo.width * scale), Math.round(photo.height * scale));
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext("2d"));
    context.drawImage(photo, 0, 0, canvas.width, canvas.height);
    const { data, width, height } = context.getImageData(0, 0, canvas.width, canvas.height);
    return { data, width, height };
  }

  /** @param {import("../vision/crosses_worker.js").ToWorker} question @returns {Promise<(Pair | null)[] | null>} */
  function look(question) {
    const worker = new Worker(new URL("../vision/crosses_worker.js", import.meta.url), { type: "module" });
    const answer = new Promise((resolve, reject) => {
      worker.onmessage = ({ data }) => resolve(data);
      worker.onerror = ({ message }) => reject(new Error(message));
      worker.postMessage(question, [question.picture.data.buffer]);
    });
    return answer.finally(() => worker.terminate());
  }

  return {
    /** Draws all crosses, with the pen that touches the paper where it is now. */
    async draw() {
      const z_mm = store.page.station?.arm?.z_mm;
      if (z_mm === undefined || blockedReason(store.page)) return;
      drawings += 1;
      const mine = drawings;
      socket.takeControlIfFree();
      /** @type {(readonly number[])[]} */ const drawn = [];
      for (const place of CROSSES) {
        send({ type: "photo_set", set: { drawn, state: "draws" } });
        const raw_deg = await cross(place, z_mm);
        if (mine !== drawings) return send({ type: "photo_set", set: { drawn: [], state: "interrupted" } });
        if (!raw_deg) return send({ type: "photo_set", set: { drawn: [], state: "interrupted" } });
        drawn.push(raw_deg);
      }
      send({ type: "photo_set", set: { drawn, state: "drawn" } });
    },
    /** Takes a photo of them. @param {File} file */
    async take(file) {
      const { photo: { drawn }, sheet } = store.page.calibrate;
      if (!sheet || drawn.length < CROSSES.length) return;
      send({ type: "photo_set", set: { state: "looks" } });
      try {
        const found = await look({ picture: await pictureOf(file), sheet: /** @type {import("../vision/geometry.js").SheetMarkers} */ (/** @type {unknown} */ (sheet.markers_mm)), wanted: CROSSES });
        if (!found) return send({ type: "photo_set", set: { state: "few_corners" } });
        const touches = found.flatMap((place_mm, n) => (place_mm ? [{ place_mm, raw_deg: drawn[n] }] : []));
        if (touches.length < LEAST_CROSSES) return send({ type: "photo_set", set: { state: "few_crosses", found: touches.length } });
        send({ type: "photo_taken", touches });
      } catch {
        send({ type: "photo_set", set: { state: "unreadable" } });
      }
    },
  };
}
