import assert from "node:assert/strict";
import { test } from "node:test";

import { RATE, createResampler } from "./resampler.js";

/** A second of a tone, through the resampler in blocks of 128 as a browser has them. */
function heard(rate, hertz) {
  const resample = createResampler(rate);
  const samples = Float32Array.from({ length: rate }, (_, n) => 0.5 * Math.sin((2 * Math.PI * hertz * n) / rate));
  const pieces = [];
  for (let at = 0; at < rate; at += 128) pieces.push(...resample(samples.subarray(at, at + 128)));
  return pieces.flatMap((piece) => [...piece]);
}

/** How strong a tone is, as a share of full scale. */
function strength(samples, hertz) {
  const part = (wave) => samples.reduce((sum, sample, n) => sum + sample * wave((2 * Math.PI * hertz * n) / RATE), 0);
  return (2 * Math.hypot(part(Math.sin), part(Math.cos))) / samples.length / 32767;
}

for (const rate of [16_000, 44_100, 48_000, 96_000]) {
  test(`a second at ${rate} Hz is a second at 16 kHz, with the tones of a voice`, () => {
    for (const hertz of [200, 1000, 3000]) {
      const samples = heard(rate, hertz);
      assert.ok(samples.length >= RATE - 1600 && samples.length <= RATE, String(samples.length));
      assert.ok(Math.abs(strength(samples, hertz) - 0.5) < 0.04, `${hertz}: ${strength(samples, hertz)}`);
    }
  });
}

test("a tone that is too high for 16 kHz is weak, and does not appear as a lower one", () => {
  const samples = heard(48_000, 15_000);
  assert.ok(strength(samples, 1000) < 0.15, String(strength(samples, 1000)));
});

test("samples beyond full scale are the largest ones", () => {
  const resample = createResampler(16_000);
  const [piece] = resample(Float32Array.from({ length: 1600 }, (_, n) => (n % 2 ? 2 : -2)));
  assert.deepEqual([piece[0], piece[1]], [-32767, 32767]);
});
