// The geometry of a photo of the sheet: from pixels to millimetres in the arm's frame. Pure. `dobot_arm/vision.py` has the same
// functions, tested with the same photos.
//
// A picture is a plane seen through a lens: pixels become straight by one number for the lens, and a homography maps the plane of
// the sheet to them. From the homography follows where the camera is, and from that where something above the sheet is.

/** @typedef {readonly [number, number]} Pair */
/** The markers of the sheet by number: four corners each, in mm in the frame of the sheet. @typedef {readonly (readonly Pair[])[]} SheetMarkers */
/** A found marker: its corners in pixels, clockwise from its upper left one. @typedef {{ id: number, corners: readonly Pair[] }} Found */
/** How the camera sees the sheet. @typedef {{ size: Pair, lens: number, toPixels: readonly number[], toSheet: readonly number[], camera_mm: readonly [number, number, number], typical_mm: number, markers: number }} SheetView */
/** A place on or above the sheet. @typedef {{ x_mm: number, y_mm: number, turn_deg: number }} Place */

/** The fewest markers of the sheet that determine where it is. */
export const LEAST_MARKERS = 3;
/** Positions on the sheet are counted from its middle, in units of 100 mm, for well-conditioned equations. */
const MIDDLE_MM = /** @type {const} */ ([200, 0]), UNIT_MM = 100;
/** How far the lens may bend, and how exactly corners are found, in pixels. */
const LENS = 0.4, LENS_DEVIATION = 0.2, CORNER_PX = 0.3;
/** The focal length, in widths of the picture, that is assumed where a view does not show it. */
const USUAL_FOCAL = 0.95;
const FOCAL = /** @type {const} */ ([0.5, 2.5]);

/** Straightens a pixel: from the middle of the picture, in widths of it. @param {Pair} size @param {number} lens @param {Pair} pixel @returns {Pair} */
export function straight([wide, high], lens, [x, y]) {
  const [u, v] = [(x - wide / 2) / wide, (y - high / 2) / wide];
  const stretch = 1 + lens * (u * u + v * v);
  return [u * stretch, v * stretch];
}

/** The reverse of `straight`. @param {Pair} size @param {number} lens @param {Pair} at @returns {Pair} */
export function bent([wide, high], lens, [u, v]) {
  let stretch = 1;
  for (let n = 0; n < 8; n += 1) stretch = 1 + (lens * (u * u + v * v)) / (stretch * stretch);
  return [(u / stretch) * wide + wide / 2, (v / stretch) * wide + high / 2];
}

/** Solves linear equations by elimination; null if they have no single solution. @param {readonly (readonly number[])[]} matrix @param {readonly number[]} right @returns {number[] | null} */
export function solve(matrix, right) {
  const rows = matrix.map((row, n) => [...row, right[n]]);
  for (let column = 0; column < rows.length; column += 1) {
    let best = column;
    for (let n = column + 1; n < rows.length; n += 1) if (Math.abs(rows[n][column]) > Math.abs(rows[best][column])) best = n;
    if (Math.abs(rows[best][column]) < 1e-12) return null;
    [rows[column], rows[best]] = [rows[best], rows[column]];
    for (const row of rows) {
      if (row === rows[column]) continue;
      const factor = row[column] / rows[column][column];
      for (let n = column; n <= rows.length; n += 1) row[n] -= factor * rows[column][n];
    }
  }
  return rows.map((row, n) => row[rows.length] / row[n]);
}

/** @param {readonly number[]} h @param {Pair} at @returns {Pair} */
export function project(h, [x, y]) {
  const w = h[6] * x + h[7] * y + h[8];
  return [(h[0] * x + h[1] * y + h[2]) / w, (h[3] * x + h[4] * y + h[5]) / w];
}

