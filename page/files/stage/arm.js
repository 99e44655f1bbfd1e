// The 3D arm: foot, turret, rear arm, forearm, crank, three rods, the level wrist, and the tool.
// The Y of its plates shows which parts lie side by side.

import { CatmullRomCurve3, Group, TubeGeometry, Vector3 } from "../vendor/three/three.js";
import { links, rad } from "./kinematics.js";
import { block, lay, pin, plate, solid, turned } from "./solid.js";
import { createTool } from "./tools.js";

/** @typedef {import("./view.js").Joints} Joints */
/** @typedef {import("./view.js").ArmShape} ArmShape */
/** @typedef {import("./view.js").View} View */
/** @typedef {import("./tools.js").Materials} Materials */

const CHEEK_Y = 32;
const ROD_Y = 25.5;
const FRONT_ROD_Y = 9.5;

/**
 * An arm without parts: `mount` builds it.
 * @param {Materials} materials
 * @param {{ foot: boolean }} with_
 */
export function createArm(materials, { foot }) {
  const group = new Group();
  /** @type {ReturnType<typeof build> | null} */ let built = null;
  return {
    group,
    /** Builds it with these lengths and this tool, in the place of what it was. @param {ArmShape} shape @param {View["tool"]} tool */
    mount(shape, tool) {
      for (const old of [...group.children]) drop(old);
      built = build(shape, tool, materials);
      group.add(built.turning);
      if (foot) group.add(standing(shape, materials));
    },
    /** @param {Joints & { gripper_deg?: number }} joints */
    pose: (joints) => built?.pose(joints),
  };
}

/**
 * Builds the rotating parts.
 * @param {ArmShape} shape
 * @param {View["tool"]} tool
 * @param {Materials} materials
 */
function build(shape, { kind, length_mm }, materials) {
  const { rear_arm_mm, forearm_mm, reach_mm } = shape;
  const turning = new Group(), wrist = new Group(), servo = new Group(), tool = createTool(kind, length_mm, materials);
  const moving = { rear: rearArm(shape, materials), fore: forearm(shape, materials), crank: crank(shape, materials), crankRod: rod(rear_arm_mm, -ROD_Y, materials), rearRod: rod(rear_arm_mm, ROD_Y, materials), frontRod: rod(forearm_mm, FRONT_ROD_Y, materials), elbow: elbow(shape, materials) };
  turning.add(turret(shape, materials), ...Object.values(moving), wrist);
  wrist.add(servo, wristHead(shape, materials));
  servo.position.x = reach_mm;
  servo.add(tool.group);
  return {
    turning,
    /** @param {Joints & { gripper_deg?: number }} joints */
    pose(joints) {
      const at = links(joints, shape);
      turning.rotation.z = rad(joints.base_deg);
      lay(moving.rear, [0, 0], at.elbow);
      lay(moving.fore, at.elbow, at.wrist);
      lay(moving.crank, [0, 0], at.crank);
      lay(moving.crankRod, at.crank, at.tail);
      lay(moving.rearRod, ...at.rearRod);
      lay(moving.frontRod, ...at.frontRod);
      moving.elbow.position.set(at.elbow[0], 0, at.elbow[1]);
      wrist.position.set(at.wrist[0], 0, at.wrist[1]);
      servo.rotation.z = rad(joints.servo_deg);
      tool.open?.(joints.gripper_deg ?? 0);
    },
  };
}

/** @param {import("../vendor/three/three.js").Object3D} group */
function drop(group) {
  group.removeFromParent();
  group.traverse((object) => {
    if ("geometry" in object) /** @type {{ dispose(): void }} */ (object.geometry).dispose();
  });
}

/** @param {ArmShape} shape @param {Materials} materials */
function standing({ pivot_above_table_mm: foot_mm }, { metal, dark, accent }) {
  const cable = new CatmullRomCurve3([[-66, 0, -90], [-92, 2, -94], [-128, 22, -99.5], [-180, 30, -99.5], [-240, 4, -99.5], [-296, 0, -99.5], [-305, 0, -104], [-308, 0, -150]].map((point) => new Vector3(...point)));
  return solid([
    [dark, [block([146, 146, 36], [0, 0, -foot_mm + 20], 20), new TubeGeometry(cable, 40, 3.2, 8), block([10, 26, 14], [-73, 0, -90], 3)]],
    [metal, [block([132, 132, 4], [0, 0, -foot_mm + 40], 18)]],
    [accent, [turned([[50, -61], [62, -61], [62, -58.5], [50, -58.5]])]],
    [dark, [[-1, -1], [-1, 1], [1, -1], [1, 1]].map(([x = 0, y = 0]) => turned([[0, -foot_mm], [8, -foot_mm], [9, -foot_mm + 2.2], [0, -foot_mm + 2.2]]).translate(x * 52, y * 52, 0))],
  ]);
}

