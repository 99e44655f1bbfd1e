// @ts-check
// Watches and moves the arm over the station's WebSocket. What the messages hold is in the API document.

import { createAround } from "./around.js";
import { createStage } from "./stage/stage.js";
import { EMPTY } from "./stage/view.js";
import { createTarget } from "./target.js";

/** @typedef {import("./api").components["schemas"]} Schemas */
/** A station writes null where there is nothing, and leaves out no field of a state. @template T @typedef {T extends object ? {[K in keyof T]-?: Whole<Exclude<T[K], undefined>>} : T} Whole */
/** @typedef {Whole<Schemas["State"]>} State */
/** @typedef {Whole<Schemas["LeaseView"]>} Lease */
/** @typedef {Whole<Schemas["JobView"]>} Job */
/** @typedef {Whole<Schemas["StopView"]>} Stop */
/** @typedef {Whole<Schemas["ArmView"]>} Arm */
/** @typedef {Schemas["Request"]} Request */
/** @typedef {Schemas["Notice"]} Notice */
/** What is told of a problem, one of the page itself too. @typedef {Pick<Schemas["Problem"], "title" | "detail" | "hint">} Problem */

const RECONNECT_MS = 1000;
const JOG_MS = 50;
const OLD_MS = 2000;
const TOLD_MS = 12000;
/** @type {Record<State["link"]["phase"], string>} */
const LINK = { searching: "no arm yet", listening: "listening", up: "arm is there", lost: "arm is lost" };

const NO_CONTROL = "Take control first.";

/** @type {WebSocket | undefined} */ let socket;
/** @type {State | undefined} */ let state;
/** @type {number | undefined} */ let me;
/** When the message about a problem goes. @type {number | undefined} */ let told;
let heardAt = 0;
let asked = 0;
/** What waits for an answer; a problem is one, too. @type {Map<number, (problem?: Problem, reply?: Schemas["Reply"]) => boolean | void>} */
const waiting = new Map();
/** What the stage was told of the arm. @type {import("./stage/view.js").Reported | null} */ let shown = null;
let isOld = false;
const dark = matchMedia("(prefers-color-scheme: dark)");

// --- The parts of the page -------------------------------------------------

/** @template {HTMLElement} [T=HTMLElement] @param {string} id @returns {T} */
function part(id) {
  return /** @type {T} */ (document.getElementById(id));
}

/** @param {string} id @param {string} text */
function write(id, text) {
  const found = part(id);
  if (found.textContent !== text) found.textContent = text;
}

/** @param {string} id @param {boolean} shown */
function show(id, shown) {
  part(id).hidden = !shown;
}

/** @param {string} id @param {string} text @param {string} tone */
function chip(id, text, tone) {
  write(id, text);
  part(id).dataset.tone = tone;
}

/** @param {number} seconds */
function span(seconds) {
  const whole = Math.max(0, Math.round(seconds));
  return whole < 60 ? `${whole} s` : `${Math.floor(whole / 60)} min ${String(whole % 60).padStart(2, "0")} s`;
}

// --- The state, drawn ------------------------------------------------------

/** @param {State} state */
function draw(state) {
  drawLink(state);
  if (state.arm) drawArm(state.arm);
  drawLaser(state.laser);
  drawStop(state.stop);
  drawControl(state.lease);
  drawJob(state.job);
  show("untrusted", !state.trust.trusted && state.arm !== null);
  write("untrusted-why", state.trust.reason ?? "");
  drawJog(state);
  around.follow(state.link.address === "virtual:");
  void around.showJob(state.job?.job);
  target.arrived();
  drawStage();
}

/** @param {State} state */
function drawLink({ link, dialect, queue, clients }) {
  const tone = link.phase === "up" ? "good" : link.phase === "lost" ? "bad" : "warn";
  chip("link-chip", LINK[link.phase] ?? link.phase, tone);
  show("link-problem", link.problem !== null);
  write("link-problem", link.problem ?? "");
  write("address", link.address ?? "not found yet");
  write("dialect", dialect ?? "not known");
  write("rate", `${link.statuses_per_s.toFixed(1)} of 12.5 in a second`);
  write("lost", `${count(link.lost_statuses, "status", "statuses")}, ${count(link.damaged_bytes, "byte", "bytes")}`);
  write("latency", link.latency_ms === null ? "not known" : `${link.latency_ms.toFixed(0)} ms`);
  write("queue", `${queue.waiting} here, ${queue.under_way} under way (${queue.ahead_s.toFixed(1)} s)`);
  write("clients", String(clients));
}

