// Keep-out zones, faint until the arm is near, and the limits that the tool is near to.

import {
  BoxGeometry, CylinderGeometry, DoubleSide, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, PlaneGeometry, RingGeometry, SRGBColorSpace, ShaderMaterial,
} from "../vendor/three/three.js";
import { forward, links, rad } from "./kinematics.js";
import { rgb } from "./paper.js";

/** @typedef {import("./colors.js").Look} Look */
/** @typedef {import("./view.js").View} View */
/** @typedef {import("./view.js").Joints} Joints */
/** @typedef {View["near"]["limits"][number]} Near */
/** @typedef {import("./view.js").ArmShape} ArmShape */
/** @typedef {import("../vendor/three/three.js").Object3D} Object3D */

const SHEET_MM = 130;

/** The keep-out zones: no part of the arm may enter them. */
export function createKeepOuts() {
  const group = new Group();
  /** @type {{ name: string, face: MeshBasicMaterial, edge: LineBasicMaterial }[]} */ let made = [];
  let color = 0;
  return {
    group,
    /** @param {View["keepOuts"]} keepOuts */
    show(keepOuts) {
      clear(group);
      made = Object.entries(keepOuts).map(([name, keepOut]) => {
        const face = new MeshBasicMaterial({ color, transparent: true, depthWrite: false, side: DoubleSide });
        const edge = new LineBasicMaterial({ color, transparent: true });
        const geometry = form(keepOut);
        group.add(new Mesh(geometry, face), new LineSegments(new EdgesGeometry(geometry, 30), edge));
        return { name, face, edge };
      });
    },
    /** Highlights the zones near the arm or the ghost. @param {View["near"]["keep_outs"]} near */
    warn(near) {
      for (const { name, face, edge } of made) {
        const closeness = near[name] ?? 0;
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

/** @param {View["keepOuts"][string]} keepOut */
function form(keepOut) {
  if ("box" in keepOut) {
    const { x_mm: [x0, x1], y_mm: [y0, y1], z_mm: [z0, z1] } = keepOut.box;
    return new BoxGeometry(x1 - x0, y1 - y0, z1 - z0).translate((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2);
  }
  const { x_mm, y_mm, radius_mm, z_mm: [z0, z1] } = keepOut.cylinder;
  return new CylinderGeometry(radius_mm, radius_mm, z1 - z0, 48).rotateX(Math.PI / 2).translate(x_mm, y_mm, (z0 + z1) / 2);
}

/** The limits: a sheet at the tool for positions, a sector at the joint for angles. */
export function createLimits() {
  const group = new Group();
  const color = { value: /** @type {[number, number, number]} */ ([0, 0, 0]) };
  /** @type {Map<string, { group: Object3D, place(near: Near, joints: Joints, shape: ArmShape): void }>} */ const made = new Map();

  /** @param {Near} near */
  function signOf({ quantity, bound }) {
    const name = `${quantity} ${bound}`;
    const known = made.get(name);
    if (known) return known;
    const sign = quantity in JOINTS ? createSector(color) : createSheet(color);
    group.add(sign.group);
    made.set(name, sign);
    return sign;
  }

  return {
    group,
    /** @param {Joints | null} joints @param {ArmShape} shape @param {readonly Near[]} limits the limits nearby */
    warn(joints, shape, limits) {
      for (const { group: sign } of made.values()) sign.visible = false;
      if (!joints) return;
      for (const near of limits) {
        const sign = signOf(near);
        sign.group.visible = true;
        sign.place(near, joints, shape);
      }
    },
    /** @param {Look} look */
    paint(look) {
      color.value = rgb(look.near);
    },
  };
}

/** Radius of a joint's sector, in mm. */
const JOINTS = { base: 96, rear: 78, fore: 78, opening: 78, servo: 44 };

/** A dotted sheet around the tool, in the plane that it must not cross. @param {{ value: number[] }} color */
function createSheet(color) {
  const strength = { value: 0 };
  const sheet = new Mesh(new PlaneGeometry(2 * SHEET_MM, 2 * SHEET_MM), new ShaderMaterial({
    transparent: true, depthWrite: false, side: DoubleSide, uniforms: { color, strength, wide: { value: SHEET_MM } },
    vertexShader: "varying vec2 at; void main() { at = position.xy; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
    fragmentShader: `uniform vec3 color; uniform float strength; uniform float wide; varying vec2 at;
      void main() {
        float spot = 1.0 - smoothstep(0.13, 0.21, length(fract(at / 8.0) - 0.5));
        float fade = pow(max(0.0, 1.0 - length(at) / wide), 1.4);
        gl_FragColor = vec4(color, fade * (0.22 + 0.78 * spot) * (0.5 + 0.5 * strength));
      }`,
  }));
  sheet.renderOrder = 5;
  return {
    group: sheet,
    /** @param {Near} near @param {Joints} joints @param {ArmShape} shape */
    place({ quantity, bound, closeness }, joints, shape) {
      const { x_mm, y_mm, z_mm } = forward(joints, shape), direction = Math.atan2(y_mm, x_mm);
      strength.value = closeness;
      sheet.position.set(quantity === "x" ? bound : x_mm, quantity === "y" ? bound : y_mm, quantity === "z" ? bound : z_mm);
      if (quantity === "reach") sheet.position.set(bound * Math.cos(direction), bound * Math.sin(direction), z_mm);
      // The plane's normal is Z: turn it outward, or to the left.
      if (quantity !== "z") sheet.rotation.set(Math.PI / 2, quantity === "y" ? 0 : Math.PI / 2 + (quantity === "reach" ? direction : 0), 0);
    },
  };
}

/** A sector at a joint, in the direction of its limit. @param {{ value: [number, number, number] }} color */
function createSector(color) {
  const material = new MeshBasicMaterial({ transparent: true, side: DoubleSide, depthTest: false });
  const ring = new Mesh(new RingGeometry(0.5, 1, 24, 1, rad(-11), rad(22)), material);
  ring.renderOrder = 6;
  const group = new Group().add(ring);
  return {
    group,
    /** @param {Near} near @param {Joints} joints @param {ArmShape} shape */
    place({ quantity, bound, closeness }, joints, shape) {
      const joint = /** @type {keyof typeof JOINTS} */ (quantity);
      const { elbow, tool } = links(joints, shape), level = joint === "base" || joint === "servo";
      // Counter-clockwise from ahead, as seen from above or from the right.
      const angle = { base: bound, servo: bound, rear: 90 - bound, fore: -bound, opening: bound - joints.rear_deg }[joint];
      const [r, z] = { base: [0, -56], servo: [tool[0], tool[1] - 10], rear: [0, 0], fore: elbow, opening: elbow }[joint];
      material.color.setRGB(...color.value, SRGBColorSpace);
      material.opacity = 0.35 + 0.5 * closeness;
      group.rotation.z = joint === "base" ? 0 : rad(joints.base_deg);
      ring.position.set(r ?? 0, 0, z ?? 0);
      ring.rotation.set(level ? 0 : Math.PI / 2, 0, rad(angle));
      ring.scale.setScalar(JOINTS[joint]);
    },
  };
}

/** @param {Group} group */
function clear(group) {
  group.traverse((/** @type {any} */ object) => {
    object.geometry?.dispose();
    object.material?.dispose();
  });
  group.clear();
}
