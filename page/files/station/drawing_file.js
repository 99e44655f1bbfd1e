// A file as a request carries it: its name, and what it holds in Base64.

import { base64 } from "../parts/base64.js";
import { MOST_BYTES } from "../state/draw.js";

/** @typedef {import("../state/types.js").Problem} Problem */

/** @param {File} file @returns {Promise<{ told: { name: string, file: string }, problem?: undefined } | { told?: undefined, problem: Problem }>} */
export async function readDrawing(file) {
  const title = `${file.name} cannot be drawn`;
  if (file.size > MOST_BYTES) return { problem: { title, detail: `the file ${file.name} has ${(file.size / 1e6).toFixed(0)} MB, and a drawing may have ${MOST_BYTES / 1e6} MB`, hint: "draw it in parts, or leave out detail that no pen shows" } };
  const bytes = await base64(file);
  if (bytes === null) return { problem: { title, detail: `the file ${file.name} cannot be read any more`, hint: "choose it again" } };
  return { told: { name: file.name, file: bytes } };
}
