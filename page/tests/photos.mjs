// Rendered photos for tests: the same for the same arguments.
import { execFile, execFileSync } from "node:child_process";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { promisify } from "node:util";
import { viewOf } from "../files/vision/geometry.js";
import { createDetector } from "../files/vision/look.js";
import { brightness } from "../files/vision/picture.js";

/** The program that renders them, built with the other examples. */
const PROGRAM = process.env.PHOTOS ?? join(dirname(process.env.DOBOT ?? ""), "examples", "photos");

/** Renders photos of a set; returns their paths without extension. */
export function renderPhotos(folder, set, count, size = "640x480") {
  execFileSync(PROGRAM, [folder, set, String(count), size]);
  return Array.from({ length: count }, (_, n) => join(folder, `${set}-${String(n).padStart(3, "0")}`));
}

/** Takes a photo of a world, a state of `GET /api/v1/world`; returns its path without extension. The page's connection passes through this process: it must not wait. */
export async function photographWorld(folder, world) {
  const rendered = promisify(execFile)(PROGRAM, [folder, "world", "1"]);
  rendered.child.stdin.end(JSON.stringify(world));
  await rendered;
  return join(folder, "world-000");
}

/** How a photo shows the sheet. */
export function viewIn(path) {
  const { picture, truth } = readPhoto(path);
  return viewOf(createDetector()(picture, brightness(picture)), truth.sheet, [picture.width, picture.height]);
}

/** A photo as a picture of four bytes a pixel, and what is true. */
export function readPhoto(path) {
  const { width, height, rgb } = readPixels(path);
  const data = new Uint8ClampedArray(4 * width * height).fill(255);
  for (let n = 0; n < width * height; n += 1) data.set(rgb.subarray(3 * n, 3 * n + 3), 4 * n);
  return { picture: { width, height, data }, truth: JSON.parse(readFileSync(`${path}.json`, "utf8")) };
}

function readPixels(path) {
  const file = readFileSync(`${path}.ppm`);
  const head = /^P6\n(\d+) (\d+)\n255\n/.exec(file.subarray(0, 40).toString("latin1"));
  return { width: Number(head[1]), height: Number(head[2]), rgb: file.subarray(head[0].length) };
}

/** Writes a photo as a file that a browser reads (BMP); returns its path. */
export function writeBitmap(path) {
  const { width, height, rgb } = readPixels(path), file = Buffer.alloc(54 + 3 * width * height);
  file.write("BM");
  for (const [at, value] of [[2, file.length], [10, 54], [14, 40], [18, width], [22, height], [26, 1 | (24 << 16)]]) file.writeUInt32LE(value, at);
  // From the lowest row up, and blue first; the width is a multiple of four.
  for (let y = 0; y < height; y += 1) for (let x = 0; x < width; x += 1) for (let color = 0; color < 3; color += 1) file[54 + 3 * ((height - 1 - y) * width + x) + color] = rgb[3 * (y * width + x) + 2 - color];
  writeFileSync(`${path}.bmp`, file);
  return `${path}.bmp`;
}

/** Writes photos as a video that a browser plays for a camera (Y4M, ten frames a second). */
export function writeVideo(file, paths) {
  const frames = paths.map(readPixels), [{ width, height }] = frames;
  const parts = [Buffer.from(`YUV4MPEG2 W${width} H${height} F10:1 Ip A1:1 C420mpeg2\n`)];
  for (const { rgb } of frames) parts.push(Buffer.from("FRAME\n"), planes(rgb, width, height));
  // Over an older one in place: a browser may be playing it.
  writeFileSync(file, Buffer.concat(parts), { flag: existsSync(file) ? "r+" : "w" });
}

/** Brightness, and two colours at half the resolution. */
function planes(rgb, width, height) {
  const frame = Buffer.alloc((width * height * 3) / 2), [u, v] = [width * height, (width * height * 5) / 4];
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      const at = 3 * (y * width + x), [r, g, b] = [rgb[at], rgb[at + 1], rgb[at + 2]];
      frame[y * width + x] = 16 + 0.257 * r + 0.504 * g + 0.098 * b;
      if (x % 2 || y % 2) continue;
      const small = (y / 2) * (width / 2) + x / 2;
      frame[u + small] = 128 - 0.148 * r - 0.291 * g + 0.439 * b;
      frame[v + small] = 128 + 0.439 * r - 0.368 * g - 0.071 * b;
    }
  }
  return frame;
}
