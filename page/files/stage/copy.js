// Shows what the processor has drawn with WebGL, without making the page wait for it: a canvas in the page would be read while it
// is still being drawn. The frame is drawn elsewhere, and copied once it is finished.

/**
 * @param {WebGL2RenderingContext} gl
 * @param {HTMLCanvasElement} canvas the visible copy
 */
export function createCopy(gl, canvas) {
  const source = /** @type {HTMLCanvasElement} */ (gl.canvas);
  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d", { alpha: false }));
  /** @type {WebGLSync | null} */ let fence = null;
  return {
    /** Marks the end of a frame. */
    drawn() {
      fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
      gl.flush();
    },
    /** Forgets the last frame: it has another size than the next one, and is gone. */
    forget() {
      if (fence) gl.deleteSync(fence);
      fence = null;
    },
    /** Shows the last frame if it is finished; returns whether none is still being drawn. */
    isFinished() {
      if (!fence) return true;
      if (!gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) return false;
      gl.deleteSync(fence);
      fence = null;
      if (canvas.width !== source.width || canvas.height !== source.height) [canvas.width, canvas.height] = [source.width, source.height];
      pen.drawImage(source, 0, 0);
      return true;
    },
  };
}
