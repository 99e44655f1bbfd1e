// Wires the station, the state, the stage and the views together.

import { createActions } from "./actions.js";
import { endEarlyStop } from "./early_stop.js";
import { listenToDrops } from "./input/file_drop.js";
import { listenToGamepad } from "./input/gamepad.js";
import { createJog } from "./input/jog.js";
import { listenToKeys } from "./input/keys.js";
import { createPads } from "./input/pads.js";
import { draw as drawPanelOf } from "./panels/draw.js";
import { jobs } from "./panels/jobs.js";
import { floatingJog } from "./panels/jog.js";
import { move } from "./panels/move.js";
import { createFrameBudget, createFrames } from "./parts/frame_budget.js";
import { readName } from "./parts/name.js";
import { keepFocus } from "./parts/keep_focus.js";
import { isDarkTheme, savePreferences, readPreferences } from "./parts/preferences.js";
import { createStage } from "./stage/stage.js";
import { recorded } from "./state/recordings.js";
import { onlyMoved, rendersSame } from "./state/equality.js";
import { createViewOf, isVeryOld, silence_ms, taughtPlace } from "./state/selectors.js";
import { begin } from "./state/state.js";
import { createStore } from "./state/store.js";
import { followAuxiliaryData } from "./station/auxiliary_data.js";
import { createButtons } from "./station/buttons.js";
import { createHands } from "./station/hands.js";
import { createPhoto } from "./station/photo.js";
import { createHttp, takeToken } from "./station/http.js";
import { createAlerts } from "./station/alerts.js";
import { createFiles } from "./station/files.js";
import { createJobs } from "./station/jobs.js";
import { createLessons } from "./station/lessons.js";
import { createLook } from "./station/look.js";
import { followPackets } from "./station/packets.js";
import { createRecordings } from "./station/recordings.js";
import { createCalibrate } from "./station/calibrate.js";
import { createSetUp } from "./station/set_up.js";
import { followDrawing } from "./station/drawing.js";
import { createSocket } from "./station/socket.js";
import { createTalk } from "./station/talk.js";
import { createTeach } from "./station/teach.js";
import { followTarget } from "./station/target.js";
import { nothing, render } from "./vendor/lit-html/lit-html.js";
import { banners, question, toasts } from "./views/banners.js";
import { welcome, welcomes } from "./views/welcome.js";
import { name } from "./views/name.js";
import { footer } from "./views/footer.js";
import { learn, point } from "./views/learn.js";
import { cameras, pose } from "./views/pose.js";
import { statusBar } from "./views/status_bar.js";
import { showDialog } from "./views/confirm.js";
import { tabs } from "./views/tabs.js";
import { languageOf, loadLanguage, formatDuration, translator } from "./i18n/i18n.js";

/** @typedef {import("./state/state.js").Page} Page */
/** @typedef {import("./views/context.js").Context} Context */

const TICK_MS = 250;
const KEEP_MS = 300;
const MESSAGE_MS = 12_000;
/** Slow frames or interruptions of a held button after which the stage becomes flat. */
const MOST_LATE = 2;
/** Storage key of the program being taught. */
const PROGRAM = "dobot.program";
const KEPT = new Set(["language", "theme", "greeted"]);
const PANELS = {
  move, draw: drawPanelOf, jobs,
  teach: later(() => import("./panels/teach.js").then(({ teach }) => teach)),
  look: later(() => import("./panels/look.js").then(({ look }) => look)),
  watch: later(() => import("./panels/watch.js").then(({ watch }) => watch)),
  set_up: later(() => import("./panels/set_up.js").then(({ setUp }) => setUp)),
};

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
const dark = matchMedia("(prefers-color-scheme: dark)");

