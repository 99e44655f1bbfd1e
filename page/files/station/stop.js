// Requests a stop until it is answered: immediately, then repeatedly over separate connections.

const FIRST_AGAIN_MS = 300, AGAIN_MS = 1000;
/** Delay before an unanswered stop is reported. */
const LATE_MS = 1000;

/**
 * @param {object} outside
 * @param {() => Promise<boolean>} outside.first sends a stop immediately, at each press; resolves to whether it was answered
 * @param {() => Promise<boolean>} outside.again sends a stop over another connection
 * @param {() => void} outside.late
 * @param {(after_ms: number) => void} outside.answered
 * @returns {() => void} presses STOP
 */
export function createStop({ first, again, late, answered }) {
  /** @type {{ since_ms: number, again: number, late: number } | null} */ let waiting = null;

  /** @param {() => Promise<boolean>} request */
  async function ask(request) {
    const mine = waiting;
    if (!(await request()) || !mine || waiting !== mine) return;
    clearTimeout(mine.again);
    clearTimeout(mine.late);
    waiting = null;
    answered(Date.now() - mine.since_ms);
  }

  function repeat() {
    if (!waiting) return;
    waiting.again = setTimeout(repeat, AGAIN_MS);
    void ask(again);
  }

  return () => {
    waiting ??= { since_ms: Date.now(), again: setTimeout(repeat, FIRST_AGAIN_MS), late: setTimeout(late, LATE_MS) };
    void ask(first);
  };
}
