import assert from "node:assert/strict";
import { test } from "node:test";

import { alarms, count, groups, isMeant, order, pageOf, sections, toneOf } from "./members.js";
import { member } from "./sample.test.js";

const ALL = { filter: "", group: null, sort: null };
const names = (members) => members.map(({ name }) => name);

test("tiles are sorted by name in natural order, and two of one name by their numbers", () => {
  assert.deepEqual(names(order(["desk-10", "desk-2", "desk-1"].map((it) => member(it)))), ["desk-1", "desk-2", "desk-10"]);
  const [one, other] = [{ ...member("desk-1"), id: "b" }, { ...member("desk-1"), id: "a" }];
  assert.deepEqual(order([one, other]), order([other, one]));
});

test("each station appears once, in the first of its groups, and those without a group come last", () => {
  const all = [member("a", { groups: ["room-2", "pens"] }), member("b"), member("c", { groups: ["room-10"] })];
  assert.deepEqual(sections(all, { ...ALL, filter: "", group: null }).map(({ group, members }) => [group, names(members)]), [["room-2", ["a"]], ["room-10", ["c"]], [null, ["b"]]]);
  assert.deepEqual(groups(all), ["pens", "room-2", "room-10"]);
});

test("a selected group shows all its members", () => {
  const all = [member("a", { groups: ["room-2", "pens"] }), member("b", { groups: ["room-1"] })];
  assert.deepEqual(sections(all, { ...ALL, filter: "", group: "pens" }).map(({ group, members }) => [group, names(members)]), [["pens", ["a"]]]);
});

test("a text finds stations by name, group, job and lease holder, word by word", () => {
  const all = [member("desk-1", { groups: ["room-1"], job: { title: "Harbour.svg", phase: "running" } }), member("desk-2", { groups: ["room-1"], lease: { name: "Anna" } })];
  const found = (text) => sections(all, { ...ALL, filter: text, group: null }).flatMap(({ members }) => names(members));
  assert.deepEqual([found("harbour"), found("anna"), found("ROOM-1"), found("room-1 anna"), found("nobody")], [["desk-1"], ["desk-2"], ["desk-1", "desk-2"], ["desk-2"], []]);
});

test("a category shows only the stations that it counts", () => {
  const all = [member("a", { stop: { at_rest: true } }), member("b", { presence: { type: "away" }, stop: { at_rest: true } }), member("c", { lock: { by: "Ms Lee" } })];
  for (const [sort, found] of [["stopped", ["a"]], ["offline", ["b"]], ["locked", ["c"]], ["running", []]]) {
    assert.deepEqual(sections(all, { ...ALL, sort }).flatMap(({ members }) => names(members)), found, sort);
    assert.equal(count(all, sort), found.length, sort);
  }
});

test("the most urgent fact comes first and determines how prominent the tile is", () => {
  const held = { by: "Ms Lee", reason: null, at_rest: false };
  const loud = member("a", { stop: held, laser: { armed_for_s: 60, on: true }, trust: { trusted: false, reason: "reset" } });
  assert.deepEqual(alarms(loud).map(({ word }) => word), ["laser.burning", "fleet.stopping", "fleet.not_confirmed"]);
  assert.equal(toneOf(loud), "bad");
  assert.equal(toneOf(member("b", { laser: { armed_for_s: 60, on: false } })), "warn");
  assert.equal(toneOf(member("c", { job: { phase: "running" } })), "good");
  assert.equal(toneOf(member("d")), "off");
});

test("a student who is at one step for three minutes is stuck, and the tile shows it; one who has finished is not", () => {
  const learner = { student: "Anna", lesson: "tour", done: 2, steps: 12, for_s: 180 };
  const all = [{ ...member("a"), learners: [learner] }, { ...member("b"), learners: [{ ...learner, for_s: 179 }] }, { ...member("c"), learners: [{ ...learner, done: 12 }] }, member("d")];
  assert.deepEqual(all.map((it) => alarms(it).map(({ word }) => word)), [["fleet.stuck"], [], [], []]);
  assert.equal(count(all, "stuck"), 1);
  assert.deepEqual(sections(all, { ...ALL, filter: "anna" }).flatMap(({ members }) => names(members)), ["a", "b", "c"]);
});

test("the tile of an absent station shows nothing else, since it may be outdated", () => {
  const away = member("a", { presence: { type: "away" }, laser: { armed_for_s: 0, on: true } });
  assert.deepEqual(alarms(away).map(({ word }) => word), ["fleet.offline"]);
  assert.equal(count([away], "running"), 0);
});

test("the page of a station is a web address, whatever the station sends", () => {
  assert.equal(pageOf(member("a", { page: "https://desk-3.school:8642/" })), "https://desk-3.school:8642/");
  for (const page of ["javascript:alert(1)", "data:text/html,x", "//elsewhere", "https://", "", null]) assert.equal(pageOf(member("a", { page })), null, String(page));
});

test("the page and the stations agree on the recipients of a request", () => {
  const it = member("desk-3", { groups: ["room-2"] });
  assert.ok(isMeant("all", it) && isMeant({ group: "room-2" }, it) && isMeant({ members: ["desk-3"] }, it));
  assert.ok(!isMeant({ group: "room-1" }, it) && !isMeant({ members: ["desk-30"] }, it));
});
