// The target: a ghost of the arm, and the handles to drag it.

import {
  BufferGeometry, ConeGeometry, DoubleSide, Group, Line, LineBasicMaterial, Mesh, MeshBasicMaterial, MeshLambertMaterial, Plane, Raycaster, RingGeometry, SphereGeometry, TorusGeometry, Vector2, Vector3,
} from "../vendor/three/three.js";
import { createArm } from "./arm.js";
import { deg, inverse, rad } from "./kinematics.js";

/** @typedef {import("./colors.js").Look} Look */
/** @typedef {import("./view.js").View} View */
/** @typedef {import("./view.js").Pose} Pose */
/** @typedef {import("./view.js").ArmShape} ArmShape */
/** @typedef {import("../vendor/three/three.js").PerspectiveCamera} PerspectiveCamera */
/** @typedef {"level" | "height" | "turn"} Handle The coordinates that it changes: x and y, z, or the rotation. */

const RING_MM = 30;
/** The handles have this share of the picture's height, at most and at least their own size. */
const SHARE = 0.055;
/** From a lower view, positions on a horizontal plane cannot be distinguished: the tip is dragged across the picture instead. */
const LOW = 0.2;

export function createTarget() {
  const group = new Group();
  const ghost = createGhost();
  const handles = createHandles();
  const drop = new Line(new BufferGeometry().setFromPoints([new Vector3(), new Vector3(0, 0, -1)]), new LineBasicMaterial({ transparent: true, opacity: 0.6 }));
  group.add(ghost.group, handles.group, drop);
  const ray = new Raycaster();
  /** @type {Pose | null} */ let at = null;
  let length_mm = 40;
  /** @type {{ handle: Handle, plane: Plane, from: Pose, start: Vector3 } | null} */ let held = null;

  /** @param {PerspectiveCamera} camera @param {Vector2} pointer */
  function aim(camera, pointer) {
    ray.setFromCamera(pointer, camera);
  }

  /** Keeps the handles as large as a finger needs. @param {PerspectiveCamera} camera */
  function size(camera) {
    if (!at) return;
    const far = camera.position.distanceTo(new Vector3(at.x_mm, at.y_mm, at.z_mm));
    const tall = 2 * far * Math.tan(rad(camera.fov / 2));
    handles.scale(Math.min(2.2, Math.max(0.55, (tall * SHARE) / RING_MM)));
  }

  /** @param {View} view @param {Pose | null} own where the arm is, whose tool can be taken where there is no ghost */
  function show(view, own) {
    at = view.ghost ?? own;
    length_mm = view.tool.length_mm;
    ghost.show(view.ghost, view.shape);
    handles.group.visible = view.draggable && at !== null;
    drop.visible = view.ghost !== null;
    if (!at) return;
    handles.place(at, length_mm);
    drop.position.set(at.x_mm, at.y_mm, at.z_mm - length_mm);
    drop.scale.z = Math.max(0.1, at.z_mm - length_mm - view.table_z_mm);
  }

  return {
    group,
    show,
    /** @param {ArmShape} shape @param {View["tool"]} tool */
    mount: (shape, tool) => ghost.mount(shape, tool),
    /** @param {Look} look @param {boolean} refused */
    paint(look, refused) {
      const color = refused ? look.refused : look.ghost;
      ghost.paint(color);
      handles.paint(color, look.paper);
      drop.material.color.set(color);
    },
    size,
    /** Returns the handle under the pointer. @param {PerspectiveCamera} camera @param {Vector2} pointer @returns {Handle | null} */
    under(camera, pointer) {
      if (!handles.group.visible) return null;
      // The last frame may be older than the place.
      size(camera);
      handles.group.updateMatrixWorld();
      aim(camera, pointer);
      return handles.hit(ray);
    },
    /** @param {Handle | null} handle */
    light: (handle) => handles.light(handle),
    /** Takes a handle. @param {Handle} handle @param {PerspectiveCamera} camera @param {Vector2} pointer */
    grab(handle, camera, pointer) {
      if (!at) return false;
      const tip = new Vector3(at.x_mm, at.y_mm, at.z_mm - length_mm);
      const seen = camera.getWorldDirection(new Vector3());
      const level = handle !== "height" && (handle === "turn" || Math.abs(seen.z) > LOW);
      const normal = level ? new Vector3(0, 0, 1) : new Vector3(seen.x, seen.y, 0.001).normalize();
      const plane = new Plane().setFromNormalAndCoplanarPoint(normal, tip);
      aim(camera, pointer);
      const start = ray.ray.intersectPlane(plane, new Vector3());
      if (!start) return false;
      held = { handle, plane, from: { ...at }, start };
      return true;
    },
    /** Returns the target for a pointer position. @param {PerspectiveCamera} camera @param {Vector2} pointer @returns {Pose | null} */
    drag(camera, pointer) {
      if (!held) return null;
      aim(camera, pointer);
      const to = ray.ray.intersectPlane(held.plane, new Vector3());
      return to && dragged(held.handle, held.from, held.start, to, held.plane.normal.z === 1);
    },
    release() {
      held = null;
    },
  };
}

/**
 * @param {Handle} handle
 * @param {Pose} from
 * @param {Vector3} start
 * @param {Vector3} to
 * @param {boolean} level whether it is dragged in a level plane
 * @returns {Pose}
 */
