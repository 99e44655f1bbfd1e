// The first five minutes of a person with a browser and no arm, who reads nothing: jogs, teaches two points and loops them,
// stops, drops a picture and watches it drawn, and finds out why a target is refused. `film.test.mjs` holds it against what the
// arm did; `film.mjs` makes the film of it that opens the README.

import { waitForAnswer } from "./bench.mjs";

/** A boat on the water: 100 by 70 mm, four pens' strokes of one drawing. */
const BOAT = `<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="70mm" viewBox="0 0 100 70" fill="none" stroke="black">
  <path d="M18 48H84L74 60H30Z"/><path d="M49 48V8L78 42H49"/><path d="M44 42V16L22 42Z"/><path d="M8 64q7 -5 14 0t14 0t14 0t14 0t14 0t14 0"/><circle cx="88" cy="14" r="7"/>
</svg>`;

/** Does what a person's hand does: at once, or as `pace` says, for somebody who looks on. */
export class Hand {
  /** @param {import("playwright-core").Page} page @param {{ glide_ms?: number, look_ms?: number }} [pace] how long a way of the pointer takes, and a look at what came of it */
  constructor(page, { glide_ms = 0, look_ms = 0 } = {}) {
    Object.assign(this, { page, glide_ms, look_ms });
    this.at = [200, 200];
  }

  /** Time to see what is there; so many times the usual one. */
  async look(times = 1) {
    if (this.look_ms) await this.page.waitForTimeout(this.look_ms * times);
  }

  /** Moves the pointer to the middle of something. */
  async to(selector) {
    const target = this.page.locator(`${selector}:visible`).first();
    await target.scrollIntoViewIfNeeded();
    const { x, y, width, height } = await target.boundingBox();
    await this.glide([x + Math.min(width / 2, 80), y + height / 2]);
  }

  /** Moves the pointer, slowest at both ends. */
  async glide([x, y]) {
    const [from_x, from_y] = this.at;
    const steps = Math.ceil(this.glide_ms / 16);
    for (let step = 1; step < steps; step += 1) {
      const part = (1 - Math.cos((Math.PI * step) / steps)) / 2;
      await this.page.mouse.move(from_x + (x - from_x) * part, from_y + (y - from_y) * part);
    }
    await this.page.mouse.move(x, y);
    this.at = [x, y];
  }

  async click(selector) {
    await this.page.waitForFunction((selector) => document.querySelector(selector) && !document.querySelector(selector).disabled, selector);
    await this.to(selector);
    await this.page.mouse.down();
    await this.page.mouse.up();
    await this.look(0.4);
  }

  /** Clicks where a share of something's width and height is. */
  async clickAt(selector, [across, down]) {
    const target = this.page.locator(selector);
    await target.scrollIntoViewIfNeeded();
    const { x, y, width, height } = await target.boundingBox();
    await this.glide([x + across * width, y + down * height]);
    await this.page.mouse.down();
    await this.page.mouse.up();
    await this.look(0.4);
  }

  /** Holds the button down until something has come about. */
  async hold(selector, until) {
    await this.to(selector);
    await this.page.mouse.down();
    await until();
    await this.page.mouse.up();
    await this.look(0.4);
  }

  async type(selector, text) {
    await this.click(selector);
    await this.page.keyboard.press("ControlOrMeta+a");
    await this.page.keyboard.type(text, { delay: this.look_ms / 6 });
  }

  /** Drops a file on something, as from the desktop. */
  async drop(selector, name, text) {
    await this.to(selector);
    const files = await this.page.evaluateHandle(([name, text]) => {
      const files = new DataTransfer();
      files.items.add(new File([text], name));
      return files;
    }, [name, text]);
    await this.page.dispatchEvent(selector, "dragover", { dataTransfer: files });
    await this.look(0.5);
    await this.page.dispatchEvent(selector, "drop", { dataTransfer: files });
  }
}

/**
 * The story. `seen` is told each part when it is over.
 * @param {Hand} hand
 * @param {(part: "jogged" | "looped" | "stopped" | "released" | "planned" | "drawn" | "looked" | "refused") => Promise<void>} seen
 */
export async function tell(hand, seen) {
  const { page } = hand;
  const arm = () => page.evaluate(async () => (await (await fetch("api/v1/state")).json()).arm);
  const gone = (name, by) => async () => {
    const from = (await arm())[name];
    await page.waitForFunction(([name, from, by]) => Math.abs(Number(document.querySelector(`[data-pose=${name}]`).textContent) - from) >= by, [name, from, by]);
  };
  const rests = () => waitForAnswer(page, "api/v1/state", ({ arm, queue, stop }) => (stop ? stop.at_rest : !arm.moving && queue.waiting + queue.under_way === 0));

  await hand.look(2);
  await hand.click("#first-jog");
  await hand.hold("[data-axis=y_plus]", gone("y_mm", 40));
  await hand.hold("[data-axis=z_plus]", gone("z_mm", 25));
  await rests();
  await seen("jogged");

  await hand.click("#tab-teach");
  await hand.click("#capture");
  await page.waitForSelector("#step-0");
  await hand.click("#tab-move");
  await hand.hold("[data-axis=y_minus]", gone("y_mm", 80));
  await rests();
  await hand.click("#tab-teach");
  await hand.click("#capture");
  await page.waitForSelector("#step-1");
  await hand.click("#teach-loop");
  await page.waitForFunction(() => document.querySelector("#teach-cycle")?.textContent.includes("Cycle 2"));
  await seen("looped");

  await hand.click("#stop");
  await page.waitForSelector("#stopped");
  await rests();
  await hand.look(1.5);
  await seen("stopped");
  await hand.click("#reset");
  await hand.click("#confirm-yes");
  await page.waitForSelector("#stopped", { state: "detached" });
  await hand.click("#teach-end");
  await seen("released");

  await hand.click("#tab-draw");
  await hand.drop("#panel", "boat.svg", BOAT);
  await page.waitForFunction(() => document.querySelector("#draw-status")?.textContent.includes("Takes "));
  await hand.look(2);
  await seen("planned");
  await hand.click("#draw-start");
  await page.waitForSelector("#job-name:text('boat.svg')");
  await page.waitForSelector("#job", { state: "detached", timeout: 120_000 });
  await seen("drawn");
  await hand.click("[data-look=top]");
  await hand.look(2.5);
  await hand.click("[data-look=iso]");
  await seen("looked");

  await hand.click("#tab-move");
  await hand.type("#target-x_mm", "600");
  await page.waitForSelector("#target-nearest");
  await hand.look(2.5);
  await seen("refused");
  await hand.click("#target-nearest");
  await hand.click("#target-go");
  // The fields are empty again once the arm is there; before it was told to go it rests, too.
  await page.waitForFunction(() => document.querySelector("#target-x_mm").value === "");
  await rests();
  await hand.look(2);
}
