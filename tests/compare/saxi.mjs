// Compares the time from file to plan with saxi's modules on the same lines: ./ci.sh compare-saxi
//
// Prints a table: processor seconds and pen-up travel, ours from the file to the plan, saxi's from the lines to the plan
// (sorting, joining within 0.05 mm, planning). The lines and our figures are those of the example `plan_time`.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const [folder, figures, modules] = process.argv.slice(2);
const require = createRequire(modules);
const Optimization = require("optimize-paths");
const Planning = require("saxi/dist/server/planning");

const JOIN_MM = 0.05;

function planned(lines) {
  const before = process.cpuUsage();
  const paths = Optimization.merge(Optimization.reorder(lines), JOIN_MM);
  const steps = Planning.Device.Axidraw.stepsPerMm;
  const scaled = paths.map((path) => path.map(({ x, y }) => ({ x: steps * x, y: steps * y })));
  Planning.plan(scaled, Planning.AxidrawFast);
  const { user, system } = process.cpuUsage(before);
  return { cpu_s: (user + system) / 1e6, travel_mm: travel(paths) };
}

function travel(paths) {
  const ways = paths.slice(1).map((path, i) => {
    const [from, to] = [paths[i].at(-1), path[0]];
    return Math.hypot(to.x - from.x, to.y - from.y);
  });
  return ways.reduce((sum, way) => sum + way, 0);
}

console.log("drawing              ours s   saxi s  ratio   ours mm  saxi mm  ratio");
for (const line of readFileSync(figures, "utf8").trim().split("\n")) {
  const ours = JSON.parse(line);
  const name = ours.file.replace(/.*\//, "").replace(/\.\w+$/, "");
  // On the paper, as ours.
  const points = JSON.parse(readFileSync(`${folder}/${name}.json`, "utf8"));
  const lines = points.map((path) => path.map(([x, y]) => ({ x: x * ours.scale, y: y * ours.scale })));
  const saxi = planned(lines);
  const columns = [ours.cpu_s, saxi.cpu_s, ours.cpu_s / saxi.cpu_s].map((number) => number.toFixed(3).padStart(8));
  const ways = [ours.travel_mm, saxi.travel_mm, ours.travel_mm / saxi.travel_mm];
  const texts = ways.map((number, i) => number.toFixed(i < 2 ? 0 : 2).padStart(8));
  console.log(name.padEnd(18) + columns.join(" ") + texts.join(" "));
}
