// Stations of a fleet, for the tests of the board.

/** @param {string} name */
export const member = (name, { groups = [], presence = { type: "present" }, page = null, ...state } = {}) => ({
  name, id: `id-${name}`, here: false, presence, heard_at_s: 1,
  about: { version: "0.1.0", page, groups, offers: [], is_virtual: true },
  state: {
    at_s: 1, link: { phase: "up" }, arm: { base_deg: 0, rear_deg: 45, fore_deg: 45, servo_deg: 0 }, trust: { trusted: true, reason: null },
    laser: { armed_for_s: 0, on: false }, lease: null, stop: null, job: null, ...state,
  },
});
