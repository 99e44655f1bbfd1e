import assert from "node:assert/strict";
import { test } from "node:test";

import { list, outcomeOf, problemOf } from "./outcome.js";

const answer = (member, status, body = {}) => ({ member, id: member, took_ms: 1, answer: { status, body } });
const away = (member) => answer(member, 503, { type: "/api/v1/problems/member-away", detail: `${member} cannot be reached` });

test("stations that obeyed, did not answer and refused are distinguished", () => {
  const role = { type: "/api/v1/problems/role", detail: "this takes the role control", hint: "use another token" };
  const found = outcomeOf([answer("desk-1", 200), away("desk-3"), answer("desk-4", 403, role), away("desk-7"), answer("desk-5", 403, role)]);
  assert.deepEqual([found.done, found.silent], [["desk-1"], ["desk-3", "desk-7"]]);
  assert.deepEqual(found.refused.map(({ members, problem }) => [members, problem.detail, problem.status]), [[["desk-4", "desk-5"], role.detail, 403]]);
});

test("an error answer without a problem document becomes a problem, too", () => {
  for (const body of [null, "text", 7, {}, [], { detail: 3 }]) assert.equal(problemOf({ status: 500, body })?.detail, "the station answered with status 500");
  assert.equal(problemOf({ status: 204, body: null }), null);
});

test("names are listed according to the language, each once", () => {
  assert.equal(list("en", ["desk-2", "desk-2", "desk-3"]), "desk-2 and desk-3");
  assert.equal(list("en", ["desk-3", "desk-7"]), "desk-3 and desk-7");
  assert.equal(list("zh", ["desk-3", "desk-7"]), "desk-3和desk-7");
});
