// Pictures of every view to `docs/pictures/page/`, as WebP: each size, both themes and languages where they tell something.
// `npm run pictures --prefix page`, or with names of views behind it. Chinese needs a font, such as Debian's fonts-noto-cjk.
import { mkdir, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { open } from "./bench.mjs";
import { crowd, queue, mockStation } from "./mock_station.mjs";
import { VIEWS, look } from "./views.mjs";

const FOLDER = fileURLToPath(new URL("../../docs/pictures/page/", import.meta.url));
const LOOKS = [["desktop", "light", "en"], ["desktop", "dark", "zh"], ["tablet", "dark", "en"], ["phone", "light", "en"]];
const QUALITY = 0.8;
/** The board of a fleet, of a stand-in with so many stations. */
const BOARD = "fleet", STATIONS = 30;
const wanted = process.argv.slice(2);
const names = (wanted.length ? wanted : Object.keys(VIEWS)).filter((it) => it !== BOARD);

await mkdir(FOLDER, { recursive: true });
const bench = await open({ virtual: true, webgl: true });
const writer = await bench.page.context().browser().newPage();

/** The same picture, smaller: the browser has a coder of its own. @param {Buffer} png */
async function webp(png) {
  const url = await writer.evaluate(async ([png, quality]) => {
    const image = new Image();
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
    canvas.getContext("2d").drawImage(image, 0, 0);
    return canvas.toDataURL("image/webp", quality);
  }, [png.toString("base64"), QUALITY]);
  return Buffer.from(url.split(",")[1], "base64");
}

// What stays open is drawn, too.
await bench.page.goto("about:blank");
for (const name of names) {
  for (const [size, theme, language] of LOOKS) {
    const page = await bench.visit(look({ size, theme, language }));
    await VIEWS[name](page);
    // The stage needs a moment until it draws as finely as it can.
    await page.waitForTimeout(800);
    await writeFile(`${FOLDER}${name}-${size}-${theme}-${language}.webp`, await webp(await page.screenshot()));
    if (name === "stopped") {
      await page.click("#reset");
      await page.click("#confirm-yes");
      await page.waitForSelector("#stopped", { state: "detached" });
    }
    await page.context().close();
  }
}
if (!wanted.length || wanted.includes(BOARD)) {
  const members = crowd(STATIONS), station = await mockStation(members, undefined, queue(members));
  for (const [size, theme, language] of LOOKS) {
    const context = await writer.context().browser().newContext(look({ size, theme, language }));
    const page = await context.newPage();
    await page.goto(station.url);
    await page.waitForSelector(".tile .learner");
    if (size !== "phone") await page.click(".tile[data-member=desk-5] .name");
    await page.click("#stop");
    await page.waitForSelector("#stop-status .silent");
    await page.waitForTimeout(800);
    await writeFile(`${FOLDER}${BOARD}-${size}-${theme}-${language}.webp`, await webp(await page.screenshot()));
    await context.close();
  }
  await station.end();
}
await bench.end();
