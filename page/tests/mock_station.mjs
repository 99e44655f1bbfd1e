// A mock of the station of a board, with any number of members: it serves the files on disk, reports the members, and
// keeps what it was asked for.
import { once } from "node:events";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { FACTS } from "../files/stage/sample.test.js";

const TYPES = { html: "text/html", css: "text/css", js: "text/javascript" };

/** What a test answers with that wants an answer lost on its way. */
export const SILENT = Symbol("no answer");

/** The state of a station whose arm rests at a place, with what a test wants to be otherwise. */
export const state = (other = {}) => ({
  at_s: 10, link: { address: "virtual:", phase: "up", problem: null, cause: null, remedy: null, bluetooth: false, statuses_per_s: 12.5, lost_statuses: 0, damaged_bytes: 0, latency_ms: 60 },
  arm: { x_mm: 200, y_mm: 0, z_mm: 40, rotation_deg: 0, base_deg: 0, rear_deg: 30, fore_deg: 40, servo_deg: 0, suction: false, gripper_deg: 0, moving: false },
  dialect: "firmware-1.1", trust: { trusted: true, reason: null }, queue: { waiting: 0, under_way: 0, ahead_s: 0 }, lease: null, stop: null,
  laser: { armed_for_s: 0, on: false }, job: null, clients: 1, ...other,
});

/** Whose time it is at an arm, and who comes next. */
export const time = (student, left_s = 250, next = "Ben") => ({ slots: { now: { student, starts_s: 0, ends_s: 10 + left_s }, next: { student: next, starts_s: 10 + left_s, ends_s: 910 + left_s }, free_s: 910 + left_s } });

/** A station of the fleet; `id` is made of its name. */
export const member = (name, { groups = [], here = false, presence = { type: "present" }, page = `http://127.0.0.1:9/${name}`, is_virtual = true, takes_work, gives_arms, offers = ["pen"], ...other } = {}) => ({
  name, id: Buffer.from(name).toString("hex").padStart(32, "0").slice(-32), here, presence, heard_at_s: 10,
  about: { version: "0.1.0", page, groups, offers, is_virtual, takes_work, gives_arms }, state: state(other),
});

export const job = (title, completed, commands = 100, other = {}) => ({ job: 4, title, kind: "drawing", created_ms: 0, phase: "running", reason: null, commands, completed, planned_s: 200, left_s: 200 * (1 - completed / commands), took_s: null, speed_percent: 100, height_mm: 0, program: null, ...other });

/** What it is at, what waits, and what is over. */
const jobsOf = ({ state: { job: now } }) => [job("first try.svg", 80, 80, { job: 3, phase: "done", took_s: 61, left_s: null }), ...(now ? [{ ...now, job: 4 }] : []), job("card for Mia.svg", 0, 120, { job: 5, phase: "queued", left_s: null })];

export const learner = (student, done, for_s = 12, lesson = "tour") => ({ student, lesson, done, steps: 12, for_s });

/** Work for any arm, as the station of the board tells it. */
export const work = (id, phase, other = {}) => ({ id: id.padEnd(32, "0"), title: `${id}.svg`, student: "Anna", needs: ["pen"], submitted_ms: Date.UTC(2026, 2, 2, 9, 30), phase, ...other });

/** All that work can be. */
export const queue = (members) => {
  const of = (n) => ({ member: { name: members[n].name, id: members[n].id } });
  return [
    work("a0", "done", { title: "star.dxf", student: "Ben", group: "room-1", ...of(1), job: job("star.dxf (Ben)", 80, 80, { phase: "done" }) }),
    work("a1", "failed", { title: "postcard.png", student: "Chen", ...of(2), job: job("postcard.png (Chen)", 12, 80, { phase: "failed", reason: "the link to the arm was lost" }), reason: "the link to the arm was lost" }),
    work("a2", "taken", { title: "harbour.svg", group: "room-1", ...of(1), job: job("harbour.svg (Anna)", 40) }),
    work("a3", "offered", { title: "house.svg", student: "Mia", ...of(5), doubt: `${members[5].name} cannot be reached; it may have been drawn` }),
    work("a4", "waiting", { title: "Zoë's name", student: "Zoë", group: "room-2", needs: ["pen", "a5"], before: [{ ...of(3), drawn: "12 of 80 commands were done when it was heard of last", is_settled: true }] }),
    work("a5", "waiting", { title: "cup.svg", student: "Ben", needs: ["laser"], reason: "no station that takes work and has laser is there now; `dobot up --takes-work --offers ...` makes one" }),
  ];
};

/** Who takes a lesson there: at some of them somebody, and one of these does not get on. */
const learnersOf = ({ name }) => {
  const number = Number(name.split("-")[1]);
  if (number % 4 !== 3) return [];
  return [number % 8 === 3 ? learner(["Mia", "Ben", "Zoë"][number % 3], number % 12) : learner("Chen", 4, 431)];
};

