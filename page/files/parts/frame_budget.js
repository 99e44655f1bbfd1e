// Spaces frames out, so that drawing leaves most of the time to input. Pure, except for the clock, the frames of the browser and
// a message after each frame.

/** Time for input after a frame, as a multiple of what the frame took. */
const REST = 4;

/** Calls back after the painting of the current frame. @param {() => void} action */
function afterPaint(action) {
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => {
    port1.close();
    action();
  };
  port2.postMessage(null);
}

/** Resolves in a later task, so that input is handled first. @returns {Promise<void>} */
export const nextTask = () => new Promise(afterPaint);

/** @param {() => number} now in ms @param {typeof afterPaint} after */
export function createFrameBudget(now = () => performance.now(), after = afterPaint) {
  let free_ms = 0;
  return {
    /** How long the next frame has to wait, in ms. */
    wait_ms: () => Math.max(0, free_ms - now()),
    /** Measures the frame that begins now. @param {(took_ms: number) => void} [ended] called after it was painted */
    begin(ended) {
      const from_ms = now();
      after(() => {
        const to_ms = now();
        free_ms = to_ms + REST * (to_ms - from_ms);
        ended?.(to_ms - from_ms);
      });
    },
  };
}

/**
 * Asks the browser for frames, one at a time. To wait, it sets a timer: a frame that draws nothing costs the browser nearly as
 * much as one that does.
 * @param {(now_ms: number) => void} draw
 */
export function createFrames(draw) {
  let frame = 0;
  /** @type {number | undefined} */ let timer;

  function drawNow(/** @type {number} */ now_ms) {
    frame = 0;
    draw(now_ms);
  }

  function cancel() {
    cancelAnimationFrame(frame);
    clearTimeout(timer);
    frame = 0;
    timer = undefined;
  }

  return {
    /** Asks for a frame after a wait. A frame that is due earlier serves this request, too. @param {number} wait_ms 0 for the next frame */
    ask(wait_ms) {
      if (frame || (timer !== undefined && wait_ms > 0)) return;
      cancel();
      if (wait_ms > 0) timer = setTimeout(frameTimer, wait_ms);
      else frame = requestAnimationFrame(drawNow);
    },
    cancel,
  };

  // The browser tests know the timer by this name.
  function frameTimer() {
    timer = undefined;
    frame = requestAnimationFrame(drawNow);
  }
}
