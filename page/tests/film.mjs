// Makes a film of a story that a test compares with the arm: `npm run film --prefix page` the one that opens the README,
// `docs/pictures/first-minutes.webp` (`film.test.mjs`), `npm run film --prefix page -- sorted-tray` that of docs/senses.md
// (`sorting.test.mjs`). It needs `img2webp` (Debian's package webp) and a calm minute.
import { spawnSync } from "node:child_process";
import { mkdtemp, rm, stat, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { open } from "./bench.mjs";
import { openSorting, tellSorting } from "./sorting.mjs";
import { Hand, tell } from "./story.mjs";

const SIZE = { width: 1120, height: 700 };
const FRAME_MS = 125;
/** What opens a bench, the story, and for each of its parts the caption and the playback speed. */
const FILMS = {
  "first-minutes": [(options) => open({ virtual: true, ...options }), (hand, bench, seen) => tell(hand, seen), [
    ["jogged", "Hold a button: the arm moves", 1],
    ["looped", "Teach two points, and loop them", 1.5],
    ["stopped", "STOP, at any moment", 1],
    ["released", "STOP, at any moment", 1],
    ["planned", "Drop a picture", 1],
    ["drawn", "Watch it drawn (6 times as fast)", 6],
    ["looked", "Look at it from above", 1],
    ["refused", "Out of reach? The page reports why, and how far the arm can go", 1],
    [null, "Out of reach? The page reports why, and how far the arm can go", 1],
  ]],
  "sorted-tray": [openSorting, tellSorting, [
    ["found", "A camera sees the printed sheet and three cubes", 1],
    ["measured", "Enter the height of each, or use the measured one", 1.5],
    ["picked", "Pick up", 1.5],
    ["placed", "Click where it goes, and place it", 1.5],
    ["sorted", "A program sorts the others: the camera says where they are", 3],
    [null, "A sorted tray", 1],
  ]],
};

if (spawnSync("img2webp", ["-version"]).error) throw new Error("img2webp not found; install the package webp");

const name = process.argv[2] ?? "first-minutes";
if (!(name in FILMS)) throw new Error(`no film named ${name}; available: ${Object.keys(FILMS).join(", ")}`);
const FILM = fileURLToPath(new URL(`../../docs/pictures/${name}.webp`, import.meta.url));
const [prepare, story, PARTS] = FILMS[name];
const bench = await prepare({ webgl: true, viewport: SIZE, options: { deviceScaleFactor: 1, colorScheme: "light" } });
const { page } = bench;

/** A pointer and a line of text over the page, for those who look on. */
await page.evaluate(() => {
  const over = (name, style) => {
    const it = document.body.appendChild(document.createElement("div"));
    it.id = name;
    Object.assign(it.style, { position: "fixed", zIndex: "99", pointerEvents: "none", ...style });
    return it;
  };
  const pointer = over("film-pointer", { width: "22px", height: "22px", margin: "-11px 0 0 -11px", borderRadius: "50%", background: "rgb(240 120 0 / 55%)", border: "2px solid rgb(200 80 0)", left: "200px", top: "200px" });
  over("film-line", { right: "335px", top: "478px", padding: "6px 14px", borderRadius: "8px", background: "rgb(20 28 38 / 88%)", color: "white", font: "600 19px system-ui, sans-serif" });
  addEventListener("pointermove", ({ clientX, clientY }) => Object.assign(pointer.style, { left: `${clientX}px`, top: `${clientY}px` }), true);
  const press = (size) => () => (pointer.style.transform = `scale(${size})`);
  addEventListener("pointerdown", press(0.65), true);
  addEventListener("pointerup", press(1), true);
});
const say = (text) => page.evaluate((text) => { document.getElementById("film-line").textContent = text; }, text);

/** What was seen, with the second at which it was. */
const seen = [];
const cast = await page.context().newCDPSession(page);
cast.on("Page.screencastFrame", ({ data, metadata, sessionId }) => {
  seen.push({ picture: Buffer.from(data, "base64"), at_s: metadata.timestamp });
  void cast.send("Page.screencastFrameAck", { sessionId });
});
/** When each part was over. */
const ends = [];
let part = 0;
await say(PARTS[part][1]);
await cast.send("Page.startScreencast", { format: "jpeg", quality: 92, maxWidth: SIZE.width, maxHeight: SIZE.height, everyNthFrame: 2 });
await story(new Hand(page, { glide_ms: 450, look_ms: 600 }), bench, async () => {
  ends.push(Date.now() / 1000);
  part += 1;
  await say(PARTS[part][1]);
});
ends.push(Date.now() / 1000);
await cast.send("Page.stopScreencast");
await bench.end();

/** When in the film a moment is shown, in ms. */
function shownAt(at_s) {
  let from_s = seen[0].at_s, shown_ms = 0;
  for (const [n, [, , faster]] of PARTS.entries()) {
    const to_s = Math.min(at_s, ends[n]);
    if (to_s > from_s) shown_ms += ((to_s - from_s) * 1000) / faster;
    from_s = ends[n];
  }
  return shown_ms;
}

// One picture for each frame: the last that was seen by then.
const all_ms = shownAt(ends.at(-1));
const folder = await mkdtemp(join(tmpdir(), "dobot-film-"));
const words = ["-loop", "0", "-lossy", "-q", "55", "-m", "4"];
let shown = null, since = 0;
const flush = async (frame) => {
  const file = join(folder, `${since}.jpg`);
  await writeFile(file, shown.picture);
  words.push("-d", String((frame - since) * FRAME_MS), file);
};
const times = seen.map(({ at_s }) => shownAt(at_s));
for (let frame = 0; frame * FRAME_MS < all_ms; frame += 1) {
  const next = seen[Math.max(0, times.findLastIndex((it) => it <= frame * FRAME_MS))];
  if (next === shown) continue;
  if (shown) await flush(frame);
  [shown, since] = [next, frame];
}
await flush(Math.ceil(all_ms / FRAME_MS) + 8);
const coder = spawnSync("img2webp", [...words, "-o", FILM], { encoding: "utf8" });
if (coder.status !== 0) throw new Error(coder.stderr);
await rm(folder, { recursive: true });
console.log(`${FILM}: ${(all_ms / 1000).toFixed(0)} s, ${((await stat(FILM)).size / 1e6).toFixed(1)} MB`);
process.exit(0);
