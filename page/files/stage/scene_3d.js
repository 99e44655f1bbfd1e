// The stage in three dimensions.

import {
  Color, Group, MeshStandardMaterial, NeutralToneMapping, PCFShadowMap, PerspectiveCamera, Scene, Vector2, Vector3, WebGLRenderer,
} from "../vendor/three/three.js";
import { createArm } from "./arm.js";
import { createCopy } from "./copy.js";
import { LENS_DEG, orbit, pan, place, preset, towards, zoom } from "./camera.js";
import { createKeepOuts, createLimits } from "./keep_outs.js";
import { createPointerInput } from "./pointer_input.js";
import { createLight, createMirrored } from "./light.js";
import { createDrawing, createPlanned, createTrail } from "./lines.js";
import { forward, inverse, rad } from "./kinematics.js";
import { colorsOf } from "./colors.js";
import { createMarks } from "./marks.js";
import { nextTask } from "../parts/frame_budget.js";
import { createPaper, createPlane, createTable } from "./paper.js";
import { createTarget } from "./target.js";
import { createBeam } from "./tools.js";
import { createWorld } from "./objects.js";

/** @typedef {import("./view.js").View} View */
/** @typedef {import("./view.js").Joints} Joints */
/** @typedef {import("./view.js").Preset} Preset */
/** @typedef {import("./view.js").Point} Point */
/** @typedef {import("../vendor/three/three.js").Object3D} Object3D */

const SWING_S = 0.45;
/** Shadow resolution, with a graphics card and without one. */
const FINE_SHADOW_PX = 2048, COARSE_SHADOW_PX = 512;
const NAMES = /** @type {const} */ (["base_deg", "rear_deg", "fore_deg", "servo_deg"]);
const METAL = { metal: 0.72, dark: 0.25, accent: 0.35, pin: 0.9, rubber: 0 };

/**
 * @param {HTMLElement} element
 * @param {{ changed(): void, target(pose: import("./view.js").Target): void, still: boolean }} outside
 * @param {boolean} card whether there is a graphics card
 */
