// The tools below the wrist, built downwards from the servo with their axis along Z, in mm below the wrist's height.

import { CylinderGeometry, Group, Mesh, MeshBasicMaterial } from "../vendor/three/three.js";
import { block, box, pin, solid, turned } from "./solid.js";

/** @typedef {import("../vendor/three/three.js").Material} Material */
/** @typedef {import("./view.js").Tool} Tool */
/** @typedef {{ metal: Material, dark: Material, accent: Material, pin: Material, rubber: Material }} Materials */

/** Lower end of the servo's horn. */
const HORN_MM = 13;
/** Opening of the gripper, as for a virtual arm without a scene. */
const FINGERS_MM = 30;

/**
 * @param {Tool} kind
 * @param {number} length_mm from the wrist's height to the tip
 * @param {Materials} materials
 */
export function createTool(kind, length_mm, materials) {
  const group = new Group();
  // A tool that is shorter than its own parts is drawn smaller.
  const scale = Math.min(1, Math.max(length_mm, 4) / 34);
  const long = length_mm / scale;
  const horn = solid([[materials.pin, [turned([[0, -HORN_MM], [9, -HORN_MM], [10, -HORN_MM + 1], [10, -8], [0, -8]])]]]);
  const made = TOOLS[kind](long, materials);
  group.add(horn, made.group);
  group.scale.setScalar(scale);
  return { group, open: made.open };
}

/** @type {Record<Tool, (long: number, materials: Materials) => { group: Group, open?: (gripper_deg: number) => void }>} */
const TOOLS = {
  suction_cup(long, { metal, rubber, dark }) {
    const cup = turned([
      [8.5, -long], [10, -long + 1], [6.6, -long + 4], [9, -long + 6.5], [5.8, -long + 9], [7.6, -long + 11], [4.6, -long + 13], [0, -long + 13],
    ]);
    const shaft = turned([[0, -long + 12], [4, -long + 12], [4, -HORN_MM], [0, -HORN_MM]]);
    const hose = pin(2.2, 2, 15, [0, -HORN_MM - 5]);
    return { group: solid([[rubber, [cup]], [metal, [shaft]], [dark, [hose]]]) };
  },
  gripper(long, { metal, dark }) {
    const group = solid([[dark, [block([20, 40, 12], [0, 0, -HORN_MM - 6], 3)]]]);
    const top = -HORN_MM - 11, tall = long + top;
    const fingers = [1, -1].map((side) => {
      const finger = solid([[metal, [
        block([10, 5, tall], [0, side * 2.5, top - tall / 2], 1.5),
        block([12, 3, Math.min(12, tall)], [0, side * 1.5, -long + Math.min(12, tall) / 2], 1.2),
      ]]]);
      group.add(finger);
      return { finger, side };
    });
    return {
      group,
      /** At 0 degrees they are apart, at 90 they touch. */
      open(gripper_deg) {
        const apart = FINGERS_MM * (1 - Math.min(Math.max(gripper_deg, 0), 90) / 90);
        for (const { finger, side } of fingers) finger.position.y = (side * apart) / 2;
      },
    };
  },
  laser(long, { metal, dark, accent }) {
    /** @type {[number, number][]} */ const fins = [];
    const from = -long + 8, to = -HORN_MM;
    const count = Math.max(2, Math.floor((to - from) / 4));
    for (let n = 0; n < count; n += 1) {
      const z = from + ((to - from) * n) / count, half = (to - from) / count / 2;
      fins.push([11, z], [11, z + half], [9, z + half], [9, z + 2 * half]);
    }
    const body = turned([[0, from], ...fins, [0, to]]);
    const nozzle = turned([[0, -long], [2.4, -long], [3.2, -long + 1], [6, -long + 8], [0, -long + 8]]);
    const ring = turned([[6.2, from - 0.2], [8.4, from - 0.2], [8.4, from + 0.8], [6.2, from + 0.8]]);
    return { group: solid([[dark, [body]], [metal, [nozzle]], [accent, [ring]]]) };
  },
  pen(long, { metal, dark, accent }) {
    const barrel = turned([[4.4, -long + 11], [4.8, -long + 13], [4.8, -HORN_MM - 1], [0, -HORN_MM - 1]]);
    const grip = turned([[1.4, -long + 3], [4.4, -long + 11], [0, -long + 11]]);
    const nib = turned([[0, -long], [0.4, -long + 0.2], [1.4, -long + 3], [0, -long + 3]]);
    const clamp = box([15, 15, 6], [0, 0, -HORN_MM - 4]);
    return { group: solid([[accent, [barrel]], [metal, [grip, clamp]], [dark, [nib]]]) };
  },
};

/**
 * The light of a laser that burns, from its tip down to the table.
 * @param {number} color
 */
export function createBeam(color) {
  const material = new MeshBasicMaterial({ color, transparent: true, opacity: 0.8, depthWrite: false });
  const group = new Group();
  const ray = new Mesh(new CylinderGeometry(0.9, 0.9, 1, 10, 1, true).rotateX(Math.PI / 2).translate(0, 0, -0.5), material);
  const spot = new Mesh(turned([[0, 0.3], [5, 0.3]]), material);
  group.add(ray, spot);
  return {
    group,
    /** @param {number} long_mm */
    reach(long_mm) {
      ray.scale.z = Math.max(long_mm, 0.1);
      spot.position.z = -long_mm;
    },
    /** @param {number} value */
    paint: (value) => material.color.set(value),
  };
}
