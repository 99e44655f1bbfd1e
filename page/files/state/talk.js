// What a person says while holding the button to talk, and what a listener next to the station understands of it. Nothing moves
// before the person confirms it.

/** @typedef {import("./state.js").Page} Page */

/** How long an order waits for its confirmation, by the station's clock. */
const ORDER_S = 15;

/**
 * @typedef {object} Talk
 * @property {boolean} listens Whether a listener runs next to the station.
 * @property {"off" | "asking" | "on"} microphone
 * @property {string | null} refused Why there is no microphone: the end of a text key, or the browser's words.
 * @property {boolean} holds Whether the button is held.
 * @property {"order" | "go" | "no" | "stop" | "nothing" | null} heard What was understood last.
 * @property {{ words: string, until_s: number } | null} order What waits for a confirmation.
 */

/** @type {Talk} */
export const NO_TALK = { listens: false, microphone: "off", refused: null, holds: false, heard: null, order: null };

/** @typedef {{ type: "talk_set", set: Partial<Talk> }} TalkMessage */

/** @param {Talk} talk @param {import("./message.js").Message} message @param {Page} page @returns {Talk} */
export function reduceTalk(talk, message, { me, station }) {
  switch (message.type) {
    case "talk_set":
      return { ...talk, ...message.set };
    case "notice": {
      const { notice } = message;
      if (notice.type !== "heard" || notice.client !== me) return talk;
      const { heard } = notice;
      const order = heard.what === "order" ? { words: heard.words, until_s: notice.at_s + ORDER_S } : heard.what === "nothing" ? talk.order : null;
      return { ...talk, heard: heard.what, order };
    }
    case "state":
      return talk.order && (station?.stop || (station?.at_s ?? 0) > talk.order.until_s) ? { ...talk, order: null } : talk;
    case "stop_pressed":
      return talk.order || talk.holds ? { ...talk, order: null, holds: false } : talk;
    case "closed":
      return { ...talk, listens: false, holds: false, order: null };
    default:
      return talk;
  }
}
