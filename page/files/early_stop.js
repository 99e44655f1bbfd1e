// STOP until the rest of the page is loaded: over HTTP, because there is no socket yet.

import { listenToStop } from "./input/keys.js";
import { stops } from "./input/stop_button.js";
import { createHttp } from "./station/http.js";
import { createStop } from "./station/stop.js";

const foot = /** @type {HTMLElement} */ (document.getElementById("foot"));
const button = /** @type {HTMLElement} */ (document.getElementById("stop"));
const late = /** @type {HTMLElement} */ (document.getElementById("late-stop"));
const ended = new AbortController();
const http = createHttp();

/** Whether the station answered. */
const request = async () => (await http.stop("api/v1/stop")).problem === undefined;
const press = createStop({ first: request, again: request, late: () => (late.hidden = false), answered: () => (late.hidden = true) });
const listener = stops(press);
for (const event of ["pointerdown", "click"]) button.addEventListener(event, listener);
listenToStop(press, ended.signal);
performance.mark("stop works");

/** Makes room for the STOP of the loaded page; a stop that is not answered is still repeated. */
export function endEarlyStop() {
  ended.abort();
  foot.replaceChildren();
}
