// The recordings of the station, and the one that is played on the stage: where the arm was then, and not where it is.

/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {import("./types.js").Problem} Problem */
/** @typedef {Schemas["RecordingView"]} RecordingView */
/** @typedef {Schemas["RecordedStates"]} RecordedStates */
/** @typedef {Schemas["SampleView"]} Sample */
/** What was read finely, and from when to when. @typedef {{ from_s: number, to_s: number, samples: readonly Sample[] }} Stretch */

/**
 * @typedef {object} Recordings
 * @property {readonly RecordingView[] | null} all The oldest first; nothing where they are not known yet.
 * @property {Problem | null} problem Why the last thing that was asked for came to nothing.
 * @property {string | null} chosen
 * @property {RecordedStates | null} states Where the arm was; nothing until they are read.
 * @property {Stretch | null} near The same around the moment that is shown, where the whole is told coarsely only.
 * @property {number} at_s Which moment is shown, by the times of the recording.
 * @property {number | null} played_ms When the moment was set forward last while it plays, by the clock of this page.
 * @property {number} speed How many times as fast as it was.
 */

/** @type {Recordings} */
export const NO_RECORDINGS = { all: null, problem: null, chosen: null, states: null, near: null, at_s: 0, played_ms: null, speed: 1 };
export const SPEEDS = /** @type {const} */ ([1, 4, 16, 64]);

/** @typedef {{ type: "recordings", all: readonly RecordingView[] }
 * | { type: "recordings_refused", problem: Problem | null }
 * | { type: "recording_chosen", name: string | null }
 * | { type: "recording_read", name: string, states: RecordedStates }
 * | { type: "recording_near", name: string, near: Stretch }
 * | { type: "recording_at", at_s: number }
 * | { type: "recording_plays", now_ms: number | null }
 * | { type: "recording_passed", now_ms: number }
 * | { type: "recording_speed", speed: number }} RecordingsMessage */

/** From when to when it goes, in seconds. @param {Recordings} recordings */
export const extent = ({ states }) => ({ from_s: states?.samples[0]?.at_s ?? 0, to_s: states?.samples.at(-1)?.at_s ?? 0 });

/** @param {Recordings} recordings @param {import("./message.js").Message} message @returns {Recordings} */
export function reduceRecordings(recordings, message) {
  switch (message.type) {
    case "recordings":
      return { ...recordings, all: message.all };
    case "recordings_refused":
      return { ...recordings, problem: message.problem, chosen: message.problem ? null : recordings.chosen };
    case "recording_chosen":
      return { ...recordings, chosen: message.name, states: null, near: null, at_s: 0, played_ms: null, problem: null };
    case "recording_read": {
      if (message.name !== recordings.chosen) return recordings;
      const read = { ...recordings, states: message.states };
      return { ...read, at_s: extent(read).from_s };
    }
    case "recording_near":
      return message.name === recordings.chosen ? { ...recordings, near: message.near } : recordings;
    case "recording_at":
      return { ...recordings, at_s: message.at_s, played_ms: null };
    case "recording_plays": {
      const { from_s, to_s } = extent(recordings);
      // At its end it begins anew.
      const at_s = recordings.at_s < to_s ? recordings.at_s : from_s;
      return { ...recordings, played_ms: message.now_ms, at_s };
    }
    case "recording_passed":
      return passed(recordings, message.now_ms);
    case "recording_speed":
      return { ...recordings, speed: message.speed };
    case "jog_held":
      // Whoever moves the arm wants to see the arm.
      return message.axis && recordings.chosen ? close(recordings) : recordings;
    case "tab":
      return recordings.chosen ? close(recordings) : recordings;
    default:
      return recordings;
  }
}

/** @param {Recordings} recordings @returns {Recordings} */
const close = (recordings) => ({ ...recordings, chosen: null, states: null, near: null, played_ms: null });

/** @param {Recordings} recordings @param {number} now_ms @returns {Recordings} */
function passed(recordings, now_ms) {
  if (recordings.played_ms === null) return recordings;
  const { to_s } = extent(recordings);
  const at_s = recordings.at_s + ((now_ms - recordings.played_ms) / 1000) * recordings.speed;
  return at_s < to_s ? { ...recordings, at_s, played_ms: now_ms } : { ...recordings, at_s: to_s, played_ms: null };
}

const NUMBERS = /** @type {const} */ (["x_mm", "y_mm", "z_mm", "rotation_deg", "base_deg", "rear_deg", "fore_deg", "servo_deg", "gripper_deg"]);

/** Where the arm was at a moment: between two samples in a straight line, which is what is known. @param {readonly Sample[]} samples @param {number} at_s @returns {Sample | null} */
export function sampleAt(samples, at_s) {
  const next = firstAfter(samples, at_s);
  const [from, to] = [samples[next - 1] ?? samples[0], samples[next] ?? samples.at(-1)];
  if (!from || !to) return null;
  const share = to.at_s > from.at_s ? Math.min(1, Math.max(0, (at_s - from.at_s) / (to.at_s - from.at_s))) : 0;
  const sample = { ...from, at_s };
  for (const name of NUMBERS) sample[name] = from[name] + (to[name] - from[name]) * share;
  return sample;
}

/** Which sample is the first one behind a moment: by halves, since there may be thousands. @param {readonly Sample[]} samples @param {number} at_s */
function firstAfter(samples, at_s) {
  let [low, high] = [0, samples.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (/** @type {Sample} */ (samples[middle]).at_s <= at_s) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Whether a stretch holds a moment. @param {Stretch | null} near @param {number} at_s @returns {near is Stretch} */
const holds = (near, at_s) => near !== null && near.from_s <= at_s && at_s <= near.to_s;

/** Whether what is known of the moment that is shown is coarse only. @param {Recordings} recordings */
export const isCoarse = ({ states, near, at_s }) => states !== null && states.spacing_s > 0 && !holds(near, at_s);

/** What the stage shows instead of the arm, or nothing where it shows the arm. @param {Recordings} recordings @returns {Sample | null} */
export function recorded({ states, near, at_s }) {
  const fine = holds(near, at_s) && near.samples.length ? near : null;
  return states && sampleAt((fine ?? states).samples, at_s);
}
