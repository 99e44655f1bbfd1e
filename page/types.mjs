// Writes `files/api.d.ts`, the types of what a station and its page say to each other, from the document that a station
// serves, and `files/program.schema.json`, from which the page makes its blocks. With `--check` it writes nothing, and fails if
// they differ.
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import openapi, { astToString } from "openapi-typescript";
import { end, start } from "./tests/program.mjs";

const TYPES = new URL("files/api.d.ts", import.meta.url);
const SCHEMA = new URL("files/program.schema.json", import.meta.url);
const HEAD = "// Made from the API's document by `npm run types --prefix page`.\n\n";

/** The document of a station with a virtual arm. */
async function fetchDocument() {
  const folder = await mkdtemp(join(tmpdir(), "dobot-types-"));
  const station = await start(["up", "--virtual", "--http", "127.0.0.1:0", "--raw", "off", "--data", folder], /page +(http:\S+)/);
  try {
    const answer = await fetch(new URL("api/v1/openapi.json", station.found));
    return await answer.json();
  } finally {
    await end(station.child, "SIGINT");
    await rm(folder, { recursive: true });
  }
}

const schema = execFileSync(process.env.DOBOT ?? "dobot", ["check", "--schema"], { encoding: "utf8" });
for (const [file, made] of [[TYPES, HEAD + astToString(await openapi(await fetchDocument()))], [SCHEMA, schema]]) {
  if (!process.argv.includes("--check")) {
    await writeFile(file, made);
  } else if ((await readFile(file, "utf8")) !== made) {
    console.error(`${file.pathname} is not what the program says; make it anew with: npm run types --prefix page`);
    process.exitCode = 1;
  }
}
