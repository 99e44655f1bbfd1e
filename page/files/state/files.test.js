import assert from "node:assert/strict";
import test from "node:test";
import { NO_FILES, reduceFiles, shownFiles } from "./files.js";

const file = (/** @type {number} */ number, /** @type {string} */ name, kind = "drawing", changed_ms = number) => /** @type {import("./files.js").StoredFile} */ ({ file: number, name, kind, changed_ms, revision: 1, bytes: 1, sha256: "", added_ms: 0, has_sketch: false });
const list = { used_bytes: 0, most_bytes: 1, most_files: 1, damaged: [], files: [file(1, "Harbour.svg"), file(2, "loop.toml", "program"), file(3, "cat.png", "photo"), file(4, "harbour (2).svg", "drawing", 0)] };

test("a panel shows its kinds of files, the last changed first, and only those that are searched", () => {
  const files = reduceFiles(NO_FILES, { type: "files", list });
  assert.deepEqual(shownFiles(files, false).map((it) => it.file), [3, 1, 4]);
  assert.deepEqual(shownFiles(files, true).map((it) => it.file), [2]);
  const searched = reduceFiles(files, { type: "files_search", text: " HARB" });
  assert.deepEqual(shownFiles(searched, false).map((it) => it.file), [1, 4]);
});

test("another station has other files", () => {
  const files = reduceFiles(reduceFiles(NO_FILES, { type: "files", list }), { type: "hello" });
  assert.equal(files.list, null);
});
