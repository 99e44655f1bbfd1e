// Compares what `dobot` draws with what Chromium shows, for 200 icons and for the cases in cases.svg.txt.
//
//   node tests/icons/compare.mjs PATH-OF-THE-EXAMPLE-strokes
//
// Both are drawn with thin lines. `missing` is the share of a browser's edges that no line is near, `extra` the share of the lines
// that no edge is near: edges of a shape on another one of the same colour, in icons and flags.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const HERE = dirname(fileURLToPath(import.meta.url));
/** The longer side of the pictures, in pixels. */
const SIDE = 320;
/** How far a line may be from an edge, in pixels. */
const NEAR = 3;
/** The largest share that may differ: corners, and pieces shorter than a pixel. */
const MOST = 0.02;
const SETS = [
  { name: "lucide-static", folder: "icons", count: 67 },
  { name: "bootstrap-icons", folder: "icons", count: 67 },
  { name: "flag-icons", folder: "flags/4x3", count: 66 },
];

/** Every nth file of a set, so that they are spread over the alphabet. */
function icons({ name, folder, count }) {
  const path = join(HERE, "node_modules", name, folder);
  const all = readdirSync(path).filter((file) => file.endsWith(".svg")).sort();
  // Markers depend on the width of lines.
  const files = all.filter((file) => !readFileSync(join(path, file), "utf8").includes("<marker"));
  return Array.from({ length: count }, (_, i) => join(path, files[Math.floor((i * files.length) / count)]));
}

/** The cases, each in a file of its own: a line for each, a page of 100 by 100. */
function cases(folder) {
  const lines = readFileSync(join(HERE, "cases.svg.txt"), "utf8").split("\n");
  const contents = lines.filter((line) => line.trim() && !line.startsWith("#"));
  return contents.map((content, i) => {
    const file = join(folder, `case-${i + 1}.svg`);
    writeFileSync(file, `<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="100" height="100" viewBox="0 0 100 100">${content}</svg>`);
    return { file, content };
  });
}

/** What runs in the page: both pictures, and the shares in which they differ. */
async function differences({ svg, drawn, side, near }) {
  const mm = 96 / 25.4;
  const [width, height] = drawn.size.map((size) => size * mm);
  const scale = side / Math.max(width, height);
  const pixels = [Math.ceil(width * scale), Math.ceil(height * scale)];
  const canvas = () => {
    const made = Object.assign(document.createElement("canvas"), { width: pixels[0], height: pixels[1] });
    const context = made.getContext("2d", { willReadFrequently: true });
    context.fillStyle = "white";
    context.fillRect(0, 0, ...pixels);
    return context;
  };
  const shown = canvas();
  const doc = new DOMParser().parseFromString(svg, "image/svg+xml");
  const root = doc.documentElement;
  if (!root.hasAttribute("viewBox")) root.setAttribute("viewBox", `0 0 ${width} ${height}`);
  root.setAttribute("width", pixels[0]);
  root.setAttribute("height", pixels[1]);
  root.style.cssText += ";width:auto;height:auto";
  const thin = doc.createElementNS("http://www.w3.org/2000/svg", "style");
  // Lines that do not scale have dashes that do not scale.
  thin.textContent = svg.includes("dasharray") ? "*{stroke-width:.4px!important}" : "*{stroke-width:1px!important;vector-effect:non-scaling-stroke!important}";
  root.append(thin);
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([new XMLSerializer().serializeToString(doc)], { type: "image/svg+xml" }));
  await image.decode();
  shown.drawImage(image, 0, 0, ...pixels);
  const lines = canvas();
  lines.scale(scale * mm, scale * mm);
  lines.lineWidth = 1.5 / (scale * mm);
  for (const [first, ...others] of drawn.strokes) {
    lines.beginPath();
    lines.moveTo(...first);
    for (const point of others) lines.lineTo(...point);
    lines.stroke();
  }
  const data = (context) => context.getImageData(0, 0, ...pixels).data;
  const [a, b] = [data(shown), data(lines)];
  const at = (x, y) => 4 * (y * pixels[0] + x);
  const differ = (i, j) => Math.max(...[0, 1, 2].map((k) => Math.abs(a[i + k] - a[j + k])));
  const edges = [];
  const inks = [];
  // The outermost pixels show the edge of the page.
  for (let y = near; y < pixels[1] - near; y += 1) {
    for (let x = near; x < pixels[0] - near; x += 1) {
      const i = at(x, y);
      if (Math.max(differ(i, at(x + 1, y)), differ(i, at(x, y + 1))) > 24) edges.push([x, y]);
      if (b[i] < 170) inks.push([x, y]);
    }
  }
  const share = (points, others) => {
    const marks = new Uint8Array(pixels[0] * pixels[1]);
    for (const [x, y] of others) {
      for (let dy = -near; dy <= near; dy += 1) {
        for (let dx = -near; dx <= near; dx += 1) marks[(y + dy) * pixels[0] + x + dx] = 1;
      }
    }
    const far = points.filter(([x, y]) => !marks[y * pixels[0] + x]).length;
    return points.length ? far / points.length : 0;
  };
  return { missing: share(edges, inks), extra: share(inks, edges), edges: edges.length };
}

async function compared(page, strokes, file) {
  const drawn = JSON.parse(execFileSync(strokes, [file], { encoding: "utf8", maxBuffer: 1 << 28 }));
  // Nothing to draw is a picture without edges.
  const { error } = drawn;
  if (error && !error.startsWith("nothing to draw")) return { error };
  const size = drawn.size ?? [100 / (96 / 25.4), 100 / (96 / 25.4)];
  const found = { size, strokes: drawn.strokes ?? [] };
  const svg = readFileSync(file, "utf8");
  const result = await page.evaluate(differences, { svg, drawn: found, side: SIDE, near: NEAR });
  const { missing, extra } = result;
  // What a warning names is not silent.
  return { ...result, warnings: drawn.warnings ?? [error], misses: missing > MOST, adds: extra > MOST };
}

/** 0: the same edges; 1: also edges inside one colour; 2: differs with a warning; 3: differs silently. */
function kindOf({ error, misses, adds, warnings }, isCase) {
  if (error) return 3;
  if (!misses && !adds) return 0;
  if (!misses && !isCase) return 1;
  return warnings.length ? 2 : 3;
}

async function main() {
  const strokes = process.argv[2];
  const folder = mkdtempSync(join(tmpdir(), "dobot-icons-"));
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu"] });
  const page = await browser.newPage();
  await page.goto("about:blank");
  let silent = 0;
  console.log("| set | pictures | same edges | also edges inside one colour | differ, with a warning | differ |\n|---|---|---|---|---|---|");
  const sets = [...SETS.map((set) => ({ name: set.name, files: icons(set).map((file) => ({ file, content: file })) })), { name: "cases", files: cases(folder) }];
  const details = [];
  for (const { name, files } of sets) {
    const counts = [0, 0, 0, 0];
    for (const { file, content } of files) {
      const result = await compared(page, strokes, file);
      const kind = kindOf(result, name === "cases");
      counts[kind] += 1;
      if (kind) details.push(`${["", "more", "warned", "silent"][kind]}: ${content}: ${JSON.stringify(result)}`);
    }
    silent += counts[3];
    console.log(`| ${name} | ${files.length} | ${counts.join(" | ")} |`);
  }
  await browser.close();
  rmSync(folder, { recursive: true });
  if (details.length) console.error(details.join("\n"));
  if (silent) throw new Error(`${silent} pictures differ from the browser's without a warning`);
}

await main();
