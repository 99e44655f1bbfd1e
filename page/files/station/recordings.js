// Reads recordings, hands them to a person as files, and lets time pass while one is played.

import { saveAs } from "../parts/save.js";

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {ReturnType<typeof createRecordings>} RecordingRequests */

/** How many places of the arm are read of a recording, however long it is. */
const MOST = 5000;

/** @param {string} name */
const pathOf = (name) => `api/v1/recordings/${encodeURIComponent(name)}`;

/** @param {Store} store @param {import("./http.js").Http} http */
export function createRecordings(store, http) {
  const { send } = store;
  let pictures = 0;

  async function list() {
    const { value, problem } = await http.ask("GET", "api/v1/recordings");
    if (problem) send({ type: "recordings_refused", problem });
    else send({ type: "recordings", all: /** @type {Schemas["RecordingView"][]} */ (value) });
  }

  function pass() {
    pictures = 0;
    send({ type: "recording_passed", now_ms: Date.now() });
  }

  store.listen((page, message) => {
    const opened = message.type === "tab" && message.tab === "jobs";
    if (opened || (message.type === "hello" && page.tab === "jobs")) void list();
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
      const answer = await http.get(pathOf(name));
      if (!answer?.ok) return void list();
      saveAs(await answer.blob(), name);
    },
  };
}
