// The files that the station stores. Pure.

/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {import("./types.js").Problem} Problem */
/** @typedef {Schemas["FileView"]} StoredFile */
/** @typedef {Schemas["Sketch"]} Sketch */
/** A file with the name of another one: what to do is asked. @typedef {{ file: File, draws: boolean }} Taken */

/**
 * @typedef {object} Files
 * @property {Schemas["FilesView"] | null} list Nothing while it is not known.
 * @property {string} search
 * @property {Readonly<Record<string, Sketch | null>>} sketches By `file digest` or `job number`.
 * @property {Problem | null} problem Why the last request failed.
 * @property {Taken | null} taken
 * @property {StoredFile | null} theirs The file that is drawn here, as somebody else has changed it.
 * @property {number | null} removes The file whose deletion is asked about.
 */

/** @type {Files} */
export const NO_FILES = { list: null, search: "", sketches: {}, problem: null, taken: null, theirs: null, removes: null };

/** @typedef {{ type: "files", list: Schemas["FilesView"] }
 * | { type: "files_search", text: string }
 * | { type: "files_problem", problem: Problem | null }
 * | { type: "file_taken", taken: Taken | null }
 * | { type: "file_theirs", theirs: StoredFile | null }
 * | { type: "file_removes", file: number | null }
 * | { type: "sketch", of: string, sketch: Sketch | null }} FilesMessage */

/** @param {Files} files @param {import("./message.js").Message} message @returns {Files} */
export function reduceFiles(files, message) {
  switch (message.type) {
    case "hello":
      return { ...NO_FILES, search: files.search };
    case "files":
      return { ...files, list: message.list };
    case "files_search":
      return { ...files, search: message.text };
    case "files_problem":
      return { ...files, problem: message.problem };
    case "file_taken":
      return { ...files, taken: message.taken, problem: null };
    case "file_theirs":
      return { ...files, theirs: message.theirs };
    case "draw_stored":
      return { ...files, theirs: null, problem: null };
    case "file_removes":
      return { ...files, removes: message.file };
    case "sketch":
      return { ...files, sketches: { ...files.sketches, [message.of]: message.sketch } };
    default:
      return files;
  }
}

/** The key of a file's picture. @param {StoredFile} file */
export const fileKey = ({ file, sha256 }) => `file ${file} ${sha256}`;
/** The key of a job's picture. @param {number} job */
export const jobKey = (job) => `job ${job}`;

/** The files of a panel that match the search, the last changed first. @param {Files} files @param {boolean} programs */
export function shownFiles({ list, search }, programs) {
  const wanted = search.trim().toLowerCase();
  const files = (list?.files ?? []).filter(({ kind, name }) => (kind === "program") === programs && name.toLowerCase().includes(wanted));
  return files.sort((a, b) => b.changed_ms - a.changed_ms);
}
