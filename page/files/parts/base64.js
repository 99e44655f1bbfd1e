// File content as Base64.

/** Returns the content of a file in Base64. @param {File} file @returns {Promise<string | null>} nothing where it cannot be read */
export function base64(file) {
  const reader = new FileReader();
  return new Promise((done) => {
    reader.onload = () => done(String(reader.result).split(",")[1] ?? "");
    reader.onerror = () => done(null);
    reader.readAsDataURL(file);
  });
}