export function createScene3d(element, outside, card) {
  const source = document.createElement("canvas");
  const renderer = new WebGLRenderer({ canvas: source, antialias: card, powerPreference: "high-performance", preserveDrawingBuffer: !card });
  const gl = /** @type {WebGL2RenderingContext} */ (renderer.getContext());
  // To check them, the page would wait for each shader.
  renderer.debug.checkShaderErrors = false;
  const canvas = card ? source : document.createElement("canvas");
  const copy = card ? null : createCopy(gl, canvas);
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  // Shadows change only with the arm, not with the camera.
  renderer.shadowMap.autoUpdate = false;
  renderer.toneMapping = NeutralToneMapping;

  const scene = new Scene();
  const lens = new PerspectiveCamera(LENS_DEG, 1, 20, 6000);
  lens.up.set(0, 0, 1);
  const light = createLight(card ? FINE_SHADOW_PX : COARSE_SHADOW_PX);
  const materials = {
    metal: new MeshStandardMaterial({ roughness: 0.34 }),
    dark: new MeshStandardMaterial({ roughness: 0.52 }),
    accent: new MeshStandardMaterial({ roughness: 0.36 }),
    pin: new MeshStandardMaterial({ roughness: 0.26 }),
    rubber: new MeshStandardMaterial({ roughness: 0.8 }),
  };
  // Not on the scene: table and paper need no reflections, which saves time.
  /** @type {ReturnType<typeof createMirrored> | null} */ let mirrored = null;
  const arm = createArm(materials, { foot: true });
  const [table, paper, marks, world] = [createTable(), createPaper(), createMarks(renderer), createWorld()];
  const [keepOuts, limits, trail, planned, drawing, target] = [createKeepOuts(), createLimits(), createTrail(), createPlanned(), createDrawing(), createTarget()];
  const plane = createPlane();
  const beam = createBeam(0xff3b30);
  const onTable = new Group().add(table.group, paper.group, marks.group, world.group);
  scene.add(light.group, arm.group, onTable, keepOuts.group, limits.group, trail.group, plane.group, planned.group, drawing.group, target.group, beam.group);

  /** @type {View | null} */ let view = null;
  /** @type {Joints | null} */ let drawn = null;
  /** The joints of the last frame. @type {Joints | null} */ let last_joints = null;
  /** The joints of the last shadow. @type {Joints | null} */ let shaded = null;
  let aspect = 1;
  let camera = preset("iso", aspect, [200, 0, 0]);
  /** @type {Preset | null} */ let kept = "iso";
  /** @type {{ from: typeof camera, to: typeof camera, since_s: number } | null} */ let swing = null;
  /** Whether something besides the joints changed after the last frame. */
  let isStale = true;

  function changed() {
    isStale = true;
    outside.changed();
  }

  /** @param {typeof camera} next */
  function look(next) {
    camera = next;
    swing = kept = null;
    changed();
  }
  const perPixel = () => (2 * camera.away_mm * Math.tan(rad(LENS_DEG / 2))) / Math.max(1, canvas.clientHeight);
  const pointer = (/** @type {{ x: number, y: number }} */ { x, y }) => new Vector2(x, y);
  const dropped = { phase: /** @type {const} */ ("drop") };
  /** @type {import("./view.js").Pose | null} */ let last = null;
  const leave = createPointerInput(canvas, {
    orbit: (dx, dy) => look(orbit(camera, -dx * 0.35, dy * 0.35)),
    pan: (dx, dy) => look(pan(camera, -dx * perPixel(), dy * perPixel())),
    zoom: (times) => look(zoom(camera, times)),
  }, {
    hover(at) {
      const handle = at && target.under(lens, pointer(at));
      target.light(handle);
      changed();
      return handle !== null;
    },
    grab(at) {
      const handle = target.under(lens, pointer(at));
      target.light(handle);
      last = null;
      if (handle === null || !target.grab(handle, lens, pointer(at))) return false;
      // What a hand drags stays under it.
      if (swing) look(camera);
      return true;
    },
    drag(at) {
      last = target.drag(lens, pointer(at)) ?? last;
      if (last) outside.target({ ...last, phase: "drag" });
    },
    drop() {
      target.release();
      if (last) outside.target({ ...last, ...dropped });
    },
  });

  function paint(/** @type {View} */ { dark, ghost, laser, tool }) {
    const colors = colorsOf(dark);
    scene.background = new Color(colors.background);
    light.sun.intensity = colors.sun;
    light.sky.intensity = colors.sky;
    for (const it of Object.values(materials)) it.envMapIntensity = colors.room;
    materials.metal.color.set(colors.metal);
    materials.dark.color.set(colors.dark);
    materials.accent.color.set(colors.accent);
    materials.pin.color.set(colors.pin);
    materials.rubber.color.set(colors.dark);
    for (const it of [table, paper, plane, keepOuts, limits, trail, planned]) it.paint(colors);
    marks.paint(colors, tool.kind === "laser");
    target.paint(colors, ghost?.refused ?? false);
    beam.paint(colors.beam);
  }

  /** Shows a view; only differences are applied. @param {View} next */
  function show(next) {
    const before = view;
    view = next;
    const differs = (/** @type {(keyof View)[]} */ ...names) => !before || names.some((name) => before[name] !== next[name]);
    if (next.shape && (!before || before.shape !== next.shape || before.tool.kind !== next.tool.kind || before.tool.length_mm !== next.tool.length_mm)) {
      arm.mount(next.shape, next.tool);
      target.mount(next.shape, next.tool);
    }
    onTable.position.z = next.table_z_mm;
    renderer.shadowMap.needsUpdate = true;
    if (differs("paper")) paper.show(next.paper);
    if (differs("plane", "tool")) plane.show(next.plane, next.tool.length_mm);
    if (differs("things")) world.show(next.things);
    if (differs("keepOuts")) keepOuts.show(next.keepOuts);
    if (differs("planned", "tool")) planned.show(next.planned, next.tool.length_mm);
    if (differs("drawing", "tool", "dark")) drawing.show(next.drawing, next.tool.length_mm, colorsOf(next.dark));
    marks.show(next.marks, next.paper);
    arm.group.visible = trail.group.visible = next.arm !== null;
    if (differs("dark", "ghost", "tool", "keepOuts")) paint(next);
    if (drawn) pose(drawn);
    changed();
  }

  /** @param {Joints} joints */
  function pose(joints) {
    if (!view?.shape) return;
    const { shape, tool, arm: reported, laser, table_z_mm, ghost, near } = view;
    arm.pose({ ...joints, gripper_deg: reported?.gripper_deg ?? 0 });
    const own = forward(joints, shape);
    const tip = new Vector3(own.x_mm, own.y_mm, own.z_mm - tool.length_mm);
    trail.follow(tip);
    beam.group.visible = laser === "burning" && reported !== null;
    beam.group.position.copy(tip);
    beam.reach(tip.z - table_z_mm);
    target.show(view, reported && own);
    const aimed = ghost && inverse(ghost, shape);
    limits.warn(aimed ?? (reported && joints), shape, near.limits);
    keepOuts.warn(near.keep_outs);
  }

  /**
   * Draws a frame if something changed and the last one is finished.
   * @param {Joints | null} joints
   * @param {number} now_s
   * @returns {{ rendered: boolean, again: boolean }} whether it drew, and whether it has to be called again
   */
  function frame(joints, now_s) {
    if (copy && !copy.isFinished()) return { rendered: false, again: true };
    const moves = (joints === null) !== (last_joints === null) || (joints !== null && NAMES.some((name) => joints[name] !== last_joints?.[name]));
    if (copy && !isStale && !moves && !swing) return { rendered: false, again: false };
    isStale = false;
    last_joints = joints;
    render(joints, now_s);
    copy?.drawn();
    return { rendered: true, again: copy !== null || swing !== null };
  }

  /** @param {Joints | null} joints @param {number} now_s */
  function render(joints, now_s) {
    if (joints) drawn = joints;
    else if (view) target.show(view, null);
    if (joints) pose(joints);
    if (joints && NAMES.some((name) => joints[name] !== shaded?.[name])) renderer.shadowMap.needsUpdate = true;
    shaded = joints;
    if (swing) {
      const share = outside.still ? 1 : Math.min(1, (now_s - swing.since_s) / SWING_S);
      camera = towards(swing.from, swing.to, share);
      if (share >= 1) swing = null;
    }
    lens.position.set(...place(camera));
    lens.lookAt(...camera.at_mm);
    target.size(lens);
    lens.updateMatrixWorld();
    renderer.render(scene, lens);
  }

  return {
    kind: /** @type {const} */ ("3d"),
    /** Whether the shaders are compiled. */
    isReady: false,
    canvas,
    show,
    frame,
    /** @param {number} width @param {number} height @param {number} density */
    resize(width, height, density) {
      copy?.forget();
      renderer.setPixelRatio(density);
      renderer.setSize(width, height, false);
      aspect = width / Math.max(1, height);
      lens.aspect = aspect;
      lens.updateProjectionMatrix();
      if (kept) camera = preset(kept, aspect, tipOf());
      isStale = true;
    },
    /** @param {Preset} name @param {number} now_s */
    look(name, now_s) {
      swing = { from: camera, to: preset(name, aspect, tipOf()), since_s: now_s };
      kept = name;
      changed();
    },
    /** By the keyboard: degrees, pixels, times. */
    turn: (/** @type {number} */ around, /** @type {number} */ up) => look(orbit(camera, around, up)),
    shift: (/** @type {number} */ right, /** @type {number} */ up) => look(pan(camera, right * perPixel(), up * perPixel())),
    near: (/** @type {number} */ times) => look(zoom(camera, times)),
    /** Sets the quality: reflections cost most, then shadows. @param {import("./render_quality.js").Quality} quality */
    refine({ mirrors, shadows }) {
      light.sun.castShadow = shadows;
      renderer.shadowMap.needsUpdate = true;
      for (const [name, it] of Object.entries(materials)) {
        it.envMap = mirrors ? (mirrored ??= createMirrored(renderer)) : null;
        // Metal without reflections is black.
        it.metalness = mirrors ? METAL[/** @type {keyof typeof METAL} */ (name)] : 0;
        it.needsUpdate = true;
      }
    },
    /** The canvas of WebGL, which loses its context. */
    source,
    compile,
    end() {
      leave();
      marks.end();
      renderer.dispose();
      canvas.remove();
    },
  };

  /** Compiles the shaders and uploads the shapes, one part after the other, so that the page never waits for all of them. */
  async function compile() {
    const parts = scene.children.filter((it) => it !== light.group);
    for (const part of parts) {
      await renderer.compileAsync(part, lens, scene);
      await nextTask();
      renderAlone(part, parts);
      await nextTask();
    }
    // The last shadow is that of one part.
    renderer.shadowMap.needsUpdate = true;
  }

  /** Draws a part into a single pixel. @param {Object3D} part @param {Object3D[]} parts */
  function renderAlone(part, parts) {
    const others = parts.filter((it) => it !== part && it.visible);
    for (const it of others) it.visible = false;
    renderer.shadowMap.needsUpdate = true;
    renderer.setScissor(0, 0, 1, 1);
    renderer.setScissorTest(true);
    renderer.render(scene, lens);
    renderer.setScissorTest(false);
    for (const it of others) it.visible = true;
  }

  /** @returns {Point} */
  function tipOf() {
    if (!drawn || !view?.shape) return [200, 0, -60];
    const { x_mm, y_mm, z_mm } = forward(drawn, view.shape);
    return [x_mm, y_mm, z_mm - view.tool.length_mm / 2];
  }
}
