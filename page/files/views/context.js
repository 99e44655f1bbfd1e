// What a view is made of: the state, the words, and what a person can do.

/**
 * @typedef {object} Context
 * @property {import("../state/state.js").Page} page
 * @property {import("../i18n/i18n.js").Translate} t
 * @property {import("../actions.js").Actions} act
 * @property {import("../input/jog.js").JogInput} jog
 * @property {import("../input/pads.js").Pads} pads
 * @property {() => void} connect
 * @property {(preset: import("../stage/view.js").Preset) => void} look
 */

export {};
