// @ts-check
// Draws a timeline on a canvas: the sheet with the whole drawing, the ink up to now, and the tool. Long drawings are drawn in
// slices of a few thousand lines, and snapshots of the ink shorten the way back.

import { EDGE, roundLength } from "./appearance.js";

/** @typedef {import("./timeline.js").Timeline} Timeline */
/** @typedef {import("./timeline.js").Place} Place */
/** @typedef {import("./appearance.js").Frame} Frame */
/** Colours of the sheet and of what is drawn on it besides the ink. */
/** @typedef {{sheet: string, travel: string, tool: string, words: string}} Theme */
/** @typedef {import("./appearance.js").Look} Look */
/** @typedef {import("./appearance.js").View} View */
/** @typedef {{canvas: HTMLCanvasElement, context: CanvasRenderingContext2D, row: number}} Layer */

/** Lines per slice, lines per path, and number of ink snapshots. */
const SLICE = 6000;
const BATCH = 250;
const KEPT_BYTES = 64e6;
/** A line without length would not be drawn. */
const DOT = 0.01;
/** Opacity of the ink to come. */
const TO_COME = 0.14;

export class Sketch {
  /** @param {Timeline} timeline @param {Look} look @param {View} view @param {Theme} theme */
  constructor(timeline, look, view, theme) {
    this.path = timeline.path;
    this.rows = timeline.path.t_s.length;
    this.look = look;
    this.view = view;
    this.theme = theme;
    this.x = timeline.path.y_mm.map(view.x);
    this.y = timeline.path.x_mm.map(view.y);
    /** The whole ink, all travel moves, and the ink up to now. */
    this.all = layer(view.frame);
    this.ways = layer(view.frame);
    this.ways.context.globalAlpha = this.shadeOfTravel();
    this.ink = layer(view.frame);
    /** Ink snapshots every `stride` rows. @type {(HTMLCanvasElement | undefined)[]} */
    this.kept = [];
    const bytes = this.ink.canvas.width * this.ink.canvas.height * 4;
    const most = Math.max(2, Math.min(24, Math.floor(KEPT_BYTES / bytes)));
    this.stride = Math.max(SLICE, Math.ceil(this.rows / (most + 1)));
  }

  /** Draws one slice up to this row; returns whether it is complete. @param {number} row */
  advance(row) {
    this.advanceAll();
    this.goBack(row);
    let left = SLICE;
    while (this.ink.row < row && left > 0) {
      const stop = Math.min(row, (Math.floor(this.ink.row / this.stride) + 1) * this.stride);
      left -= this.inkUpTo(this.ink, stop, left);
      this.keep();
    }
    return this.ink.row === row && this.all.row === this.rows - 1;
  }

  /** The static layers. */
  advanceAll() {
    const { all, ways, rows } = this;
    if (all.row === rows - 1) return;
    this.inkUpTo(all, Math.min(rows - 1, all.row + 4 * SLICE), SLICE);
    this.travel(ways.context, ways.row, all.row);
    ways.row = all.row;
  }

  /** Ink cannot be removed: start from an earlier snapshot, or from a later one if that is nearer. @param {number} row */
  goBack(row) {
    const { ink, stride } = this;
    let mark = Math.floor(row / stride);
    while (mark > 0 && !this.kept[mark]) mark -= 1;
    if (ink.row <= row && ink.row >= mark * stride) return;
    clear(ink.context, this.view.frame);
    const picture = this.kept[mark];
    if (picture) copy(picture, ink.context);
    ink.row = picture ? mark * stride : -1;
  }

  keep() {
    const { ink, stride } = this;
    const mark = ink.row / stride;
    if (mark < 1 || !Number.isInteger(mark) || this.kept[mark]) return;
    const { canvas, context } = layer(this.view.frame);
    copy(ink.canvas, context);
    this.kept[mark] = canvas;
  }

  /** Draws the lines up to a row, or `most` of them; how many. @param {Layer} layer @param {number} to @param {number} most */
  inkUpTo(layer, to, most) {
    const { context } = layer;
    const { ink } = this.path;
    let { row } = layer;
    let [drawn, batch, style, end] = [0, 0, -1, -1];
    while (row < to && drawn < most) {
      row += 1;
      if (ink[row] === 0) continue;
      if (this.look.classes[row] !== style || batch === BATCH) {
        if (batch > 0) context.stroke();
        style = this.look.classes[row];
        this.begin(context, this.look.styles[style]);
        [batch, end] = [0, -1];
      }
      this.add(context, row, end);
      end = row;
      batch += 1;
      drawn += 1;
    }
    if (batch > 0) context.stroke();
    layer.row = row;
    return drawn;
  }

  /** @param {CanvasRenderingContext2D} context @param {{color: string, width_mm: number}} style */
  begin(context, { color, width_mm }) {
    context.strokeStyle = color;
    context.lineWidth = Math.max(1.1, width_mm * this.view.scale);
    context.beginPath();
  }

  /** A dot, or the line from the row before. @param {CanvasRenderingContext2D} context @param {number} row @param {number} end Where the path ends. */
  add(context, row, end) {
    const [x, y] = [this.x[row], this.y[row]];
    if (this.path.ink[row] === 2 || row === 0) {
      context.moveTo(x, y);
      context.lineTo(x + DOT, y);
    } else {
      if (end !== row - 1) context.moveTo(this.x[row - 1], this.y[row - 1]);
      context.lineTo(x, y);
    }
  }