/** @param {ArmShape} shape @param {Materials} materials */
function turret({ rear_rod_at_mm: [rodX = 0, rodZ = 0] }, { metal, dark, pin: bright }) {
  /** @type {[number, number, number][]} */
  const outline = [[-34, -46, 7], [34, -46, 7], [0, 0, 23], [rodX, rodZ, 9]];
  const cheek = (/** @type {number} */ side) => plate(outline, side * CHEEK_Y, 6, [[0, -30, 9], [-17, -33, 4.5], [17, -33, 4.5]]);
  const motor = (/** @type {number} */ side) => block([42, 30, 42], [0, side * 58, 0], 5);
  return solid([
    [metal, [turned([[0, -58.5], [58, -58.5], [60, -57.5], [60, -51.5], [58.5, -50.5], [0, -50.5]]), cheek(1), cheek(-1), pin(18, 35, 43), pin(18, -43, -35)]],
    [dark, [motor(1), motor(-1), block([34, 52, 9], [-18, 0, -46], 4)]],
    [bright, [pin(7, -76, 76), pin(4.5, ROD_Y - 4, CHEEK_Y + 6, [rodX, rodZ])]],
  ]);
}

/** @param {ArmShape} shape @param {Materials} materials */
function rearArm({ rear_arm_mm: long_mm }, { metal, pin: bright, accent }) {
  const bored = /** @type {const} */ ([[38, 0, 8], [64, 0, 7], [88, 0, 6], [109, 0, 4.6]]);
  const side = (/** @type {number} */ y) => plate([[0, 0, 20], [long_mm, 0, 15]], y, 6, bored);
  const cap = (/** @type {number} */ from) => pin(11, from, from + 1.6);
  return solid([
    [metal, [side(15), side(-15)]],
    [bright, [pin(8, -30, 30), pin(4, -12, 12, [24, 11]), pin(4, -12, 12, [52, -10]), pin(3.4, -12, 12, [76, 9])]],
    [accent, [cap(18).translate(long_mm, 0, 0), cap(-19.6).translate(long_mm, 0, 0)]],
  ]);
}

/** @param {ArmShape} shape @param {Materials} materials */
function forearm({ forearm_mm, crank_mm }, { metal, pin: bright }) {
  const bored = /** @type {const} */ ([[34, 0, 7], [58, 0, 6.2], [80, 0, 5.4], [100, 0, 4.6], [118, 0, 3.8]]);
  const body = plate([[-crank_mm, 0, 8], [0, 0, 15], [forearm_mm, 0, 9], [0, 0, 15]], 0, 14, bored);
  return solid([
    [metal, [body]],
    [bright, [pin(7, -21.5, 24), pin(4, -ROD_Y - 3.5, 10, [-crank_mm, 0]), pin(4.5, -21.5, 21.5, [forearm_mm, 0])]],
  ]);
}

/** @param {ArmShape} shape @param {Materials} materials */
function crank({ crank_mm }, { dark, pin: bright }) {
  return solid([[dark, [plate([[0, 0, 14], [crank_mm, 0, 8]], -21, 4)]], [bright, [pin(4, -ROD_Y - 3.5, -18, [crank_mm, 0])]]]);
}

/**
 * @param {number} long_mm
 * @param {number} y_mm
 * @param {Materials} materials
 */
function rod(long_mm, y_mm, { dark }) {
  const eye = (/** @type {number} */ x) => plate([[x, 0, 7], [x + (x ? -9 : 9), 0, 4.5]], y_mm, 4);
  return solid([[dark, [plate([[0, 0, 3.4], [long_mm, 0, 3.4]], y_mm, 3.6), eye(0), eye(long_mm)]]]);
}

/** The plate at the elbow that stays level: it hands the rear rod's hold to the front rod. @param {ArmShape} shape @param {Materials} materials */
function elbow({ rear_rod_at_mm: [rearX = 0, rearZ = 0], front_rod_at_mm: [frontX = 0, frontZ = 0] }, { accent, pin: bright }) {
  return solid([
    [accent, [plate([[0, 0, 11], [frontX, frontZ, 7], [rearX, rearZ, 7]], 21.3, 3.4)]],
    [bright, [pin(4, 19, ROD_Y + 3.5, [rearX, rearZ]), pin(4, FRONT_ROD_Y - 3.5, 24, [frontX, frontZ])]],
  ]);
}

/** @param {ArmShape} shape @param {Materials} materials */
function wristHead({ reach_mm: beyond_mm, front_rod_at_mm: [rodX = 0, rodZ = 0] }, { metal, dark, pin: bright }) {
  const side = (/** @type {number} */ y) => plate([[0, 0, 10], [30, -3, 5], [rodX, rodZ, 7]], y, 4);
  return solid([
    [metal, [side(17.5), side(-17.5), block([beyond_mm - 9, 31, 11], [(beyond_mm - 9) / 2 + 22, 0, -2.5], 5)]],
    [dark, [block([23, 13, 24], [beyond_mm, 0, 15], 2), block([31, 13, 2.5], [beyond_mm, 0, 12], 1.2)]],
    [bright, [pin(4, FRONT_ROD_Y - 4, 21, [rodX, rodZ])]],
  ]);
}