/** @param {number} number @param {string} one @param {string} many */
function count(number, one, many) {
  return `${number} ${number === 1 ? one : many}`;
}

/** @param {Arm} arm */
function drawArm(arm) {
  for (const output of document.querySelectorAll("output[data-pose]")) {
    const value = arm[/** @type {"x_mm"} */ (/** @type {HTMLElement} */ (output).dataset.pose)];
    output.textContent = value.toFixed(1);
  }
  write("moving", arm.moving ? "moving" : "at rest");
  chip("suction", arm.suction ? "on" : "off", arm.suction ? "warn" : "off");
  chip("gripper", `${arm.gripper_deg.toFixed(0)}°`, "off");
}

/** Shows the arm and all around it. */
function drawStage() {
  const arm = state?.arm ?? null;
  if (arm && state && shown?.at_s !== state.at_s) shown = { ...arm, at_s: state.at_s };
  if (!arm) shown = null;
  const mine = state !== undefined && (hindrance(state) === "" || (state.lease === null && hindrance(state) === NO_CONTROL));
  const where = arm ? `x ${arm.x_mm.toFixed(0)}, y ${arm.y_mm.toFixed(0)}, z ${arm.z_mm.toFixed(0)} mm` : "no arm yet";
  stage.show({
    ...EMPTY,
    ...around.view(),
    arm: shown,
    laser: state?.laser.on ? "burning" : (state?.laser.armed_for_s ?? 0) > 0 ? "armed" : "off",
    ghost: target.ghost(),
    draggable: mine,
    old: isOld,
    dark: dark.matches,
    note: isOld ? part("old").textContent ?? "" : "",
    label: `The arm: ${where}`,
  });
}

/** @param {State["laser"]} laser */
function drawLaser(laser) {
  if (laser.on) chip("laser", "burning", "bad");
  else if (laser.armed_for_s > 0) chip("laser", `armed for ${span(laser.armed_for_s)}`, "warn");
  else chip("laser", "disarmed", "off");
  show("disarm", laser.on || laser.armed_for_s > 0);
}

/** @param {Stop | null} stop */
function drawStop(stop) {
  show("stopped", stop !== null);
  if (!stop) return;
  const why = stop.reason ? `: ${stop.reason}` : "";
  write("stopped-by", `By ${stop.by}${why}. ${stop.at_rest ? "It is at rest." : "It has not come to rest yet."}`);
}

/** @param {Lease | null} lease */
function drawControl(lease) {
  const mine = lease !== null && lease.client === me;
  const asked = lease?.asked_by.some((it) => it.client === me) ?? false;
  write("holder", mine ? "You have control." : lease ? `${lease.name} has control.` : "Nobody has control.");
  show("take", lease === null || lease.is_program);
  show("release", mine);
  show("ask", lease !== null && !mine && !lease.is_program);
  const ask = /** @type {HTMLButtonElement} */ (part("ask"));
  ask.disabled = asked;
  write("ask", asked ? "You asked for it" : "Ask for it");
  drawAsking(mine ? lease.asked_by : []);
}

/** @param {Lease["asked_by"]} asking */
function drawAsking(asking) {
  const list = part("asking");
  const shown = JSON.stringify(asking);
  if (list.dataset.shown === shown) return;
  list.dataset.shown = shown;
  list.replaceChildren(...asking.map(({ client, name }) => {
    const item = document.createElement("li");
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = `Give it to ${name}`;
    button.addEventListener("click", () => ask({ type: "grant_lease", to: client }));
    item.append(button);
    return item;
  }));
}

/** @param {Job | null} job */
function drawJob(job) {
  show("job", job !== null);
  show("no-job", job === null);
  if (!job) return;
  write("job-name", job.title);
  chip("job-phase", job.phase, job.phase === "running" ? "good" : "warn");
  const progress = /** @type {HTMLProgressElement} */ (part("job-progress"));
  progress.value = job.commands ? job.completed / job.commands : 0;
  const left = job.left_s === null ? "" : `; ${span(job.left_s)} left`;
  write("job-left", `${job.completed} of ${job.commands} commands${left}.`);
  write("job-reason", job.reason ?? "");
  show("job-waits", job.phase === "paused" || job.phase === "queued");
  show("pause", job.phase === "running");
  drawAdjustment(job);
}

