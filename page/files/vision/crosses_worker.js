// Looks for crosses in a photo beside the page.

import { crossesIn } from "./crosses.js";

/** @typedef {{ picture: import("./picture.js").Picture, sheet: import("./geometry.js").SheetMarkers, wanted: readonly import("./geometry.js").Pair[] }} ToWorker */

onmessage = ({ data }) => {
  const { picture, sheet, wanted } = /** @type {ToWorker} */ (data);
  postMessage(crossesIn(picture, sheet, wanted));
};
