import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { test } from "node:test";

import { LABEL, LANGUAGES, TEXTS, formatClock, languageOf, formatDuration, loadLanguage, translator } from "./i18n.js";

await Promise.all(Object.keys(LANGUAGES).map(loadLanguage));

const ROOT = new URL("../", import.meta.url);

/** The page's own modules, as one text. */
async function modules() {
  const paths = await readdir(ROOT, { recursive: true });
  const own = paths.filter((it) => it.endsWith(".js") && !it.endsWith(".test.js") && !it.startsWith("vendor") && !/^i18n\/..\.js$/.test(it));
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

test("lessons name the same controls in each language, by the keys of their labels", () => {
  const labels = (text) => [...text.matchAll(new RegExp(LABEL, "g"))].map(([, key]) => key).sort();
  for (const [language, texts] of Object.entries(TEXTS)) {
    for (const [key, text] of Object.entries(texts).filter(([key]) => key.startsWith("lesson."))) {
      assert.deepEqual(labels(text), labels(TEXTS.en[key]), `${language} ${key}`);
      for (const label of labels(text)) assert.ok(label in texts, `${key}: ${label}`);
      assert.doesNotMatch(text.replace(new RegExp(LABEL, "g"), ""), /[“”"「」„[\]]/, `${language} ${key} quotes no label as text`);
    }
  }
});

test("Chinese texts follow one convention: full-width punctuation, one word for each term", () => {
  const HALF = /[\u4e00-\u9fff]\s*[,:;?()!]|[,:;?()!]\s*[\u4e00-\u9fff]/;
  // The word that is used instead.
  const OTHERS = { 您: "你", 服务: "控制站", 工作站: "控制站", 站点: "控制站", 作业: "任务", 录制: "记录", 烧刻: "灼烧", 方言: "协议", 待发: "启用", 沉默: "无数据", 世界: "场景", 登录: "令牌", 拱形: "JUMP", 原位: "初始位置", 交还: "释放" };
  for (const [key, text] of Object.entries(TEXTS.zh)) {
    assert.doesNotMatch(text, HALF, key);
    assert.doesNotMatch(text, /[「」『』]| mm\b|\bmm |[\u4e00-\u9fff]"|"[\u4e00-\u9fff]/, key);
    for (const [word, better] of Object.entries(OTHERS)) assert.ok(!text.includes(word), `${key}: ${better}, not ${word}`);
  }
});

test("what a text quotes is the label of a control in its language", () => {
  for (const [language, texts] of Object.entries(TEXTS)) {
    const labels = new Set(Object.values(texts).map((text) => text.replace(/ ?…$/, "")));
    for (const [key, text] of Object.entries(texts)) for (const [, label] of text.matchAll(/[“„]([^”“]+)[”“]/g)) assert.ok(labels.has(label), `${language} ${key}: ${label}`);
  }
});

test("German texts address the user as du, and set quotes and ellipses as German does", () => {
  for (const [key, text] of Object.entries(TEXTS.de)) {
    assert.doesNotMatch(text, /(?<=[a-zäöüß,] )(Sie|Ihr|Ihre|Ihrem|Ihren|Ihnen)\b/, key);
    assert.doesNotMatch(text.replace(/„[^„“"]*“/g, ""), /["„“”]|\S…|\.\.\.|(?<![\d.])\d+\.\d+(?![\d.])/, key);
  }
});

test("values are inserted where the text names them", () => {
  assert.equal(translator("en")("control.others", { name: "desk 3", since: "10:31" }), "desk 3 has control (since 10:31).");
});

test("a browser gets the first available language of its list, or English", () => {
  assert.equal(languageOf(["fr-FR", "zh-CN", "en"]), "zh");
  assert.equal(languageOf(["fr"]), "en");
});

test("times are written as a person would say them", () => {
  const t = translator("en");
  assert.deepEqual([formatDuration(t, 41.4), formatDuration(t, 62), formatDuration(t, 3720)], ["41 s", "1 min 02 s", "1 h 02 min"]);
  assert.equal(formatClock(581), "9:41");
});
