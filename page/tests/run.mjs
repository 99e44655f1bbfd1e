// Runs the browser tests, several files in parallel: `npm run browser --prefix page`, followed by names to run only some files, as in
// `-- stage watch`. `npm run browser:fleet` runs the tests that need a `dobot` with the feature `fleet`. Each file starts its
// own browser: that takes less CPU time than to pass every message through the server of a shared one.
import { spawnSync } from "node:child_process";
import { readdir } from "node:fs/promises";
import { basename } from "node:path";
import { run } from "node:test";
import { spec } from "node:test/reporters";
import { launch, leave } from "./browser.mjs";

/** Files in parallel: most of the time each waits for its arm. */
const CONCURRENCY = 3;
/** The slowest files, started first. */
const FIRST = ["axe", "board", "film", "learn"];
/** Files that run only when named. */
const NAMED = ["fleet"];

function fail(message) {
  console.error(`error: ${message}`);
  process.exit(1);
}

const folder = new URL("./", import.meta.url);
const all = (await readdir(folder)).filter((name) => name.endsWith(".test.mjs")).map((name) => name.replace(".test.mjs", ""));
const wanted = process.argv.slice(2);
const unknown = wanted.find((name) => !all.includes(name));
if (unknown) fail(`no tests named ${unknown}; available: ${all.join(", ")}`);
const names = wanted.length ? wanted : [...FIRST, ...all.filter((name) => !FIRST.includes(name) && !NAMED.includes(name))];
const dobot = process.env.DOBOT ?? "dobot";
if (spawnSync(dobot, ["--version"]).error) fail(`cannot run ${dobot}; build it with cargo build, and set DOBOT to its path`);
await launch().then(leave, (error) => fail(error.message));

/** How long each file took, in ms. */
const took = new Map();
const tests = run({ files: names.map((name) => new URL(`${name}.test.mjs`, folder).pathname), concurrency: CONCURRENCY });
tests.on("test:fail", () => (process.exitCode = 1));
for (const event of ["test:pass", "test:fail"]) tests.on(event, ({ file, details }) => took.set(file, (took.get(file) ?? 0) + details.duration_ms));
tests.compose(new spec()).pipe(process.stdout);
process.once("exit", () => {
  const slowest = [...took].sort(([, one], [, other]) => other - one).slice(0, 5);
  for (const [file, ms] of slowest) console.log(`${basename(file ?? "")}: ${(ms / 1000).toFixed(0)} s`);
});
