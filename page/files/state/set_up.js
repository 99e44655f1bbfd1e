// State of the Set up tab: policy draft, tokens, and the virtual arm's faults.

/** @typedef {import("./types.js").Problem} Problem */
/** @typedef {import("./types.js").Policy} Policy */
/** @typedef {import("./types.js").Schemas} Schemas */

/** The section that a change belongs to. @typedef {"arm" | "calibrate" | "paper" | "policy" | "tokens" | "faults" | "world"} Place */
/** The station's check of a draft. @typedef {{ type: "unknown" } | { type: "good" } | { type: "bad", problem: Problem }} DraftCheck */

/**
 * @typedef {object} SetUp
 * @property {string | null} kept The text of the policy that holds.
 * @property {string | null} draft
 * @property {number} revision Revision of the draft; results for earlier revisions are ignored.
 * @property {DraftCheck} check
 * @property {Policy | null} drafted The last valid policy in the draft; null before the first check.
 * @property {boolean} overtaken Whether another policy was applied while this draft was edited.
 * @property {readonly Schemas["TokenView"][] | null} tokens Nothing where this page may not see them.
 * @property {readonly string[]} addresses The addresses at which a phone reaches the page; none if the station listens on this computer only.
 * @property {boolean} needs_network Whether a phone was wanted that cannot reach the station.
 * @property {Schemas["NewToken"] | null} made The token that was made last, whose secret is shown once.
 * @property {readonly string[] | null} faults Of the station's own virtual arm.
 * @property {{ place: Place, problem: Problem } | null} refused Why the last change was refused.
 * @property {Schemas["Finding"] | null} finding The result of the dialect detection.
 */

/** @type {SetUp} */
export const NO_SET_UP = { kept: null, draft: null, revision: 0, check: { type: "unknown" }, drafted: null, overtaken: false, tokens: null, addresses: [], needs_network: false, made: null, faults: null, refused: null, finding: null };

/** @typedef {{ type: "policy_text", text: string }
 * | { type: "policy_typed", text: string }
 * | { type: "policy_checked", revision: number, check: DraftCheck, policy: Policy | null }
 * | { type: "policy_kept", text: string }
 * | { type: "policy_forgotten" }
 * | { type: "tokens", tokens: readonly Schemas["TokenView"][] }
 * | { type: "addresses", addresses: readonly string[] }
 * | { type: "phone_wanted" }
 * | { type: "token_made", token: Schemas["NewToken"] | null }
 * | { type: "faults", faults: readonly string[] }
 * | { type: "set_up_refused", place: Place, problem: Problem | null }
 * | { type: "finding", finding: Schemas["Finding"] | null }} SetUpMessage */

/** Whether the draft differs from the policy in force. @param {SetUp} setUp */
export const isChanged = ({ draft, kept }) => draft !== null && draft !== kept;

/** @param {SetUp} setUp @param {import("./message.js").Message} message @returns {SetUp} */
export function reduceSetUp(setUp, message) {
  switch (message.type) {
    case "policy_text":
      if (isChanged(setUp)) return { ...setUp, kept: message.text, overtaken: setUp.kept !== message.text };
      // Read again, as after it was put in force from here: what is known of it stays.
      if (setUp.draft === message.text) return setUp;
      return { ...setUp, kept: message.text, draft: message.text, revision: setUp.revision + 1, check: { type: "unknown" }, drafted: null };
    case "policy_typed":
      return { ...setUp, draft: message.text, revision: setUp.revision + 1, check: { type: "unknown" } };
    case "policy_checked":
      return message.revision === setUp.revision ? { ...setUp, check: message.check, drafted: message.policy ?? setUp.drafted } : setUp;
    case "policy_kept":
      return { ...setUp, kept: message.text, overtaken: false, refused: null };
    case "policy_forgotten":
      return { ...setUp, draft: setUp.kept, revision: setUp.revision + 1, check: { type: "unknown" }, drafted: null, overtaken: false, refused: null };
    case "tokens":
      return { ...setUp, tokens: message.tokens };
    case "addresses":
      return { ...setUp, addresses: message.addresses };
    case "phone_wanted":
      return { ...setUp, needs_network: true, made: null };
    case "token_made":
      return { ...setUp, made: message.token, needs_network: false };
    case "faults":
      return { ...setUp, faults: message.faults, refused: null };
    case "set_up_refused":
      return { ...setUp, refused: message.problem && { place: message.place, problem: message.problem } };
    case "finding":
      return { ...setUp, finding: message.finding };
    case "tab":
      return { ...setUp, made: null, needs_network: false, refused: null };
    default:
      return setUp;
  }
}
