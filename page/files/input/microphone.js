// The microphone in a thread of its own: its samples as 16-bit integers at 16 kHz, in pieces of a tenth of a second.

import { createResampler } from "./resampler.js";

/** What an audio thread offers, which has no types of its own. @typedef {{ sampleRate: number, AudioWorkletProcessor: new () => { port: MessagePort }, registerProcessor: (name: string, processor: unknown) => void }} AudioThread */

const { sampleRate, AudioWorkletProcessor, registerProcessor } = /** @type {AudioThread} */ (/** @type {unknown} */ (globalThis));

class Microphone extends AudioWorkletProcessor {
  resample = createResampler(sampleRate);

  /** @param {Float32Array[][]} inputs */
  process(inputs) {
    const channel = inputs[0]?.[0];
    if (channel) for (const piece of this.resample(channel)) this.port.postMessage(piece, [piece.buffer]);
    return true;
  }
}
registerProcessor("microphone", Microphone);