/** @param {Job} job */
function drawAdjustment(job) {
  const mine = state?.lease?.client === me;
  /** @type {HTMLFieldSetElement} */ (part("adjust")).disabled = !mine;
  write("adjust-why", mine ? "" : "Take control to change speed and height.");
  if (!dialing) {
    /** @type {HTMLInputElement} */ (part("job-speed")).value = String(job.speed_percent);
    write("job-speed-shown", `${Math.round(job.speed_percent)} %`);
  }
  write("job-height-shown", height(job.height_mm));
  show("job-speed-planned", job.speed_percent !== 100);
  show("job-height-planned", job.height_mm !== 0);
}

/** How far above the plan, in words. @param {number} mm */
function height(mm) {
  if (mm === 0) return "as planned";
  return `${mm > 0 ? "+" : "−"}${Math.abs(mm).toFixed(1)} mm`;
}

/** Why the arm cannot be jogged now, or nothing. @param {State} state */
function hindrance(state) {
  if (socket?.readyState !== WebSocket.OPEN) return "There is no connection to the station.";
  if (state.link.phase !== "up") return "There is no arm to move.";
  if (state.stop) return "The arm is stopped.";
  if (!state.trust.trusted) return "The pose is not confirmed.";
  if (state.lease?.client !== me) return NO_CONTROL;
  if (state.job?.phase === "running") return "A job has the arm.";
  return "";
}

/** @param {State} state */
function drawJog(state) {
  const why = hindrance(state);
  write("jog-why", why || refused || "Hold a button, or Enter on it. Letting go stops.");
  part("jog-why").dataset.tone = !why && refused ? "bad" : "off";
  for (const button of jogButtons()) button.disabled = why !== "";
  if (why) letGo();
}

/** @returns {HTMLButtonElement[]} */
function jogButtons() {
  return [...document.querySelectorAll(".pad button")].map((it) => /** @type {HTMLButtonElement} */ (it));
}

// --- What happened, and what went wrong ------------------------------------

/** @param {Notice} notice */
function addNotice(notice) {
  const list = part("notices");
  const ago = state ? Math.max(0, state.at_s - notice.at_s) : 0;
  const time = document.createElement("time");
  time.textContent = new Date(Date.now() - ago * 1000).toLocaleTimeString();
  const item = document.createElement("li");
  item.append(time, notice.text);
  list.prepend(item);
  while (list.childElementCount > 30) list.lastElementChild?.remove();
}

/** @param {Problem} problem */
function tell(problem) {
  write("problem-title", `${sentence(problem.title)}:`);
  write("problem-detail", `${sentence(problem.detail)}.`);
  write("problem-hint", problem.hint ? `${sentence(problem.hint)}.` : "");
  show("problem", true);
  clearTimeout(told);
  told = setTimeout(forget, TOLD_MS);
}

/** Takes the message away, unless somebody is at it. */
function forget() {
  const message = part("problem");
  if (message.matches(":hover, :focus-within")) told = setTimeout(forget, TOLD_MS);
  else message.hidden = true;
}