const store = createStore(begin({ language: languageOf(navigator.languages), theme: "auto", greeted: false, program: localStorage.getItem(PROGRAM) ?? "", name: readName(), ...readPreferences() }));
await loadLanguage(store.page.language).catch(() => {});
const http = createHttp();
const socket = createSocket({ store, http });
const setUpRequests = createSetUp(store, http, socket);
const jobRequests = createJobs(store, http, socket);
const fileRequests = createFiles(store, http);
const alertRequests = createAlerts(store, ({ language }) => translator(language));
const act = createActions({ store, socket, http, alerts: alertRequests, files: fileRequests, setUp: setUpRequests, calibrate: createCalibrate(store, http, setUpRequests.change), recordings: createRecordings(store, http), lessons: createLessons(store, http), jobs: jobRequests, teach: createTeach(store, http, jobRequests), buttons: createButtons(store, http, jobRequests), look: createLook(store, http, socket, jobRequests), talk: createTalk(store, http, socket), photo: createPhoto(store, socket) });
const hands = createHands(store, http, socket, act.stop);
const jog = createJog(store, socket);
const pads = createPads(store, socket);
const stage = createStage(part("stage"));
const viewOf = createViewOf();

// --- The state, drawn: once for each picture of the screen, however much has changed -----------------

/** @type {Page | null} */ let drawn = null;
const budget = createFrameBudget();
const frames = createFrames(draw);

/** Draws with the next frame. A report of the arm waits until there was time for input, and so does everything while a button is held. */
function changed(isReport = false) {
  frames.ask(isReport || store.page.jog.held !== null ? budget.wait_ms() : 0);
}

// Read only on a change: reading `matches` between frames makes Chromium swallow the event.
let isSystemDark = dark.matches;
const isDark = (/** @type {Page} */ { theme }) => isDarkTheme(theme, isSystemDark);

function draw() {
  socket.beat();
  budget.begin();
  const { page } = store;
  const t = translator(page.language);
  /** @type {Context} */
  const context = { page, t, act, jog, pads, hands, connect: socket.connect, look: (preset) => stage.look(preset) };
  // While a button is held, the page has time for the numbers only.
  const isFirst = drawn === null;
  const numbersOnly = drawn !== null && page.jog.held !== null && onlyMoved(drawn, page);
  drawn = page;
  drawStage(page, t);
  if (numbersOnly) return void render(pose(context), part("numbers"));
  drawRoot(page.language, isDark(page) ? "dark" : "light");
  if (isFirst) endEarlyStop();
  keepFocus(() => renderAll(context));
  point(page);
}

/** Sets the language and the theme; each setting restyles every element, even if the value is unchanged. @param {string} language @param {string} theme */
function drawRoot(language, theme) {
  const root = document.documentElement;
  if (root.lang !== language) root.lang = language;
  if (root.dataset.theme !== theme) root.dataset.theme = theme;
}

/** @param {Context} context */
function renderAll(context) {
  const { page } = context;
  render(statusBar(context), part("strip"));
  render(banners(context), part("banners"));
  render(toasts(context), part("toasts"));
  render(pose(context), part("numbers"));
  render(cameras(context), part("cameras"));
  render(floatingJog(context), part("float"));
  render(page.learn.lesson || page.learn.chooses ? learn(context) : welcomes(page) ? welcome(context) : name(context), part("first"));
  render(tabs(context), part("tabs"));
  render(footer(context), part("foot"));
  drawPanel(context);
  showDialog(/** @type {HTMLDialogElement} */ (part("confirm")), question(context), page.question !== null);
}

/** @param {Context} context */
function drawPanel(context) {
  const { tab } = context.page;
  const panel = part("panel");
  panel.setAttribute("aria-labelledby", `tab-${tab}`);
  render(PANELS[tab](context), panel);
}

/** A panel that is loaded when it is first shown. @param {() => Promise<(context: Context) => unknown>} load */
function later(load) {
  /** @type {((context: Context) => unknown) | undefined} */ let panel;
  return (/** @type {Context} */ context) => {
    if (panel) return panel(context);
    load().then((loaded) => {
      panel = loaded;
      changed();
    }, () => {});
    return nothing;
  };
}

