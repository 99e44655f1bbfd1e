// What a screen reader and people who see little need, in every view, at every size, in both themes: axe finds nothing.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { readFile } from "node:fs/promises";
import { open } from "./bench.mjs";
import { LANGUAGES, SIZES, THEMES, VIEWS, look } from "./views.mjs";

const AXE = await readFile(new URL("../node_modules/axe-core/axe.min.js", import.meta.url), "utf8");

let bench;

before(async () => {
  bench = await open({ virtual: true });
});
after(() => bench.end());

/** What is wrong in a view, by rule and place. The themes differ in colours alone: all rules are checked in one of them. */
async function violations(page, theme) {
  const all = theme === THEMES[0];
  const { violations, passes } = await page.evaluate((rules) => window.axe.run(rules), all ? {} : { runOnly: ["color-contrast"] });
  assert.ok(passes.length > (all ? 15 : 0), "axe has looked at it");
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map((it) => it.target.join(" ")).join(", ")}`);
}

for (const size of Object.keys(SIZES)) {
  test(`axe finds nothing on a ${size} in both themes`, async () => {
    // Each view is that of a person who has seen nothing yet.
    const page = await bench.visit(look({ size, theme: THEMES[0], language: LANGUAGES[0] }), () => [localStorage, sessionStorage].forEach((it) => it.clear()));
    for (const [name, lead] of Object.entries(VIEWS)) {
      await page.emulateMedia({ colorScheme: THEMES[0] });
      await bench.enter(page);
      await lead(page);
      await page.evaluate(AXE);
      for (const theme of THEMES) {
        await page.emulateMedia({ colorScheme: theme });
        await page.waitForSelector(`:root[data-theme=${theme}]`);
        assert.deepEqual(await violations(page, theme), [], `${name}, ${theme}`);
      }
      if (name === "stopped") await letMove(page);
    }
    await page.context().close();
  });
}

async function letMove(page) {
  await page.click("#reset");
  await page.click("#confirm-yes");
  await page.waitForSelector("#stopped", { state: "detached" });
}
