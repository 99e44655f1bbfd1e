import { open, takeControl } from "./bench.mjs";
const SIZES = { desk: [1440, 900], small: [1280, 720], phone: [390, 844], land: [844, 390], z2: [720, 450], z3: [480, 300], tiny: [320, 256] };
const bench = await open({ virtual: true, viewport: { width: 1440, height: 900 } });
const names = (process.env.SIZES ?? Object.keys(SIZES).join()).split(",");
for (const name of names) {
  const [width, height] = SIZES[name];
  const page = await bench.visit({ viewport: { width, height }, hasTouch: name === "phone" });
  const shot = (what) => page.screenshot({ path: `/tmp/h/shots/${name}-${what}.png` });
  await shot("first");
  if (await page.isVisible("#first-close")) await page.click("#first-close");
  if (await page.isVisible("#confirm-pose")) { await page.click("#confirm-pose"); await page.click("#confirm-yes"); await page.waitForSelector("#confirm-pose", { state: "detached" }); }
  await shot("move");
  await page.click("#tab-draw");
  await page.check("#draw-title ~ .segments input[value=text]", { force: true });
  await page.fill("#draw-text", "Hello");
  await page.waitForFunction(() => document.querySelector("#draw-status")?.textContent.includes("Takes"));
  await shot("draw");
  await page.click("#tab-teach"); await page.click("#capture"); await page.waitForSelector("#step-0"); await shot("teach");
  if (name === names[0]) {
    await page.click("#tab-draw"); await page.waitForSelector("#draw-start:enabled"); await page.click("#draw-start"); await page.waitForSelector("#job");
  }
  await page.waitForTimeout(300);
  await shot("job");
  await page.context().close();
}
await bench.end();
