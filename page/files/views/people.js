// Who has control and who stopped the arm, as this page calls them.

/** @typedef {import("./context.js").Context} Context */
/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {import("../i18n/i18n.js").Translate} Translate */

/** The name that the station gives to a page without one. */
const NAMELESS = "page";

/** A time of the station, by the clock of this computer. @param {Context["page"]} page @param {number} at_s */
function clockTime({ station, received_ms, language }, at_s) {
  const then = new Date(received_ms - 1000 * ((station?.at_s ?? at_s) - at_s));
  return then.toLocaleTimeString(language, { hour: "2-digit", minute: "2-digit" });
}

/** A client with its device: `Anna (phone)`, or another page. @param {Translate} t @param {{ name: string, device?: Schemas["Device"] | null }} client */
export function clientName(t, { name, device }) {
  if (!device) return name;
  return t(name === NAMELESS ? "people.page" : "people.named", { name, device: t(`device.${device}`) });
}

/** Who has control, and since when. @param {Context["page"]} page @param {Translate} t */
export function holderText(page, t) {
  const { station, me, name } = page;
  const lease = station?.lease;
  if (!lease) return t("control.free");
  if (lease.client === me) return t("control.mine");
  const since = clockTime(page, lease.since_s);
  if (!lease.device) return t("control.others", { name: lease.name, since });
  const key = lease.name === name ? "control.own_page" : lease.name === NAMELESS ? "control.other_page" : "control.others_page";
  return t(key, { name: lease.name, device: t(`device.${lease.device}`), since });
}

/** Who stopped the arm and why. @param {Context["page"]} page @param {Translate} t @param {Schemas["StopView"]} stop @param {string} rest */
export function stopText({ me }, t, stop, rest) {
  const why = stop.reason ? `: ${stop.reason}` : "";
  if (stop.client != null && stop.client === me) return t("stopped.by_you", { why, rest });
  return t(stop.of_fleet ? "stopped.by_fleet" : "stopped.by", { by: clientName(t, { name: stop.by, device: stop.device }), why, rest });
}
