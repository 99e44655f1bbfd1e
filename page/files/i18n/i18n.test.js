import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { test } from "node:test";

import { LESSONS } from "../state/learn.js";
import { parse } from "../vendor/smol-toml/index.js";
import { TEXTS, formatClock, languageOf, formatDuration, translator } from "./i18n.js";

const ROOT = new URL("../", import.meta.url);

/** The page's own modules, as one text. */
async function modules() {
  const paths = await readdir(ROOT, { recursive: true });
  const own = paths.filter((it) => it.endsWith(".js") && !it.endsWith(".test.js") && !it.startsWith("vendor") && it !== "i18n/en.js" && it !== "i18n/zh.js");
  return (await Promise.all(own.map((it) => readFile(new URL(it, ROOT), "utf8")))).join("\n");
}

test("each language has every text, with the same values in it", () => {
  const values = (text) => [...text.matchAll(/\{\w+\}/g)].map(String).sort();
  for (const [language, words] of Object.entries(TEXTS)) {
    assert.deepEqual(Object.keys(words).sort(), Object.keys(TEXTS.en).sort(), language);
    for (const [word, text] of Object.entries(words)) assert.deepEqual(values(text), values(TEXTS.en[word]), `${language} ${word}`);
  }
});

test("every text is used", async () => {
  const source = await modules();
  // `link.${phase}` uses all that begin so.
  const families = [...source.matchAll(/`([a-z_.]+)\$\{/g)].map((it) => it[1]);
  const unused = Object.keys(TEXTS.en).filter((word) => !source.includes(`"${word}"`) && !families.some((it) => word.startsWith(it)));
  assert.deepEqual(unused, []);
});

test("lessons name the controls as on the page", async () => {
  for (const lesson of LESSONS) {
    const { steps } = parse(await readFile(new URL(`lessons/${lesson}.toml`, ROOT), "utf8"));
    for (const { text } of steps) {
      for (const [, label] of text.zh.matchAll(/“([^”]+)”/g)) {
        const keys = Object.keys(TEXTS.zh).filter((key) => TEXTS.zh[key].replace(/…$/, "") === label);
        assert.ok(keys.some((key) => text.en.includes(TEXTS.en[key].replace(/…$/, ""))), `${lesson}: ${label}`);
      }
    }
  }
});

test("values are inserted where the text names them", () => {
  assert.equal(translator("en")("control.others", { name: "desk 3" }), "desk 3 has control.");
});

test("a browser gets the first available language of its list, or English", () => {
  assert.equal(languageOf(["de-DE", "zh-CN", "en"]), "zh");
  assert.equal(languageOf(["fr"]), "en");
});

test("times are written as a person would say them", () => {
  const t = translator("en");
  assert.deepEqual([formatDuration(t, 41.4), formatDuration(t, 62), formatDuration(t, 3720)], ["41 s", "1 min 02 s", "1 h 02 min"]);
  assert.equal(formatClock(581), "9:41");
});
