// Keeps a held button pressed while the page is busy for a moment, and releases it if the page is busy for longer. Pure: the
// caller has the clock and the connection.

/** A hold of a button: its number, higher than that of the last one, and how long the page may be silent. @typedef {{ number: number, busy_ms: number }} Hold */

/** How often a held button is repeated. */
export const REPEAT_MS = 50;
/** How long a page may be silent before its button is released, unless the policy allows more. With less, drawing on a slow computer ends a hold. */
export const BUSY_MS = 250;

/** The id of a repeated request, whose answer nobody waits for. */
export const REPEATED = 0;

/** @param {(text: string) => void} send sends a message to the station */
export function createKeepAlive(send) {
  /** @type {{ hold: number, busy_ms: number, text: string, heard_ms: number, sent_ms: number } | null} */ let held = null;
  /** The last hold that was released here: what the page still sends of it presses nothing. */
  let released = 0;

  return {
    /** Handles a request of the page that holds a button. @param {Hold} hold @param {string} text @param {number} now_ms @returns {boolean} whether the hold lasts */
    press({ number: hold, busy_ms }, text, now_ms) {
      if (hold <= released) return false;
      send(text);
      held = { hold, busy_ms, text, heard_ms: now_ms, sent_ms: now_ms };
      return true;
    },
    /** The page responds, and the button of this hold is still pressed. @param {number} hold @param {number} now_ms */
    beat(hold, now_ms) {
      if (held?.hold === hold) held.heard_ms = now_ms;
    },
    /** The page has ended the hold. */
    end() {
      if (held) released = held.hold;
      held = null;
    },
    /** Repeats the last press of a page that is busy, or releases the button of one that is busy for too long. @param {number} now_ms */
    tick(now_ms) {
      if (!held) return;
      if (now_ms - held.heard_ms > held.busy_ms) {
        send(JSON.stringify({ id: REPEATED, request: { type: "release" } }));
        this.end();
      } else if (now_ms - held.sent_ms >= REPEAT_MS) {
        send(JSON.stringify({ ...JSON.parse(held.text), id: REPEATED }));
        held.sent_ms = now_ms;
      }
    },
  };
}
