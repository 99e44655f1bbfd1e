// The state of the page: one tree, changed by `reduce` alone.

import { NO_BUTTONS } from "./buttons.js";
import { NO_ALERTS } from "./alerts.js";
import { NO_CALIBRATE } from "./calibrate.js";
import { NO_DRAW } from "./draw.js";
import { NO_FILES } from "./files.js";
import { NO_HANDS } from "./hands.js";
import { NO_HISTORY } from "./history.js";
import { NO_JOBS } from "./jobs.js";
import { NO_JOG } from "./jog.js";
import { NO_LEARN } from "./learn.js";
import { NO_LOOK } from "./look.js";
import { NO_PACKETS } from "./packets.js";
import { NO_RECORDINGS } from "./recordings.js";
import { NO_SET_UP } from "./set_up.js";
import { NO_TALK } from "./talk.js";
import { NO_TARGET } from "./target.js";
import { NO_TEACH } from "./teach.js";
import { NO_TOUCH_PAPER } from "./touch_paper.js";

/** @typedef {import("./types.js").Station} Station */
/** @typedef {import("./types.js").Problem} Problem */
/** @typedef {import("./types.js").Notice} Notice */
/** @typedef {import("./types.js").Policy} Policy */
/** @typedef {import("./types.js").Facts} Facts */
/** @typedef {import("./types.js").Near} Near */
/** @typedef {import("./types.js").Role} Role */
/** @typedef {import("../stage/view.js").View} View */
/** @typedef {import("../i18n/i18n.js").Language} Language */

/** @typedef {"connecting" | "open" | "closed" | "token"} Connection `token`: the station wants one. */
/** @typedef {"move" | "draw" | "teach" | "look" | "jobs" | "watch" | "set_up"} Tab */
/** @typedef {"auto" | "light" | "dark"} Theme */
/** A question that asks for confirmation. @typedef {{ about: "confirm_pose" | "reset_stop" | "arm_laser" | "detect" | "clear_calibration" | "send_angles" | "remove_token", values?: Record<string, string | number> }} Question */
/** The scene around a virtual arm. @typedef {Pick<View, "tool" | "table_z_mm" | "paper" | "things" | "marks">} Around */

/**
 * @typedef {object} Page
 * @property {Connection} connection
 * @property {boolean} is_token_unknown Whether the station does not know the token of this page.
 * @property {number | null} me The station's number for this client.
 * @property {Role | null} role
 * @property {string | null} name The name of the person at this page; empty for none, null if nobody was asked.
 * @property {string} person By which name time slots know this page.
 * @property {boolean} says_name Whether that name is the page's own; a personal token sets it to the token's name.
 * @property {string} version
 * @property {boolean} is_stale Whether this page is another version than the one that the station serves.
 * @property {string | null} fleet The name of this station in its fleet; null without a fleet.
 * @property {Station | null} station The last state of the station.
 * @property {number} received_ms When it did, by the clock of this page.
 * @property {number} now_ms
 * @property {readonly Notice[]} notices The newest last.
 * @property {string} filter Filter for notices.
 * @property {{ after_s: number | null } | null} late_stop A STOP that was not answered in time, and when it was answered.
 * @property {Problem | null} problem
 * @property {string | null} message The last message to all observers of this station, with its sender.
 * @property {Question | null} question
 * @property {Policy | null} policy
 * @property {Facts | null} facts The lengths, tools, limits and periods of the arm, and what its dialect changes.
 * @property {Near | null} ghost_near Limits and zones near the ghost; null without a ghost or outside of the arm's reach.
 * @property {Around | null} around
 * @property {View["planned"]} planned The planned path of the job.
 * @property {number | null} dialed_percent The job speed while the slider moves.
 * @property {boolean} adjusts Whether a phone shows the speed and height of the job.
 * @property {import("./history.js").History} history
 * @property {import("./jog.js").Jog} jog
 * @property {import("./target.js").Target} target
 * @property {import("./teach.js").Teach} teach
 * @property {import("./touch_paper.js").TouchPaper} touch_paper
 * @property {import("./set_up.js").SetUp} set_up
 * @property {import("./calibrate.js").Calibrate} calibrate
 * @property {import("./buttons.js").Buttons} buttons
 * @property {import("./alerts.js").Alerts} alerts
 * @property {import("./draw.js").Draw} draw
 * @property {import("./files.js").Files} files
 * @property {import("./learn.js").Learn} learn
 * @property {import("./look.js").Look} look
 * @property {import("./talk.js").Talk} talk
 * @property {import("./hands.js").Hands} hands
 * @property {import("./jobs.js").Jobs} jobs
 * @property {import("./recordings.js").Recordings} recordings
 * @property {import("./packets.js").Packets} packets
 * @property {string | null} pad_refused Why the last packet of the mouse or hand pad was refused.
 * @property {Tab} tab
 * @property {boolean} flattened Whether the stage became flat because drawing it was too slow for a held button.
 * @property {boolean} greeted Whether the welcome card was closed.
 * @property {Language} language
 * @property {Theme} theme
 */

/** @param {{ language: Language, theme: Theme, greeted: boolean, program: string, name?: string | null }} wish @returns {Page} */
export const begin = ({ language, theme, greeted, program, name = null }) => ({
  connection: "connecting",
  is_token_unknown: false,
  me: null,
  role: null,
  name,
  person: "",
  says_name: false,
  version: "",
  is_stale: false,
  fleet: null,
  station: null,
  received_ms: 0,
  now_ms: 0,
  notices: [],
  filter: "",
  late_stop: null,
  problem: null,
  message: null,
  question: null,
  policy: null,
  facts: null,
  ghost_near: null,
  around: null,
  planned: null,
  dialed_percent: null,
  adjusts: false,
  history: NO_HISTORY,
  jog: NO_JOG,
  target: NO_TARGET,
  teach: { ...NO_TEACH, text: program },
  touch_paper: NO_TOUCH_PAPER,
  set_up: NO_SET_UP,
  calibrate: NO_CALIBRATE,
  buttons: NO_BUTTONS,
  alerts: NO_ALERTS,
  draw: NO_DRAW,
  files: NO_FILES,
  learn: NO_LEARN,
  look: NO_LOOK,
  talk: NO_TALK,
  hands: NO_HANDS,
  jobs: NO_JOBS,
  recordings: NO_RECORDINGS,
  packets: NO_PACKETS,
  pad_refused: null,
  tab: "move",
  flattened: false,
  greeted,
  language,
  theme,
});