/** @param {string} text */
function sentence(text) {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

// --- Talking to the station ------------------------------------------------

/**
 * Asks for something. A refusal is told to all of the page, unless whoever asked takes it.
 * @param {Request} request @param {(problem?: Problem, reply?: Schemas["Reply"]) => boolean | void} [answered] whether it keeps the problem to itself is what it returns
 */
function ask(request, answered) {
  if (socket?.readyState !== WebSocket.OPEN) {
    tell({ title: "there is no connection", detail: "the station is not reached at the moment", hint: "the page tries again by itself" });
    return;
  }
  asked += 1;
  if (answered) waiting.set(asked, answered);
  /** @type {Schemas["FromClient"]} */
  const message = { id: asked, request };
  socket.send(JSON.stringify(message));
}

/** Stops the arm by every way there is. */
function stop() {
  if (socket?.readyState === WebSocket.OPEN) {
    const timer = setTimeout(stopByRequest, 300);
    ask({ type: "stop" }, () => clearTimeout(timer));
  } else {
    stopByRequest();
  }
  letGo();
  /** @type {HTMLDialogElement} */ (part("sure")).close();
}

async function stopByRequest() {
  try {
    const answer = await fetch("api/v1/stop", { method: "POST", headers: authorization() });
    if (!answer.ok) tell(await answer.json());
  } catch {
    tell({ title: "the stop did not reach the station", detail: "nothing answers at its address", hint: "switch the arm off" });
  }
}

/** @returns {Record<string, string>} */
function authorization() {
  const token = sessionStorage.getItem("token");
  return token ? { authorization: `Bearer ${token}` } : {};
}

function connect() {
  const token = sessionStorage.getItem("token");
  const url = new URL("api/v1/ws?name=page", location.href);
  url.protocol = url.protocol.replace("http", "ws");
  socket = new WebSocket(url, token ? ["dobot", `dobot.token.${token}`] : ["dobot"]);
  socket.addEventListener("message", (event) => hear(JSON.parse(event.data)));
  socket.addEventListener("close", (event) => tryAgain(event));
}

/** @param {Schemas["ToClient"]} message */
function hear(message) {
  heardAt = Date.now();
  if ("hello" in message) {
    me = message.hello.client;
    catchUp();
    around.begin();
    target.askAgain();
  } else if ("state" in message) {
    state = /** @type {State} */ (message.state);
    draw(state);
  } else if ("notice" in message) {
    addNotice(message.notice);
    if (message.notice.type === "policy_changed") void around.readPolicy();
  }
  const id = "id" in message ? message.id : undefined;
  const problem = "problem" in message ? message.problem : undefined;
  const answered = id == null ? undefined : waiting.get(id);
  if (id != null) waiting.delete(id);
  const taken = answered?.(problem, "reply" in message ? message.reply : undefined);
  if (problem && !taken) tell(problem);
}

/** What happened before this page was there. */
async function catchUp() {
  const answer = await fetch("api/v1/notices", { headers: authorization() });
  if (!answer.ok) return;
  part("notices").replaceChildren();
  /** @type {Notice[]} */
  const notices = await answer.json();
  for (const notice of notices.slice(-30)) addNotice(notice);
}

/** @param {CloseEvent} event */
async function tryAgain(event) {
  letGo();
  around.end();
  waiting.clear();
  me = undefined;
  chip("link-chip", "no connection", "bad");
  if (state) draw(state), chip("link-chip", "no connection", "bad");
  if (event.code === 1008) tell({ title: "the station closed the connection", detail: event.reason });
  if (!(await needsToken())) setTimeout(connect, RECONNECT_MS);
}

/** Asks for a token if that is what is missing. */
async function needsToken() {
  const answer = await fetch("api/v1/state", { headers: authorization() }).catch(() => undefined);
  const needed = answer?.status === 401;
  show("token", needed);
  if (needed) part("token-field").focus();
  return needed;
}

/** Says how old the view is when nothing comes any more. */
function watchAge() {
  const open = socket?.readyState === WebSocket.OPEN;
  const quiet = Date.now() - heardAt;
  const old = heardAt > 0 && quiet > OLD_MS && (!open || state?.link.phase === "up");
  show("old", old);
  part("main").classList.toggle("is-old", old);
  const turns = old !== isOld;
  isOld = old;
  if (old) write("old", `This view is ${span(quiet / 1000)} old. ${open ? "The station is silent." : "Connecting again…"}`);
  if (old || turns) drawStage();
}

// --- Jogging: nothing moves unless a button is held -------------------------

/** @type {{button: HTMLButtonElement, timer: number} | undefined} */ let held;
/** Why the last press came to nothing, until the next one. */
let refused = "";

/** @param {HTMLButtonElement} button */
function hold(button) {
  if (held?.button === button || button.disabled) return;
  letGo();
  refused = "";
  const frame = button.closest("#pad-joint") ? "joint" : "linear";
  const axis = button.dataset.axis;
  const press = () => {
    const speed_percent = Number(/** @type {HTMLInputElement} */ (part("speed")).value);
    ask({ type: "jog", jog: /** @type {Schemas["Jog"]} */ ({ frame, axis, speed_percent }) }, answered);
  };
  const mine = { button, timer: setInterval(press, JOG_MS) };
  // A refusal ends the press: it is told beside the button, and a new press is needed.
  const answered = (/** @type {Problem | undefined} */ problem) => {
    if (!problem) return false;
    if (held === mine) {
      letGo();
      refused = `${button.firstChild?.textContent}: ${problem.detail}.`;
      if (state) drawJog(state);
    }
    return true;
  };
  held = mine;
  button.classList.add("is-held");
  press();
}

/** Lets go of this button; another one that is held meanwhile stays so. @param {HTMLButtonElement} button */
function letGoOf(button) {
  if (held?.button === button) letGo();
}

function letGo() {
  if (!held) return;
  clearInterval(held.timer);
  held.button.classList.remove("is-held");
  held = undefined;
  if (socket?.readyState === WebSocket.OPEN) ask({ type: "release" });
}

// --- Buttons and keys --------------------------------------------------------

/** @param {string} id @param {() => void} act */
function on(id, act) {
  part(id).addEventListener("click", act);
}

/** Asks a person before something is done. @param {string} title @param {string} text @param {string} yes @param {Request} request */
function sure(title, text, yes, request) {
  write("sure-title", title);
  write("sure-text", text);
  write("sure-yes", yes);
  const dialog = /** @type {HTMLDialogElement} */ (part("sure"));
  part("sure-yes").onclick = () => {
    dialog.close();
    ask(request);
  };
  // Not a modal one: STOP has to stay within reach.
  dialog.show();
  part("sure-no").focus();
}

function listen() {
  on("stop", stop);
  on("take", () => ask({ type: "take_lease" }));
  on("release", () => ask({ type: "release_lease" }));
  on("ask", () => ask({ type: "ask_lease" }));
  on("disarm", () => ask({ type: "disarm_laser" }));
  on("pause", () => ask({ type: "pause_job" }));
  on("resume", () => state?.job && ask({ type: "start_job", job: state.job.job }));
  on("problem-close", () => show("problem", false));
  on("sure-no", () => /** @type {HTMLDialogElement} */ (part("sure")).close());
  on("reset", () => sure("May the arm move again?", "Look at the arm first: nothing and nobody may be in its way.", "It may move", { type: "reset_stop" }));
  on("confirm-pose", () => sure("Is the arm where it says?", "Compare the arm with the numbers and the pictures on this page. If they differ, the safety rules would protect the wrong places.", "It is there", { type: "confirm_pose" }));
  part("token").addEventListener("submit", (event) => {
    event.preventDefault();
    sessionStorage.setItem("token", /** @type {HTMLInputElement} */ (part("token-field")).value.trim());
    show("token", false);
    connect();
  });
  listenToJob();
  listenToJog();
  // Before all else, wherever the focus is.
  document.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" && event.key !== " ") return;
    if (event.key === " " && document.activeElement?.id === "token-field") return;
    event.preventDefault();
    if (!event.repeat) stop();
  }, { capture: true });
}

