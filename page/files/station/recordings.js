// Reads and downloads recordings, and advances the playback time.

import { isCoarse } from "../state/recordings.js";
import { saveFrom } from "../parts/download.js";

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {ReturnType<typeof createRecordings>} RecordingRequests */

/** The most positions read of a recording. */
const MOST = 5000;

/** Length of the stretch read at full resolution, in seconds; a third of it lies before the current time. */
const NEAR_S = 60;
/** Delay after scrubbing before that stretch is read. */
const RESTS_MS = 150;

/** @param {string} name */
const pathOf = (name) => `api/v1/recordings/${encodeURIComponent(name)}`;

/** @param {Store} store @param {import("./http.js").Http} http */
export function createRecordings(store, http) {
  const { send } = store;
  let pictures = 0;
  /** @type {number | undefined} */ let timer;

  async function list() {
    const { value, problem } = await http.ask("GET", "api/v1/recordings");
    if (problem) send({ type: "recordings_refused", problem });
    else send({ type: "recordings", all: /** @type {Schemas["RecordingView"][]} */ (value) });
  }

  function pass() {
    pictures = 0;
    send({ type: "recording_passed", now_ms: Date.now() });
  }

  /** Reads finely what lies around the moment that is shown. */
  async function look() {
    const { chosen, at_s } = store.page.recordings;
    const from_s = Math.max(0, at_s - NEAR_S / 3);
    const to_s = from_s + NEAR_S;
    /** @type {Schemas["RecordedStates"] | undefined} */
    const states = chosen ? await http.json(`${pathOf(chosen)}/states?from_s=${from_s}&to_s=${to_s}&most=${MOST}`) : undefined;
    timer = undefined;
    if (chosen && states) send({ type: "recording_near", name: chosen, near: { from_s, to_s, samples: states.samples } });
  }

  store.subscribe((page, message) => {
    const opened = message.type === "tab" && message.tab === "jobs";
    if (opened || (message.type === "hello" && page.tab === "jobs")) void list();
    if (message.type === "recording_at") {
      clearTimeout(timer);
      timer = undefined;
    }
    const moved = message.type === "recording_at" || message.type === "recording_passed";
    if (moved && isCoarse(page.recordings)) timer ??= setTimeout(() => void look(), RESTS_MS);
    if (page.recordings.played_ms !== null) pictures ||= requestAnimationFrame(pass);
  });

  return {
    list,
    /** Shows a recording on the stage. @param {string} name */
    async open(name) {
      send({ type: "recording_chosen", name });
      const { value, problem } = await http.ask("GET", `${pathOf(name)}/states?most=${MOST}`);
      if (problem) send({ type: "recordings_refused", problem });
      else send({ type: "recording_read", name, states: /** @type {Schemas["RecordedStates"]} */ (value) });
    },
    /** Gives a person the file: with the token, which a link would not carry. @param {string} name */
    async save(name) {
      if (!(await saveFrom(http, pathOf(name), name))) void list();
    },
  };
}
