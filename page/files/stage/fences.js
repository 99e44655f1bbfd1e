// What the arm must not do: keep-outs, faint until something comes near, and the limits that the tool is near to.

import {
  BoxGeometry, CylinderGeometry, DoubleSide, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, PlaneGeometry, RingGeometry, ShaderMaterial, Vector3,
} from "../vendor/three/three.js";
import { forward, links, rad } from "./links.js";
import { nearKeepOut, nearLimits } from "./near.js";

/** @typedef {import("./look.js").Look} Look */
/** @typedef {import("./view.js").View} View */
/** @typedef {import("./view.js").Joints} Joints */
/** @typedef {import("./near.js").Near} Near */
/** @typedef {import("../vendor/three/three.js").Object3D} Object3D */

const SHEET_MM = 130;

/** The keep-outs: what no part of the arm may touch. */
export function createKeepOuts() {
  const group = new Group();
  /** @type {{ keepOut: View["keepOuts"][number], face: MeshBasicMaterial, edge: LineBasicMaterial }[]} */ let made = [];
  let color = 0;
  return {
    group,
    /** @param {View["keepOuts"]} keepOuts */
    show(keepOuts) {
      clear(group);
      made = keepOuts.map((keepOut) => {
        const face = new MeshBasicMaterial({ color, transparent: true, depthWrite: false, side: DoubleSide });
        const edge = new LineBasicMaterial({ color, transparent: true });
        const geometry = form(keepOut);
        group.add(new Mesh(geometry, face), new LineSegments(new EdgesGeometry(geometry, 30), edge));
        return { keepOut, face, edge };
      });
    },
    /** Brings out those that are near to one of these places. @param {readonly [number, number, number][]} places */
    warn(places) {
      for (const { keepOut, face, edge } of made) {
        const closeness = Math.max(0, ...places.map((at) => nearKeepOut(keepOut, at)));
        face.opacity = 0.09 + 0.26 * closeness;
        edge.opacity = 0.4 + 0.6 * closeness;
      }
    },
    /** @param {Look} look */
    paint(look) {
      color = look.keepOut;
      for (const { face, edge } of made) for (const it of [face, edge]) it.color.set(color);
    },
  };
}

