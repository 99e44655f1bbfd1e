// The colours of the stage, in both themes. Red means refused, amber near a limit, grey outdated; nothing else uses them.

/** @typedef {typeof LIGHT} Look */

const LIGHT = {
  background: 0xeef1f4,
  table: 0xd9dddf,
  tableEdge: 0xbfc6ca,
  grid: 0x8796a3,
  metal: 0xdfe4e8,
  dark: 0x363d44,
  accent: 0x2a72b8,
  pin: 0xa9b2ba,
  cable: 0x3a4148,
  paper: 0xffffff,
  ink: 0x16293f,
  burn: 0x4a2c14,
  planned: 0x2a72b8,
  trail: 0x2a72b8,
  ghost: 0x2a72b8,
  refused: 0xc8001e,
  near: 0xd98a00,
  keepOut: 0xb4465f,
  beam: 0xff3b30,
  sun: 1.75,
  sky: 1.7,
  room: 0.55,
};

/** @type {Look} */
const DARK = {
  ...LIGHT,
  background: 0x0e141a,
  table: 0x222c35,
  tableEdge: 0x10171d,
  grid: 0x5c6d7c,
  metal: 0xc3cad1,
  dark: 0x48525b,
  accent: 0x4f9be0,
  cable: 0x2a3138,
  paper: 0xd9d6cd,
  planned: 0x7cb8f2,
  trail: 0x7cb8f2,
  ghost: 0x7cb8f2,
  refused: 0xff5468,
  near: 0xf3b23c,
  keepOut: 0xe0728c,
  sun: 1.5,
  sky: 0.9,
  room: 0.42,
};

/** @param {boolean} dark */
export const colorsOf = (dark) => (dark ? DARK : LIGHT);

/** A colour, as style sheets and canvases write it. @param {number} hex */
export const css = (hex) => `#${hex.toString(16).padStart(6, "0")}`;
