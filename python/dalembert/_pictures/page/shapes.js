// What is drawn, as objects of three.js that know how to go to a frame: object.userData.go(number).
import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, DynamicDrawUsage, InstancedMesh, Line, LineBasicMaterial, LineSegments, Matrix4,
  Mesh, MeshStandardMaterial, SphereGeometry,
} from "three";
import { frame } from "./data.js";

const SPOTS = new Color();

function material(color, colored, flat) {
  const [red, green, blue, alpha] = color;
  const made = new MeshStandardMaterial({ roughness: 0.55, metalness: 0.05, side: DoubleSide, flatShading: flat, vertexColors: colored });
  made.color.setRGB(red, green, blue, "srgb");
  if (alpha < 1) Object.assign(made, { transparent: true, opacity: alpha, depthWrite: false });
  return made;
}

function linear(bytes, stride) {
  const count = bytes.length / stride, result = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i) {
    SPOTS.setRGB(bytes[stride * i] / 255, bytes[stride * i + 1] / 255, bytes[stride * i + 2] / 255, "srgb").toArray(result, 3 * i);
  }
  return result;
}

function geometry(entry, arrays) {
  const made = new BufferGeometry();
  made.setAttribute("position", new BufferAttribute(arrays[entry.points].slice(), 3));
  made.setIndex(new BufferAttribute(arrays[entry.triangles], 1));
  if (entry.normals != null) made.setAttribute("normal", new BufferAttribute(arrays[entry.normals], 3));
  if (entry.colors != null) made.setAttribute("color", new BufferAttribute(linear(arrays[entry.colors], 4), 3));
  return made;
}

// Edges move with their faces; they are shown where graphics data ask for them, or when the reader does.
function edges(entry, arrays, position) {
  const made = new BufferGeometry();
  made.setAttribute("position", position);
  made.setIndex(new BufferAttribute(arrays[entry.edges], 1));
  const lines = new LineSegments(made, new LineBasicMaterial({ color: 0x202020, transparent: true, opacity: 0.7 }));
  lines.visible = entry.marked;
  lines.userData.edges = !entry.marked;
  lines.frustumCulled = false;
  lines.raycast = () => {};
  return lines;
}

function rigid(entry, arrays) {
  const shape = geometry(entry, arrays);
  const count = entry.items.length, numbers = new Float32Array(12), matrix = new Matrix4();
  const mesh = new InstancedMesh(shape, material(entry.color, entry.colors != null, entry.normals == null), count);
  const frames = entry.places.map((place) => arrays[place]);
  const rims = arrays[entry.edges].length && count <= 200 ? frames.map(() => edges(entry, arrays, shape.getAttribute("position"))) : [];
  for (const rim of rims) rim.matrixAutoUpdate = false;
  mesh.frustumCulled = false;
  mesh.userData = {
    items: entry.items,
    rims,
    go(number) {
      frames.forEach((values, i) => {
        frame(values, 12, number, numbers);
        matrix.set(...numbers, 0, 0, 0, 1);
        mesh.setMatrixAt(i, matrix);
        if (rims[i]) rims[i].matrix.copy(matrix), rims[i].matrixWorldNeedsUpdate = true;
      });
      mesh.instanceMatrix.needsUpdate = true;
      mesh.boundingSphere = null;
    },
  };
  return [mesh, ...rims];
}

function deformed(entry, arrays) {
  const shape = geometry(entry, arrays), position = shape.getAttribute("position"), values = arrays[entry.frames];
  position.setUsage(DynamicDrawUsage);
  const shades = entry.frameColors != null ? arrays[entry.frameColors] : null;
  if (shades) shape.setAttribute("color", new BufferAttribute(new Float32Array(3 * position.count), 3));
  const mesh = new Mesh(shape, material(entry.color, shades != null || entry.colors != null, !entry.smooth));
  mesh.frustumCulled = false;
  mesh.userData = {
    items: entry.items,
    go(number) {
      frame(values, 3 * position.count, number, position.array);
      position.needsUpdate = true;
      if (entry.smooth) shape.computeVertexNormals();
      if (shades) {
        const size = 3 * position.count, at = Math.min(number, shades.length / size - 1);
        shape.getAttribute("color").copyArray(linear(shades.subarray(at * size, (at + 1) * size), 3)).needsUpdate = true;
      }
      shape.boundingSphere = null;
    },
  };
  return [mesh, edges(entry, arrays, position)];
}

function spheres(entry, arrays) {
  const count = entry.items.length, numbers = new Float32Array(4), matrix = new Matrix4();
  if (count === 0) return [];
  const fine = count < 500 ? 24 : 10;
  const mesh = new InstancedMesh(new SphereGeometry(1, fine, fine), material([1, 1, 1, 1], false, false), count);
  const colors = linear(arrays[entry.colors], 3);
  for (let i = 0; i < count; ++i) mesh.setColorAt(i, SPOTS.fromArray(colors, 3 * i));
  const frames = entry.places.map((place) => arrays[place]);
  mesh.frustumCulled = false;
  mesh.userData = {
    items: entry.items,
    go(number) {
      frames.forEach((values, i) => {
        const [x, y, z, r] = frame(values, 4, number, numbers);
        mesh.setMatrixAt(i, matrix.set(r, 0, 0, x, 0, r, 0, y, 0, 0, r, z, 0, 0, 0, 1));
      });
      mesh.instanceMatrix.needsUpdate = true;
      mesh.boundingSphere = null;
    },
  };
  return [mesh];
}

function line(entry, arrays) {
  const values = arrays[entry.frames], size = 3 * entry.count, made = new BufferGeometry();
  const position = new BufferAttribute(new Float32Array(size), 3);
  made.setAttribute("position", position);
  const [red, green, blue] = entry.color;
  const drawn = new Line(made, new LineBasicMaterial({ color: new Color().setRGB(red, green, blue, "srgb") }));
  drawn.frustumCulled = false;
  drawn.userData = {
    items: [entry.item],
    go(number) {
      frame(values, size, number, position.array);
      position.needsUpdate = true;
      made.boundingSphere = null;
    },
  };
  return [drawn];
}

export function shapes(head, arrays) {
  return [
    ...head.meshes.flatMap((entry) => (entry.frames != null ? deformed(entry, arrays) : rigid(entry, arrays))),
    ...spheres(head.spheres, arrays),
    ...head.lines.flatMap((entry) => line(entry, arrays)),
  ];
}
