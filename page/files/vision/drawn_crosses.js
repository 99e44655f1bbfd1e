// The crosses that an arm draws for a calibration by a photo; what finds them is loaded with the photo.

/** @typedef {import("./geometry.js").Pair} Pair */

/** Where an arm draws crosses for a photo, in mm: between the points of the sheet. */
export const CROSSES = Array.from({ length: 25 }, (_, n) => /** @type {Pair} */ ([140 + 30 * Math.floor(n / 5), -90 + 45 * (n % 5)]));
/** How far a line of a cross reaches, along x and y: lines of 8 mm at 45 degrees. */
export const DIAGONAL_MM = 4 / Math.SQRT2;
/** The fewest crosses for a calibration. */
export const LEAST_CROSSES = 12;
