// Requests about the shared queue of this board's station.

import { readDrawing } from "../station/drawing_file.js";
import { optionsOf } from "./queue.js";

/** @typedef {import("./fleet.js").Store} Store */
/** @typedef {import("../state/types.js").Problem} Problem */
/** @typedef {import("./queue.js").Form} Form */
/** @typedef {import("./queue.js").WorkView} WorkView */

/** Polling interval: other stations do not announce changes. */
const AGAIN_MS = 2000;
const WORK = "api/v1/fleet/work";
const KEY_BYTES = 16;

/** @param {Store} store @param {import("../station/http.js").Http} http */
export function createQueueRequests(store, http) {
  const { send } = store;
  /** @type {number | undefined} */ let timer;
  /** Number of reads: results of earlier ones are ignored. */
  let requests = 0;
  /** Idempotency key of the current form: a submission can be repeated after a lost answer. */
  let key = newKey();

  async function read() {
    clearTimeout(timer);
    if (store.page.connection !== "open") return;
    const mine = requests += 1;
    const all = document.hidden ? undefined : await http.json(WORK);
    if (mine !== requests) return;
    if (all) send({ type: "queue", all });
    timer = setTimeout(() => void read(), AGAIN_MS);
  }

  async function readFormats() {
    const formats = await http.json("api/v1/formats");
    if (formats) send({ type: "queue_formats", formats });
  }

  store.subscribe((_, { type }) => {
    if (type === "queue_form") key = newKey();
    if (type === "fleet" || type === "queue_open") void read();
    if (type === "queue_open") void readFormats();
  });

  /** @param {string} work @param {"POST" | "DELETE"} method @param {string} path */
  async function decide(work, method, path) {
    send({ type: "queue_asked", work });
    const { problem } = await http.ask(method, path);
    if (problem) send({ type: "queue_refused", work, problem });
    await read();
  }

  return {
    async submit() {
      const { form } = store.page.queue, mine = key;
      send({ type: "queue_asked", work: null });
      const { body, problem: unread } = await bodyOf(form);
      if (unread) return send({ type: "queue_refused", work: null, problem: unread });
      /** @type {import("../station/http.js").Outcome<WorkView>} */ const { value, problem } = await http.ask("POST", WORK, body, mine);
      if (problem) return send({ type: "queue_refused", work: null, problem });
      if (key === mine) key = newKey();
      send({ type: "queue_submitted", form, title: value.title });
      await read();
    },
    /** Cancels a job. @param {string} work */
    cancel: (work) => decide(work, "DELETE", `${WORK}/${work}`),
    /** A person has looked at the arm, and another one is to do it. @param {string} work */
    reassign: (work) => decide(work, "POST", `${WORK}/${work}/give`),
  };
}

/** @param {Form} form @returns {Promise<{ body?: unknown, problem?: Problem }>} */
async function bodyOf(form) {
  const { student, group, needs } = form;
  const { content, problem } = form.what === "file" && form.file ? await readDrawing(form.file) : {};
  if (problem) return { problem };
  return { body: { drawing: { ...content, options: optionsOf(form) }, needs, student: student.trim(), ...(group.trim() && { group: group.trim() }) } };
}

/** A number that no other submission has. */
const newKey = () => [...crypto.getRandomValues(new Uint8Array(KEY_BYTES))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
