// The keep-out zones of a policy's text: each is a line of its own below `[keep_out]`. Comments and all other lines stay.

/** @typedef {import("./types.js").Schemas["KeepOut"]} Zone */

const HEADER = /^\s*\[keep_out\]/;
const ANY_HEADER = /^\s*\[/;

/** @param {string} name */
const escaped = (name) => name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");

/** @param {string} name */
const isName = (name) => /^[A-Za-z0-9_-]+$/.test(name);

/** @param {number[]} bounds */
const range = (bounds) => `[${bounds.join(", ")}]`;

/** A zone as a line of TOML. @param {string} name @param {Zone} zone */
function lineOf(name, zone) {
  if ("box" in zone) {
    const { x_mm, y_mm, z_mm } = zone.box;
    return `${name} = { box = { x_mm = ${range(x_mm)}, y_mm = ${range(y_mm)}, z_mm = ${range(z_mm)} } }`;
  }
  const { x_mm, y_mm, radius_mm, z_mm } = zone.cylinder;
  return `${name} = { cylinder = { x_mm = ${x_mm}, y_mm = ${y_mm}, radius_mm = ${radius_mm}, z_mm = ${range(z_mm)} } }`;
}

/**
 * The text with this zone, or without it; nothing where the zone is written in another way, so that a person has to change it.
 * @param {string} text @param {string} name @param {Zone | null} zone @returns {string | null}
 */
export function withZone(text, name, zone) {
  if (!isName(name)) return null;
  const lines = text.split("\n");
  const begin = lines.findIndex((line) => HEADER.test(line));
  if (begin < 0) return zone ? [...lines, "", "[keep_out]", lineOf(name, zone), ""].join("\n") : null;
  const after = lines.findIndex((line, n) => n > begin && ANY_HEADER.test(line));
  const end = after < 0 ? lines.length : after;
  const own = new RegExp(`^\\s*("?)${escaped(name)}\\1\\s*=\\s*\\{.*\\}\\s*(#.*)?$`);
  const at = lines.findIndex((line, n) => n > begin && n < end && own.test(line));
  if (at >= 0) lines.splice(at, 1, ...(zone ? [lineOf(name, zone)] : []));
  else if (zone && !lines.some((line) => line.includes(`keep_out.${name}]`))) lines.splice(begin + 1, 0, lineOf(name, zone));
  else return null;
  return lines.join("\n");
}

/** A name that no zone has yet. @param {readonly string[]} taken */
export function freeName(taken) {
  for (let n = 1; ; n += 1) if (!taken.includes(`zone_${n}`)) return `zone_${n}`;
}
