// The recordings of the station, and the playback on the stage.

/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {import("./types.js").Problem} Problem */
/** @typedef {Schemas["RecordingView"]} RecordingView */
/** @typedef {Schemas["RecordedStates"]} RecordedStates */
/** @typedef {Schemas["SampleView"]} Sample */
/** A stretch read at full resolution. @typedef {{ from_s: number, to_s: number, samples: readonly Sample[] }} Stretch */

/**
 * @typedef {object} Recordings
 * @property {readonly RecordingView[] | null} all The oldest first; nothing where they are not known yet.
 * @property {Problem | null} problem Why the last request was refused.
 * @property {string | null} chosen
 * @property {RecordedStates | null} states The recorded states; null until they are read.
 * @property {Stretch | null} near Full-resolution states around the current time, if the whole is coarse.
 * @property {number} at_s The current time in the recording.
 * @property {number | null} played_ms When the moment was set forward last while it plays, by the clock of this page.
 * @property {number} speed Playback speed, as a factor.
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

/** Start and end of the recording, in seconds. @param {Recordings} recordings */
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
      // Playback restarts at the end.
      const at_s = recordings.at_s < to_s ? recordings.at_s : from_s;
      return { ...recordings, played_ms: message.now_ms, at_s };
    }
    case "recording_passed":
      return passed(recordings, message.now_ms);
    case "recording_speed":
      return { ...recordings, speed: message.speed };
    case "jog_held":
      // Jogging returns to the live arm.
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

/** Returns the arm at a time, interpolated linearly between two samples. @param {readonly Sample[]} samples @param {number} at_s @returns {Sample | null} */
export function sampleAt(samples, at_s) {
  const next = firstAfter(samples, at_s);
  const [from, to] = [samples[next - 1] ?? samples[0], samples[next] ?? samples.at(-1)];
  if (!from || !to) return null;
  const share = to.at_s > from.at_s ? Math.min(1, Math.max(0, (at_s - from.at_s) / (to.at_s - from.at_s))) : 0;
  const sample = { ...from, at_s };
  for (const name of NUMBERS) sample[name] = from[name] + (to[name] - from[name]) * share;
  return sample;
}

/** Returns the first sample after a time, by binary search. @param {readonly Sample[]} samples @param {number} at_s */
function firstAfter(samples, at_s) {
  let [low, high] = [0, samples.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (/** @type {Sample} */ (samples[middle]).at_s <= at_s) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Whether a stretch contains a time. @param {Stretch | null} near @param {number} at_s @returns {near is Stretch} */
const holds = (near, at_s) => near !== null && near.from_s <= at_s && at_s <= near.to_s;

/** Whether only coarse data is known for the current time. @param {Recordings} recordings */
export const isCoarse = ({ states, near, at_s }) => states !== null && states.spacing_s > 0 && !holds(near, at_s);

/** The sample that the stage shows instead of the live arm, or null. @param {Recordings} recordings @returns {Sample | null} */
export function recorded({ states, near, at_s }) {
  const fine = holds(near, at_s) && near.samples.length ? near : null;
  return states && sampleAt((fine ?? states).samples, at_s);
}
