// Light, shadow and reflections: one sun, and an invisible room that metal reflects.

import {
  BackSide, BoxGeometry, DirectionalLight, Group, HemisphereLight, Mesh, MeshBasicMaterial, PMREMGenerator, Scene,
} from "../vendor/three/three.js";

/** @typedef {import("../vendor/three/three.js").WebGLRenderer} WebGLRenderer */

/** The sun, with a shadow over all that the arm reaches. @param {number} shadow_px how fine it is */
export function createLight(shadow_px) {
  const group = new Group();
  const sun = new DirectionalLight(0xfffdf9, 1);
  sun.position.set(180, -360, 620);
  sun.target.position.set(110, 0, -60);
  sun.castShadow = true;
  sun.shadow.mapSize.set(shadow_px, shadow_px);
  sun.shadow.radius = 5;
  sun.shadow.bias = -0.0006;
  sun.shadow.normalBias = 0.6;
  Object.assign(sun.shadow.camera, { left: -380, right: 380, top: 380, bottom: -380, near: 300, far: 1100 });
  sun.shadow.camera.updateProjectionMatrix();
  const sky = new HemisphereLight(0xffffff, 0x9aa0a6, 1);
  sky.position.set(0, 0, 1);
  group.add(sun, sun.target, sky);
  return { group, sun, sky };
}

/**
 * Renders the reflected room.
 * @param {WebGLRenderer} renderer
 */
export function createMirrored(renderer) {
  const room = new Scene();
  const side = new BoxGeometry(1, 1, 1);
  /** @param {number} grey @param {number[]} size @param {number[]} at @param {boolean} inside */
  const add = (grey, [x = 0, y = 0, z = 0], [atX = 0, atY = 0, atZ = 0], inside = false) => {
    const material = new MeshBasicMaterial(inside ? { side: BackSide } : {});
    material.color.setScalar(grey);
    const mesh = new Mesh(side, material);
    mesh.scale.set(x, y, z);
    mesh.position.set(atX, atY, atZ);
    room.add(mesh);
  };
  add(0.42, [20, 20, 12], [0, 0, 3], true);
  add(6, [7, 7, 0.1], [1, -2, 8.6]);
  add(3, [0.1, 8, 4], [-9.6, 0, 4]);
  add(2.2, [8, 0.1, 5], [0, 9.6, 4]);
  add(1.4, [0.1, 5, 2], [9.6, -3, 3]);
  const made = new PMREMGenerator(renderer);
  const { texture } = made.fromScene(room, 0.03);
  made.dispose();
  side.dispose();
  return texture;
}
