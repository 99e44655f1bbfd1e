// The WebSocket to the station: connects, reconnects, and delivers each answer to its requester. It draws nothing.

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
  /** @type {WebSocket | undefined} */ let socket;
  let lastId = 0;
  /** @type {Map<number, (answer: Answer) => void>} */ const waiting = new Map();

  const isOpen = () => socket?.readyState === WebSocket.OPEN;
  // A station sends a state with each status of a connected arm, and on changes of a disconnected one.
  const isExpected = () => isOpen() && (store.page.station?.link.phase ?? "up") === "up";
  const resetSilence = watchSilence({ isExpected, silent: reconnect });

  function connect() {
    store.send({ type: "connecting" });
    const url = new URL("api/v1/ws", location.href);
    const name = store.page.learn.student || "page";
    url.searchParams.set("name", name);
    url.protocol = url.protocol.replace("http", "ws");
    const token = http.token();
    const mine = socket = new WebSocket(url, token ? ["dobot", `dobot.token.${token}`] : ["dobot"]);
    const late = setTimeout(() => mine === socket && reconnect(), CONNECT_MS);
    mine.addEventListener("open", () => clearTimeout(late));
    mine.addEventListener("message", (event) => mine === socket && handleMessage(JSON.parse(event.data), name));
    mine.addEventListener("close", (event) => {
      clearTimeout(late);
      if (mine === socket) void tryAgain(event);
    });
  }

  /** Abandons a silent connection, which may take minutes to close. */
  function reconnect() {
    const silent = socket;
    socket = undefined;
    silent?.close();
    lose();
    connect();
  }

  function lose() {
    for (const resolve of waiting.values()) resolve(NO_CONNECTION);
    waiting.clear();
    // Nothing counts as held from now on, with or without a token.
    store.send({ type: "closed", needs_token: false });
  }

  /** @param {Schemas["ToClient"]} message @param {string} name the name that this page sent */
  function handleMessage(message, name) {
    resetSilence();
    const now_ms = Date.now();
    if ("hello" in message) {
      const { client, role, version, page = "", person = "" } = message.hello;
      store.send({ type: "hello", client, role, version, person, says_name: person === name, is_stale: isStale(page), now_ms });
    } else if ("state" in message) {
      store.send({ type: "state", station: /** @type {Station} */ (message.state), now_ms });
    } else if ("notice" in message) {
      store.send({ type: "notice", notice: message.notice });
    } else if (message.id != null && waiting.has(message.id)) {
      waiting.get(message.id)?.("problem" in message ? { problem: message.problem } : { reply: message.reply });
      waiting.delete(message.id);
    } else if ("problem" in message) {
      store.send({ type: "problem", problem: message.problem });
    }
  }

  /** @param {CloseEvent} event */
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

  /** Sends a request; it always gets an answer. @param {Request} request @returns {Promise<Answer>} */
  function ask(request) {
    if (!socket || !isOpen()) return Promise.resolve(NO_CONNECTION);
    if (NEED_CONTROL.has(request.type)) takeControlIfFree();
    // A person starts the job here and has seen what it waits for.
    const { job } = store.page.station ?? {};
    if ((request.type === "start_job" || request.type === "step_job") && job?.job === request.job && job.waits_for_person) void ask({ type: "confirm_job", job: request.job });
    const id = lastId += 1;
    /** @type {Schemas["FromClient"]} */
    const message = { id, request };
    socket.send(JSON.stringify(message));
    return new Promise((resolve) => waiting.set(id, resolve));
  }

  return {
    connect,
    isOpen,
    ask,
    takeControlIfFree,
    /** Closes the connection; it reopens automatically, under the current name. */
    again: () => socket?.close(),
  };
}
