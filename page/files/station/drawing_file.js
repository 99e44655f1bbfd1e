// A drawing file as a request body: its name and content in Base64.

import { base64 } from "../parts/base64.js";
import { MOST_BYTES } from "../state/draw.js";

/** @typedef {import("../state/types.js").Problem} Problem */

/** @param {File} file @returns {Promise<{ content: { name: string, file: string }, problem?: undefined } | { content?: undefined, problem: Problem }>} */
export async function readDrawing(file) {
  const title = `${file.name} cannot be drawn`;
  if (file.size > MOST_BYTES) return { problem: { title, detail: `the file ${file.name} has ${(file.size / 1e6).toFixed(0)} MB; the limit is ${MOST_BYTES / 1e6} MB`, hint: "split the drawing, or remove detail that no pen shows" } };
  const bytes = await base64(file);
  if (bytes === null) return { problem: { title, detail: `the file ${file.name} can no longer be read`, hint: "choose it again" } };
  return { content: { name: file.name, file: bytes } };
}
