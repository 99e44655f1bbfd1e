// Requests a plan shortly after the drawing changed, and deletes plans that are no longer needed.

import { timelineOf } from "../preview/timeline.js";
import { hasSubject, optionsOf, wrongField } from "../state/draw.js";
import { readDrawing } from "./drawing_file.js";

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {import("../state/types.js").Problem} Problem */

const PLAN_MS = 250;

/** @param {Store} store @param {import("./http.js").Http} http @param {import("./files.js").FileRequests} files */
export function followDrawing(store, http, files) {
  const { send } = store;
  /** @type {number | undefined} */ let timer;
  let seen = store.page.draw.revision;
  /** The drawings that the station plans or keeps for this page. @type {Set<number>} */ const kept = new Set();

  const isWanted = (/** @type {number} */ revision) => store.page.draw.revision === revision;

  /** @param {number | null} but */
  function forgetAll(but) {
    for (const drawing of kept) {
      if (drawing === but) continue;
      kept.delete(drawing);
      void http.ask("DELETE", `api/v1/drawings/${drawing}`);
    }
  }

  /** The body of the request. @returns {Promise<{ body?: unknown, problem?: Problem }>} */
  async function body() {
    const { what, file } = store.page.draw;
    if (what === "file" && file && !store.page.draw.stored) {
      const stored = await files.stored(file);
      if (stored) send({ type: "draw_kept", file, stored });
    }
    const { stored } = store.page.draw;
    const options = optionsOf(store.page);
    if (what === "text") return { body: { options } };
    if (stored) return { body: { stored: stored.file, options } };
    if (!file) return { body: { options } };
    const { content, problem } = await readDrawing(file);
    return problem ? { problem } : { body: { ...content, options } };
  }

  /** @param {number} revision @param {number} drawing */
  async function follow(revision, drawing) {
    const { set } = store.page.draw;
    while (isWanted(revision)) {
      const { value, problem } = await http.ask("GET", `api/v1/drawings/${drawing}`);
      if (problem) return send({ type: "draw_failed", revision, problem });
      const view = /** @type {Schemas["DrawingView"]} */ (value);
      if (view.problem) return send({ type: "draw_failed", revision, problem: view.problem });
      if (view.plan) return send({ type: "draw_planned", revision, title: view.title, plan: view.plan, timeline: timelineOf(view.plan.timeline), set });
    }
  }

  async function plan() {
    const { draw } = store.page;
    forgetAll(null);
    if (!hasSubject(draw) || wrongField(draw.set)) return;
    const { revision } = draw;
    const request = await body();
    // Once it is stored, it is planned where it was placed.
    if (!isWanted(revision)) return;
    if (request.problem) return send({ type: "draw_failed", revision, problem: request.problem });
    const { value, problem } = await http.ask("POST", "api/v1/drawings", request.body);
    if (problem) return send({ type: "draw_failed", revision, problem });
    const { drawing } = /** @type {Schemas["DrawingView"]} */ (value);
    kept.add(drawing);
    if (!isWanted(revision)) return forgetAll(null);
    send({ type: "draw_begun", revision, drawing });
    await follow(revision, drawing);
  }

  async function readChoices() {
    const [materials, formats] = await Promise.all([http.json("api/v1/materials"), http.json("api/v1/formats")]);
    if (materials) send({ type: "materials", materials });
    if (formats) send({ type: "formats", formats });
  }

  store.subscribe(({ draw }, { type }) => {
    if (type === "hello") void readChoices();
    if (draw.revision === seen) return;
    seen = draw.revision;
    clearTimeout(timer);
    if (type === "draw_cancelled") forgetAll(null);
    else timer = setTimeout(() => void plan(), PLAN_MS);
  });
}
