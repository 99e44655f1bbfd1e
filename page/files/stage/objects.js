// The objects on the table of a virtual arm.

import { CylinderGeometry, Group, Mesh, MeshStandardMaterial } from "../vendor/three/three.js";
import { rad } from "./kinematics.js";
import { block } from "./solid.js";

/** @typedef {import("./view.js").Thing} Thing */

export function createWorld() {
  const group = new Group();
  /** @type {Map<string, { shape: string, mesh: Mesh<import("../vendor/three/three.js").BufferGeometry, MeshStandardMaterial> }>} */
  const there = new Map();

  /** @param {string} name */
  function remove(name) {
    const old = there.get(name);
    if (!old) return;
    old.mesh.removeFromParent();
    old.mesh.geometry.dispose();
    old.mesh.material.dispose();
    there.delete(name);
  }

  /** @param {Thing} thing */
  function place(thing) {
    const shape = JSON.stringify(thing.shape);
    if (there.get(thing.name)?.shape !== shape) {
      remove(thing.name);
      const mesh = new Mesh(form(thing.shape), new MeshStandardMaterial({ roughness: 0.55, metalness: 0 }));
      mesh.castShadow = mesh.receiveShadow = true;
      group.add(mesh);
      there.set(thing.name, { shape, mesh });
    }
    const mesh = there.get(thing.name)?.mesh;
    if (!mesh) return;
    mesh.material.color.set(thing.color);
    mesh.position.set(...thing.at_mm, thing.bottom_mm);
    mesh.rotation.z = rad(thing.turn_deg);
  }

  return {
    group,
    /** @param {readonly Thing[]} things */
    show(things) {
      const names = new Set(things.map((thing) => thing.name));
      for (const name of [...there.keys()]) if (!names.has(name)) remove(name);
      things.forEach(place);
    },
  };
}

/** @param {Thing["shape"]} shape */
function form(shape) {
  if (shape.type === "box") {
    const [x, y, z] = shape.size_mm;
    return block([x, y, z], [0, 0, z / 2], Math.min(2, x / 4, y / 4));
  }
  const { diameter_mm, height_mm } = shape;
  return new CylinderGeometry(diameter_mm / 2, diameter_mm / 2, height_mm, 40).rotateX(Math.PI / 2).translate(0, 0, height_mm / 2);
}