/** The homography that maps points to others, by least squares; null if they are in a line. @param {readonly (readonly [Pair, Pair])[]} pairs @returns {number[] | null} */
export function homography(pairs) {
  /** @type {number[] | null} */ let h = null;
  // The first round weighs points by their distance; the others weigh all alike.
  for (let round = 0; round < 3; round += 1) {
    const matrix = Array.from({ length: 8 }, () => new Array(8).fill(0)), right = new Array(8).fill(0);
    for (const [[x, y], [u, v]] of pairs) {
      const w = h ? h[6] * x + h[7] * y + 1 : 1;
      for (const [row, value] of /** @type {[number[], number][]} */ ([[[x, y, 1, 0, 0, 0, -u * x, -u * y], u], [[0, 0, 0, x, y, 1, -v * x, -v * y], v]])) {
        for (let i = 0; i < 8; i += 1) {
          for (let j = 0; j < 8; j += 1) matrix[i][j] += (row[i] * row[j]) / (w * w);
          right[i] += (row[i] * value) / (w * w);
        }
      }
    }
    const found = solve(matrix, right);
    if (!found) return null;
    h = [...found, 1];
  }
  return h;
}

/** @param {readonly number[]} m a matrix of 3 x 3 */
function inverse([a, b, c, d, e, f, g, h, i]) {
  const whole = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  return [e * i - f * h, c * h - b * i, b * f - c * e, f * g - d * i, a * i - c * g, c * d - a * f, d * h - e * g, b * g - a * h, a * e - b * d].map((part) => part / whole);
}

/** Where the camera is, in units from the middle of the sheet. @param {readonly number[]} h @returns {[number, number, number]} */
function cameraOf([a, b, c, d, e, f, g, h, i]) {
  // The axes of the sheet are equally long and at right angles: two equations for the focal length.
  const [p1, q1, p2, q2] = [a * b + d * e, g * h, a * a + d * d - b * b - e * e, g * g - h * h];
  const shown = Math.sqrt(-(p1 * p1 + p2 * p2) / (p1 * q1 + p2 * q2));
  const focal = shown >= FOCAL[0] && shown <= FOCAL[1] ? shown : USUAL_FOCAL;
  const [r1, r2, t] = [[a / focal, d / focal, g], [b / focal, e / focal, h], [c / focal, f / focal, i]];
  const scale = 2 / (Math.hypot(...r1) + Math.hypot(...r2));
  const r3 = [r1[1] * r2[2] - r1[2] * r2[1], r1[2] * r2[0] - r1[0] * r2[2], r1[0] * r2[1] - r1[1] * r2[0]].map((part) => part * scale);
  const along = (/** @type {number[]} */ axis) => -scale * scale * (axis[0] * t[0] + axis[1] * t[1] + axis[2] * t[2]);
  return [along(r1), along(r2), Math.abs(along(r3))];
}

const inUnits = (/** @type {Pair} */ [x, y]) => /** @type {Pair} */ ([(x - MIDDLE_MM[0]) / UNIT_MM, (y - MIDDLE_MM[1]) / UNIT_MM]);

/**
 * How the camera sees the sheet; null with fewer than three of its markers.
 * @param {readonly Found[]} found @param {SheetMarkers} sheet @param {Pair} size of the picture @returns {SheetView | null}
 */
