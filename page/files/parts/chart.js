// A chart over time, drawn only while it is in the document and when its data changed.

import { AsyncDirective } from "../vendor/lit-html/async-directive.js";
import { directive } from "../vendor/lit-html/directive.js";
import { nothing } from "../vendor/lit-html/lit-html.js";

/** @typedef {typeof import("../vendor/uplot/uplot.js").default} UPlot */

/** A line of a chart: what it is called, and the custom property of its colour. @typedef {{ name: string, color: string, dash?: number[] }} Line */
/** @typedef {readonly (readonly (number | null)[])[]} Columns Seconds first, then a column for each line. */

/** The values that are seen at least, whatever the lines do. @typedef {readonly [low: number, high: number]} Seen */

const HEIGHT = 120;
/** The least visible time span, in seconds. */
const LEAST_S = 30;

class Chart extends AsyncDirective {
  /** @type {InstanceType<UPlot> | undefined} */ #plot;
  /** @type {ResizeObserver | undefined} */ #watched;
  #key = "";
  /** @type {Columns | undefined} */ #shown;

  /** @param {Columns} _columns @param {readonly Line[]} _lines @param {Seen} _seen @param {string} _key */
  render(_columns, _lines, _seen, _key) {
    return nothing;
  }

  /** @override @param {import("../vendor/lit-html/directive.js").ElementPart} part @param {[Columns, readonly Line[], Seen, string]} args */
  update({ element }, [columns, lines, seen, key]) {
    this.#shown = columns;
    // A new element is not in the document yet, where its size and its colours come from. The library is loaded by the first chart.
    if (key !== this.#key) void import("../vendor/uplot/uplot.js").then((loaded) => this.#build(loaded.default, /** @type {HTMLElement} */ (element), lines, seen, key));
    else this.#draw();
    return nothing;
  }

  /** @param {UPlot} uPlot @param {HTMLElement} element @param {readonly Line[]} lines @param {Seen} seen @param {string} key */
  #build(uPlot, element, lines, [low, high], key) {
    if (!element.isConnected) return;
    this.#end();
    this.#key = key;
    const style = getComputedStyle(element);
    const color = (/** @type {string} */ name) => style.getPropertyValue(name).trim();
    const axis = { stroke: color("--quiet"), grid: { stroke: color("--line"), width: 1 }, ticks: { stroke: color("--line") }, font: "11px system-ui" };
    this.#plot = new uPlot({
      width: Math.max(200, element.clientWidth),
      height: HEIGHT,
      cursor: { show: false },
      legend: { show: false },
      scales: {
        x: { time: false, range: (_, first) => [Math.min(-LEAST_S, first ?? 0), 0] },
        y: { range: (_, least, most) => [Math.min(low, least ?? low), Math.max(high, most ?? high)] },
      },
      axes: [{ ...axis, size: 24, values: (_, ticks) => ticks.map((tick) => `${tick} s`) }, { ...axis, size: 44 }],
      series: [{}, ...lines.map(({ color: name, dash }) => ({ stroke: color(name), width: 1.5, dash, points: { show: false } }))],
    }, [[], ...lines.map(() => [])], element);
    this.#watched = new ResizeObserver(() => this.#plot?.setSize({ width: Math.max(200, element.clientWidth), height: HEIGHT }));
    this.#watched.observe(element);
    this.#draw();
  }

  #draw() {
    this.#plot?.setData(/** @type {uPlot.AlignedData} */ (/** @type {unknown} */ (this.#shown)));
  }

  #end() {
    this.#watched?.disconnect();
    this.#plot?.destroy();
    this.#plot = undefined;
  }

  /** @override */
  disconnected() {
    this.#end();
    this.#key = "";
  }
}

/** Draws columns into the element that it stands in; `key` changes with what the lines look like. */
export const chart = directive(Chart);
