// The board of a fleet: wires requests, state and views together.

import { listenToDrops } from "../input/file_drop.js";
import { listenToStop } from "../input/keys.js";
import { isDarkTheme, readPreferences } from "../parts/preferences.js";
import { createStoreCore } from "../state/store_core.js";
import { createHttp, takeToken } from "../station/http.js";
import { render } from "../vendor/lit-html/lit-html.js";
import { showDialog } from "../views/confirm.js";
import { languageOf, loadLanguage, translator } from "../i18n/i18n.js";
import { details } from "./details.js";
import { followFleet } from "./fleet_subscription.js";
import { followLearners } from "./learner_polling.js";
import { footer } from "./footer.js";
import { createPictures } from "./pictures.js";
import { queue } from "./queue_list.js";
import { createQueueRequests } from "./queue_requests.js";
import { createRequests } from "./requests.js";
import { slotsAside } from "./slot_form.js";
import { begin, reduce } from "./state.js";
import { banners, header, question, toasts } from "./header.js";
import { tiles } from "./tiles.js";
import { outcomeOf } from "./outcome.js";
import { listenToWalk } from "./arrow_keys.js";

/** @typedef {ReturnType<typeof createBoard>} Store */
/** @typedef {import("./state.js").Board} Board */
/** @typedef {import("./state.js").Message} Message */
/** The context of a view of the board. @typedef {{ board: Board, t: import("../i18n/i18n.js").Translate, act: ReturnType<typeof createActions> }} Context */

/** Redraw interval of the texts; pictures follow each frame. */
const TEXTS_MS = 150;
const MESSAGE_MS = 12_000;
/** Messages that come many times per second. */
const FREQUENT = new Set(["members", "alive", "tick", "queue", "learners", "slots"]);

/** @param {string} id */
const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
const dark = matchMedia("(prefers-color-scheme: dark)"), still = matchMedia("(prefers-reduced-motion: reduce)");

const createBoard = () => createStoreCore(reduce, begin({ language: languageOf(navigator.languages), theme: "auto", ...readPreferences() }));

const store = createBoard();
await loadLanguage(store.page.language).catch(() => {});
const http = createHttp();
const fleet = followFleet(store, http);
const requests = createRequests(store, http);
const queueRequests = createQueueRequests(store, http);
const pictures = createPictures({ isStill: () => still.matches });
const act = createActions();

function createActions() {
  return {
    ...requests,
    queue: queueRequests,
    send: store.send,
    /** @param {boolean} yes */
    answer(yes) {
      const { question } = store.page;
      store.send({ type: "question", question: null });
      if (yes && question) confirmed(question);
    },
    /** @param {string} secret */
    useToken(secret) {
      http.useToken(secret);
      store.send({ type: "outcome_closed", what: "denied" });
      fleet.follow();
    },
  };
}

/** A person has said yes. @param {import("./state.js").Question} question */
function confirmed(question) {
  switch (question.about) {
    case "fleet_reset":
      return requests.reset(question.to);
    case "fleet_reassign":
      return void queueRequests.reassign(question.work);
    case "fleet_end_arm":
      return requests.endArm(question.giver, question.name);
    case "fleet_cancel":
      return void queueRequests.cancel(question.work);
  }
}

// --- The state, drawn ------------------------------------------------------------------------------------

let frame = 0;
/** @type {number | undefined} */ let later;

/** Draws with the next picture of the screen; what comes many times in a second waits for the rest of it. @param {boolean} isFrequent */
function changed(isFrequent) {
  if (isFrequent) return void (later ??= setTimeout(() => changed(false), TEXTS_MS));
  clearTimeout(later);
  later = undefined;
  frame ||= requestAnimationFrame(draw);
}

function draw() {
  frame = 0;
  const { page: board } = store;
  const t = translator(board.language);
  document.documentElement.lang = board.language;
  document.documentElement.dataset.theme = isDarkTheme(board.theme, dark.matches) ? "dark" : "light";
  /** @type {Context} */ const context = { board, t, act };
  render(header(context), part("strip"));
  part("banners").ariaLabel = t("fleet.banners");
  render(banners(context), part("banners"));
  render(tiles(context), part("tiles"));
  render(details(context), part("details"));
  part("details").hidden = board.chosen === null;
  render(queue(context), part("queue"));
  part("queue").hidden = !board.queue.open;
  render(slotsAside(context), part("slots"));
  part("slots").hidden = !board.slots.open;
  render(footer(context), part("foot"));
  render(toasts(context), part("toasts"));
  showDialog(/** @type {HTMLDialogElement} */ (part("confirm")), question(context), board.question !== null);
  pictures.take(part("floor"));
  show();
}

function show() {
  const { page: board } = store;
  pictures.show(board.members, board.facts, { dark: isDarkTheme(board.theme, dark.matches), old: board.connection !== "open" });
}

// --- What comes in ----------------------------------------------------------------------------------------

/** @type {number | undefined} */ let hideTimer;

/** Hides a success message, unless the pointer or focus is on it. */
function hideMessage() {
  if (part("toasts").matches(":hover, :focus-within")) hideTimer = setTimeout(hideMessage, MESSAGE_MS);
  else store.send({ type: "outcome_closed", what: "request" });
}

store.subscribe((board, message) => {
  changed(FREQUENT.has(message.type));
  if (message.type === "members") show();
  if (message.type !== "answered" || board.request?.number !== message.number) return;
  clearTimeout(hideTimer);
  const { silent, refused } = outcomeOf(message.answers ?? []);
  if (!message.problem && silent.length + refused.length === 0) hideTimer = setTimeout(hideMessage, MESSAGE_MS);
});
dark.addEventListener("change", () => changed(false));

listenToStop(() => void requests.stop("all"));
followLearners(store, http);
listenToWalk(part("tiles"), ".tile .name");
listenToDrops(part("floor"), (file) => {
  store.send({ type: "queue_form", form: { what: "file", file } });
  store.send({ type: "queue_open", open: true });
});
takeToken(http);
draw();
fleet.follow();