  /** The travel moves after a row up to another. @param {CanvasRenderingContext2D} context @param {number} from @param {number} to */
  travel(context, from, to) {
    this.dash(context);
    let end = -1;
    for (let row = Math.max(1, from + 1); row <= to; row += 1) {
      if (this.path.ink[row] === 1 || !this.isMove(row)) continue;
      if (end !== row - 1) context.moveTo(this.x[row - 1], this.y[row - 1]);
      context.lineTo(this.x[row], this.y[row]);
      end = row;
    }
    context.stroke();
    context.setLineDash([]);
  }

  /** Whether this row is at another place than the one before, seen from above. @param {number} row */
  isMove(row) {
    return this.x[row] !== this.x[row - 1] || this.y[row] !== this.y[row - 1];
  }

  /** @param {CanvasRenderingContext2D} context */
  dash(context) {
    context.strokeStyle = this.theme.travel;
    context.lineWidth = 1;
    context.setLineDash([5, 5]);
    context.beginPath();
  }

  /** Fainter, the more of the sheet they cover. */
  shadeOfTravel() {
    let length = 0;
    for (let row = 1; row < this.rows; row += 1) {
      if (this.path.ink[row] !== 1) length += Math.hypot(this.x[row] - this.x[row - 1], this.y[row] - this.y[row - 1]);
    }
    const cover = length / (this.view.frame.width * this.view.frame.height);
    return Math.max(0.15, Math.min(0.9, 0.02 / cover));
  }

  // --- The moment ------------------------------------------------------------

  /** @param {CanvasRenderingContext2D} context @param {Place} place */
  show(context, place) {
    const { width, height, ratio } = this.view.frame;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = this.theme.sheet;
    context.fillRect(0, 0, width, height);
    copy(this.ways.canvas, context);
    context.globalAlpha = TO_COME;
    copy(this.all.canvas, context);
    context.globalAlpha = 1;
    copy(this.ink.canvas, context);
    this.showWay(context, place);
    this.showTool(context, place);
    this.showMarks(context);
  }

  /** The line or the travel move that it is at. @param {CanvasRenderingContext2D} context @param {Place} place */
  showWay(context, { row, x_mm, y_mm, inks }) {
    [context.lineCap, context.lineJoin] = ["round", "round"];
    let first = row;
    if (inks) this.begin(context, this.look.styles[this.look.classes[Math.min(row + 1, this.rows - 1)]]);
    else {
      while (first > 0 && this.path.ink[first] === 0) first -= 1;
      this.dash(context);
      context.lineWidth = 1.5;
    }
    context.moveTo(this.x[first], this.y[first]);
    for (let next = first + 1; next <= row; next += 1) context.lineTo(this.x[next], this.y[next]);
    context.lineTo(this.view.x(y_mm) + DOT, this.view.y(x_mm));
    context.stroke();
    context.setLineDash([]);
  }

  /** A filled dot with ink, a ring without. @param {CanvasRenderingContext2D} context @param {Place} place */
  showTool(context, { x_mm, y_mm, inks }) {
    const [x, y] = [this.view.x(y_mm), this.view.y(x_mm)];
    context.beginPath();
    context.arc(x, y, inks ? 5 : 7, 0, 2 * Math.PI);
    context.lineWidth = inks ? 5 : 7;
    context.strokeStyle = this.theme.sheet;
    context.stroke();
    context.lineWidth = 2.5;
    context.strokeStyle = this.theme.tool;
    context.stroke();
    context.fillStyle = this.theme.tool;
    if (inks) context.fill();
  }

  /** Axis arrows and a scale bar. @param {CanvasRenderingContext2D} context */
  showMarks(context) {
    const { width, height } = this.view.frame;
    context.font = "12px system-ui, sans-serif";
    context.strokeStyle = context.fillStyle = this.theme.words;
    context.lineWidth = 1.25;
    const [x, y] = [EDGE + 52, height - 10];
    context.beginPath();
    for (const [dx, dy] of [[0, -16], [-16, 0]]) arrow(context, x, y, dx, dy);
    const long_mm = roundLength((0.2 * width) / this.view.scale);
    const long = long_mm * this.view.scale;
    const right = width - EDGE;
    context.moveTo(right - long, y - 5);
    for (const [at, up] of [[right - long, 0], [right, 0], [right, 5]]) context.lineTo(at, y - up);
    context.stroke();
    context.textAlign = "left";
    context.fillText("X forward", x + 7, y - 8);
    context.textAlign = "right";
    context.fillText("Y left", x - 20, y + 4);
    context.textAlign = "center";
    context.fillText(`${long_mm} mm`, right - long / 2, y - 7);
  }
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {number} dx @param {number} dy */
function arrow(context, x, y, dx, dy) {
  const [tipX, tipY] = [x + dx, y + dy];
  context.moveTo(x, y);
  context.lineTo(tipX, tipY);
  context.moveTo(tipX - dx / 4 + dy / 4, tipY - dy / 4 + dx / 4);
  context.lineTo(tipX, tipY);
  context.lineTo(tipX - dx / 4 - dy / 4, tipY - dy / 4 - dx / 4);
}

/** @param {Frame} frame @returns {Layer} */
function layer({ width, height, ratio }) {
  const canvas = document.createElement("canvas");
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  context.scale(ratio, ratio);
  [context.lineCap, context.lineJoin] = ["round", "round"];
  return { canvas, context, row: -1 };
}

/** @param {CanvasRenderingContext2D} context @param {Frame} frame */
function clear(context, { width, height }) {
  context.clearRect(0, 0, width, height);
}

/** Device pixel by device pixel. @param {HTMLCanvasElement} from @param {CanvasRenderingContext2D} to */
function copy(from, to) {
  to.save();
  to.setTransform(1, 0, 0, 1, 0, 0);
  to.drawImage(from, 0, 0);
  to.restore();
}
