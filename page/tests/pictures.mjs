// Pictures of every view, at each size, in both themes and languages, to `docs/pictures/page/`:
// `npm run pictures --prefix page`, or with names of views behind it.
import { mkdir } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { open } from "./bench.mjs";
import { LANGUAGES, SIZES, THEMES, VIEWS, look } from "./views.mjs";

const FOLDER = fileURLToPath(new URL("../../docs/pictures/page/", import.meta.url));
const wanted = process.argv.slice(2);
const names = wanted.length ? wanted : Object.keys(VIEWS);

await mkdir(FOLDER, { recursive: true });
const bench = await open({ virtual: true, webgl: true });
for (const name of names) {
  for (const size of Object.keys(SIZES)) {
    for (const theme of THEMES) {
      for (const language of LANGUAGES) {
        const page = await bench.visit(look({ size, theme, language }));
        await VIEWS[name](page);
        // The stage needs a moment until it draws as finely as it can.
        await page.waitForTimeout(1500);
        await page.screenshot({ path: `${FOLDER}${name}-${size}-${theme}-${language}.png` });
        if (name === "stopped") {
          await page.click("#reset");
          await page.click("#sure-yes");
          await page.waitForSelector("#stopped", { state: "detached" });
        }
        await page.context().close();
      }
    }
  }
}
await bench.end();
