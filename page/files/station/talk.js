// The microphone: asked for when the view opens and a listener runs, off when it closes. Sound leaves this page only while the button
// is held. An order is sent after it was confirmed, marked as the microphone's.

import { blockedReason } from "../state/selectors.js";
import { isSecure, refusalOf, stopTracks } from "./media.js";

/** @typedef {ReturnType<typeof createTalk>} TalkRequests */

/** How often an open view asks whether a listener runs. */
const ASK_MS = 2000;
/** How much sound after the release belongs to what was said. */
const TAIL_MS = 250;

/** @param {import("../state/store.js").Store} store @param {import("./http.js").Http} http @param {import("./socket.js").Socket} socket */
export function createTalk(store, http, socket) {
  const { send } = store;
  const set = (/** @type {Partial<import("../state/talk.js").Talk>} */ set) => send({ type: "talk_set", set });
  /** @type {MediaStream | null} */ let stream = null;
  /** @type {AudioContext | null} */ let audio = null;
  /** @type {number | undefined} */ let timer;
  /** Counts openings: an answer to an earlier question for the microphone is ignored. */
  let openings = 0;
  let isOpen = false;
  /** Whether the station expects the end of what is said. */
  let isSaying = false;
  /** @type {number | undefined} */ let tail;

  async function look() {
    const mine = openings;
    /** @type {{ listens: boolean } | undefined} */ const answer = await http.json("api/v1/talk");
    if (mine !== openings) return;
    const listens = answer?.listens ?? false;
    if (listens !== store.page.talk.listens) set({ listens });
    if (listens && store.page.talk.microphone === "off" && !store.page.talk.refused) void ask();
    timer = setTimeout(look, ASK_MS);
  }

  /** Asks for the microphone. */
  async function ask() {
    const mine = openings, { mediaDevices } = navigator;
    if (!isSecure()) return set({ refused: "insecure" });
    set({ microphone: "asking", refused: null });
    try {
      const own = await mediaDevices.getUserMedia({ audio: { channelCount: 1 }, video: false });
      if (mine !== openings) return stopTracks(own);
      stream = own;
      own.getAudioTracks()[0].onended = () => {
        off();
        set({ microphone: "off", refused: "unplugged" });
      };
      audio = new AudioContext();
      await audio.audioWorklet.addModule(new URL("../input/microphone.js", import.meta.url));
      const microphone = new AudioWorkletNode(audio, "microphone", { numberOfOutputs: 0 });
      microphone.port.onmessage = ({ data }) => (store.page.talk.holds || isSaying) && say(data);
      audio.createMediaStreamSource(own).connect(microphone);
      set({ microphone: "on" });
    } catch (error) {
      if (mine !== openings) return;
      off();
      set({ microphone: "off", refused: refusalOf(error) });
    }
  }

  /** @param {Int16Array<ArrayBuffer>} piece */
  function say(piece) {
    isSaying = true;
    socket.sendAudio(piece.buffer);
  }

  /** Ends what is said. */
  function end() {
    clearTimeout(tail);
    tail = undefined;
    if (isSaying) socket.sendAudio(new ArrayBuffer(0));
    isSaying = false;
  }

  function off() {
    stopTracks(stream);
    void audio?.close();
    [stream, audio] = [null, null];
    end();
  }

  async function go() {
    const { order } = store.page.talk;
    set({ order: null });
    if (!order || blockedReason(store.page)) return;
    socket.takeControlIfFree();
    const { problem } = await socket.ask({ type: "sensed_command", sense: "microphone", command: { type: "voice", text: order.words } });
    if (problem) send({ type: "problem", problem });
  }

  /** The order before this message. */
  let order = store.page.talk.order;
  store.subscribe((page, message) => {
    const said = message.type === "notice" && message.notice.type === "heard" && message.notice.client === page.me ? message.notice.heard.what : null;
    if (said === "go" && order) {
      set({ order });
      void go();
    }
    if (message.type === "tab" && page.tab !== "move" && isOpen) close();
    if (!page.talk.holds && isSaying) tail ??= setTimeout(end, TAIL_MS);
    order = store.page.talk.order;
  });

  function close() {
    isOpen = false;
    openings += 1;
    clearTimeout(timer);
    off();
    set({ microphone: "off", holds: false, order: null, heard: null });
  }

  return {
    /** The view was opened. */
    open() {
      isOpen = true;
      openings += 1;
      set({ refused: null });
      void look();
    },
    close,
    again: ask,
    hold() {
      clearTimeout(tail);
      tail = undefined;
      void audio?.resume();
      set({ holds: true, heard: null });
    },
    release: () => store.page.talk.holds && set({ holds: false }),
    go,
    forget: () => set({ order: null }),
  };
}
