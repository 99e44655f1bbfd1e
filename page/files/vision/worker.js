// Looks at pictures beside the page: STOP and the arm never wait for it.

import { createLook } from "./look.js";

/** @type {ReturnType<typeof createLook> | null} */ let eye = null;

/** @typedef {{ sheet: import("./geometry.js").SheetMarkers } | { forget: true } | { picture: import("./picture.js").Picture, hue_deg: number | null }} ToWorker */

onmessage = ({ data }) => {
  const message = /** @type {ToWorker} */ (data);
  if ("sheet" in message) eye = createLook(message.sheet);
  else if ("forget" in message) eye?.forget();
  else if (eye) postMessage(eye.look(message.picture, message.hue_deg));
};
