// From a printed sheet to a sorted tray, as docs/senses.md describes it: a camera sees three cubes, a person has one picked up
// and placed, and a program sorts the others. `sorting.test.mjs` checks what the arm did; `film.mjs` makes the film of it.

import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout } from "node:timers/promises";
import { open, waitForAnswer } from "./bench.mjs";
import { photographWorld, viewIn, writeVideo } from "./photos.mjs";
import { inPicture } from "../files/vision/geometry.js";

/** The height of the tray, and of a cube. */
export const TRAY_MM = 6, CUBE_MM = 25;
/** Where the cubes are placed on the tray: x and y by marker. */
export const SLOTS = { 7: [208, -80], 8: [235, -80], 9: [262, -80] };
/** The tool's height above the table is that of the arm plus 60 mm. */
const PAPER_MM = -60;

const box = (name, size, at, turn_deg, color) => `[[box]]\nname = "${name}"\nsize_mm = [${size}]\nat_mm = [${at}]\nturn_deg = ${turn_deg}\nmass_g = 20\ncolor = "${color}"\n`;
const cube = (marker, at, turn_deg, color) => box(`marker ${marker}`, [CUBE_MM, CUBE_MM, CUBE_MM], at, turn_deg, color);
const SCENE = `[suction-cup]\ndown_z_mm = ${PAPER_MM}\ngive_mm = 3\ndiameter_mm = 12\nlifts_g = 500\n
${cube(7, [240, 75], 20, "red")}${cube(8, [180, 30], -35, "yellow")}${cube(9, [195, 95], 60, "blue")}${box("tray", [90, 60, TRAY_MM], [235, -80], 0, "teal")}`;

const place = ([x, y]) => `{ x = ${x}, y = ${y}, z = ${PAPER_MM + TRAY_MM + CUBE_MM} }`;
const ASIDE = '[[steps]]\ngo = { x = 200, y = 0, z = 30 }\npath = "movj"\n';
const PROGRAM = `title = "sort the others"\n${ASIDE}${[8, 9].map((marker) => `[[steps]]\npick = { from = "seen", marker = ${marker} }\napproach = 40\n[[steps]]\nplace = ${place(SLOTS[marker])}\napproach = 40\n`).join("")}${ASIDE}`;

/** A bench whose virtual arm stands beside the cubes, and whose browser has a camera that shows them. */
export async function openSorting(options = {}) {
  const folder = await mkdtemp(join(tmpdir(), "sorting-"));
  const video = join(folder, "camera.y4m");
  const browserArgs = ["--use-fake-ui-for-media-stream", "--use-fake-device-for-media-stream", `--use-file-for-fake-video-capture=${video}`];
  const bench = await open({ virtual: true, browserArgs, ...options });
  const put = await fetch(new URL("api/v1/world", bench.url), { method: "PUT", headers: { "content-type": "application/json" }, body: JSON.stringify({ scene: SCENE }) });
  if (!put.ok) throw new Error(await put.text());
  /** Takes a photo of the objects that the arm does not hold; the camera shows it from then on. */
  async function shoot() {
    const photo = await photographWorld(folder, await bench.ask("api/v1/world"));
    writeVideo(video, [photo]);
    return photo;
  }
  const view = viewIn(await shoot());
  return {
    ...bench, shoot,
    /** Takes a photo whenever the arm takes or releases an object, until the state of the station is so. */
    async shootUntil(isSo) {
      for (let shown = "", is_over = false, tries = 0; !is_over; await setTimeout(50)) {
        if ((tries += 1) > 1200) throw new Error(`the state of the station never becomes what was waited for: ${isSo}`);
        is_over = isSo(await bench.ask("api/v1/state"));
        const held = (await bench.ask("api/v1/world")).held.join();
        if (held !== shown) await shoot();
        shown = held;
      }
    },
    /** Where a place is in the picture, as shares of its width and height. */
    shareOf(at, height_mm) {
      const [x, y] = inPicture(view, at, height_mm);
      return [x / view.size[0], y / view.size[1]];
    },
    async end() {
      await bench.end();
      await rm(folder, { recursive: true });
    },
  };
}

/**
 * The story. `seen` is called with each part when it is over.
 * @param {import("./story.mjs").Hand} hand
 * @param {Awaited<ReturnType<typeof openSorting>>} bench
 * @param {(part: "found" | "measured" | "picked" | "placed" | "sorted") => Promise<void>} seen
 */
export async function tellSorting(hand, { shoot, shootUntil, shareOf }, seen) {
  const { page } = hand;
  const holds = (wanted) => waitForAnswer(page, "api/v1/world", ({ held }) => held.join() === wanted);
  const isFree = (marker) => page.waitForFunction((marker) => document.querySelector(`[data-thing='marker ${marker}'] [data-act=pick]`)?.disabled === false, marker);

  await hand.click("#first-close");
  await hand.click("#tab-look");
  await page.waitForSelector("[data-thing='marker 9']");
  await hand.look(3);
  await seen("found");

  await hand.type("[data-thing='marker 7'] input", String(CUBE_MM));
  await page.keyboard.press("Tab");
  for (const marker of [8, 9]) await hand.click(`[data-thing='marker ${marker}'] [data-act=measure]`);
  await hand.look(1.5);
  await seen("measured");

  await isFree(7);
  await hand.click("[data-thing='marker 7'] [data-act=pick]");
  await holds("marker 7");
  await shoot();
  await page.waitForFunction(() => !document.querySelector("[data-thing='marker 7']"));
  await isFree(8);
  await seen("picked");

  await hand.type("#look-surface", String(TRAY_MM));
  await page.keyboard.press("Tab");
  await hand.clickAt("#look-picture", shareOf(SLOTS[7], TRAY_MM));
  await hand.click("#look-place");
  await holds("");
  await shoot();
  await page.waitForSelector("[data-thing='marker 7']");
  await isFree(8);
  await seen("placed");

  await hand.click("#tab-teach");
  await hand.to("#teach-open");
  await page.setInputFiles("#teach-file", { name: "sort.toml", mimeType: "text/plain", buffer: Buffer.from(PROGRAM) });
  await page.waitForSelector("#step-5");
  await hand.look();
  await hand.click("#teach-once");
  await page.waitForSelector("#job-question");
  await hand.click("#tab-look");
  // What is below the picture stays where it is once the objects are found.
  await page.waitForSelector("[data-thing='marker 9']");
  await hand.click("#look-answers");
  await page.waitForSelector("#look-answers:checked");
  await shootUntil(({ job }) => job === null || job.phase === "done");
  await seen("sorted");

  await hand.click("[data-look=top]");
  await hand.look(3);
}
