// Values derived from the members of a fleet. Pure.

/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {import("../state/types.js").Station} Station */
/** @typedef {import("../i18n/i18n.js").TextKey} TextKey */
/** A student in a lesson. @typedef {Schemas["LearnerView"]} Learner */
/** A member with its last reported state and its students. @typedef {Omit<Schemas["Member"], "state" | "about"> & { state: Station | null, about: Schemas["MemberAbout"] | null, learners?: readonly Learner[] }} Member */
/** @typedef {"bad" | "warn" | "good" | "off"} Tone */
/** Something that a person has to know of an arm. @typedef {{ word: TextKey, tone: Tone, values?: Record<string, string> }} Alarm */
/** @typedef {{ group: string | null, members: Member[] }} Section */

/** By name as a person counts: desk-2 comes before desk-10; two of one name by their numbers. @param {readonly Member[]} members */
export const order = (members) => [...members].sort((a, b) => byName(a.name, b.name) || (a.id < b.id ? -1 : 1));

const byName = new Intl.Collator("en", { numeric: true }).compare;

/** @param {Member} member */
export const isThere = ({ presence }) => presence.type === "present";

/** @param {Member} member */
export const groupsOf = ({ about }) => about?.groups ?? [];

/** All groups by name. @param {readonly Member[]} members */
export const groups = (members) => [...new Set(members.flatMap(groupsOf))].sort(byName);

/** The member's own page: an http(s) address or null. @param {Member} member */
export const pageOf = ({ about }) => pageIn(about?.page ?? "");

/** Returns an address if it is http(s), otherwise null. @param {string} page */
export function pageIn(page) {
  return /^https?:\/\//i.test(page) && URL.canParse(page) ? page : null;
}

/**
 * The tiles that are shown, in sections: each station stands in the first of its groups, and those without one come last.
 * If a group is selected, it contains all of its members.
 * @param {readonly Member[]} members @param {{ filter: string, group: string | null, sort: Sort | null }} sift @returns {Section[]}
 */
export function sections(members, { filter, group, sort }) {
  const words = filter.toLowerCase().split(/\s+/).filter(Boolean);
  const shown = members.filter((member) => (group === null || groupsOf(member).includes(group)) && (sort === null || IS[sort](member)) && words.every((word) => textOf(member).includes(word)));
  if (group !== null) return [{ group, members: shown }];
  const named = groups(members).map((name) => ({ group: name, members: shown.filter((member) => groupsOf(member)[0] === name) }));
  const rest = { group: null, members: shown.filter((member) => groupsOf(member).length === 0) };
  return [...named, rest].filter((member) => member.members.length > 0);
}

/** The searchable text of a tile. @param {Member} member */
function textOf({ name, about, state, learners = [] }) {
  return [name, ...(about?.groups ?? []), ...(about?.offers ?? []), ...learners.map(({ student }) => student), state?.job?.title, state?.job?.phase, state?.lease?.name, state?.slots?.now?.student].join(" ").toLowerCase();
}

/** The alarms of an arm, worst first. @param {Member} member @returns {Alarm[]} */
export function alarms({ presence, state, learners }) {
  /** @type {Alarm[]} */ const all = [];
  if (presence.type === "refused") all.push({ word: "fleet.refused", tone: "bad" });
  if (presence.type === "away") all.push({ word: "fleet.offline", tone: "warn" });
  // The state of an offline member may be outdated.
  if (!state || presence.type !== "present") return all;
  const { stop, link, laser, trust, arm, job } = state;
  if (laser.on) all.push({ word: "laser.burning", tone: "bad" });
  if (stop) all.push({ word: stop.at_rest ? "fleet.stopped" : "fleet.stopping", tone: "bad" });
  if (link.phase === "lost") all.push({ word: "link.lost", tone: "bad" });
  if (link.phase === "searching" || link.phase === "listening") all.push({ word: "link.searching", tone: "warn" });
  if (!laser.on && laser.armed_for_s > 0) all.push({ word: "fleet.laser_armed", tone: "warn" });
  if (arm && !trust.trusted) all.push({ word: "fleet.not_confirmed", tone: "warn" });
  if (lockOf(state)) all.push({ word: "fleet.locked", tone: "warn" });
  if (job?.phase === "paused") all.push({ word: "job.paused", tone: "warn" });
  if (learners?.some(isStuck)) all.push({ word: "fleet.stuck", tone: "warn" });
  return all;
}

/** Converts a typed name to a fleet name: lower-case letters and digits, separated by hyphens. @param {string} typed */
export const nameOf = (typed) => typed.trim().normalize("NFD").replace(/\p{M}/gu, "").toLowerCase().replace(/[\s_.-]+/g, "-").replace(/^-|-$/g, "");

/** The station with the most virtual arms left, or null. @param {readonly Member[]} members */
export function giver(members) {
  const left = (/** @type {Member} */ { name, about }) => (about?.gives_arms ?? 0) - members.filter((other) => other.about?.given_by === name).length;
  const givers = members.filter((member) => isThere(member) && member.about?.gives_arms != null);
  return givers.sort((a, b) => left(b) - left(a))[0] ?? null;
}

/** The lock of a station, if one holds it. @param {Station | null} state */
export const lockOf = (state) => state?.lock ?? null;

/** The longest normal time for a lesson step; a lesson of twelve steps takes five minutes. */
const STUCK_S = 180;

/** Whether a student is stuck. @param {Learner} learner */
export const isStuck = ({ done, steps, for_s }) => done < steps && for_s >= STUCK_S;

/** The tone of a tile. @param {Member} member @returns {Tone} */
export function toneOf(member) {
  if (member.presence.type === "away") return "off";
  return alarms(member)[0]?.tone ?? (member.state?.job?.phase === "running" ? "good" : "off");
}

/** Progress of a job, from 0 to 1. @param {{ commands: number, completed: number }} job */
export const share = ({ commands, completed }) => (commands ? completed / commands : 0);

/** The categories that members are counted and filtered by. @typedef {"running" | "stopped" | "offline" | "locked" | "stuck"} Sort */
/** @type {Record<Sort, (member: Member) => boolean>} */
const IS = {
  running: (member) => isThere(member) && member.state?.job?.phase === "running",
  stopped: (member) => isThere(member) && member.state?.stop != null,
  offline: (member) => !isThere(member),
  locked: (member) => isThere(member) && lockOf(member.state) !== null,
  stuck: (member) => isThere(member) && (member.learners?.some(isStuck) ?? false),
};

/** @type {readonly Sort[]} */
export const SORTS = ["running", "stopped", "offline", "locked", "stuck"];

/** Returns the number of members in a category. @param {readonly Member[]} members @param {Sort} sort */
export const count = (members, sort) => members.filter(IS[sort]).length;

/** Whom a person means who has chosen a group, or none. @param {string | null} group @returns {Schemas["Recipients"]} */
export const recipients = (group) => (group === null ? "all" : { group });

/** @param {Schemas["Recipients"]} to @param {Member} member */
export function isMeant(to, member) {
  if (to === "all") return true;
  return "group" in to ? groupsOf(member).includes(to.group) : to.members.includes(member.name);
}
