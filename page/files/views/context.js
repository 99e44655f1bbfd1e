// The context of a view: state, translation and actions.

/**
 * @typedef {object} Context
 * @property {import("../state/state.js").Page} page
 * @property {import("../i18n/i18n.js").Translate} t
 * @property {import("../actions.js").Actions} act
 * @property {import("../input/jog.js").JogInput} jog
 * @property {import("../input/pads.js").Pads} pads
 * @property {import("../station/hands.js").HandsRequests} hands
 * @property {() => void} connect
 * @property {(preset: import("../stage/view.js").Preset) => void} look
 */

export {};