function dragged(handle, from, start, to, level) {
  /** @param {number} value */
  const round = (value) => Math.round(value * 10) / 10;
  if (handle === "height") return { ...from, z_mm: round(from.z_mm + to.z - start.z) };
  if (handle === "turn") {
    const angle = (/** @type {Vector3} */ point) => deg(Math.atan2(point.y - from.y_mm, point.x - from.x_mm));
    const turn = ((angle(to) - angle(start) + 540) % 360) - 180;
    return { ...from, rotation_deg: round(from.rotation_deg + turn) };
  }
  const far = Math.hypot(from.x_mm + to.x - start.x, from.y_mm + to.y - start.y);
  // Near the horizon a pixel is a metre: nothing is dragged farther than the table is wide.
  if (far > 450) return from;
  const moved = { ...from, x_mm: round(from.x_mm + to.x - start.x), y_mm: round(from.y_mm + to.y - start.y) };
  return level ? moved : { ...moved, z_mm: round(from.z_mm + to.z - start.z) };
}

/** An arm of glass: first its depth is drawn, then its colour, so that nothing of it shines through itself. */
function createGhost() {
  // The arm covers a ghost at the same place.
  const behind = { polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 8 };
  const depth = new MeshBasicMaterial({ colorWrite: false, ...behind });
  const glass = new MeshLambertMaterial({ transparent: true, opacity: 0.36, depthWrite: false, ...behind });
  const group = new Group();
  const arm = createArm({ metal: glass, dark: glass, accent: glass, pin: glass, rubber: glass }, { foot: false });
  group.add(arm.group);
  /** @param {Mesh} part @param {number} order */
  const settle = (part, order) => Object.assign(part, { renderOrder: order, castShadow: false, receiveShadow: false });
  return {
    group,
    /** @param {ArmShape} shape @param {View["tool"]} tool */
    mount(shape, tool) {
      arm.mount(shape, tool);
      /** @type {Mesh[]} */ const parts = [];
      arm.group.traverse((object) => object instanceof Mesh && parts.push(object));
      for (const part of parts) settle(part, 9).add(settle(new Mesh(part.geometry, depth), 8));
    },
    /** @param {Pose | null} pose @param {ArmShape | null} shape */
    show(pose, shape) {
      const joints = pose && shape && inverse(pose, shape);
      group.visible = joints !== null;
      if (joints) arm.pose(joints);
    },
    /** @param {number} color */
    paint(color) {
      glass.color.set(color);
      glass.emissive.set(color).multiplyScalar(0.25);
    },
  };
}

/** A ball at the tip for x and y, an arrow above for z, a ring for the rotation; each with more room to hit than to see. */
function createHandles() {
  const group = new Group(), tip = new Group(), top = new Group(), ring = new Group();
  const color = new MeshBasicMaterial({ transparent: true, depthTest: false });
  const rim = new MeshBasicMaterial({ transparent: true, depthTest: false, side: DoubleSide });
  const lit = new MeshBasicMaterial({ transparent: true, depthTest: false });
  const unseen = new MeshBasicMaterial({ visible: false, side: DoubleSide });
  /** @type {Record<Handle, { parts: Mesh[], room: Mesh }>} */
  const all = {
    level: { parts: [new Mesh(new SphereGeometry(6.5, 24, 16), color)], room: new Mesh(new SphereGeometry(15, 8, 6), unseen) },
    height: {
      parts: [new Mesh(new ConeGeometry(6, 13, 24).rotateX(Math.PI / 2).translate(0, 0, 8), color), new Mesh(new ConeGeometry(6, 13, 24).rotateX(-Math.PI / 2).translate(0, 0, -8), color)],
      room: new Mesh(new SphereGeometry(19, 8, 6), unseen),
    },
    turn: {
      parts: [new Mesh(new TorusGeometry(RING_MM, 1.1, 8, 72), color), new Mesh(new SphereGeometry(5, 20, 12).translate(RING_MM, 0, 0), color)],
      room: new Mesh(new RingGeometry(RING_MM - 7, RING_MM + 8, 32), unseen),
    },
  };
  const halo = new Mesh(new SphereGeometry(8.2, 24, 16), rim);
  tip.add(halo);
  for (const [parent, { parts, room }] of /** @type {[Group, { parts: Mesh[], room: Mesh }][]} */ ([[tip, all.level], [top, all.height], [ring, all.turn]])) parent.add(...parts, room);
  group.add(tip, top, ring);
  group.traverse((object) => void (object.renderOrder = 21));
  halo.renderOrder = 20;
  return {
    group,
    /** @param {Pose} at @param {number} length_mm */
    place(at, length_mm) {
      tip.position.set(at.x_mm, at.y_mm, at.z_mm - length_mm);
      ring.position.copy(tip.position);
      ring.rotation.z = rad(at.rotation_deg);
      top.position.set(at.x_mm, at.y_mm, at.z_mm + 58);
    },
    /** @param {number} times */
    scale: (times) => [tip, top, ring].forEach((part) => part.scale.setScalar(times)),
    /** Returns the handle hit by the ray; small ones have priority. @param {Raycaster} ray @returns {Handle | null} */
    hit(ray) {
      const found = /** @type {Handle[]} */ (["level", "height", "turn"]).find((handle) => ray.intersectObject(all[handle].room).length > 0);
      return found ?? null;
    },
    /** @param {Handle | null} handle */
    light(handle) {
      for (const [name, { parts }] of Object.entries(all)) for (const part of parts) part.material = name === handle ? lit : color;
    },
    /** @param {number} main @param {number} edge */
    paint(main, edge) {
      color.color.set(main);
      rim.color.set(edge);
      lit.color.set(main).lerp(rim.color, 0.45);
    },
  };
}