/** @param {object[]} members @param {(request: { method: string, path: string, body: any, token: string | null }) => { status?: number, body: unknown } | typeof SILENT | undefined} answer what is answered otherwise @param {object[]} submitted the work for any arm */
export async function mockStation(members, answer = () => undefined, submitted = []) {
  const asked = [];
  const listeners = new Set();
  /** The time slots of each, by name. */
  const slots = new Map(members.map((it) => [it.name, it.slots ?? []]));
  const fleet = new Map(members.map((it) => [it.id, it]));
  const event = (it) => `event: member\ndata: ${JSON.stringify(it)}\n\n`;
  const json = (response, status, body) => response.writeHead(status, { "content-type": status < 400 ? "application/json" : "application/problem+json" }).end(JSON.stringify(body));
  const meant = (to) => [...fleet.values()].filter((it) => to === "all" || it.about.groups.includes(to.group) || to.members?.includes(it.name));
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, "http://stand.in");
    if (!pathname.startsWith("/api/")) {
      const name = pathname === "/fleet" ? "/fleet/index.html" : pathname === "/" ? "/index.html" : pathname;
      const bytes = await readFile(new URL(`../files${name}`, import.meta.url)).catch(() => null);
      return bytes ? response.writeHead(200, { "content-type": `${TYPES[name.split(".").at(-1)] ?? "text/plain"}; charset=utf-8` }).end(bytes) : response.writeHead(404).end();
    }
    let text = "";
    for await (const piece of request) text += piece;
    const body = text ? JSON.parse(text) : undefined;
    const token = request.headers.authorization?.replace("Bearer ", "") ?? null;
    asked.push({ method: request.method, path: pathname, body, token, key: request.headers["idempotency-key"] });
    const other = answer({ method: request.method, path: pathname, body, token });
    if (other === SILENT) return response.destroy();
    if (other) return json(response, other.status ?? 200, other.body);
    if (pathname === "/api/v1/arm") return json(response, 200, FACTS);
    if (pathname === "/api/v1/fleet") return json(response, 200, { name: members.find((it) => it.here)?.name ?? "", at_s: 10, members: [...fleet.values()] });
    if (pathname === "/api/v1/fleet/work" && request.method === "GET") return json(response, 200, submitted);
    if (pathname === "/api/v1/fleet/events") {
      response.writeHead(200, { "content-type": "text/event-stream" });
      response.write([...fleet.values()].map(event).join(""));
      listeners.add(response);
      return response.on("close", () => listeners.delete(response));
    }
    if (pathname === "/api/v1/fleet/stop" || pathname === "/api/v1/fleet/requests") return json(response, 200, meant(body?.to ?? "all").map((it) => ({ member: it.name, id: it.id, answer: answerOf(it, body), took_ms: 1 })));
    return json(response, 404, { type: "/api/v1/problems/unknown-path", title: "nothing is here", status: 404, detail: `there is nothing at ${pathname}` });
  });
  const answerOf = (it, { path, method, body } = {}) => {
    if (it.presence.type === "away") return { status: 503, body: { type: "/api/v1/problems/member-away", title: "away", status: 503, detail: `${it.name} cannot be reached` } };
    if (path === "/api/v1/learners") return { status: 200, body: learnersOf(it) };
    if (path === "/api/v1/slots") {
      if (method !== "GET") slots.set(it.name, body?.slots ?? []);
      return { status: 200, body: { type: "slots", slots: slots.get(it.name) } };
    }
    return { status: 200, body: path === "/api/v1/jobs" && method === "GET" ? jobsOf(it) : { type: "done" } };
  };
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  return {
    asked,
    url: `http://127.0.0.1:${server.address().port}/fleet`,
    /** Tells a member anew. */
    tell(it) {
      fleet.set(it.id, it);
      for (const response of listeners) response.write(event(it));
    },
    /** How often the events are listened to. */
    listeners: () => listeners.size,
    /** Ends all listening, as a station that ends. */
    cut: () => { for (const response of listeners) response.destroy(); },
    async end() {
      server.closeAllConnections();
      server.close();
    },
  };
}

/** A fleet of so many, with all that can be seen on a tile. */
export function crowd(count) {
  const titles = ["harbour.svg", "Zoë's name", "star.dxf", "pick and place", "postcard.png"];
  return Array.from({ length: count }, (_, n) => {
    const name = `desk-${n + 1}`, groups = [`room-${1 + Math.floor(n / Math.max(12, count / 4))}`];
    const turn = ((n * 37) % 160) - 80, rear_deg = 10 + ((n * 13) % 50), fore_deg = 15 + ((n * 29) % 50);
    const other = { groups, here: n === 0, takes_work: "queue", ...(n === 0 && { gives_arms: 30 }), offers: n % 2 ? ["pen"] : ["pen", "a5"], arm: { ...state().arm, base_deg: turn, rear_deg, fore_deg } };
    if (n % 3 === 1) Object.assign(other, { job: job(titles[n % titles.length], (n * 17) % 100), lease: { client: 2, name: ["Anna", "Bo", "Chen"][n % 3], is_program: false, since_s: 1, asked_by: [] } });
    if (n % 8 === 1) Object.assign(other, time("Anna"));
    if (n % 9 === 4) Object.assign(other, { job: job("name.svg", 40, 100, { phase: "paused", reason: "put the red pen in" }) });
    if (n % 11 === 6) Object.assign(other, { stop: { by: "Ms Lee", reason: "a hand is in the way", at_s: 9, rests_by_s: 9.5, at_rest: true } });
    if (n % 13 === 8) Object.assign(other, { trust: { trusted: false, reason: "the arm was reset: look where it is" } });
    if (n % 14 === 10) Object.assign(other, { laser: { armed_for_s: 212, on: n % 28 === 10 } });
    if (n % 17 === 5) Object.assign(other, { presence: { type: "away" } });
    if (n % 23 === 12) Object.assign(other, { presence: { type: "refused", problem: { type: "member-refused", title: "nothing is asked of this station", status: 409, detail: "two stations are called desk-13", hint: "start one of them with another --name" } } });
    if (n % 19 === 15) Object.assign(other, { arm: null, link: { ...state().link, phase: "searching", address: null } });
    return member(name, other);
  });
}
