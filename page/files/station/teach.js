// Checks a program shortly after it changed, edits its steps, and creates jobs.

import { base64 } from "../parts/base64.js";
import { parse, stringify } from "../vendor/smol-toml/index.js";
import { rowsIn } from "../state/selectors.js";
import { retaught, rowsOf, titled } from "../state/teach.js";
import { createRecorder } from "./record.js";

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {import("../state/types.js").Problem} Problem */
/** @typedef {ReturnType<typeof createTeach>} TeachRequests */

const CHECK_MS = 200;

/** @param {number} value */
const hundredths = (value) => Math.round(value * 100) / 100;

/** @param {Store} store @param {import("./http.js").Http} http @param {import("./jobs.js").JobRequests} jobs */
export function createTeach(store, http, jobs) {
  const { send } = store;
  /** @type {number | undefined} */ let timer;
  let seen = store.page.teach.revision, checking = false;

  /** One at a time: a large program takes a moment. */
  async function check() {
    if (checking) return;
    checking = true;
    const { revision, text } = store.page.teach;
    const { value, problem } = await http.ask("POST", "api/v1/programs/check", { text, files: {} });
    checking = false;
    if (problem) send({ type: "teach_refused", problem });
    else send({ type: "teach_checked", revision, report: /** @type {Schemas["ProgramReport"]} */ (value) });
    if (store.page.teach.revision !== revision) void check();
  }

  store.subscribe(({ teach, tab }, message) => {
    const opened = message.type === "tab" && tab === "teach" && teach.report === null && teach.text !== "";
    if (teach.revision === seen && !opened) return;
    seen = teach.revision;
    clearTimeout(timer);
    timer = setTimeout(() => void check(), CHECK_MS);
  });

  /** @param {Schemas["Edit"][]} edits @param {number | null} chosen the row that is chosen then */
  async function edit(edits, chosen) {
    const { text, name, revision } = store.page.teach;
    const { value, problem } = await http.ask("POST", "api/v1/programs/edit", { text, edits });
    if (problem) {
      send({ type: "teach_refused", problem });
      return false;
    }
    // Keeps text typed in the meantime.
    if (store.page.teach.revision !== revision) return false;
    send({ type: "teach_text", text: titled(/** @type {Schemas["EditedProgram"]} */ (value).text, name), chosen });
    return true;
  }

  /** The program of the blocks that is not in the text yet. @type {Record<string, unknown> | null} */ let unmerged = null;
  let merging = false;

  /** Puts the program of the blocks into the text, which keeps its comments. @param {Record<string, unknown>} program */
  async function merge(program) {
    unmerged = program;
    if (merging) return;
    merging = true;
    while (unmerged) {
      /** @type {Record<string, unknown>} */ const content = unmerged;
      const { text, revision, name } = store.page.teach;
      const { value, problem } = await http.ask("POST", "api/v1/programs/merge", { text, content: stringify(content) });
      /** @type {boolean} */ const isNew = unmerged !== content;
      if (problem) {
        unmerged = isNew ? unmerged : null;
        send({ type: "teach_refused", problem });
      } else if (!isNew && store.page.teach.revision === revision) {
        unmerged = null;
        merging = false;
        send({ type: "teach_text", text: titled(/** @type {Schemas["MergedProgram"]} */ (value).text, name) });
      }
    }
    merging = false;
  }

  /** After the selected step, or at the end. */
  function behind() {
    const rows = rowsIn(store.page.teach.text);
    return store.page.teach.chosen === null ? rows.length : Math.min(rows.length, store.page.teach.chosen + 1);
  }

  /** @param {Schemas["Action"]} step */
  function insert(step) {
    const at = behind();
    return edit([{ type: "insert", at, step }], at);
  }

  /** The place where the arm is, as a point. */
  function here() {
    const arm = store.page.station?.arm;
    if (!arm) return null;
    const { x_mm, y_mm, z_mm, rotation_deg } = arm;
    return { x: hundredths(x_mm), y: hundredths(y_mm), z: hundredths(z_mm), rotation: hundredths(rotation_deg) };
  }

  /** The place where the arm is, as a touched one. @returns {Schemas["RecordedPlace"] | null} */
  function touched() {
    const arm = store.page.station?.arm;
    return arm ? { point_mm: [arm.x_mm, arm.y_mm, arm.z_mm], rotation_deg: arm.rotation_deg, suction: arm.suction, gripper_deg: arm.gripper_deg } : null;
  }

  /** Removes the touched places once they are used. @param {boolean} isDone */
  const done = (isDone) => void (isDone && send({ type: "teach_wizard", set: { places: [] } }));

  /** The job of the program that is running or paused. */
  function ownJob() {
    const { teach: { ran }, station } = store.page;
    return ran && station?.job?.job === ran.job ? ran : null;
  }

  /** Runs the program as a job, from a row on or from the first; its paused job ends. @param {number | null} row @param {Schemas["Repeat"] | null} times @param {"start_job" | "step_job"} [type] */
  async function run(row, times, type) {
    const { text, name, chosen } = store.page.teach;
    const whole = titled(text, name), before = ownJob();
    const from_line = row === null ? null : rowsOf(whole)[row]?.line ?? null;
    if (before) await jobs.end(before.job);
    const { job, problem } = await jobs.run("api/v1/programs/jobs", { program: { text: whole, files: {} }, from_line, times }, type);
    if (job !== undefined) send({ type: "teach_job", ran: { job, text, chosen } });
    send({ type: "teach_refused", problem: problem ?? null });
  }

  /** Adds a jogged path, and selects its last step. @param {{ places: Schemas["RecordedPlace"][], tolerance_mm: number }} path */
  async function insertPath(path) {
    const at = behind(), before = rowsIn(store.page.teach.text).length;
    if (!(await edit([{ type: "insert_path", at, ...path }], null))) return false;
    send({ type: "teach_chosen", row: at + rowsIn(store.page.teach.text).length - before - 1 });
    return true;
  }

  return {
    insert,
    recorder: createRecorder(store, insertPath),
    here,
    merge,
    /** Whether the blocks are ahead of the text. */
    isMerging: () => merging,
    /** The schema of programs. */
    schema: async () => (await fetch(new URL("../program.schema.json", import.meta.url))).json(),
    /** The place where the arm is, as a step. */
    capture() {
      const go = here();
      return go && insert({ go, path: store.page.teach.path });
    },
    /** Teaches the place of the chosen step again: where the arm is. */
    retake() {
      const { chosen, path, text } = store.page.teach;
      const place = here();
      if (chosen !== null && place) void edit([retaught(text, chosen, place, path)], chosen);
    },
    /** Takes the place where the arm is as the touched one of this number. @param {number} number */
    touch(number) {
      const place = touched(), { places } = store.page.teach.wizard;
      if (place) send({ type: "teach_wizard", set: { places: [...places.slice(0, number), place, ...places.slice(number + 1)] } });
    },
    /** Puts what was touched into the program; a new tray is visited cell by cell after the chosen step. */
    async addTouched() {
      const { text, chosen, wizard: { kind, name: given, places: [first, second, third], columns, rows, layers, layer_mm } } = store.page.teach;
      const name = given.trim();
      if (!first) return;
      const { x, y, z } = Object.fromEntries(["x", "y", "z"].map((key, n) => [key, hundredths(first.point_mm[n] ?? 0)]));
      if (kind === "point") return done(await edit([{ type: "set_point", name, point: { x, y, z, ...(first.rotation_deg ? { rotation: hundredths(first.rotation_deg) } : {}) } }], chosen));
      if (!second || !third) return;
      if (kind === "frame") return done(await edit([{ type: "set_frame", name, places: [first, second, third] }], chosen));
      const isNew = !Object.hasOwn(/** @type {object} */ (parse(text).grids ?? {}), name);
      const at = behind();
      /** @type {Schemas["Edit"][]} */ const visit = isNew && text.trim() ? [{ type: "insert", at, step: { each: name, steps: [{ go: name }] } }] : [];
      done(await edit([{ type: "set_grid", name, corners: [first, second, third], size: { columns, rows, layers, layer_mm: layers > 1 ? layer_mm : 0 } }, ...visit], isNew ? at : chosen));
    },
    remove() {
      const { chosen } = store.page.teach;
      if (chosen === null) return;
      const left = rowsIn(store.page.teach.text).length - 1;
      void edit([{ type: "remove", at: chosen }], left ? Math.min(chosen, left - 1) : null);
    },
    /** @param {number} from @param {number} to */
    async move(from, to) {
      const of = rowsIn(store.page.teach.text).length;
      if (from === to || to < 0 || to >= of) return;
      if (await edit([{ type: "move", from, to }], to)) send({ type: "teach_moved", to, of });
    },
    /** Runs it, from the chosen step on or from the first. @param {boolean} fromChosen @param {Schemas["Repeat"] | null} times */
    run: (fromChosen, times) => run(fromChosen ? store.page.teach.chosen : null, times),
    /** The next step alone: of the paused job, or of a new one if the text or the chosen row is another. */
    async step() {
      const { text, chosen } = store.page.teach, own = ownJob();
      if (own?.text !== text || own.chosen !== chosen) return run(chosen, null, "step_job");
      send({ type: "teach_refused", problem: await jobs.step(own.job) ?? null });
    },
    /** A program, or a file of the vendor's programs. @param {File} file */
    async open(file) {
      const from = /\.(xml|play|playback)$/i.exec(file.name)?.[1]?.toLowerCase();
      if (!from) return send({ type: "teach_text", text: await file.text(), name: file.name, chosen: null });
      const { value, problem } = await http.ask("POST", "api/v1/programs/convert", { data: await base64(file), from, to: "toml" });
      if (problem) return send({ type: "teach_refused", problem });
      const { text } = /** @type {Schemas["ConvertedProgram"]} */ (value);
      send({ type: "teach_text", text, name: file.name.replace(/\.[^.]*$/, ".toml"), chosen: null });
    },
    /** The program as a file of the vendor's programs. @param {Schemas["ProgramForm"]} to @returns {Promise<string | null>} */
    async exported(to) {
      const { value, problem } = await http.ask("POST", "api/v1/programs/convert", { text: store.page.teach.text, to });
      send({ type: "teach_refused", problem: problem ?? null });
      return problem ? null : /** @type {Schemas["ConvertedProgram"]} */ (value).text;
    },
  };
}
