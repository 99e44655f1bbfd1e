// The files that the station stores: list, pictures, opening, storing; saves where a drawing was placed.

import { base64 } from "../parts/base64.js";
import { saveFrom } from "../parts/download.js";
import { hasSubject, sameOptions, storedOptions } from "../state/draw.js";
import { fileKey, jobKey } from "../state/files.js";
import { MOST_BYTES } from "../state/draw.js";

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/files.js").StoredFile} StoredFile */
/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {ReturnType<typeof createFiles>} FileRequests */

const FILES = "api/v1/files";
/** How long a placement rests before it is saved. */
const SAVE_MS = 500;
/** How often a picture that is not made yet is asked for again. */
const SKETCH_MS = 1000;
/** The most jobs whose pictures are read. */
const MOST_JOBS = 50;
/** Storage key of the drawing that is opened after a reload. */
const LAST = "dobot.file";

/** @param {Store} store @param {import("./http.js").Http} http */
export function createFiles(store, http) {
  const { send } = store;
  /** What became of files that were chosen here. @type {WeakMap<File, Promise<StoredFile | null>>} */ const kept = new WeakMap();
  /** @type {Set<string>} */ const asked = new Set();
  /** @type {number | undefined} */ let saving;

  const mayStore = () => store.page.role !== null && store.page.role !== "watch";

  async function read() {
    const { value, problem } = await http.ask("GET", FILES);
    if (problem) return send({ type: "files_problem", problem });
    send({ type: "files", list: /** @type {Schemas["FilesView"]} */ (value) });
    for (const file of /** @type {Schemas["FilesView"]} */ (value).files) {
      if (file.has_sketch) await readSketch(fileKey(file), `${FILES}/${file.file}/sketch`);
    }
    // A new file has its picture a moment later.
    const waits = /** @type {Schemas["FilesView"]} */ (value).files.some(({ kind, has_sketch, problem }) => kind !== "program" && !has_sketch && !problem);
    if (waits) setTimeout(() => isSeen() && void read(), SKETCH_MS);
  }

  const isSeen = () => ["draw", "teach"].includes(store.page.tab) && !document.hidden;

  /** @param {string} of @param {string} path */
  async function readSketch(of, path) {
    if (asked.has(of)) return;
    asked.add(of);
    const { value, problem } = await http.ask("GET", path);
    if (!problem) send({ type: "sketch", of, sketch: /** @type {Schemas["Sketch"] | null} */ (value) });
  }

  /** @param {readonly import("../state/jobs.js").JobView[]} jobs */
  async function readJobs(jobs) {
    const newest = [...jobs].sort((a, b) => b.job - a.job).slice(0, MOST_JOBS);
    for (const { job } of newest) await readSketch(jobKey(job), `api/v1/jobs/${job}/sketch`);
  }

  /** @param {File} file @param {string} existing @returns {Promise<{ stored?: StoredFile, problem?: import("../state/types.js").Problem }>} */
  async function post(file, existing) {
    const content = file.size > MOST_BYTES ? null : await base64(file);
    if (content === null) return {};
    const { value, problem } = await http.ask("POST", FILES, { name: file.name, content, existing });
    return problem ? { problem } : { stored: /** @type {StoredFile} */ (value) };
  }

  /** Stores a file; if another one has its name, that is asked first. @param {File} file @param {boolean} draws @param {string} [existing] @returns {Promise<StoredFile | null>} */
  async function keep(file, draws, existing = "refuse") {
    if (!mayStore()) return null;
    const { stored, problem } = await post(file, existing);
    if (problem?.type?.endsWith("/file-exists")) send({ type: "file_taken", taken: { file, draws } });
    else if (problem) send({ type: "files_problem", problem });
    else send({ type: "file_taken", taken: null });
    if (stored) void read();
    return stored ?? null;
  }

  /** Saves where the drawing is, and with what. */
  async function save() {
    const { stored, planned } = store.page.draw;
    if (!stored || !planned || !mayStore()) return;
    const options = storedOptions(store.page);
    if (sameOptions(options, stored.options)) return;
    const { value, problem } = await http.ask("PUT", `${FILES}/${stored.file}`, { revision: stored.revision, options });
    if (!problem) return send({ type: "draw_saved", stored: /** @type {StoredFile} */ (value) });
    if (problem.type?.endsWith("/file-changed")) return ask(stored.file);
    send({ type: "files_problem", problem });
  }

  /** Somebody else changed the file that is drawn here: whose placement counts is asked. @param {number} number */
  async function ask(number) {
    const theirs = await view(number);
    if (!theirs || theirs.file !== store.page.draw.stored?.file) return;
    // A job of this page only noted what it drew.
    if (sameOptions(theirs.options, storedOptions(store.page))) send({ type: "draw_saved", stored: theirs });
    else send({ type: "file_theirs", theirs });
  }

  /** @param {number} number @returns {Promise<StoredFile | undefined>} */
  const view = (number) => http.json(`${FILES}/${number}`);

  /** Opens the drawing of the last visit, unless another one is open. */
  async function reopen() {
    const last = Number(localStorage.getItem(LAST));
    if (!last || hasSubject(store.page.draw)) return;
    const stored = await view(last);
    if (stored && stored.kind !== "program" && !hasSubject(store.page.draw)) send({ type: "draw_stored", stored });
  }

  let last = store.page.draw.stored;
  store.subscribe((page, message) => {
    if (message.type === "hello") {
      asked.clear();
      void reopen();
    }
    const opened = message.type === "tab" || message.type === "hello";
    if (opened && isSeen()) void read();
    if (message.type === "jobs") void readJobs(message.all);
    if (message.type === "draw_planned") {
      clearTimeout(saving);
      saving = setTimeout(() => void save(), SAVE_MS);
    }
    // The station notes the job, and what it draws.
    if (message.type === "job_starting" && !message.starting && page.draw.stored) void view(page.draw.stored.file).then((stored) => stored && send({ type: "draw_saved", stored }));
    if (page.draw.stored?.file === last?.file) return;
    last = page.draw.stored;
    if (last) localStorage.setItem(LAST, String(last.file));
    else localStorage.removeItem(LAST);
  });

  return {
    read,
    /** The stored form of a file that was chosen here, once it is stored. @param {File} file */
    stored(file) {
      const known = kept.get(file) ?? keep(file, true);
      kept.set(file, known);
      return known;
    },
    /** Answers what to do with a file whose name is taken; null leaves it unstored. @param {"replace" | "keep_both" | null} existing */
    async answer(existing) {
      const { taken } = store.page.files;
      send({ type: "file_taken", taken: null });
      if (!taken || !existing) return;
      const stored = await keep(taken.file, taken.draws, existing);
      if (stored && taken.draws && store.page.draw.file === taken.file) send({ type: "draw_kept", file: taken.file, stored });
    },
    /** Stores a program. @param {string} text @param {string} name */
    keepProgram: (text, name) => void keep(new File([text], name), false),
    /** Opens a drawing where it was placed, or a program. @param {StoredFile} file @param {(file: File) => void} openProgram */
    async open(file, openProgram) {
      const now = await view(file.file);
      if (!now) return void read();
      if (now.kind !== "program") return send({ type: "draw_stored", stored: now });
      const answer = await http.get(`${FILES}/${now.file}/content`);
      if (answer?.ok) openProgram(new File([await answer.blob()], now.name));
    },
    /** @param {StoredFile} file */
    async download({ file, name }) {
      if (!(await saveFrom(http, `${FILES}/${file}/content`, name))) void read();
    },
    /** @param {number} file */
    async remove(file) {
      send({ type: "file_removes", file: null });
      const { problem } = await http.ask("DELETE", `${FILES}/${file}`);
      if (problem && problem.status !== 404) send({ type: "files_problem", problem });
      else if (store.page.draw.stored?.file === file) send({ type: "draw_unstored" });
      await read();
    },
    /** Whose placement counts: that of the other page, or the one here. @param {boolean} theirs */
    settle(theirs) {
      const stored = store.page.files.theirs;
      if (!stored) return;
      send({ type: "file_theirs", theirs: null });
      if (theirs) return send({ type: "draw_stored", stored });
      send({ type: "draw_saved", stored });
      void save();
    },
  };
}
