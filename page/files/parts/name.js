// The name of the person who uses this page, by which others at the arm know it.

const KEY = "dobot.name";
/** The most characters of a name, as for the station. */
export const NAME_LENGTH = 60;
/** The names that the station accepts: no control characters, no invisible ones, none that change the direction of text. */
export const NAME_PATTERN = `(?=.*\\S)[^\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}]{1,${NAME_LENGTH}}`;
const NAME = new RegExp(`^${NAME_PATTERN}$`, "u");

/** Whether a text is a name. @param {string} text */
export const isName = (text) => NAME.test(text);

/** The name that was given in this browser: empty if the person wants none, null if nobody has been asked. @returns {string | null} */
export function readName() {
  const name = sessionStorage.getItem(KEY) ?? localStorage.getItem(KEY);
  return name === null || name === "" || isName(name) ? name : null;
}

/** Remembers a name. @param {string} name @param {boolean} isShared Whether several people use this browser in turn, as in a class: then for as long as the tab is open. */
export const saveName = (name, isShared) => (isShared ? sessionStorage : localStorage).setItem(KEY, name);

/** The kind of this device. */
export const DEVICE = globalThis.matchMedia?.("(pointer: coarse) and (hover: none)").matches ? "phone" : "computer";
