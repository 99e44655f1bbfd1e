// Writes `files/api.d.ts`, the types of what a station and its page say to each other, from the document that a station
// serves. With `--check` it writes nothing, and fails if they differ.
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import openapi, { astToString } from "openapi-typescript";
import { end, start } from "./tests/program.mjs";

const FILE = new URL("files/api.d.ts", import.meta.url);
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

const made = HEAD + astToString(await openapi(await fetchDocument()));
if (!process.argv.includes("--check")) {
  await writeFile(FILE, made);
} else if ((await readFile(FILE, "utf8")) !== made) {
  console.error("page/files/api.d.ts is not what the API's document says; make it anew with: npm run types --prefix page");
  process.exitCode = 1;
}