/** Whether somebody is turning the job's speed. */
let dialing = false;

function listenToJob() {
  const speed = /** @type {HTMLInputElement} */ (part("job-speed"));
  speed.addEventListener("input", () => {
    dialing = true;
    write("job-speed-shown", `${speed.value} %`);
  });
  speed.addEventListener("change", () => {
    dialing = false;
    ask({ type: "set_job_speed", percent: Number(speed.value) });
  });
  on("job-speed-planned", () => ask({ type: "set_job_speed", percent: 100 }));
  on("job-height-planned", () => ask({ type: "set_job_height", offset_mm: 0 }));
  on("job-lower", () => raise(-0.1));
  on("job-higher", () => raise(0.1));
}

/** @param {number} by_mm */
function raise(by_mm) {
  const now_mm = state?.job?.height_mm ?? 0;
  ask({ type: "set_job_height", offset_mm: Math.round((now_mm + by_mm) * 10) / 10 });
}

function listenToJog() {
  for (const button of jogButtons()) {
    button.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      button.setPointerCapture(event.pointerId);
      hold(button);
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture", "blur", "keyup"]) {
      button.addEventListener(end, () => letGoOf(button));
    }
    button.addEventListener("keydown", (event) => {
      if (event.key === "Enter" && !event.repeat) hold(button);
    });
    button.addEventListener("contextmenu", (event) => event.preventDefault());
  }
  window.addEventListener("blur", letGo);
  document.addEventListener("visibilitychange", letGo);
  part("frames").addEventListener("change", (event) => {
    const frame = /** @type {HTMLInputElement} */ (event.target).value;
    letGo();
    show("pad-linear", frame === "linear");
    show("pad-joint", frame === "joint");
  });
  const speed = /** @type {HTMLInputElement} */ (part("speed"));
  speed.addEventListener("input", () => write("speed-shown", `${speed.value} %`));
}

/** A token in the address (`#token=...`) is taken out of it, and of the history. */
function takeToken() {
  const token = new URLSearchParams(location.hash.slice(1)).get("token");
  if (!token) return;
  sessionStorage.setItem("token", token);
  history.replaceState(null, "", location.pathname);
}

const around = createAround((path) => fetch(path, { headers: authorization() }), () => drawStage());
const target = createTarget({ state: () => state, ask, changed: () => drawStage() });
const stage = createStage(part("stage"));
part("stage").addEventListener("target", (event) => target.fill(/** @type {CustomEvent<import("./stage/view.js").Target>} */ (event).detail));
for (const button of document.querySelectorAll("[data-look]")) {
  button.addEventListener("click", () => stage.look(/** @type {import("./stage/view.js").Preset} */ (/** @type {HTMLElement} */ (button).dataset.look)));
}
dark.addEventListener("change", drawStage);

takeToken();
listen();
connect();
setInterval(watchAge, 500);
