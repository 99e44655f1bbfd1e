// Applies a message to the state. Pure: no clock, no document, no network.

import { reduceButtons } from "./buttons.js";
import { reduceAlerts } from "./alerts.js";
import { reduceCalibrate } from "./calibrate.js";
import { reduceDraw } from "./draw.js";
import { reduceFiles } from "./files.js";
import { reduceHands } from "./hands.js";
import { reduceHistory } from "./history.js";
import { reduceJobs } from "./jobs.js";
import { reduceJog } from "./jog.js";
import { reduceLearn } from "./learn.js";
import { reduceLook } from "./look.js";
import { reducePackets } from "./packets.js";
import { reduceRecordings } from "./recordings.js";
import { reduceSetUp } from "./set_up.js";
import { reduceTalk } from "./talk.js";
import { reduceTarget } from "./target.js";
import { reduceTeach } from "./teach.js";
import { reduceTouchPaper } from "./touch_paper.js";

/** @typedef {import("./state.js").Page} Page */
/** @typedef {import("./message.js").Message} Message */

/** The most notices kept; the station keeps more. */
const NOTICES = 200;

/** @param {Page} page @param {Message} message @returns {Page} */
export function reduce(page, message) {
  const next = reduceOwn(page, message);
  const jog = reduceJog(next.jog, message);
  const target = reduceTarget(next.target, message, page.station, next.station);
  const calibrate = reduceCalibrate(next.calibrate, message);
  const buttons = reduceButtons(next.buttons, message);
  const draw = reduceDraw(next.draw, message);
  const alerts = reduceAlerts(next.alerts, message);
  const files = reduceFiles(next.files, message);
  const learn = reduceLearn(next.learn, message);
  const set_up = reduceSetUp(next.set_up, message);
  const teach = reduceTeach(next.teach, message);
  const touch_paper = reduceTouchPaper(next.touch_paper, message);
  const jobs = reduceJobs(next.jobs, message);
  const look = reduceLook(next.look, message);
  const hands = reduceHands(next.hands, message);
  const talk = reduceTalk(next.talk, message, next);
  const recordings = reduceRecordings(next.recordings, message);
  const packets = reducePackets(next.packets, message);
  const history = reduceHistory(next.history, message);
  const isSame = jog === next.jog && target === next.target && buttons === next.buttons && calibrate === next.calibrate && draw === next.draw && alerts === next.alerts && files === next.files && learn === next.learn && set_up === next.set_up && teach === next.teach && touch_paper === next.touch_paper && jobs === next.jobs && look === next.look && talk === next.talk && hands === next.hands && recordings === next.recordings && packets === next.packets && history === next.history;
  return isSame ? next : { ...next, jog, target, buttons, calibrate, draw, alerts, files, learn, set_up, teach, touch_paper, jobs, look, talk, hands, recordings, packets, history };
}

/** @param {Page} page @param {Message} message @returns {Page} */
function reduceOwn(page, message) {
  switch (message.type) {
    case "hello":
      return { ...page, connection: "open", me: message.client, role: message.role, person: message.person, says_name: message.says_name, is_stale: message.is_stale, version: message.version, fleet: message.fleet, received_ms: message.now_ms, now_ms: message.now_ms, around: null, planned: null };
    case "state":
      return { ...page, station: message.station, late_stop: page.station?.stop && !message.station.stop ? unanswered(page) : page.late_stop, received_ms: message.now_ms, now_ms: message.now_ms };
    case "notices":
      return { ...page, notices: message.notices.slice(-NOTICES) };
    case "notice":
      return { ...page, notices: [...page.notices, message.notice].slice(-NOTICES), message: spoken(message.notice) ?? page.message };
    case "filter":
      return { ...page, filter: message.text };
    case "connecting":
      return { ...page, connection: page.connection === "token" ? "connecting" : page.connection };
    case "closed":
      return { ...page, connection: message.needs_token ? "token" : "closed", is_token_unknown: message.is_unknown ?? false, me: null, question: null };
    case "stop_pressed":
      return { ...page, question: null, late_stop: unanswered(page) };
    case "stop_late":
      return { ...page, late_stop: { after_s: null } };
    case "stop_answered":
      return { ...page, late_stop: page.late_stop && { after_s: message.after_s } };
    case "tick":
      return { ...page, now_ms: message.now_ms };
    case "problem":
      return { ...page, problem: message.problem };
    case "problem_closed":
      return { ...page, problem: null };
    case "message_closed":
      return { ...page, message: null };
    case "question":
      return { ...page, question: message.question };
    case "policy":
      return { ...page, policy: message.policy };
    case "facts":
      return { ...page, facts: message.facts };
    case "ghost_near":
      return { ...page, ghost_near: message.near };
    case "around":
      return { ...page, around: message.around };
    case "planned":
      return { ...page, planned: message.planned };
    case "dialed":
      return { ...page, dialed_percent: message.percent };
    case "adjusts":
      return { ...page, adjusts: message.open };
    case "pad_refused":
      return { ...page, pad_refused: message.detail };
    case "flattened":
      return { ...page, flattened: true };
    case "greeted":
      return { ...page, greeted: true };
    case "name":
      return { ...page, name: message.name };
    case "tab":
      return { ...page, tab: message.tab };
    case "language":
      return { ...page, language: message.language };
    case "theme":
      return { ...page, theme: message.theme };
    default:
      return page;
  }
}

/** An unanswered STOP is shown until it is answered; its answer until the next STOP, or until the stop is cleared. @param {Page} page */
const unanswered = ({ late_stop }) => (late_stop?.after_s === null ? late_stop : null);

/** The text of a message to all observers. @param {{ type: string, text: string }} notice */
const spoken = ({ type, text }) => (type === "message" ? text : null);
