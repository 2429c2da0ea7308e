// A floor below all that is drawn: a grid with round numbers, and the shadows of what stands or moves above it.
import { Box3, BufferGeometry, DirectionalLight, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Mesh, PlaneGeometry, ShadowMaterial } from "three";

const CELLS = 20; // of the grid, in each direction
const MAP = 2048; // pixels of the shadow map
const DARK = 0.25; // opacity of shadows

// A round number that is not smaller.
const round = (value) => {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [1, 2, 5, 10].find((part) => part * power >= value);
};

export class Floor {
  // `box` has the corners of the scene, `up` is the number of the axis that points upwards.
  constructor(box, up, shadows) {
    const low = box.min.getComponent(up), size = box.max.clone().sub(box.min), [i, j] = [(up + 1) % 3, (up + 2) % 3];
    const wide = Math.max(size.getComponent(i), size.getComponent(j), size.getComponent(up) / 2);
    this.cell = round(wide / 8);
    this.up = up;
    this.level = this.cell * Math.floor((low - 1e-6 * wide) / this.cell);
    this.object = new Group();
    const middle = [i, j].map((axis) => this.cell * Math.round((box.min.getComponent(axis) + box.max.getComponent(axis)) / 2 / this.cell));
    const half = (CELLS / 2) * this.cell, points = [];
    const at = (x, y) => {
      const point = [0, 0, 0];
      point[i] = middle[0] + x;
      point[j] = middle[1] + y;
      point[up] = this.level;
      points.push(...point);
    };
    for (let k = -CELLS / 2; k <= CELLS / 2; ++k)
      at(k * this.cell, -half), at(k * this.cell, half), at(-half, k * this.cell), at(half, k * this.cell);
    const shape = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
    this.object.add(new LineSegments(shape, new LineBasicMaterial({ color: 0x888888, transparent: true, opacity: 0.25, depthWrite: false })));
    if (shadows) this.shade(middle, half, i, j, box.max.getComponent(up) - this.level);
  }

  // A lamp straight above, nearly, and the plane that receives shadows.
  shade(middle, half, i, j, height) {
    const sun = new DirectionalLight(0xffffff, 0.3), ground = new Mesh(new PlaneGeometry(2 * half, 2 * half), new ShadowMaterial({ opacity: DARK, depthWrite: false }));
    const put = (object, x, y, z) => object.position.setComponent(i, middle[0] + x).setComponent(j, middle[1] + y).setComponent(this.up, this.level + z);
    put(ground, 0, 0, 0);
    put(sun.target, 0, 0, 0);
    put(sun, 0.3 * half, 0.2 * half, 2 * half + height);
    if (this.up === 1) ground.rotation.x = -Math.PI / 2;
    if (this.up === 0) ground.rotation.y = Math.PI / 2;
    ground.receiveShadow = sun.castShadow = true;
    Object.assign(sun.shadow.camera, { left: -half, right: half, top: half, bottom: -half, near: 0.01 * half, far: 4 * half + 2 * height });
    sun.shadow.mapSize.set(MAP, MAP);
    sun.shadow.radius = 4;
    this.object.add(sun, sun.target, ground);
  }

  // Whether something of the scene is below it.
  pierced(box) {
    return box.min.getComponent(this.up) < this.level;
  }

  end() {
    this.object.traverse((part) => {
      part.geometry?.dispose();
      part.material?.dispose();
      part.dispose?.();
    });
  }
}

// The smallest box around the meshes that are shown.
export function around(objects) {
  const all = new Box3(), part = new Box3();
  for (const object of objects) {
    if (!object.isMesh || !object.visible) continue;
    if (object.isInstancedMesh) object.computeBoundingBox(), part.copy(object.boundingBox);
    else object.geometry.computeBoundingBox(), part.copy(object.geometry.boundingBox);
    all.union(part);
  }
  return all;
}
