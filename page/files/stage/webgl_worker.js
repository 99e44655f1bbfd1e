// Finds out what draws three dimensions here: a graphics card, the processor, or nothing.

/** @typedef {"card" | "processor" | "nothing"} Renderer */

/** @returns {Renderer} */
function renderer() {
  const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
  if (!gl) return "nothing";
  const named = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name) ? "processor" : "card";
}

postMessage(renderer());