/** @param {Page} page @param {import("./i18n/i18n.js").Translate} t */
function drawStage(page, t) {
  const then = recorded(page.recordings);
  const arm = then ?? page.station?.arm;
  const silent_ms = silence_ms(page);
  stage.show(viewOf(page, {
    dark: isDark(page),
    note: then ? t("recorded.note") : silent_ms ? t("old.note", { age: silent_ms < 10_000 ? t("time.s", { s: (silent_ms / 1000).toFixed(1) }) : formatDuration(t, silent_ms / 1000) }) : "",
    label: arm ? t(then ? "recorded.where" : "stage.where", { x: arm.x_mm.toFixed(0), y: arm.y_mm.toFixed(0), z: arm.z_mm.toFixed(0) }) : t("stage.none"),
  }));
  part("work").classList.toggle("is-old", isVeryOld(page));
}

// --- What comes in --------------------------------------------------------------------------------------

/** @type {number | undefined} */ let hideTimer;

/** Hides the message, unless the pointer or focus is on it. */
function hideMessage() {
  if (part("toasts").matches(":hover, :focus-within")) hideTimer = setTimeout(hideMessage, MESSAGE_MS);
  else store.send({ type: "problem_closed" });
}

let kept = store.page.teach.text;
/** @type {number | undefined} */ let keeping;

/** How often a frame was slow while a button was held, or a hold ended because the page did not say in time that it lasts. */
let late = 0;

/** Rendering must not end a hold: it slows down while a button is held, and becomes flat when that is not enough. */
function countLate() {
  if (part("stage").dataset.shown !== "3d") return;
  late += 1;
  if (late < MOST_LATE) return;
  stage.flatten();
  store.send({ type: "flattened" });
}

store.subscribe((page, message) => {
  if (message.type === "jog_held") stage.hold(message.axis !== null);
  if (message.type === "jog_refused" && message.problem.type?.endsWith("/let-go")) countLate();
  // The stage needs the report of an arm at rest; the rest of the page does not change.
  if (message.type === "state" && drawn && rendersSame(drawn, page)) drawStage(page, translator(page.language));
  else changed(message.type === "state");
  if (message.type === "problem") {
    clearTimeout(hideTimer);
    hideTimer = setTimeout(hideMessage, MESSAGE_MS);
  }
  if (page.teach.text !== kept) {
    kept = page.teach.text;
    clearTimeout(keeping);
    keeping = setTimeout(() => localStorage.setItem(PROGRAM, kept), KEEP_MS);
  }
  if (KEPT.has(message.type)) {
    const { language, theme, greeted } = page;
    savePreferences({ language, theme, greeted });
  }
});
part("stage").addEventListener("slow", countLate);
part("stage").addEventListener("target", (event) => {
  const { x_mm, y_mm, z_mm, rotation_deg, phase } = /** @type {CustomEvent<import("./stage/view.js").Target>} */ (event).detail;
  const place = { x_mm, y_mm, z_mm, rotation_deg };
  store.send(taughtPlace(store.page) ? { type: "teach_placed", place, phase } : { type: "target_placed", place });
});
dark.addEventListener("change", ({ matches }) => {
  isSystemDark = matches;
  changed();
});
// A field shows the current value after it loses focus.
document.addEventListener("focusout", () => changed());
setInterval(() => {
  // A clock that ticks for nothing draws nothing.
  if (silence_ms({ ...store.page, now_ms: Date.now() }) > 0 || silence_ms(store.page) > 0) store.send({ type: "tick", now_ms: Date.now() });
}, TICK_MS);

listenToKeys({ stage: part("stage"), stop: act.stop, jog, frame: () => store.page.jog.frame });
listenToGamepad({ stop: act.stop, jog, speed_percent: () => store.page.jog.speed_percent, linear: () => store.page.jog.frame === "linear" || store.send({ type: "jog_set", set: { frame: "linear" } }) });
followAuxiliaryData(store, http);
followTarget(store, socket);
followDrawing(store, http, fileRequests);
followPackets(store, http);
listenToDrops(part("work"), act.openFile);
takeToken(http);
// Where there is room for it beside the arm.
if (matchMedia("(min-width: 75rem) and (min-height: 42rem)").matches) store.send({ type: "jog_set", set: { floats: true } });
// In a task of its own: until then the STOP of the page that is not loaded yet stays.
changed();
socket.connect();
// An installed page says at once that the station does not answer.
if ("serviceWorker" in navigator) void navigator.serviceWorker.register("offline.js").catch(() => {});
