import assert from "node:assert/strict";
import { test } from "node:test";

import { arms, canSubmit, counts, ofMember, offers, optionsOf, groupWork } from "./queue.js";
import { begin, reduce } from "./state.js";
import { member } from "./sample.test.js";

const work = (id, phase, other = {}) => ({ id, title: `${id}.svg`, student: "Anna", needs: [], submitted_ms: 0, phase, ...other });
const at = (name) => ({ member: { name, id: `id-${name}` } });
const ids = (all) => all.map(({ id }) => id);
/** A station that is there, takes work and has this. */
const taker = (name, has, other = {}) => {
  const it = member(name, other);
  return { ...it, about: { ...it.about, offers: has, takes_work: "queue" } };
};
const after = (...messages) => messages.reduce(reduce, begin({ language: "en", theme: "auto" }));
const form = (change) => ({ type: "queue_form", form: change });

test("work in doubt comes first, then assigned work, then waiting work in its order, then finished work, the newest first", () => {
  const all = [work("a", "done"), work("b", "waiting"), work("c", "taken", at("desk-1")), work("d", "offered", { ...at("desk-2"), doubt: "desk-2 cannot be reached" }), work("e", "waiting"), work("f", "failed")];
  const { doubt, assigned, waiting, finished } = groupWork(all);
  assert.deepEqual([doubt, assigned, waiting, finished].map(ids), [["d"], ["c"], ["b", "e"], ["f", "a"]]);
  assert.deepEqual(counts(all), { open: 4, doubt: 1 });
});

test("needs are chosen from those that present stations that accept work can meet", () => {
  const all = [taker("desk-1", ["pen", "a5"]), taker("desk-2", ["laser"], { presence: { type: "away" } }), { ...member("desk-3"), about: { ...member("desk-3").about, offers: ["gripper"] } }];
  assert.deepEqual(offers(all, []), ["a5", "pen"]);
  assert.deepEqual(offers(all, ["laser"]), ["a5", "laser", "pen"], "what was chosen before its station went can be taken back");
  assert.deepEqual(arms(all, ["pen"]).map(({ name }) => name), ["desk-1"]);
  assert.deepEqual(arms(all, ["pen", "laser"]), []);
});

test("an arm's share of the queue is its work, its offers, and the waiting work that it could accept", () => {
  const desk = taker("desk-1", ["pen"]);
  const all = [
    work("has", "taken", at("desk-1")), work("asked", "offered", at("desk-1")), work("elsewhere", "taken", at("desk-2")), work("over", "done", at("desk-1")),
    work("fits", "waiting", { needs: ["pen"] }), work("needs more", "waiting", { needs: ["pen", "laser"] }), work("was here", "waiting", { before: [{ ...at("desk-1"), drawn: "", is_settled: true }] }),
  ];
  assert.deepEqual(ids(ofMember(all, desk).has), ["has", "asked"]);
  assert.deepEqual(ids(ofMember(all, desk).suitable), ["fits"]);
  assert.deepEqual(ofMember(all, member("desk-1")).suitable, [], "a station that takes no work could take none");
});

test("a submission needs a subject, a student and a height that is a number or empty", () => {
  const whole = { what: "text", text: "Anna", student: "Anna" };
  assert.ok(canSubmit(after(form(whole)).queue.form));
  for (const wrong of [{ text: " " }, { student: "" }, { down: "low" }, { what: "file" }]) assert.ok(!canSubmit(after(form({ ...whole, ...wrong })).queue.form), JSON.stringify(wrong));
  assert.ok(canSubmit(after(form({ ...whole, down: "-40,5" })).queue.form));
});

test("the height of the paper is sent if it is given, and otherwise left to the station that draws", () => {
  const options = (change) => optionsOf(after(form({ what: "text", text: "Anna", ...change })).queue.form);
  assert.deepEqual(options({ down: "-40,5", fit: true }), { what: { text: "Anna" }, place: { fit: true, pen_down: -40.5 } });
  assert.deepEqual(options({}), { what: { text: "Anna" }, place: { fit: false } });
});

test("submitted fields are cleared except for the student; text typed meanwhile stays", () => {
  const typed = after(form({ what: "text", text: "Anna", student: "Anna", needs: ["pen"] }), { type: "queue_asked", work: null });
  const done = (board) => reduce(board, { type: "queue_submitted", form: typed.queue.form, title: "Anna" });
  assert.deepEqual([done(typed).queue.form.text, done(typed).queue.form.student, done(typed).queue.form.needs], ["", "Anna", ["pen"]]);
  assert.equal(done(reduce(typed, form({ text: "Ben" }))).queue.form.text, "Ben");
});

test("a refusal is shown next to its request until the next one there; if a token is missing, the page asks for one", () => {
  const denied = { title: "", detail: "this takes the role queue", status: 403 };
  const board = after({ type: "queue_asked", work: "a" }, { type: "queue_refused", work: "a", problem: denied });
  assert.deepEqual(board.queue.refused, { work: "a", problem: denied });
  assert.deepEqual(board.denied, denied);
  assert.equal(reduce(board, { type: "queue_asked", work: "a" }).queue.refused, null);
});

test("the queue and the details of an arm are never open together: on a phone each fills the screen", () => {
  const board = after({ type: "chosen", id: "id-a" }, { type: "queue_open", open: true });
  assert.deepEqual([board.chosen, board.queue.open], [null, true]);
  assert.equal(reduce(board, { type: "chosen", id: "id-b" }).queue.open, false);
});
