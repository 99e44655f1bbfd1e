// Where the paper lies.

/** Where the tip touches what lies on the table of a virtual arm; else where the arm stands. @param {import("./state.js").Page} page */
export function paperOf({ around, station }) {
  if (around) return Math.round((around.table_z_mm + around.tool.length_mm) * 10) / 10;
  return Math.round((station?.arm?.z_mm ?? -40) * 10) / 10;
}
