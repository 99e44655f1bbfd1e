// The lines of ink or burn. Each is drawn once, when it is new, to a picture that lies on the table: a drawing of many
// thousand lines costs no more than an empty paper.

import {
  BufferAttribute, BufferGeometry, CustomBlending, DoubleSide, InstancedBufferAttribute, InstancedBufferGeometry, LinearFilter, LinearMipmapLinearFilter, MaxEquation, Mesh, OneFactor, OrthographicCamera, PlaneGeometry, RedFormat, Scene, ShaderMaterial, WebGLRenderTarget,
} from "../vendor/three/three.js";
import { rgb } from "./paper.js";
import { areaOf, fineness } from "./marks_area.js";

/** @typedef {import("./colors.js").Look} Look */
/** @typedef {import("./view.js").View} View */
/** @typedef {import("./view.js").Marks} Marks */
/** @typedef {import("./marks_area.js").Area} Area */

/** Lines per draw call, and the least line width in pixels. */
const AT_ONCE = 8192;
const THIN_PX = 1.6;

/** @param {import("../vendor/three/three.js").WebGLRenderer} renderer */
export function createMarks(renderer) {
  const line = new ShaderMaterial({
    blending: CustomBlending, blendEquation: MaxEquation, blendSrc: OneFactor, blendDst: OneFactor,
    depthTest: false, depthWrite: false, side: DoubleSide, toneMapped: false,
    uniforms: { width: { value: 1 }, pixel: { value: 0.1 } }, vertexShader: LINE_VERTEX, fragmentShader: LINE_FRAGMENT,
  });
  const color = { value: [0, 0, 0] }, drawnOn = { value: /** @type {unknown} */ (null) };
  const shown = new ShaderMaterial({
    transparent: true, depthWrite: false, polygonOffset: true, polygonOffsetFactor: -3, polygonOffsetUnits: -6,
    uniforms: { color, drawn: drawnOn }, vertexShader: SHEET_VERTEX, fragmentShader: SHEET_FRAGMENT,
  });
  const sheet = new Mesh(new PlaneGeometry(1, 1), shown);
  sheet.renderOrder = 1;
  sheet.visible = false;
  const above = new OrthographicCamera(-1, 1, 1, -1, -1, 1);
  /** @type {Marks | null} */ let marks = null;
  /** @type {View["paper"]} */ let paper = null;
  /** @type {Area | null} */ let area = null;
  /** @type {WebGLRenderTarget | null} */ let picture = null;
  let count = 0;

  /** An empty picture of the area. @param {Area} wanted */
  function begin(wanted) {
    area = wanted;
    picture?.dispose();
    const [x0, y0] = area.from_mm, [x1, y1] = area.to_mm, fine = fineness(area);
    picture = new WebGLRenderTarget(Math.ceil((x1 - x0) * fine), Math.ceil((y1 - y0) * fine), {
      format: RedFormat, depthBuffer: false, generateMipmaps: true, minFilter: LinearMipmapLinearFilter, magFilter: LinearFilter,
      anisotropy: renderer.capabilities.getMaxAnisotropy(),
    });
    drawnOn.value = picture.texture;
    Object.assign(above, { left: x0, right: x1, bottom: y0, top: y1 }).updateProjectionMatrix();
    sheet.position.set((x0 + x1) / 2, (y0 + y1) / 2, 0.4);
    sheet.scale.set(x1 - x0, y1 - y0, 1);
    /** @type {{ value: unknown }} */ (line.uniforms.pixel).value = 1 / fine;
    paint([], 0, 0, true);
    count = 0;
  }

  /** @param {Marks | null} next @param {View["paper"]} nextPaper */
  function show(next, nextPaper) {
    const fresh = next !== marks || nextPaper !== paper;
    marks = next;
    paper = nextPaper;
    sheet.visible = (marks?.shades.length ?? 0) > 0;
    if (!marks || !sheet.visible) return void (count = fresh ? 0 : count);
    const wanted = areaOf(fresh ? paper : area, marks.ends_mm, fresh ? 0 : count * 4);
    if (wanted && (fresh || wanted !== area)) begin(wanted);
    /** @type {{ value: unknown }} */ (line.uniforms.width).value = marks.width_mm;
    while (count < marks.shades.length) {
      const to = Math.min(count + AT_ONCE, marks.shades.length);
      paint(marks.ends_mm.slice(count * 4, to * 4), count, to, false);
      count = to;
    }
  }

  /** @param {number[]} ends @param {number} from @param {number} to @param {boolean} clear */
  function paint(ends, from, to, clear) {
    const scene = new Scene();
    /** @type {BufferGeometry | null} */ let geometry = null;
    if (to > from) scene.add(new Mesh((geometry = lines(ends, marks?.shades.slice(from, to) ?? [])), line)).children.forEach((mesh) => void (mesh.frustumCulled = false));
    const kept = renderer.autoClear;
    renderer.autoClear = false;
    renderer.setRenderTarget(picture);
    if (clear) renderer.setClearColor(0, 0), renderer.clear();
    renderer.render(scene, above);
    renderer.setRenderTarget(null);
    renderer.autoClear = kept;
    geometry?.dispose();
  }

  return {
    group: sheet,
    show,
    /** @param {Look} look @param {boolean} burnt */
    paint(look, burnt) {
      color.value = rgb(burnt ? look.burn : look.ink);
    },
    end: () => picture?.dispose(),
  };
}

/** A square for each line, which the card lays along it. @param {number[]} ends @param {number[]} shades */
function lines(ends, shades) {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  geometry.setAttribute("ends", new InstancedBufferAttribute(new Float32Array(ends), 4));
  geometry.setAttribute("shade", new InstancedBufferAttribute(new Float32Array(shades), 1));
  geometry.instanceCount = shades.length;
  return geometry;
}

const LINE_VERTEX = `
uniform float width;
uniform float pixel;
attribute vec4 ends;
attribute float shade;
varying vec2 at;
varying float far;
varying float dark;
void main() {
  vec2 way = ends.zw - ends.xy;
  far = length(way);
  vec2 along = far > 0.0 ? way / far : vec2(1.0, 0.0);
  float room = max(width, ${THIN_PX.toFixed(1)} * pixel) * 0.5 + pixel;
  at = vec2(position.x * far + (position.x * 2.0 - 1.0) * room, position.y * room);
  dark = shade;
  vec2 place = ends.xy + along * at.x + vec2(-along.y, along.x) * at.y;
  gl_Position = projectionMatrix * viewMatrix * vec4(place, 0.0, 1.0);
}`;

// Distance from the line, with round ends.
const LINE_FRAGMENT = `
uniform float width;
uniform float pixel;
varying vec2 at;
varying float far;
varying float dark;
void main() {
  float off = length(vec2(at.x - clamp(at.x, 0.0, far), at.y));
  float half_mm = max(width, ${THIN_PX.toFixed(1)} * pixel) * 0.5;
  float covered = clamp((half_mm - off) / pixel + 0.5, 0.0, 1.0);
  gl_FragColor = vec4(covered * dark, 0.0, 0.0, 1.0);
}`;

const SHEET_VERTEX = `
varying vec2 at;
void main() {
  at = uv;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const SHEET_FRAGMENT = `
uniform vec3 color;
uniform sampler2D drawn;
varying vec2 at;
void main() {
  gl_FragColor = vec4(color, pow(texture2D(drawn, at).r, 0.7));
}`;
