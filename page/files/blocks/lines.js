// Where the parts of a program stand in its text: problems name lines, blocks have paths.

/** The path of a part: `["steps", 2, "when", 0]`, `["points", "aside"]`. @typedef {readonly (string | number)[]} Place */

const HEADER = /^\s*\[(\[)?\s*([^\]]+?)\s*\]/;
const NAMED = /^\s*("(?:[^"\\]|\\.)*"|'[^']*'|[\w-]+)\s*=/;

/** The parts of a dotted key. @param {string} key */
const partsOf = (key) => [...key.matchAll(/"((?:[^"\\]|\\.)*)"|'([^']*)'|[\w-]+/g)].map(([all, double, single]) => double ?? single ?? all);

/** The place of each line, counted from 0: the innermost table in which it is, or the named value. @param {string} text @returns {Place[]} */
export function placesOf(text) {
  /** How often each list has begun, by its path. @type {Map<string, number>} */ const counts = new Map();
  /** @type {(string | number)[]} */ let table = [];
  return text.split("\n").map((line) => {
    const header = HEADER.exec(line);
    if (header) {
      const parts = partsOf(header[2] ?? "");
      table = [];
      parts.forEach((part, n) => {
        table.push(part);
        const key = JSON.stringify(table);
        if (header[1] && n === parts.length - 1) counts.set(key, (counts.get(key) ?? -1) + 1);
        const count = counts.get(key);
        if (count !== undefined) table.push(count);
      });
      return [...table];
    }
    const name = NAMED.exec(line)?.[1];
    return name === undefined ? [...table] : [...table, ...partsOf(name)];
  });
}
