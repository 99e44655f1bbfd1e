// Every message that can change the state of the page: a closed union.

/** @typedef {import("./types.js").Station} Station */
/** @typedef {import("./types.js").Problem} Problem */
/** @typedef {import("./types.js").Notice} Notice */
/** @typedef {import("./types.js").Policy} Policy */
/** @typedef {import("./state.js").Page} Page */

/**
 * @typedef {{ type: "hello", client: number, role: import("./types.js").Role, version: string, fleet: string | null, person: string, says_name: boolean, is_stale: boolean, now_ms: number }
 * | { type: "state", station: Station, now_ms: number }
 * | { type: "notices", notices: readonly Notice[] }
 * | { type: "notice", notice: Notice }
 * | { type: "filter", text: string }
 * | { type: "closed", needs_token: boolean, is_unknown?: boolean }
 * | { type: "connecting" }
 * | { type: "stop_pressed" }
 * | { type: "stop_late" }
 * | { type: "stop_answered", after_s: number }
 * | { type: "tick", now_ms: number }
 * | { type: "problem", problem: Problem }
 * | { type: "problem_closed" }
 * | { type: "message_closed" }
 * | { type: "question", question: import("./state.js").Question | null }
 * | { type: "policy", policy: Policy | null }
 * | { type: "facts", facts: import("./types.js").Facts }
 * | { type: "ghost_near", near: import("./types.js").Near | null }
 * | { type: "around", around: import("./state.js").Around | null }
 * | { type: "planned", planned: Page["planned"] }
 * | { type: "adjusts", open: boolean }
 * | { type: "dialed", percent: number | null }
 * | { type: "pad_refused", detail: string | null }
 * | { type: "flattened" }
 * | { type: "greeted" }
 * | { type: "name", name: string }
 * | { type: "tab", tab: import("./state.js").Tab }
 * | { type: "language", language: import("./state.js").Language }
 * | { type: "theme", theme: import("./state.js").Theme }
 * | import("./buttons.js").ButtonsMessage
 * | import("./calibrate.js").CalibrateMessage
 * | import("./jog.js").JogMessage
 * | import("./jobs.js").JobsMessage
 * | import("./look.js").LookMessage
 * | import("./hands.js").HandsMessage
 * | import("./talk.js").TalkMessage
 * | import("./recordings.js").RecordingsMessage
 * | import("./packets.js").PacketsMessage
 * | import("./draw.js").DrawMessage
 * | import("./alerts.js").AlertsMessage
 * | import("./files.js").FilesMessage
 * | import("./learn.js").LearnMessage
 * | import("./set_up.js").SetUpMessage
 * | import("./target.js").TargetMessage
 * | import("./teach.js").TeachMessage
 * | import("./touch_paper.js").TouchPaperMessage} Message
 */

export {};
