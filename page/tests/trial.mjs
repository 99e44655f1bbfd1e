// The page of a running station, as a new user sees it first: `node trial.mjs URL PICTURE` jogs the virtual arm with the mouse.
import { launch } from "./browser.mjs";

const [url, picture] = process.argv.slice(2);
const browser = await launch();
const page = await browser.newPage({ viewport: { width: 1280, height: 720 } });
page.setDefaultTimeout(120_000);
await page.goto(url);
await page.waitForSelector("#link-chip[data-tone=good]");
await page.click("#take");
const button = page.locator("[data-axis=y_plus]:visible:enabled").first();
await button.waitFor();
const y_mm = async () => (await (await fetch(new URL("api/v1/state", url))).json()).arm.y_mm;
const before = await y_mm();
await button.hover();
await page.mouse.down();
for (let tries = 0; tries < 100 && (await y_mm()) < before + 3; tries += 1) await page.waitForTimeout(100);
await page.mouse.up();
const after = await y_mm();
await page.screenshot({ path: picture });
await page.click("#release");
await browser.close();
console.log(`y went from ${before} to ${after} mm`);
process.exit(after >= before + 3 ? 0 : 1);
