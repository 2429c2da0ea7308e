// What is drawn, as objects of three.js; object.userData.put(numbers) brings them to where they are now.
import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, DynamicDrawUsage, InstancedBufferAttribute, InstancedMesh, LineBasicMaterial,
  LineSegments, Matrix4, Mesh, MeshDepthMaterial, MeshStandardMaterial, RGBADepthPacking, SphereGeometry,
} from "three";

const SPOTS = new Color();

function material(color, colored, flat) {
  const [red, green, blue, alpha] = color;
  const made = new MeshStandardMaterial({ roughness: 0.55, metalness: 0.05, side: DoubleSide, flatShading: flat, vertexColors: colored });
  made.color.setRGB(red, green, blue, "srgb");
  if (alpha < 1) Object.assign(made, { transparent: true, opacity: alpha, depthWrite: false });
  made.onBeforeCompile = veiled;
  return made;
}

// The opacity of each item, an attribute, on top of that of the material; what has none is not drawn.
function veiled(shader) {
  const after = (name, code) => [`#include <${name}>`, `#include <${name}>\n${code}`];
  shader.vertexShader = shader.vertexShader
    .replace(...after("common", "attribute float veil; varying float seen;"))
    .replace(...after("begin_vertex", "seen = veil;"));
  shader.fragmentShader = shader.fragmentShader
    .replace(...after("common", "varying float seen;"))
    .replace(...after("clipping_planes_fragment", "if (seen < 0.004) discard;"))
    .replace(...after("color_fragment", "diffuseColor.a *= seen;"));
}

const SHADE = new MeshDepthMaterial({ depthPacking: RGBADepthPacking }); // of what casts a shadow
SHADE.onBeforeCompile = veiled;

// Give a mesh userData.reveal(opacity of the item with a number), for all its instances, or for the points of its only item.
function veil(made, items, rims = []) {
  const single = !made.isInstancedMesh, count = single ? made.geometry.getAttribute("position").count : items.length;
  const Attribute = single ? BufferAttribute : InstancedBufferAttribute, seen = new Attribute(new Float32Array(count).fill(1), 1);
  made.geometry.setAttribute("veil", seen);
  Object.assign(made, { castShadow: true, customDepthMaterial: SHADE });
  made.userData.reveal = (opacity) => {
    const parts = items.map(opacity);
    single ? seen.array.fill(parts[0]) : seen.array.set(parts);
    seen.needsUpdate = true;
    made.userData.veiled = parts.some((part) => part > 0 && part < 1);
    rims.forEach((rim, i) => (rim.userData.hidden = !parts[i]));
  };
}

// Bytes as three.js computes with them; `stride` bytes for each color.
const LINEAR = Float32Array.from({ length: 256 }, (_, byte) => SPOTS.setRGB(byte / 255, 0, 0, "srgb").r);

