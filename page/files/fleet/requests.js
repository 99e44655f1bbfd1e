// Requests to several stations, through the station of this board.

import { saveAs } from "../parts/download.js";
import { createStop } from "../station/stop.js";
import { drawingOf } from "./drawing_svg.js";
import { isMeant, recipients } from "./members.js";
import { problemOf } from "./outcome.js";
import { listsOf } from "./slots.js";

/** @typedef {import("./fleet.js").Store} Store */
/** @typedef {import("./state.js").Recipients} Recipients */
/** @typedef {import("./state.js").MemberAnswer} MemberAnswer */
/** @typedef {import("./state.js").What} What */
/** @typedef {{ method: string, path: string, body?: unknown, lease?: string }} Request */
/** @typedef {ReturnType<typeof createRequests>} Requests */

/** Polling interval of the visible job list: jobs of other clients are not announced. */
const JOBS_MS = 2000;
const LEASE = "/api/v1/lease", SLOTS = "/api/v1/slots", ARMS = "/api/v1/fleet/virtual-arms";

/** @type {import("../state/types.js").Problem} */
const UNANSWERED = { title: "no answer to STOP", detail: "no station answered STOP", hint: "switch the arms off; the board repeats STOP every second" };

/** @param {Store} store @param {import("../station/http.js").Http} http */
export function createRequests(store, http) {
  const { send } = store;
  let lastNumber = 0;
  /** @type {number | undefined} */ let timer;
  /** @type {number | undefined} */ let slotsTimer;

  /** @param {Recipients} to @param {Request} request @returns {Promise<import("../station/http.js").Outcome<MemberAnswer[]>>} */
  const request = (to, request) => http.ask("POST", "api/v1/fleet/requests", { to, ...request });

  /** Sends a request and shows its outcome. @param {What} what @param {Recipients} to @param {() => ReturnType<typeof request>} does @returns {Promise<MemberAnswer[]>} */
  async function withOutcome(what, to, does) {
    const number = lastNumber += 1;
    // First of all: a stop waits for nothing.
    const outcome = does();
    send({ type: "requested", request: { number, what, to, answers: null, problem: null } });
    const { value, problem } = await outcome;
    send({ type: "answered", number, answers: value ?? null, problem: problem ?? null });
    return value ?? [];
  }

  /** @param {What} what @param {Recipients} to @param {Request} wanted */
  const ask = (what, to, wanted) => withOutcome(what, to, () => request(to, wanted));

  async function readJobs() {
    clearTimeout(timer);
    const { chosen, members } = store.page;
    const member = members.find(({ id }) => id === chosen);
    if (!member) return;
    timer = setTimeout(() => void readJobs(), JOBS_MS);
    if (document.hidden || member.presence.type !== "present") return;
    const { value } = await request({ members: [member.name] }, { method: "GET", path: "/api/v1/jobs" });
    const answer = value?.find(({ id }) => id === member.id)?.answer;
    if (answer && !problemOf(answer)) send({ type: "jobs", id: member.id, jobs: /** @type {import("../state/jobs.js").JobView[]} */ (answer.body) });
  }

  /** Polls the time slots of the visible members. */
  async function readSlots() {
    clearTimeout(slotsTimer);
    const { chosen, members, slots: { open }, group } = store.page;
    const member = members.find(({ id }) => id === chosen);
    if (!member && !open) return;
    slotsTimer = setTimeout(() => void readSlots(), JOBS_MS);
    if (document.hidden) return;
    const { value } = await request(member ? { members: [member.name] } : recipients(group), { method: "GET", path: SLOTS });
    if (value) send({ type: "slots", lists: listsOf(value) });
  }

  /** Asks one station for what is its own. @param {import("./slots.js").Share} share @returns {Promise<MemberAnswer[]>} */
  async function setShare({ name, id, slots }) {
    const { value, problem } = await request({ members: [name] }, { method: "PUT", path: SLOTS, body: { slots } });
    return value ?? [{ member: name, id, answer: { status: problem?.status ?? 503, body: problem ?? null }, took_ms: 0 }];
  }

  store.subscribe((_, { type }) => {
    if (type === "chosen") void readJobs();
    if (type === "chosen" || type === "slots_open" || type === "group") void readSlots();
  });

  /** Asks for something about a job, and reads what became of it. @param {string} name @param {Request} wanted */
  async function ofJob(name, wanted) {
    const answers = await ask("job", { members: [name] }, wanted);
    await readJobs();
    return answers;
  }

  return {
    /** Stops several arms: each press sends a new request, repeated until it is answered. @param {Recipients} to */
    stop(to) {
      const reason = `pressed on the board of ${store.page.name || "a fleet"}`;
      const own = store.page.members.find(({ here }) => here);
      const number = lastNumber += 1;
      /** @param {MemberAnswer[] | null} answers @param {import("../state/types.js").Problem | null} problem */
      const tell = (answers, problem) => send({ type: "answered", number, answers, problem });
      // If the fleet cannot be reached, at least the arm of this station is stopped, before anything is shown.
      const stopOwn = () => void ((!own || isMeant(to, own)) && http.stop("api/v1/stop", { reason }));
      /** @param {string} reason */
      async function ask(reason) {
        const { value, problem } = await http.stop("api/v1/fleet/stop", { to, reason });
        if (problem && problem.status === undefined) return false;
        if (!value?.length) stopOwn();
        tell(value ?? null, problem ?? null);
        return true;
      }
      const again = () => (stopOwn(), ask(`${reason} (repeated)`));
      createStop({ first: () => ask(reason), again, late: () => tell(null, UNANSWERED), answered: () => {} })();
      send({ type: "requested", request: { number, what: "stop", to, answers: null, problem: null } });
    },

    /** A person has looked. Where no other station is shown as stopped, a stop of the fleet is over for its queue too. @param {Recipients} to */
    async reset(to) {
      await ask("reset", to, { method: "DELETE", path: "/api/v1/stop" });
      const { group, members } = store.page;
      if (group === null && members.every((member) => !member.state?.stop?.of_fleet || isMeant(to, member))) void http.ask("DELETE", "api/v1/fleet/stop");
    },

    /** @param {Recipients} to @param {string} message */
    lock: (to, message) => void ask("lock", to, { method: "POST", path: "/api/v1/lock", body: { message } }),

    /** @param {Recipients} to */
    release: (to) => void ask("release", to, { method: "DELETE", path: "/api/v1/lock" }),

    /** Sets the time slots of each arm, replacing existing ones. @param {Recipients} to @param {readonly import("./slots.js").Share[]} shares */
    async setSlots(to, shares) {
      const answers = await withOutcome("slots", to, async () => ({ value: (await Promise.all(shares.map(setShare))).flat() }));
      await readSlots();
      return answers;
    },

    /** @param {Recipients} to */
    clearSlots: (to) => void ask("no_slots", to, { method: "DELETE", path: SLOTS }).then(readSlots),

    /** @param {Recipients} to @param {string} text */
    message: (to, text) => ask("message", to, { method: "POST", path: "/api/v1/message", body: { text } }),

    /** Asks a station for a virtual arm of this name. @param {string} giver @param {string} name */
    giveArm: (giver, name) => ask("give_arm", { members: [giver] }, { method: "POST", path: ARMS, body: { name } }),

    /** Ends a virtual arm that a station gave. @param {string} giver @param {string} name */
    endArm: (giver, name) => void ask("end_arm", { members: [giver] }, { method: "DELETE", path: `${ARMS}/${encodeURIComponent(name)}` }),

    /** @param {string} name */
    pauseJob: (name) => void ofJob(name, { method: "POST", path: "/api/v1/jobs/pause" }),

    /** @param {string} name @param {number} job */
    endJob: (name, job) => void ofJob(name, { method: "DELETE", path: `/api/v1/jobs/${job}` }),

    /** Starts or resumes a job: takes control, and releases it immediately; the job continues without it. @param {string} name @param {number} job */
    async startJob(name, job) {
      const [taken] = await ofJob(name, { method: "POST", path: LEASE, body: { name: `board of ${store.page.name}` } });
      if (!taken || problemOf(taken.answer)) return;
      const { token: lease } = /** @type {{ token: string }} */ (taken.answer.body);
      await ofJob(name, { method: "POST", path: `/api/v1/jobs/${job}/start`, lease });
      await request({ members: [name] }, { method: "DELETE", path: LEASE, lease });
    },

    /** Gives a person what was drawn, a picture for each station. @param {Recipients} to */
    async saveDrawings(to) {
      const answers = await ask("drawing", to, { method: "GET", path: "/api/v1/world" });
      for (const { member, answer } of answers) {
        if (problemOf(answer)) continue;
        const text = drawingOf(/** @type {import("../state/types.js").Schemas["WorldState"]} */ (answer.body), member);
        saveAs(new Blob([text], { type: "image/svg+xml" }), `${member}.svg`);
      }
    },
  };
}
