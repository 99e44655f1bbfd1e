// The state of the board: one tree, changed by `reduce` alone. Pure: no clock, no document, no network.

import { order } from "./members.js";
import { problemOf } from "./outcome.js";
import { NO_QUEUE, reduceQueue } from "./queue.js";

/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {import("../state/types.js").Problem} Problem */
/** @typedef {import("../i18n/i18n.js").Language} Language */
/** @typedef {import("../state/state.js").Theme} Theme */
/** @typedef {import("./members.js").Member} Member */
/** @typedef {Schemas["Recipients"]} Recipients */
/** @typedef {Schemas["MemberAnswer"]} MemberAnswer */
/** @typedef {import("../state/jobs.js").JobView} JobView */

/** `token`: the station of this board wants one. `alone`: it belongs to no fleet. @typedef {"connecting" | "open" | "closed" | "token" | "alone"} Connection */
/** The kinds of requests to several stations. @typedef {"stop" | "reset" | "lock" | "release" | "message" | "job" | "drawing" | "slots" | "no_slots" | "give_arm" | "end_arm"} What */
/** A request with its outcome: all answers, or the problem; neither while it is pending. @typedef {{ number: number, what: What, to: Recipients, answers: readonly MemberAnswer[] | null, problem: Problem | null }} FleetRequest */
/** A question that asks for confirmation. @typedef {({ about: "fleet_reset", to: Recipients } | { about: "fleet_reassign" | "fleet_cancel", work: string } | { about: "fleet_end_arm", giver: string, name: string }) & { values: Record<string, string | number> }} Question */

/**
 * @typedef {object} Board
 * @property {Connection} connection
 * @property {string} name Name of this board's station; empty until known.
 * @property {readonly Member[]} members In the order in which they are shown.
 * @property {import("../state/types.js").Facts | null} facts The facts of this station's arm, used to draw all arms.
 * @property {number} received_ms When something came last, by the clock of this page.
 * @property {number} now_ms
 * @property {string} filter Filter for tiles.
 * @property {string | null} group The group that is shown alone.
 * @property {import("./members.js").Sort | null} sort The only sort that is shown.
 * @property {string | null} current The station whose tile the tab key leads to, by its number.
 * @property {string | null} chosen The station whose details are shown, by its number.
 * @property {import("./queue.js").Queue} queue Work for any arm.
 * @property {{ open: boolean, lists: Record<string, readonly import("../state/slots.js").TimeSlot[]> }} slots Time slots: whether the panel is open, and the slots of each station by its id.
 * @property {readonly JobView[] | null} jobs The jobs of that station; nothing where they are not known yet.
 * @property {FleetRequest | null} stop The stop that was asked for last; its outcome stays until it is let go.
 * @property {FleetRequest | null} request The last other request.
 * @property {Problem | null} denied Why a token is required.
 * @property {boolean} lesson Whether the class tools are open on a phone.
 * @property {boolean} wanting Whether the form for a virtual arm is open.
 * @property {Question | null} question
 * @property {Language} language
 * @property {Theme} theme
 */

/**
 * @typedef {{ type: "fleet", name: string, members: readonly Member[], now_ms: number }
 * | { type: "members", members: readonly Member[], gone: readonly string[], now_ms: number }
 * | { type: "alive", now_ms: number }
 * | { type: "learners", answers: readonly MemberAnswer[] }
 * | { type: "facts", facts: import("../state/types.js").Facts }
 * | { type: "connecting" }
 * | { type: "closed", problem: Problem | null }
 * | { type: "alone" }
 * | { type: "tick", now_ms: number }
 * | { type: "filter", text: string }
 * | { type: "group", group: string | null }
 * | { type: "sort", sort: import("./members.js").Sort | null }
 * | { type: "current", id: string }
 * | { type: "chosen", id: string | null }
 * | { type: "jobs", id: string, jobs: readonly JobView[] }
 * | { type: "slots_open", open: boolean }
 * | { type: "slots", lists: Board["slots"]["lists"] }
 * | { type: "requested", request: FleetRequest }
 * | { type: "answered", number: number, answers: readonly MemberAnswer[] | null, problem: Problem | null }
 * | { type: "outcome_closed", what: "stop" | "request" | "denied" }
 * | { type: "lesson", open: boolean }
 * | { type: "wanting", open: boolean }
 * | { type: "question", question: Question | null }
 * | import("./queue.js").QueueMessage} Message
 */

/** @param {{ language: Language, theme: Theme }} wish @returns {Board} */
export const begin = ({ language, theme }) => ({
  connection: "connecting",
  name: "",
  members: [],
  facts: null,
  received_ms: 0,
  now_ms: 0,
  filter: "",
  group: null,
  sort: null,
  current: null,
  chosen: null,
  jobs: null,
  queue: NO_QUEUE,
  slots: { open: false, lists: {} },
  stop: null,
  request: null,
  denied: null,
  lesson: false,
  wanting: false,
  question: null,
  language,
  theme,
});

