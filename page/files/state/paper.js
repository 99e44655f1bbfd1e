// Height of the paper.

/** Returns the z at which the tip touches the table of a virtual arm, otherwise the arm's current z. @param {import("./state.js").Page} page */
export function paperOf({ around, station }) {
  if (around) return Math.round((around.table_z_mm + around.tool.length_mm) * 10) / 10;
  return Math.round((station?.arm?.z_mm ?? -40) * 10) / 10;
}
