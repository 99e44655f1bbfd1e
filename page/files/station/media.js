// Camera and microphone of the browser.

/** Why a browser gives no camera or microphone: the end of a text key, or its own words. @param {unknown} error */
export function refusalOf(error) {
  const { name, message } = /** @type {DOMException} */ (error);
  return name === "NotAllowedError" ? "not_allowed" : name === "NotFoundError" ? "none" : message;
}

/** Whether the browser gives any: only to this machine or over an encrypted connection. */
export const isSecure = () => navigator.mediaDevices !== undefined;

/** @param {MediaStream | null} stream */
export const stopTracks = (stream) => stream?.getTracks().forEach((track) => track.stop());
