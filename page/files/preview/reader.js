// @ts-check
// Reads a timeline in a worker: a large file takes a second, and STOP and the jog buttons cannot wait.

import { Refused, checkSize, readTimeline } from "./timeline.js";

/** @param {File} file */
async function read(file) {
  try {
    checkSize(file.size);
    return { timeline: readTimeline(await file.text()) };
  } catch (error) {
    return { refused: error instanceof Refused ? error.message : new Refused("cannot be read", "a timeline").message };
  }
}

/** Transferred buffers. @param {import("./timeline.js").Timeline} timeline */
function buffers({ moves, path }) {
  return [...Object.values(path), moves.kind, moves.pass, moves.from_s].map((column) => column.buffer);
}

addEventListener("message", async ({ data }) => {
  const answer = await read(data);
  postMessage(answer, { transfer: answer.timeline ? buffers(answer.timeline) : [] });
});
