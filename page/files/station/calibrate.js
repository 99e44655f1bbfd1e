// Calibration requests: reads what is known, fits recorded points, and saves the reviewed result.

import { saveFrom } from "../parts/download.js";
import { LEAST_TOUCHES, pointBlockedReason, questionOf, rawDegrees, touchBlockedReason, touchesOf } from "../state/calibrate.js";
import { PLACES } from "../state/touch_paper.js";

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {ReturnType<typeof createCalibrate>} CalibrateRequests */

const KNOWN = "api/v1/calibration";

/** @param {Store} store @param {import("./http.js").Http} http @param {import("./set_up.js").Change} change */
export function createCalibrate(store, http, change) {
  const { send } = store;
  let seen = store.page.calibrate.revision;
  let touched = store.page.touch_paper.places;

  async function read() {
    /** @type {Schemas["Calibrations"] | undefined} */
    const known = await http.json(KNOWN);
    if (known) send({ type: "calibrations", known });
  }

  /** @param {object} question */
  const ask = (question) => http.ask("POST", `${KNOWN}/fit`, question);

  async function fit() {
    const { revision } = store.page.calibrate;
    const { value, problem } = await ask(questionOf(store.page.calibrate));
    send({ type: "calibrate_fitted", revision, fit: /** @type {Schemas["FitReport"] | undefined} */ (value) ?? null, problem: problem ?? null });
  }

  /** @param {readonly import("../stage/view.js").Point[]} places */
  async function judge(places) {
    const { value, problem } = await http.ask("POST", `${KNOWN}/paper`, { places_mm: places });
    send({ type: "paper_judged", places, found: /** @type {Schemas["PaperReport"] | undefined} */ (value) ?? null, problem: problem ?? null });
  }

  store.subscribe(({ tab, calibrate, touch_paper: { places } }, message) => {
    const news = message.type === "hello" || message.type === "tab" || (message.type === "notice" && message.notice.type === "calibrated");
    if (news && (tab === "set_up" || tab === "draw" || tab === "look")) void read();
    if (places !== touched) {
      touched = places;
      if (places && places.length >= PLACES) void judge(places);
    }
    if (calibrate.revision === seen) return;
    seen = calibrate.revision;
    if (touchesOf(calibrate).length >= LEAST_TOUCHES) void fit();
  });

  /** @param {Schemas["CalibrationFile"] | null} calibration @param {"calibrate" | "paper"} [place] where it was asked for */
  async function hold(calibration, place = "calibrate") {
    /** @type {Extract<Schemas["Reply"], { type: "calibrated" }> | undefined} */
    const reply = await change(place, "PUT", KNOWN, { calibration });
    if (reply) send({ type: "calibrations", known: reply.calibrations });
    return reply !== undefined;
  }

  return {
    async begin() {
      /** @type {Schemas["SheetPoints"] | undefined} */
      const sheet = await change("calibrate", "GET", `${KNOWN}/points`);
      if (sheet) send({ type: "calibrate_begun", sheet });
    },
    /** Gives a person the sheet: with the token, which a link would not carry. */
    saveSheet: () => saveFrom(http, `${KNOWN}/sheet`, "sheet.svg"),
    /** Has the station check the bar of the print. */
    async takeBar() {
      const { number, bar } = store.page.calibrate;
      const print = { sheet: Number(number), bar_mm: Number(bar) };
      const { problem } = await http.ask("POST", `${KNOWN}/bar`, print);
      send({ type: "calibrate_bar", print, problem: problem ?? null });
    },
    /** The tip stands on the point. */
    touch() {
      const arm = store.page.station?.arm;
      if (arm && !pointBlockedReason(store.page)) send({ type: "calibrate_visited", raw_deg: rawDegrees(arm) });
    },
    /** Saves exactly the reviewed calibration. */
    async keep() {
      const { shown } = store.page.calibrate;
      if (shown && (await hold(shown))) send({ type: "calibrate_ended" });
    },
    bringBack() {
      const before = store.page.calibrate.known?.before;
      if (before) void hold(before);
    },
    forget: () => hold(null),
    /** The tip stands on the paper. */
    touchPaper() {
      const arm = store.page.station?.arm;
      if (arm && !touchBlockedReason(store.page)) send({ type: "paper_touched", place: [arm.x_mm, arm.y_mm, arm.z_mm] });
    },
    /** Saves the paper surface with the rest of the calibration. @param {Schemas["PaperPlane"] | null} paper */
    keepPaper: (paper) => hold(/** @type {Schemas["CalibrationFile"]} */ ({ zeros: { base: 0, rear: 0, fore: 0 }, ...store.page.calibrate.known?.calibration, paper }), "paper"),
  };
}
