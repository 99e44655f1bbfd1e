// The WebSocket to the station: connects, reconnects, and delivers each answer to its requester. It draws nothing.

import { DEVICE } from "../parts/name.js";
import { createThreadedSocket } from "./threaded_socket.js";
import { SILENT_MS, watchSilence } from "./silence.js";

/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {import("../state/types.js").Request} Request */
/** @typedef {import("../state/types.js").Answer} Answer */
/** @typedef {import("../state/types.js").Station} Station */
/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {ReturnType<typeof createSocket>} Socket */

const RECONNECT_MS = 1000, CONNECT_MS = 5000;
/** Requests that need control. Held buttons and pads take it once, when they are pressed: a hold does not take it back. @type {ReadonlySet<Request["type"]>} */
const NEED_CONTROL = new Set(["step", "arm_laser", "set_angles", "detect", "start_job", "step_job", "set_job_speed", "set_job_height"]);
/** Requests that end the hold of a button. @type {ReadonlySet<Request["type"]>} */
const ENDS_HOLD = new Set(["release", "stop"]);
/** @type {Answer} */
const LET_GO = { problem: { type: "/api/v1/problems/let-go", title: "the button was released", detail: "the page did not respond in time" } };
/** @type {Answer} */
export const NO_CONNECTION = { problem: { type: "no-connection", title: "no connection", detail: "the station cannot be reached at the moment", hint: "the page reconnects automatically" } };

/** The version of this page; none where its files are not from a station. */
const PAGE = document.querySelector("meta[name=dobot-page]")?.getAttribute("content");

/** Whether the station serves another version of this page. @param {string} served */
const isStale = (served) => PAGE != null && served !== PAGE;

/**
 * @param {object} outside
 * @param {Store} outside.store
 * @param {import("./http.js").Http} outside.http
 */
export function createSocket({ store, http }) {
  const open = createThreadedSocket();
  /** @type {import("./threaded_socket.js").Connection | undefined} */ let socket;
  let lastId = 0;
  /** @type {Map<number, (answer: Answer) => void>} */ const waiting = new Map();

  const isOpen = () => socket?.isOpen() ?? false;
  // A station sends a state with each status of a connected arm, and on changes of a disconnected one.
  const isExpected = () => isOpen() && (store.page.station?.link.phase ?? "up") === "up";
  const resetSilence = watchSilence({ isExpected, silent: reconnect });

  function connect() {
    store.send({ type: "connecting" });
    const url = new URL("api/v1/ws", location.href);
    const { name } = store.page;
    if (name) url.searchParams.set("name", name);
    url.searchParams.set("device", DEVICE);
    url.protocol = url.protocol.replace("http", "ws");
    const token = http.token();
    const late = setTimeout(() => mine === socket && reconnect(), CONNECT_MS);
    /** @type {import("./threaded_socket.js").Connection} */
    const mine = open(url.href, token ? ["dobot", `dobot.token.${token}`] : ["dobot"], {
      opened: () => clearTimeout(late),
      message: (data) => mine === socket && handleMessage(JSON.parse(data), name || "page"),
      released: (id) => mine === socket && answer(id, LET_GO),
      closed(end) {
        clearTimeout(late);
        if (mine === socket) void tryAgain(end);
      },
    });
    socket = mine;
  }

  /** Replaces the connection without waiting for its end: a silent one may take minutes to close. */
  function reconnect() {
    const last = socket;
    socket = undefined;
    last?.close();
    lose();
    connect();
  }

  function lose() {
    for (const resolve of waiting.values()) resolve(NO_CONNECTION);
    waiting.clear();
    // Nothing counts as held from now on, with or without a token.
    store.send({ type: "closed", needs_token: false });
  }

  /** @param {Schemas["ToClient"]} message @param {string} name the name of this page */
  function handleMessage(message, name) {
    resetSilence();
    const now_ms = Date.now();
    if ("hello" in message) {
      const { client, role, version, fleet = null, page = "", person = "" } = message.hello;
      store.send({ type: "hello", client, role, version, fleet, person, says_name: person === name, is_stale: isStale(page), now_ms });
    } else if ("state" in message) {
      store.send({ type: "state", station: /** @type {Station} */ (message.state), now_ms });
    } else if ("notice" in message) {
      store.send({ type: "notice", notice: message.notice });
    } else if (message.id != null && waiting.has(message.id)) {
      answer(message.id, "problem" in message ? { problem: message.problem } : { reply: message.reply });
    } else if ("problem" in message) {
      store.send({ type: "problem", problem: message.problem });
    }
  }

  /** Gives a request its answer. @param {number} id @param {Answer} answer */
  function answer(id, answer) {
    waiting.get(id)?.(answer);
    waiting.delete(id);
  }

  /** @param {{ code: number, reason: string }} event */
  async function tryAgain(event) {
    lose();
    if (event.code === 1008) store.send({ type: "problem", problem: { title: "the station closed the connection", detail: event.reason } });
    const answer = await http.get("api/v1/state", AbortSignal.timeout(SILENT_MS));
    if (answer?.status === 401) store.send({ type: "closed", needs_token: true, is_unknown: http.token() !== null });
    else setTimeout(connect, RECONNECT_MS);
  }

  /** Takes control if nobody has it, as the first action does. */
  function takeControlIfFree() {
    if (store.page.station && !store.page.station.lease) void ask({ type: "take_lease" });
  }

  /** Sends a request; it always gets an answer. @param {Request} request @param {import("./keep_alive.js").Hold | null} [hold] the hold of a button that it repeats @returns {Promise<Answer>} */
  function ask(request, hold = null) {
    if (!socket || !isOpen()) return Promise.resolve(NO_CONNECTION);
    if (NEED_CONTROL.has(request.type)) takeControlIfFree();
    // A person starts the job here and has seen what it waits for.
    const { job } = store.page.station ?? {};
    if ((request.type === "start_job" || request.type === "step_job") && job?.job === request.job && job.waits_for_person) void ask({ type: "confirm_job", job: request.job });
    const id = lastId += 1;
    /** @type {Schemas["FromClient"]} */
    const message = { id, request };
    socket.send(JSON.stringify(message), id, hold, ENDS_HOLD.has(request.type));
    return new Promise((resolve) => waiting.set(id, resolve));
  }

  return {
    connect,
    isOpen,
    ask,
    /** Says that the page responds, while a button is held. */
    beat: () => void socket?.beat(),
    /** Sends a piece of sound to the listener next to the station; empty at its end. @param {ArrayBuffer} pcm */
    sendAudio: (pcm) => socket?.sendAudio(pcm),
    takeControlIfFree,
    /** Reconnects, under the current name. */
    again: () => isOpen() && reconnect(),
  };
}
