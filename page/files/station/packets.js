// Listens to the packets while somebody looks at them, by server-sent events that are read with the token, which an
// EventSource would not carry.

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/types.js").Schemas} Schemas */

const AGAIN_MS = 1000;

/**
 * The events of a stream, cut out of its text as it comes.
 * @param {(event: string, data: string) => void} hear @returns {(text: string) => void}
 */
export function createReader(hear) {
  let rest = "";
  return (text) => {
    const blocks = (rest + text).split("\n\n");
    rest = blocks.pop() ?? "";
    for (const block of blocks) {
      const field = (/** @type {string} */ name) => block.split("\n").find((it) => it.startsWith(`${name}: `))?.slice(name.length + 2) ?? "";
      if (field("data")) hear(field("event"), field("data"));
    }
  };
}

/** @param {Store} store @param {import("./http.js").Http} http */
export function followPackets(store, http) {
  const { send } = store;
  /** What ends the listening that goes on. @type {AbortController | null} */ let listening = null;

  const isWanted = () => store.page.packets.listening && store.page.tab === "watch" && store.page.connection === "open";

  /** @param {AbortController} mine */
  async function listen(mine) {
    const answer = await http.get("api/v1/packets", mine.signal);
    if (answer && !answer.ok) send({ type: "packets_refused", problem: await answer.json() });
    const stream = answer?.ok ? answer.body?.pipeThrough(new TextDecoderStream()).getReader() : undefined;
    /** @type {Schemas["PacketView"][]} */ let heard = [];
    const read = createReader((event, data) => {
      if (event === "packet") heard.push(JSON.parse(data));
      else if (event === "lost") send({ type: "packets_lost", count: JSON.parse(data).lost });
    });
    while (stream) {
      const { value, done } = await stream.read().catch(() => ({ value: undefined, done: true }));
      if (done || listening !== mine) break;
      read(value ?? "");
      if (heard.length) send({ type: "packets", packets: heard });
      heard = [];
    }
    if (listening !== mine) return;
    listening = null;
    if (answer?.ok !== false) setTimeout(follow, AGAIN_MS);
  }

  function follow() {
    if (isWanted() === (listening !== null)) return;
    listening?.abort();
    listening = isWanted() ? new AbortController() : null;
    if (listening) void listen(listening);
  }

  store.listen((_, { type }) => {
    if (type === "packets_wanted" || type === "tab" || type === "hello" || type === "closed") follow();
  });
}