/** @param {View["keepOuts"][number]} keepOut */
function form(keepOut) {
  if ("box" in keepOut) {
    const { x_mm: [x0, x1], y_mm: [y0, y1], z_mm: [z0, z1] } = keepOut.box;
    return new BoxGeometry(x1 - x0, y1 - y0, z1 - z0).translate((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2);
  }
  const { x_mm, y_mm, radius_mm, z_mm: [z0, z1] } = keepOut.cylinder;
  return new CylinderGeometry(radius_mm, radius_mm, z1 - z0, 48).rotateX(Math.PI / 2).translate(x_mm, y_mm, (z0 + z1) / 2);
}

/** The limits: a sheet at the tool for those of its place, a sector at the joint for those of an angle. */
export function createLimits() {
  const group = new Group();
  const color = { value: [0, 0, 0] };
  let shown = "";

  /** @param {Near} near @param {Joints} joints @param {View["tool"]["kind"]} kind */
  function sheet({ quantity, bound, closeness }, joints, kind) {
    const at = forward(joints, kind), direction = Math.atan2(at.y_mm, at.x_mm);
    const middle = new Vector3(at.x_mm, at.y_mm, at.z_mm);
    const flat = new PlaneGeometry(2 * SHEET_MM, 2 * SHEET_MM);
    if (quantity === "z") middle.z = bound;
    else if (quantity === "reach") flat.rotateY(Math.PI / 2).rotateZ(direction), middle.set(bound * Math.cos(direction), bound * Math.sin(direction), at.z_mm);
    else if (quantity === "x") flat.rotateY(Math.PI / 2), middle.setX(bound);
    else flat.rotateX(Math.PI / 2), middle.setY(bound);
    const mesh = new Mesh(flat.translate(...middle.toArray()), faded(color, middle, closeness));
    mesh.renderOrder = 5;
    return mesh;
  }

  /** @param {Near} near @param {Joints} joints @param {View["tool"]["kind"]} kind */
  function sector({ quantity, bound, closeness }, joints, kind) {
    const at = links(joints, kind);
    const material = new MeshBasicMaterial({ transparent: true, opacity: 0.3 + 0.5 * closeness, side: DoubleSide, depthTest: false });
    material.color.setRGB(...rgb(color.value));
    const level = quantity === "base" || quantity === "servo";
    // Angles of the ring, counter-clockwise from ahead, as seen from above or from the right.
    const angle = { base: bound, servo: joints.base_deg + bound, rear: 90 - bound, fore: -bound, opening: bound - joints.rear_deg }[/** @type {"base"} */ (quantity)];
    const upper = quantity === "base" ? 74 : quantity === "servo" ? 34 : 62;
    const ring = new Mesh(new RingGeometry(upper * 0.72, upper, 24, 1, rad(angle - 6), rad(12)), material);
    ring.renderOrder = 6;
    const turning = new Group();
    turning.rotation.z = level ? 0 : rad(joints.base_deg);
    const [r, z] = quantity === "base" ? [0, -54] : quantity === "servo" ? at.tool : quantity === "rear" ? [0, 0] : at.elbow;
    if (quantity === "servo") ring.position.set(r * Math.cos(rad(joints.base_deg)), r * Math.sin(rad(joints.base_deg)), z - 10);
    else ring.position.set(r, 0, z);
    if (!level) ring.rotation.x = Math.PI / 2;
    turning.add(ring);
    return turning;
  }

  return {
    group,
    /** @param {Joints | null} joints @param {View["tool"]["kind"]} kind @param {View["limits"]} limits */
    warn(joints, kind, limits) {
      const near = joints ? nearLimits(joints, kind, limits) : [];
      const now = JSON.stringify([near.length > 0 && joints, near]);
      if (now === shown) return;
      shown = now;
      clear(group);
      if (!joints) return;
      const places = ["x", "y", "z", "reach"];
      for (const one of near) group.add(places.includes(one.quantity) ? sheet(one, joints, kind) : sector(one, joints, kind));
    },
    /** @param {Look} look */
    paint(look) {
      color.value = [(look.near >> 16) & 255, (look.near >> 8) & 255, look.near & 255].map((it) => it / 255);
      shown = "";
    },
  };
}

/** @param {number[]} color @returns {[number, number, number]} */
const rgb = ([r = 0, g = 0, b = 0]) => [r, g, b];

/**
 * A sheet of dots that is seen around a place only.
 * @param {{ value: number[] }} color
 * @param {Vector3} middle
 * @param {number} closeness
 */
function faded(color, middle, closeness) {
  return new ShaderMaterial({
    transparent: true, depthWrite: false, side: DoubleSide,
    uniforms: { color, middle: { value: middle }, strength: { value: closeness }, wide: { value: SHEET_MM } },
    vertexShader: `varying vec3 at; varying vec2 on;
      void main() { at = position; on = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
    fragmentShader: `uniform vec3 color; uniform vec3 middle; uniform float strength; uniform float wide; varying vec3 at; varying vec2 on;
      void main() {
        float far = length(at - middle) / wide;
        vec2 cell = fract(on * wide / 5.0) - 0.5;
        float dot_ = 1.0 - smoothstep(0.12, 0.2, length(cell));
        float fade = pow(max(0.0, 1.0 - far), 1.6);
        gl_FragColor = vec4(color, fade * (0.18 + 0.62 * dot_) * (0.25 + 0.75 * strength));
      }`,
  });
}

/** @param {Group} group */
function clear(group) {
  group.traverse((/** @type {any} */ it) => {
    it.geometry?.dispose();
    it.material?.dispose();
  });
  group.clear();
}
