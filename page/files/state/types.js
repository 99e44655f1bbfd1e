// The API types, as the page uses them.

/** @typedef {import("../api").components["schemas"]} Schemas */
/** A station writes null for missing values and omits no field of a state. @template T @typedef {T extends object ? {[K in keyof T]-?: Whole<Exclude<T[K], undefined>>} : T} Whole */
/** The state of the arm and its station. @typedef {Whole<Schemas["State"]>} Station */
/** @typedef {Whole<Schemas["ArmView"]>} Arm */
/** @typedef {Whole<Schemas["JobView"]>} Job */
/** @typedef {Whole<Schemas["LeaseView"]>} Lease */
/** @typedef {Schemas["Request"]} Request */
/** @typedef {Schemas["Reply"]} Reply */
/** @typedef {Schemas["Command"]} Command */
/** @typedef {Schemas["Notice"]} Notice */
/** @typedef {Schemas["Policy"]} Policy */
/** The arm's facts: dimensions, tools and limits. @typedef {Schemas["ArmFacts"]} Facts */
/** @typedef {Schemas["NearView"]} Near */
/** @typedef {Schemas["Role"]} Role */
/** A problem, from the station or from the page itself. @typedef {Pick<Schemas["Problem"], "title" | "detail"> & Partial<Pick<Schemas["Problem"], "hint" | "type" | "status" | "rule" | "nearest_mm" | "at_mm">>} Problem */
/** The result of a request: a reply or a problem. @typedef {{ problem?: Problem, reply?: Reply }} Answer */

export {};
