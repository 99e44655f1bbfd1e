import { open, takeControl, press, rest } from "./bench.mjs";
const WEBGL = process.env.WEBGL !== "0";
const bench = await open({ webgl: WEBGL, patient: true });
let { page } = bench;
function top(profile, n = 25) {
  const self = new Map(), byId = new Map(profile.nodes.map((x) => [x.id, x]));
  const parent = new Map(); for (const x of profile.nodes) for (const ch of x.children ?? []) parent.set(ch, x.id);
  const total = new Map();
  profile.samples.forEach((id, i) => {
    const dt = profile.timeDeltas[i] / 1000; const x = byId.get(id);
    const name = (c) => `${c.functionName || "(anon)"} ${c.url.split("/").slice(-2).join("/")}:${c.lineNumber}`;
    self.set(name(x.callFrame), (self.get(name(x.callFrame)) ?? 0) + dt);
    const seen = new Set(); for (let p = id; p; p = parent.get(p)) { const k = name(byId.get(p).callFrame); if (!seen.has(k)) { seen.add(k); total.set(k, (total.get(k) ?? 0) + dt); } }
  });
  const fmt = (m) => [...m].sort((a, b) => b[1] - a[1]).slice(0, n).map(([k, v]) => `  ${v.toFixed(0).padStart(6)} ms ${k}`).join("\n");
  return "SELF\n" + fmt(self) + "\nTOTAL\n" + fmt(total);
}
const c = await page.context().newCDPSession(page);
await c.send("Profiler.enable"); await c.send("Profiler.setSamplingInterval", { interval: 500 });
if (process.env.LOAD) {
  await c.send("Profiler.start"); await page.reload(); await page.waitForTimeout(9000);
  console.log(top((await c.send("Profiler.stop")).profile));
} else {
  await takeControl(page); await rest(page);
  await press(page, "y_plus"); await c.send("Profiler.start"); await page.waitForTimeout(1500);
  const { profile } = await c.send("Profiler.stop"); await page.mouse.up();
  console.log(top(profile, 30));
}
await bench.end();
