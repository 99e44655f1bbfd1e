// Downloads files.

/** @param {Blob} file @param {string} name */
export function saveAs(file, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(file);
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

/** Gives a person what the station has at a path. @param {import("../station/http.js").Http} http @param {string} path @param {string} name @returns {Promise<boolean>} whether there is something */
export async function saveFrom(http, path, name) {
  const answer = await http.get(path);
  if (!answer?.ok) return false;
  saveAs(await answer.blob(), name);
  return true;
}