function linear(bytes, stride, result = new Float32Array((3 * bytes.length) / stride)) {
  for (let i = 0, from = 0; i < result.length; i += 3, from += stride) {
    result[i] = LINEAR[bytes[from]];
    result[i + 1] = LINEAR[bytes[from + 1]];
    result[i + 2] = LINEAR[bytes[from + 2]];
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

// The corners of faces with the edges between them.
function frame(entry, arrays, position) {
  return new BufferGeometry().setAttribute("position", position).setIndex(new BufferAttribute(arrays[entry.edges], 1));
}

// Edges move with their faces; they are shown where graphics data ask for them, or when the reader does.
function edges(entry, shape) {
  const rims = new LineSegments(shape, new LineBasicMaterial({ color: 0x202020, transparent: true, opacity: 0.7 }));
  rims.visible = entry.marked;
  rims.userData = { rim: true, marked: entry.marked };
  rims.frustumCulled = false;
  rims.raycast = () => {};
  return rims;
}

// A mesh and its edges. One that keeps its shape stands at several places, each 12 numbers, the rows of matrix and place; one that
// deforms is put where its points are, with bytes for their colors if it is shaded.
export function mesh(entry, arrays) {
  return entry.frames != null || entry.deforms ? deformed(entry, arrays) : rigid(entry, arrays);
}

function rigid(entry, arrays) {
  const shape = geometry(entry, arrays), count = entry.items.length, matrix = new Matrix4();
  const made = new InstancedMesh(shape, material(entry.color, entry.colors != null, entry.normals == null), count);
  const rims = [];
  if (arrays[entry.edges].length && count <= 200) {
    const shared = frame(entry, arrays, shape.getAttribute("position"));
    for (let i = 0; i < count; ++i) rims.push(edges(entry, shared));
  }
  for (const rim of rims) rim.matrixAutoUpdate = false;
  made.frustumCulled = false;
  made.userData = {
    items: entry.items,
    put(rows) {
      for (let i = 0, k = 0; i < count; ++i, k += 12) {
        matrix.set(
          rows[k], rows[k + 1], rows[k + 2], rows[k + 3], rows[k + 4], rows[k + 5], rows[k + 6], rows[k + 7], rows[k + 8], rows[k + 9],
          rows[k + 10], rows[k + 11], 0, 0, 0, 1,
        );
        made.setMatrixAt(i, matrix);
        if (rims[i]) rims[i].matrix.copy(matrix), (rims[i].matrixWorldNeedsUpdate = true);
      }
      made.instanceMatrix.needsUpdate = true;
      made.boundingSphere = null;
    },
  };
  veil(made, entry.items, rims);
  return [made, ...rims];
}

function deformed(entry, arrays) {
  const shape = geometry(entry, arrays), position = shape.getAttribute("position"), shaded = entry.shaded || entry.frameColors != null;
  const smooth = entry.smooth ?? entry.normals != null;
  position.setUsage(DynamicDrawUsage);
  if (shaded) shape.setAttribute("color", new BufferAttribute(new Float32Array(3 * position.count), 3));
  const color = shaded ? [1, 1, 1, entry.color[3]] : entry.color;
  const made = new Mesh(shape, material(color, shaded || entry.colors != null, !smooth));
  made.frustumCulled = false;
  made.userData = {
    items: entry.items,
    deforms: true,
    put(points, shades) {
      position.copyArray(points).needsUpdate = true;
      if (smooth) shape.computeVertexNormals();
      if (shades) {
        const colors = shape.getAttribute("color");
        linear(shades, 3, colors.array);
        colors.needsUpdate = true;
      }
      shape.boundingSphere = null;
    },
  };
  const rims = edges(entry, frame(entry, arrays, position));
  veil(made, entry.items, [rims]);
  return [made, rims];
}

// Parts of the circles of spheres, of which there are so many: they may have so many triangles together.
const TRIANGLES = { graphics: 6e6, processor: 3e5 };

export function parts(count, drawnBy) {
  return Math.min(Math.max(Math.round(Math.sqrt(TRIANGLES[drawnBy] / 2 / count)), 4), 48);
}

// Each is four numbers: center and radius.
export function spheres(entry, arrays, drawnBy) {
  const count = entry.items.length, matrix = new Matrix4();
  if (count === 0) return [];
  const fine = parts(count, drawnBy);
  const made = new InstancedMesh(new SphereGeometry(1, fine, fine), material([1, 1, 1, 1], false, false), count);
  const colors = linear(arrays[entry.colors], 3);
  for (let i = 0; i < count; ++i) made.setColorAt(i, SPOTS.fromArray(colors, 3 * i));
  made.frustumCulled = false;
  made.userData = {
    items: entry.items,
    put(balls) {
      for (let i = 0; i < count; ++i) {
        const r = balls[4 * i + 3];
        made.setMatrixAt(i, matrix.set(r, 0, 0, balls[4 * i], 0, r, 0, balls[4 * i + 1], 0, 0, r, balls[4 * i + 2], 0, 0, 0, 1));
      }
      made.instanceMatrix.needsUpdate = true;
      made.boundingSphere = null;
    },
  };
  veil(made, entry.items);
  return [made];
}

const BRIGHT = [221, 221, 221]; // what is black, on a dark background

// All lines as one object: the points of one after those of the other, and how many each has. Lines may grow.
export function lines(colors, items) {
  const made = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true }));
  made.frustumCulled = false;
  made.raycast = () => {};
  let room = 0, dark = false, last = null, hidden = [];
  made.userData = {
    items,
    paint(isDark) {
      if (dark === isDark) return;
      dark = isDark;
      if (last) made.userData.put(...last);
    },
    reveal(opacity) {
      hidden = items.map((item) => !opacity(item));
      if (last) made.userData.put(...last);
    },
    put(points, counts) {
      last = [points, counts];
      const needed = 2 * counts.reduce((sum, count) => sum + Math.max(count - 1, 0), 0), shape = made.geometry;
      if (needed > room) {
        room = Math.max(needed, 2 * room);
        shape.dispose(); // what the graphics card has of it
        for (const name of ["position", "color"]) shape.setAttribute(name, new BufferAttribute(new Float32Array(3 * room), 3));
      }
      shape.setDrawRange(0, 0);
      if (!needed) return;
      const position = shape.getAttribute("position"), shade = shape.getAttribute("color");
      let to = 0;
      for (let line = 0, from = 0; line < counts.length; from += 3 * counts[line++]) {
        if (hidden[line]) continue;
        const [red, green, blue] = dark && !Math.max(...colors[line]) ? BRIGHT : colors[line];
        SPOTS.setRGB(red / 255, green / 255, blue / 255, "srgb");
        for (let i = 0; i + 1 < counts[line]; ++i, to += 6) {
          position.array.set(points.subarray(from + 3 * i, from + 3 * i + 6), to);
          SPOTS.toArray(shade.array, to);
          SPOTS.toArray(shade.array, to + 3);
        }
      }
      shape.setDrawRange(0, to / 3);
      position.needsUpdate = shade.needsUpdate = true;
    },
  };
  return [made];
}