/** @param {Board} board @param {Message} message @returns {Board} */
export function reduce(board, message) {
  switch (message.type) {
    case "fleet":
      return { ...board, connection: "open", name: message.name, members: order(withLearners(board.members, message.members)), received_ms: message.now_ms, now_ms: message.now_ms };
    case "members":
      return { ...board, chosen: message.gone.includes(board.chosen ?? "") ? null : board.chosen, members: withNews(without(board.members, message.gone), withLearners(board.members, message.members)), received_ms: message.now_ms, now_ms: message.now_ms };
    case "alive":
      return { ...board, received_ms: message.now_ms, now_ms: message.now_ms };
    case "learners":
      return { ...board, members: board.members.map((member) => ({ ...member, learners: learnersOf(message.answers, member) })) };
    case "facts":
      return { ...board, facts: message.facts };
    case "connecting":
      return board.connection === "token" ? { ...board, connection: "connecting" } : board;
    case "closed":
      return { ...board, connection: message.problem ? "token" : "closed", denied: message.problem ?? board.denied };
    case "alone":
      return { ...board, connection: "alone", members: [] };
    case "tick":
      return { ...board, now_ms: message.now_ms };
    case "filter":
      return { ...board, filter: message.text };
    case "group":
      return { ...board, group: message.group };
    case "sort":
      return { ...board, sort: message.sort };
    case "current":
      return { ...board, current: message.id };
    case "chosen":
      return { ...board, chosen: message.id, jobs: null, queue: { ...board.queue, open: board.queue.open && message.id === null }, slots: { ...board.slots, open: board.slots.open && message.id === null } };
    case "jobs":
      return message.id === board.chosen ? { ...board, jobs: message.jobs } : board;
    case "requested":
      // After a reset the tiles show which stations did not answer.
      return { ...board, ...(message.request.what === "reset" && { stop: null }), [placeOf(message.request.what)]: message.request, question: null };
    case "answered":
      return answered(board, message);
    case "outcome_closed":
      return { ...board, [message.what]: null };
    case "lesson":
      return { ...board, lesson: message.open };
    case "wanting":
      return { ...board, wanting: message.open };
    case "question":
      return { ...board, question: message.question };
    case "queue_open":
      return { ...board, queue: reduceQueue(board.queue, message), chosen: message.open ? null : board.chosen, slots: { ...board.slots, open: board.slots.open && !message.open } };
    case "slots_open":
      return { ...board, slots: { ...board.slots, open: message.open }, chosen: message.open ? null : board.chosen, queue: { ...board.queue, open: board.queue.open && !message.open } };
    case "slots":
      return { ...board, slots: { ...board.slots, lists: { ...board.slots.lists, ...message.lists } } };
    case "queue_refused":
      return { ...board, queue: reduceQueue(board.queue, message), denied: isDenial(message.problem) ? message.problem : board.denied };
    default:
      return { ...board, queue: reduceQueue(board.queue, message) };
  }
}

/** A stop keeps a place of its own: nothing that is asked for later hides who did not answer. @param {What} what */
const placeOf = (what) => (what === "stop" ? "stop" : "request");

/** Members that came or changed among all of them; who came first has the same place as before. @param {readonly Member[]} members @param {readonly Member[]} news */
function withNews(members, news) {
  const changed = new Map(news.map((member) => [member.id, member]));
  const isNew = [...changed.values()].some(({ id }) => members.every((member) => member.id !== id));
  if (!isNew) return members.map((member) => changed.get(member.id) ?? member);
  const all = new Map([...members, ...news].map((member) => [member.id, member]));
  return order([...all.values()]);
}

/** The remaining members. @param {readonly Member[]} members @param {readonly string[]} gone */
const without = (members, gone) => (gone.length ? members.filter(({ id }) => !gone.includes(id)) : members);

/** Updated members, with their known students. @param {readonly Member[]} members @param {readonly Member[]} news @returns {Member[]} */
function withLearners(members, news) {
  const known = new Map(members.map((member) => [member.id, member.learners]));
  return news.map((member) => {
    const learners = known.get(member.id);
    return learners ? { ...member, learners } : member;
  });
}

/** The students of a station; where it does not answer nothing is known of them. @param {readonly MemberAnswer[]} answers @param {Member} member */
function learnersOf(answers, { id }) {
  const answer = answers.find((entry) => entry.id === id)?.answer;
  return answer && !problemOf(answer) ? /** @type {import("./members.js").Learner[]} */ (answer.body) : [];
}

/** Of two that were asked the later one counts. @param {Board} board @param {Extract<Message, { type: "answered" }>} message @returns {Board} */
function answered(board, { number, answers, problem }) {
  const denied = problem && isDenial(problem) ? problem : firstDenial(answers ?? []) ?? board.denied;
  for (const place of /** @type {const} */ (["stop", "request"])) {
    const request = board[place];
    if (request?.number === number) return { ...board, denied, [place]: { ...request, answers, problem } };
  }
  return { ...board, denied };
}

/** @param {Problem} problem */
const isDenial = ({ status }) => status === 401 || status === 403;

/** @param {readonly MemberAnswer[]} answers @returns {Problem | undefined} */
function firstDenial(answers) {
  const denied = answers.find(({ answer }) => isDenial(/** @type {Problem} */ ({ status: answer.status })));
  return denied && /** @type {Problem} */ (denied.answer.body);
}
