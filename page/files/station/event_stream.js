// Server-sent events read with the access token, which an EventSource cannot send.

/**
 * Splits the text of a stream into events.
 * @param {(event: string, data: string) => void} onEvent @returns {(text: string) => void}
 */
export function createReader(onEvent) {
  let rest = "";
  return (text) => {
    const blocks = (rest + text).split("\n\n");
    rest = blocks.pop() ?? "";
    for (const block of blocks) {
      const field = (/** @type {string} */ name) => block.split("\n").find((line) => line.startsWith(`${name}: `))?.slice(name.length + 2) ?? "";
      if (field("data")) onEvent(field("event"), field("data"));
    }
  };
}

/**
 * Reads a stream until it ends or is no longer needed.
 * @param {Response} answer
 * @param {object} listener
 * @param {(event: string, data: string) => void} listener.onEvent receives each event
 * @param {() => void} [listener.onChunk] is called after the events of each chunk, also of a keep-alive without events
 * @param {() => boolean} listener.isWanted
 */
export async function readEvents(answer, { onEvent, onChunk, isWanted }) {
  const stream = answer.body?.pipeThrough(new TextDecoderStream()).getReader();
  const read = createReader(onEvent);
  while (stream) {
    const { value, done } = await stream.read().catch(() => ({ value: undefined, done: true }));
    if (done || !isWanted()) break;
    read(value ?? "");
    onChunk?.();
  }
}
