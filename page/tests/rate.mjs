// Measures how many frames the stage draws while the arm moves over a drawing of 50,000 lines, on what draws here: a graphics
// card, or the processor where there is none. `npm run rate --prefix page`, with CARD=1 on a computer with a card.
import { openStage } from "./stage_bench.mjs";

const LINES = 50_000;
const MEASURED_S = 6;

/** A spiral, and an arm that never stands still; the intervals between the frames, in ms. */
async function measure({ lines, seconds }) {
  const ends_mm = [];
  const at = (n) => [225 + (5 + n * 0.0017) * Math.cos(n * 0.05), (5 + n * 0.0017) * Math.sin(n * 0.05)];
  for (let n = 0; n < lines; n += 1) ends_mm.push(...at(n), ...at(n + 1));
  const begun = performance.now();
  window.show({ marks: { width_mm: 0.3, ends_mm, shades: Array(lines).fill(1) }, paper: { from_mm: [120, -105], to_mm: [330, 105] } });
  const drawn_ms = performance.now() - begun;
  const start = performance.now();
  const feed = setInterval(() => {
    const at_s = (performance.now() - start) / 1000;
    const joints = { base_deg: 40 * Math.sin(at_s), rear_deg: 30 + 10 * Math.sin(2 * at_s), fore_deg: 45, servo_deg: 0 };
    window.show({ arm: { at_s, ...joints, suction: false, gripper_deg: 0 } });
  }, 80);
  const frames = [];
  // The first seconds are those in which the stage finds out how fine it can draw.
  while (performance.now() - start < 2 * seconds * 1000) {
    const before = performance.now();
    await new Promise((done) => requestAnimationFrame(done));
    if (before - start > seconds * 1000) frames.push(performance.now() - before);
  }
  clearInterval(feed);
  const gl = document.querySelector("canvas").getContext("webgl2"), named = gl.getExtension("WEBGL_debug_renderer_info");
  return { drawn_ms, frames, pixels: [gl.drawingBufferWidth, gl.drawingBufferHeight], card: gl.getParameter(named.UNMASKED_RENDERER_WEBGL) };
}

for (const viewport of [{ width: 1000, height: 700 }, { width: 390, height: 340 }]) {
  const bench = await openStage({ viewport });
  const { frames, pixels, card, drawn_ms } = await bench.page.evaluate(measure, { lines: LINES, seconds: MEASURED_S });
  await bench.end();
  frames.sort((a, b) => a - b);
  const share = (part) => frames[Math.floor(frames.length * part)].toFixed(0);
  console.log(`${viewport.width}x${viewport.height}, drawn with ${pixels.join("x")} pixels by ${card}`);
  console.log(`  ${LINES} lines were put on the paper in ${drawn_ms.toFixed(0)} ms; frame to frame: median ${share(0.5)} ms, 95 % within ${share(0.95)} ms`);
}
