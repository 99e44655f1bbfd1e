// What hands do with a STOP button when they are in a hurry: by random numbers, and by fingers and mouse of the browser.

const LONGEST_WAY_PX = 40;

/** Random numbers from 0 to 1, the same for each seed (mulberry32). */
export function numbers(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let bits = Math.imul(state ^ (state >>> 15), 1 | state);
    bits = (bits + Math.imul(bits ^ (bits >>> 7), 61 | bits)) ^ bits;
    return ((bits ^ (bits >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** One gesture; `rests` are the places where another finger may rest meanwhile. */
export function gesture(random, rests) {
  const one = (all) => all[Math.floor(random() * all.length)];
  const length = random() * LONGEST_WAY_PX, turn = random() * 2 * Math.PI;
  return {
    by: one(["finger", "finger", "finger", "mouse"]),
    /** Three are a flat hand. */
    fingers: one([1, 1, 1, 2, 3]),
    rests: one([null, null, ...rests]),
    /** Where on the button, as shares of its size. */
    at: [0.1 + 0.8 * random(), 0.1 + 0.8 * random()],
    way: random() < 0.3 ? [0, 0] : [length * Math.cos(turn), length * Math.sin(turn)],
    lasts: one(["tap", "until it stops", "long"]),
  };
}

/** In words, for a gesture that did not stop. */
export const words = ({ by, fingers, rests, way: [x, y], lasts }) => `${by === "mouse" ? "the mouse" : `${fingers} finger(s)`}, ${Math.hypot(x, y).toFixed(0)} px, ${lasts}${rests ? `, another finger on ${rests}` : ""}`;

const middle = ({ x, y, width, height }) => ({ x: x + width / 2, y: y + height / 2 });

/** Fingers on the screen of a page. */
export async function hand(page) {
  const session = await page.context().newCDPSession(page);
  const touch = (type, touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
  const box = (selector) => page.locator(selector).first().boundingBox();
  return {
    touch, box,
    /** Rests a finger in the middle of an element. */
    async rest(selector) {
      const finger = { ...middle(await box(selector)), id: 9 };
      await touch("touchStart", [finger]);
      return [finger];
    },
    /**
     * Makes a gesture on a button, and tells when the press was. `acted` waits for what the button does; then what rests is lifted, too.
     * @returns {Promise<number>}
     */
    async press(selector, { by, fingers, at, way, lasts }, resting, acted) {
      const { x, y, width, height } = await box(selector);
      const down = { x: x + at[0] * width, y: y + at[1] * height };
      /** A share of the way. */
      const after = (share) => ({ x: down.x + share * way[0], y: down.y + share * way[1] });
      const points = (share) => [...resting, ...Array.from({ length: fingers }, (_, id) => ({ x: Math.min(x + width - 2, after(share).x + 25 * id), y: after(share).y, id }))];
      if (by === "mouse") await page.mouse.move(down.x, down.y);
      const pressed = performance.now();
      await (by === "mouse" ? page.mouse.down() : touch("touchStart", points(0)));
      for (const share of way.some(Boolean) ? [0.25, 0.5, 0.75, 1] : []) await (by === "mouse" ? page.mouse.move(after(share).x, after(share).y) : touch("touchMove", points(share)));
      if (lasts !== "tap") await acted();
      // Longer than a browser takes for a long press.
      if (lasts === "long") await page.evaluate(() => new Promise((done) => setTimeout(done, 600)));
      if (by === "mouse") await page.mouse.up();
      // Fingers that are not told of any more are lifted.
      else await (resting.length ? touch("touchMove", resting) : touch("touchEnd", []));
      await acted();
      if (resting.length) await touch("touchEnd", []);
      return pressed;
    },
  };
}
