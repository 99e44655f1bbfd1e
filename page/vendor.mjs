// Copies what the page uses of other people's work from the pinned npm packages to `files/vendor/`, minified as they were
// published, with their licences, and writes the digests to `vendor.sha256`. With `--check` it writes nothing, and fails
// if anything differs.
import { createHash } from "node:crypto";
import { mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";

const FOLDER = new URL("files/vendor/", import.meta.url);
const DIGESTS = new URL("vendor.sha256", import.meta.url);
const PACKAGES = new URL("node_modules/", import.meta.url);

const LIT = ["directive", "directive-helpers", "async-directive", "directives/class-map", "directives/if-defined", "directives/live", "directives/ref", "directives/repeat"];

const TOML = ["date", "error", "extract", "parse", "primitive", "stringify", "struct", "util"];

const ARUCO = [
  { from: "cv.js", to: "cv.js", needs: "", gives: "CV" },
  { from: "aruco.js", to: "aruco.js", needs: "cv.js", gives: "AR" },
  { from: "dictionaries/aruco_4x4_1000.js", to: "dictionary.js", needs: "aruco.js", gives: "AR" },
].map(({ from, to, needs, gives }) => ({
  from: `js-aruco2/src/${from}`,
  to: `js-aruco2/${to}`,
  begin: `${needs && `import * as needed from "./${needs}";\n`}const scope = { ${needs && "...needed"} };\n(function () {\n`,
  end: `\n}).call(scope);\nexport const ${gives} = scope.${gives};\n`,
  types: `export const ${gives}: any;\n`,
}));

/** What makes a module of a script that was published for Node. */
const SCRIPT = { begin: "const exports = {}, module = { exports };\n", end: "\nexport default module.exports;\n" };

/** A row for each file: where it comes from, where it goes to, and its types, for those that the page imports. */
const ROWS = [
  { from: "three/build/three.module.min.js", to: "three/three.js", types: 'export * from "three";\n' },
  { from: "three/build/three.core.min.js", to: "three/three.core.min.js" },
  { from: "three/LICENSE", to: "three/LICENSE" },
  { from: "lit-html/lit-html.js", to: "lit-html/lit-html.js", types: 'export * from "lit-html";\n' },
  ...LIT.map((it) => ({ from: `lit-html/${it}.js`, to: `lit-html/${it}.js`, types: `export * from "lit-html/${it}.js";\n` })),
  { from: "lit-html/LICENSE", to: "lit-html/LICENSE" },
  // Its minified build is a script that makes a variable.
  { from: "uplot/dist/uPlot.iife.min.js", to: "uplot/uplot.js", end: "\nexport default uPlot;\n", types: 'export { default } from "uplot";\n' },
  { from: "uplot/dist/uPlot.min.css", to: "uplot/uplot.css" },
  { from: "uplot/LICENSE", to: "uplot/LICENSE" },
  ...TOML.map((it) => ({ from: `smol-toml/dist/${it}.js`, to: `smol-toml/${it}.js` })),
  { from: "smol-toml/dist/index.js", to: "smol-toml/index.js", types: 'export * from "smol-toml";\n' },
  { from: "smol-toml/LICENSE", to: "smol-toml/LICENSE" },
  { from: "uqr/dist/index.mjs", to: "uqr/uqr.js", types: 'export * from "uqr";\n' },
  { from: "uqr/LICENSE", to: "uqr/LICENSE" },
  // Scripts for Node and for a page's variables, made modules.
  ...ARUCO,
  { from: "js-aruco2/LICENSE.txt", to: "js-aruco2/LICENSE" },
  { from: "blockly/blockly_compressed.js", to: "blockly/blockly.js", ...SCRIPT, types: 'import * as Blockly from "blockly/core";\nexport default Blockly;\n' },
  ...["en", "zh-hans", "de"].map((language) => ({ from: `blockly/msg/${language}.js`, to: `blockly/${language}.js`, ...SCRIPT, types: "declare const texts: Record<string, string>;\nexport default texts;\n" })),
  { from: "blockly/LICENSE", to: "blockly/LICENSE" },
];

/** The style sheet that Blockly puts into a page, which the page's security policy does not allow, without its pictures. */
async function blocklyStyles() {
  let css = "";
  const head = { prepend: (style) => (css = style.textContent) };
  Object.assign(globalThis, { window: {}, document: { head, createElement: () => ({}) } });
  const { default: blockly } = await import(new URL("blockly/blockly_compressed.js", PACKAGES));
  blockly.Css.inject({ getRootNode: () => document }, true, "");
  return css.replace(/cursor: url\([^)]*\), /g, "cursor: ").replace(/background(-image)?: url\([^)]*\)[^;]*;/g, "");
}

/** What the folder has to hold: a text for each path. */
async function made() {
  const files = new Map();
  for (const { from, to, begin = "", end = "", types } of ROWS) {
    const text = await readFile(new URL(from, PACKAGES), "utf8");
    files.set(to, begin + text.replace(/\n?\/\/# sourceMappingURL=.*\s*$/, "\n") + end);
    if (types) files.set(to.replace(/\.js$/, ".d.ts"), types);
  }
  files.set("blockly/blockly.css", await blocklyStyles());
  return files;
}

function digests(files) {
  const line = ([path, text]) => `${createHash("sha256").update(text).digest("hex")}  files/vendor/${path}\n`;
  return [...files].sort(([a], [b]) => (a < b ? -1 : 1)).map(line).join("");
}

/** The paths of the files whose text is not what it has to be, that are missing or too many. */
async function differences(files) {
  const entries = await readdir(FOLDER, { recursive: true, withFileTypes: true }).catch(() => []);
  const folder = fileURLToPath(FOLDER);
  const there = entries.filter((it) => it.isFile()).map((it) => `${it.parentPath}/${it.name}`.replace(/\/+/g, "/").slice(folder.length));
  const found = there.filter((path) => !files.has(path));
  for (const [path, text] of files) {
    if ((await readFile(new URL(path, FOLDER), "utf8").catch(() => "")) !== text) found.push(path);
  }
  if ((await readFile(DIGESTS, "utf8").catch(() => "")) !== digests(files)) found.push("vendor.sha256");
  return found;
}

async function write(files) {
  await rm(FOLDER, { recursive: true, force: true });
  for (const [path, text] of files) {
    const file = new URL(path, FOLDER);
    await mkdir(dirname(fileURLToPath(file)), { recursive: true });
    await writeFile(file, text);
  }
  await writeFile(DIGESTS, digests(files));
}

const files = await made();
if (!process.argv.includes("--check")) {
  await write(files);
} else {
  const wrong = await differences(files);
  if (wrong.length > 0) {
    console.error(`page/files/vendor is not what the pinned packages hold: ${wrong.join(", ")}; copy them again with: npm ci --prefix page && npm run vendor --prefix page`);
    process.exitCode = 1;
  }
}
