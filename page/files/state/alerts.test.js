import assert from "node:assert/strict";
import test from "node:test";
import { translator } from "../i18n/i18n.js";
import { iconOf, newsOf, titleOf } from "./alerts.js";
import { begin } from "./state.js";

const t = translator("en");
const page = begin({ language: "en", theme: "auto", greeted: true, program: "" });
/** @param {object} job */
const drawing = (job) => /** @type {import("./state.js").Page} */ ({ ...page, connection: "open", station: { job: { job: 7, title: "harbour.svg", phase: "running", commands: 200, completed: 83, reason: null, waits_for_person: false, question: null, ...job } } });
/** @param {object} notice */
const notice = (notice) => /** @type {import("./message.js").Message} */ ({ type: "notice", notice: { number: 1, at_s: 0, text: "", ...notice } });
const state = /** @type {import("./message.js").Message} */ ({ type: "state" });

test("the title shows how far the job is, and is plain without one", () => {
  assert.equal(titleOf(drawing({}), t), "41 % harbour.svg");
  assert.equal(titleOf(page, t), "Dobot station");
  // Of a station that cannot be reached nothing is known.
  assert.equal(titleOf({ ...drawing({}), connection: "closed" }, t), "Dobot station");
});

test("the icon changes in steps, not with each command", () => {
  assert.equal(iconOf(drawing({})), iconOf(drawing({ completed: 84 })));
  assert.notEqual(iconOf(drawing({})), iconOf(drawing({ completed: 120 })));
  assert.equal(iconOf(page), null);
});

test("a pen change is announced once, when it begins", () => {
  const waits = drawing({ phase: "paused", waits_for_person: true, reason: "pen 2: blue" });
  assert.equal(newsOf(drawing({}), waits, state, null, t), "harbour.svg waits for you: pen 2: blue");
  assert.equal(newsOf(waits, waits, state, null, t), null);
  assert.equal(newsOf(drawing({}), drawing({ phase: "paused" }), state, null, t), null);
});

test("the end of a job, also of one that the station no longer shows, and a lost arm are announced, and other notices are not", () => {
  const over = (/** @type {string} */ phase) => newsOf(page, page, notice({ type: "job", job: 7, phase }), { job: 7, title: "harbour.svg" }, t);
  assert.equal(over("done"), "harbour.svg is done.");
  assert.match(over("failed") ?? "", /harbour\.svg has ended: failed/i);
  assert.equal(over("running"), null);
  assert.equal(newsOf(page, page, notice({ type: "job", job: 8, phase: "done" }), { job: 7, title: "harbour.svg" }, t), "Job 8 is done.");
  assert.equal(newsOf(page, page, notice({ type: "link_lost" }), null, t), "The connection to the arm is lost.");
  assert.equal(newsOf(page, page, notice({ type: "link_up" }), null, t), null);
});
