// The types of the interface, as the page reads them.

/** @typedef {import("../api").components["schemas"]} Schemas */
/** A station writes null where there is nothing, and leaves out no field of a state. @template T @typedef {T extends object ? {[K in keyof T]-?: Whole<Exclude<T[K], undefined>>} : T} Whole */
/** What the station tells of the arm and of itself. @typedef {Whole<Schemas["State"]>} Station */
/** @typedef {Whole<Schemas["ArmView"]>} Arm */
/** @typedef {Whole<Schemas["JobView"]>} Job */
/** @typedef {Whole<Schemas["LeaseView"]>} Lease */
/** @typedef {Schemas["Request"]} Request */
/** @typedef {Schemas["Reply"]} Reply */
/** @typedef {Schemas["Command"]} Command */
/** @typedef {Schemas["Notice"]} Notice */
/** @typedef {Schemas["Policy"]} Policy */
/** What the station serves of the arm itself. @typedef {Schemas["ArmFacts"]} Facts */
/** @typedef {Schemas["NearView"]} Near */
/** @typedef {Schemas["Role"]} Role */
/** What is told of a problem, one of the page itself too. @typedef {Pick<Schemas["Problem"], "title" | "detail"> & Partial<Pick<Schemas["Problem"], "hint" | "type" | "status" | "rule" | "nearest_mm" | "at_mm">>} Problem */
/** What came of a request: a reply, or a problem. @typedef {{ problem?: Problem, reply?: Reply }} Answer */

export {};
