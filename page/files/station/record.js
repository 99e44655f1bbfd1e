// Records the path on which the arm is jogged, for the program that is being taught.

/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {Schemas["RecordedPlace"]} Place */
/** @typedef {ReturnType<typeof createRecorder>} Recorder */

/** The most places: an hour, as in `dobot teach`. */
export const MOST_PLACES = 45_000;
/** How far the lines of the program may be from the path. */
const TOLERANCE_MM = 0.5;

/** The place that a state reports. @param {Schemas["ArmView"]} arm @returns {Place} */
const placeOf = ({ x_mm, y_mm, z_mm, rotation_deg, suction, gripper_deg }) => ({ point_mm: [x_mm, y_mm, z_mm], rotation_deg, suction, gripper_deg });

/** @param {import("../state/store.js").Store} store @param {(path: { places: Place[], tolerance_mm: number }) => Promise<boolean>} insert adds a path to the program */
export function createRecorder(store, insert) {
  const { send } = store;
  /** @type {Place[]} */ let places = [];

  store.subscribe(({ station, teach }, message) => {
    if (message.type !== "state" || teach.recorded === null || !station?.arm || places.length >= MOST_PLACES) return;
    const place = placeOf(station.arm);
    if (JSON.stringify(place) === JSON.stringify(places.at(-1))) return;
    places.push(place);
    send({ type: "teach_recorded", places: places.length });
  });

  return {
    /** Starts a recording, or ends it and adds the path to the program; what cannot be added is kept for another try. */
    async toggle() {
      const { teach, station } = store.page;
      if (teach.recorded === null) {
        places = station?.arm ? [placeOf(station.arm)] : [];
        return send({ type: "teach_recorded", places: places.length });
      }
      if (places.length > 1 && !(await insert({ places, tolerance_mm: TOLERANCE_MM }))) return;
      send({ type: "teach_recorded", places: null });
    },
  };
}