export function viewOf(found, sheet, size) {
  const markers = found.filter(({ id }) => id < sheet.length);
  if (new Set(markers.map(({ id }) => id)).size < LEAST_MARKERS) return null;
  const corners = markers.flatMap(({ id, corners }) => corners.map((at, n) => /** @type {const} */ ([inUnits(sheet[id][n]), at])));
  const fit = (/** @type {number} */ lens) => {
    const pairs = corners.map(([at, pixel]) => /** @type {const} */ ([at, straight(size, lens, pixel)]));
    const h = homography(pairs);
    if (!h) return null;
    const sum = pairs.reduce((sum, [at, [u, v]]) => {
      const [x, y] = project(h, at);
      return sum + (x - u) ** 2 + (y - v) ** 2;
    }, 0);
    return { lens, h, sum, cost: (sum * size[0] ** 2) / CORNER_PX ** 2 + (lens / LENS_DEVIATION) ** 2 };
  };
  const best = least((lens) => fit(lens)?.cost ?? Infinity, -LENS, LENS);
  const fitted = fit(best);
  if (!fitted) return null;
  const { h, sum } = fitted, [x, y, z] = cameraOf(h);
  const camera_mm = /** @type {const} */ ([x * UNIT_MM + MIDDLE_MM[0], y * UNIT_MM + MIDDLE_MM[1], z * UNIT_MM]);
  const view = { size, lens: best, toPixels: h, toSheet: inverse(h), camera_mm, typical_mm: 0, markers: corners.length / 4 };
  // The deviation of a corner in pixels, in the scale of the middle of the sheet.
  const [left, right] = [-0.5, 0.5].map((x) => project(h, [x, 0]));
  const perUnit = Math.hypot(right[0] - left[0], right[1] - left[1]);
  return { ...view, typical_mm: (Math.sqrt(sum / corners.length) / perUnit) * UNIT_MM };
}

/** Where a function of one number is least (golden section). @param {(at: number) => number} f @param {number} low @param {number} high */
function least(f, low, high) {
  const part = (Math.sqrt(5) - 1) / 2;
  let [a, b] = [high - part * (high - low), low + part * (high - low)], [fa, fb] = [f(a), f(b)];
  for (let n = 0; n < 22; n += 1) {
    if (fa < fb) [high, b, fb] = [b, a, fa], a = high - part * (high - low), fa = f(a);
    else [low, a, fa] = [a, b, fb], b = low + part * (high - low), fb = f(b);
  }
  return (low + high) / 2;
}

/** The place of a pixel at a height above the sheet, in mm. @param {SheetView} view @param {Pair} pixel @param {number} [height_mm] @returns {Pair} */
export function onSheet({ size, lens, toSheet, camera_mm }, pixel, height_mm = 0) {
  const [u, v] = project(toSheet, straight(size, lens, pixel));
  const [x, y] = [u * UNIT_MM + MIDDLE_MM[0], v * UNIT_MM + MIDDLE_MM[1]];
  const up = height_mm / camera_mm[2];
  return [x + (camera_mm[0] - x) * up, y + (camera_mm[1] - y) * up];
}

/** The pixel of a place at a height above the sheet. @param {SheetView} view @param {Pair} place_mm @param {number} [height_mm] @returns {Pair} */
export function inPicture({ size, lens, toPixels, camera_mm }, [x, y], height_mm = 0) {
  const up = height_mm / camera_mm[2];
  return bent(size, lens, project(toPixels, inUnits([(x - camera_mm[0] * up) / (1 - up), (y - camera_mm[1] * up) / (1 - up)])));
}

/** The place of a marker whose surface is this high. @param {SheetView} view @param {Found} marker @param {number} height_mm @returns {Place} */
export function placeOfMarker(view, { corners }, height_mm) {
  const at = corners.map((corner) => onSheet(view, corner, height_mm));
  const mean = (/** @type {0 | 1} */ axis) => at.reduce((sum, corner) => sum + corner[axis] / 4, 0);
  const ahead = (/** @type {0 | 1} */ axis) => at[0][axis] + at[1][axis] - at[2][axis] - at[3][axis];
  return { x_mm: mean(0), y_mm: mean(1), turn_deg: (Math.atan2(ahead(1), ahead(0)) * 180) / Math.PI };
}

/** How high a marker is above the sheet, by its size: what is nearer to the camera seems larger. In mm, 0 at least. @param {SheetView} view @param {Found} marker @param {number} side_mm its true side */
export function heightOfMarker(view, { corners }, side_mm) {
  const at = corners.map((corner) => onSheet(view, corner));
  const seen_mm = at.reduce((sum, [x, y], n) => sum + Math.hypot(at[(n + 1) % 4][0] - x, at[(n + 1) % 4][1] - y) / 4, 0);
  return Math.max(0, view.camera_mm[2] * (1 - side_mm / seen_mm));
}
