// A scene of three.js with its camera, and what readers do with it: turn, move, zoom, pick, measure, cut. Both pages, that of a motion
// and the live one, are views. Names of items are set as text, never as HTML. Nothing is loaded from anywhere.
import {
  AmbientLight, Box3, Box3Helper, BufferGeometry, Color, DirectionalLight, HemisphereLight, Line, LineBasicMaterial, Matrix4, PerspectiveCamera,
  Plane, Points, PointsMaterial, Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { axes } from "./axes.js";
import { Floor, around } from "./floor.js";
import { Film, download, flat } from "./picture.js";

export const FIELD = 30; // degrees, of the camera
const PARALLEL = 1; // degrees, of one that is so far away that lines look parallel
const DEPTH = 180; // heights that are seen before and behind the middle
const ROUND_OFF = 1e-6; // of a distance, in its components
const NARROW = 640; // pixels of a page on which all panels are in one column
const AGAIN = 20; // pictures until it is checked again that the floor is below everything
const CLICK = 4; // pixels that the mouse may move in a click
const RED = 0xcc0d0d; // of what readers have marked
const END = 6; // pixels of the ends of lines that readers have drawn

export const MOUSE = [
  ["left, right button", "rotate, move"], ["wheel", "zoom"], ["click", "select an item"], ["shift and two clicks", "measure a distance"],
];

export function element(parent, tag, properties = {}) {
  return parent.appendChild(Object.assign(document.createElement(tag), properties));
}

const half = ({ fov }) => Math.tan((fov / 2) * (Math.PI / 180));

// What is drawn lies between two distances from the camera.
export function reach(camera, controls) {
  const distance = camera.position.distanceTo(controls.target), zoom = distance * half(camera);
  Object.assign(camera, { near: Math.max(distance / 200, distance - DEPTH * zoom), far: distance + DEPTH * zoom });
  camera.updateProjectionMatrix();
}

// The rows of the rotation are right, up and towards the viewer; zoom is half the height that is seen.
export function look(camera, controls, { rotation, center, zoom }) {
  const towards = new Vector3(...rotation.slice(6, 9)), middle = new Vector3(...center), distance = zoom / half(camera);
  const up = rotation.slice(3, 6), main = up.map(Math.abs).indexOf(Math.max(...up.map(Math.abs)));
  const upright = Math.abs(rotation[main]) < 1e-6; // it stays so when it is turned by mouse
  camera.up.set(...(upright ? up.map((part, i) => (i === main ? Math.sign(part) : 0)) : up));
  controls._quat?.setFromUnitVectors(camera.up, new Vector3(0, 1, 0)); // three.js looks at `up` once only
  controls._quatInverse?.copy(controls._quat).invert();
  camera.position.copy(middle).addScaledVector(towards, distance);
  controls.target.copy(middle);
  reach(camera, controls);
  controls.update();
}

// The same numbers of a view as it is.
export function looking(camera, controls) {
  camera.updateMatrixWorld();
  const right = new Vector3(), up = new Vector3(), towards = new Vector3();
  camera.matrixWorld.extractBasis(right, up, towards);
  const zoom = camera.position.distanceTo(controls.target) * half(camera);
  return { rotation: [...right, ...up, ...towards], center: [...controls.target], zoom };
}

// What leaves out that which is beyond a plane, on the side to which its normal points; no normal, no plane.
export function planes(x, y, z, distance) {
  const normal = new Vector3(x, y, z), length = normal.length();
  return length ? [new Plane(normal.divideScalar(-length), distance)] : [];
}

// What draws: a graphics card, or the processor in its place.
function drawnBy(gl) {
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  return /llvmpipe|softpipe|swiftshader|software|basic render/i.test(name) ? "processor" : "graphics";
}

export class View {
  constructor(place) {
    Object.assign(this, { place, objects: [], items: [], marks: true, drawn: 0, background: [1, 1, 1], picked: null, ends: [], panes: [], opacities: new Map() });
    this.renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.drawnBy = drawnBy(this.renderer.getContext());
    this.canvas = this.renderer.domElement;
    place.appendChild(this.canvas);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(FIELD, 1, 0.01, 1000);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener("change", () => (reach(this.camera, this.controls), this.wish()));
    this.renderer.shadowMap.enabled = this.drawnBy === "graphics"; // a processor would take too long
    this.light();
    this.axes = axes(place);
    this.labels = element(place, "div", { className: "labels" });
    this.hint = element(place, "div", { className: "hint" });
    this.time = element(place, "div", { className: "time" });
    this.bar = element(place, "div", { className: "bar" });
    this.timeline = element(this.bar, "div", { className: "times", hidden: true });
    this.tools = element(this.bar, "div", { className: "tools" });
    this.scale = element(place, "div", { className: "contour" });
    this.watcher = new ResizeObserver(() => this.resize());
    for (const watched of [place, this.bar]) this.watcher.observe(watched);
    this.paint();
    this.resize();
    this.canvas.addEventListener("pointermove", (event) => this.point(event));
    this.canvas.addEventListener("pointerdown", (event) => (this.down = [event.clientX, event.clientY]));
    this.canvas.addEventListener("pointerup", (event) => this.isClick(event) && this.click(event));
    this.canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    requestAnimationFrame((now) => this.tick(now));
  }

  light() {
    this.scene.add(new AmbientLight(0xffffff, 0.5), new HemisphereLight(0xffffff, 0x777777, 0.8));
    const key = new DirectionalLight(0xffffff, 1.6), fill = new DirectionalLight(0xffffff, 0.5);
    key.position.set(-0.5, 0.8, 1.1);
    fill.position.set(0.9, 0.1, 0.6);
    for (const lamp of [key, fill]) lamp.target.position.set(0, 0, -1);
    this.lamps = [key, key.target, fill, fill.target]; // they turn with the reader
    this.camera.add(...this.lamps);
    this.scene.add(this.camera);
  }

  // The objects of another scene; items are [kind, number, type, name, ...].
  replace(objects, items) {
    for (const old of this.objects) {
      this.scene.remove(old);
      old.geometry.dispose();
      old.material.dispose();
      old.dispose?.();
    }
    this.objects = objects;
    this.items = items;
    this.scene.add(...objects);
    for (const object of objects) if (object.isMesh) object.userData.own = { opacity: object.material.opacity, clear: object.material.transparent };
    this.reveal();
    this.list();
    this.lay();
  }

  // Put a floor below everything, if readers want one; it is put lower where something falls below it.
  lay() {
    const box = around(this.objects);
    if (this.floor && this.upwards === this.floor.up && !this.floor.pierced(box) && !this.bare) return;
    if (this.floor) this.scene.remove(this.floor.object), this.floor.end();
    const far = this.floor && this.upwards === this.floor.up ? this.floor.box : box;
    this.floor = this.bare || !(box.min.distanceTo(box.max) > 0) || box.isEmpty() ? null : new Floor(far.union(box), this.upwards ?? 2, this.renderer.shadowMap.enabled);
    if (this.floor) this.scene.add(Object.assign(this.floor, { box: far }).object);
    this.wish();
  }

  // Opacity of the item with a number, 0 if it is hidden; weight is, until readers show it.
  opacity(number) {
    const item = this.items[number];
    return this.opacities.get(JSON.stringify(item)) ?? (item?.[2] === "MassProportional" ? 0 : 1);
  }

  // Show, hide or veil items.
  veil(numbers, opacity) {
    for (const number of numbers) this.opacities.set(JSON.stringify(this.items[number]), opacity);
    this.reveal();
  }

  reveal() {
    for (const object of this.objects) object.userData.reveal?.((number) => this.opacity(number));
    this.fade(this.faded ?? 1);
    this.showEdges();
    this.mark();
  }

  // The panel of all items, if it is open, and others are drawn now: readers may be at its search.
  list() {
    const { items } = this.panels?.open ?? {};
    if (items && items.shown !== JSON.stringify(this.items)) this.panels.items(this);
  }

  paint(background) {
    if (background) this.background = background;
    this.scene.background = this.isDark ? new Color(0x1b1d22) : new Color().setRGB(...this.background, "srgb");
    this.place.classList.toggle("dark", !!this.isDark);
    for (const object of this.objects) object.userData.paint?.(!!this.isDark);
    this.wish();
  }

  // As settings say.
  dress({ background, edges, faces, transparent, upwards }) {
    this.upwards = upwards;
    this.lay();
    this.paint(background);
    this.allEdges = edges;
    this.showEdges();
    this.fade(faces ? transparent : 0);
  }

  // A camera that was fitted to a wider window looks from farther away.
  look({ aspect = 0, ...seen }) {
    look(this.camera, this.controls, { ...seen, zoom: seen.zoom * Math.max(aspect / this.camera.aspect, 1) });
    this.wish();
  }

  // Perspective, or lines that stay parallel.
  parallel() {
    const field = this.camera.fov === FIELD ? PARALLEL : FIELD;
    for (const { camera, controls } of [this, ...this.panes]) {
      const seen = looking(camera, controls);
      camera.fov = field;
      look(camera, controls, seen);
    }
    this.wish();
  }

  looking() {
    return looking(this.camera, this.controls);
  }

  contour(contour, range) {
    this.scale.replaceChildren();
    this.range = null;
    if (!contour) return;
    element(this.scale, "div", { textContent: contour.name });
    const values = [], rows = [];
    contour.colors.toReversed().forEach((color, i) => {
      const row = element(this.scale, "div", { className: "row" });
      rows.push(row);
      element(row, "span").style.background = `rgb(${color.join(",")})`;
      if (i % 3 === 0) values.push([element(row, "i"), i / (contour.colors.length - 1)]);
    });
    this.range = (low, high) => {
      const size = Math.max(Math.abs(low), Math.abs(high)), least = 1e-9 * size; // less is what rounding leaves of zero
      const constant = high === low, step = (high - low) / (values.length - 1);
      const digits = constant ? 0 : Math.min(Math.max(Math.ceil(Math.log10(size / Math.abs(step))) + 2, 4), 15); // numbers differ
      rows.forEach((row, i) => (row.hidden = constant && i < rows.length - 1)); // the lowest color is that of all
      for (const [place, part] of values) {
        const number = constant ? low : high + (low - high) * part;
        place.textContent = constant ? Number(low.toPrecision(6)) : Math.abs(number) < least ? "0" : number.toPrecision(digits);
      }
    };
    if (range) this.range(...range);
  }

  edges() {
    this.allEdges = !this.allEdges;
    this.showEdges();
  }

  showEdges() {
    for (const object of this.objects) {
      const { rim, marked, hidden } = object.userData;
      if (rim) object.visible = (marked || !!this.allEdges) && !hidden;
    }
    this.wish();
  }

  // How clear faces are, on top of their own colors; 0 hides them.
  fade(part) {
    this.faded = part;
    for (const object of this.objects) {
      if (!object.isMesh) continue;
      const { own: { opacity, clear: own }, veiled } = object.userData, clear = own || veiled;
      Object.assign(object.material, { opacity: opacity * part, transparent: clear || part < 1, depthWrite: part === 1 && !clear, visible: part > 0 });
      object.material.needsUpdate = true;
    }
    this.wish();
  }

  cut(x, y, z, distance) {
    this.renderer.clippingPlanes = planes(x, y, z, distance);
    this.wish();
  }

  dark() {
    this.isDark = !this.isDark;
    if (this.texts) this.write(this.texts, this.places);
    this.paint();
  }

  save() {
    this.render();
    download(flat(this.place, this.canvas).toDataURL(), "picture.png");
  }

  // Begin a film of what is drawn, or end it and save it.
  shoot() {
    if (this.film) this.film = this.film.end();
    else this.film = new Film(this.place, this.canvas);
    this.filmed?.classList.toggle("on", !!this.film);
    this.wish();
  }

  // From the reader through a place of the window; `pane`: as it is seen there.
  ray(x, y, pane) {
    const box = (pane?.window ?? this.canvas).getBoundingClientRect(), ray = new Raycaster();
    ray.setFromCamera(new Vector2(((x - box.left) / box.width) * 2 - 1, 1 - ((y - box.top) / box.height) * 2), (pane ?? this).camera);
    return ray;
  }

  // What is at a place of the window: number of the item, point, distance; null if there is nothing. `kinds`: of items that count.
  hit(x, y, pane, kinds) {
    const cuts = pane ? pane.clip : this.renderer.clippingPlanes;
    const hits = this.ray(x, y, pane).intersectObjects(this.objects.filter((object) => object.isMesh && object.material.visible), false);
    const item = ({ object, instanceId }) => object.userData.items[instanceId ?? 0];
    const counts = (number) => this.opacity(number) && (!kinds || kinds.includes(this.items[number]?.[0]));
    const found = hits.find((hit) => counts(item(hit)) && cuts.every((plane) => plane.distanceToPoint(hit.point) >= 0));
    if (!found) return null;
    return { number: item(found), point: found.point, distance: found.distance };
  }

  itemAt(x, y, pane) {
    const hit = this.hit(x, y, pane);
    return hit && this.items[hit.number];
  }

  // Where a point of the system is in the window.
  projected(point) {
    this.camera.updateMatrixWorld();
    const { x, y } = new Vector3(...point).project(this.camera), box = this.canvas.getBoundingClientRect();
    return [box.left + ((x + 1) / 2) * box.width, box.top + ((1 - y) / 2) * box.height];
  }

  // With a floor, or without.
  ground() {
    this.bare = !this.bare;
    this.lay();
  }

  // What is below the mouse, and where that point is.
  point(event, pane) {
    if (event.buttons) return;
    const hit = this.hit(event.clientX, event.clientY, pane), box = this.place.getBoundingClientRect();
    const [kind, number, type, name] = hit ? this.items[hit.number] : [];
    this.hint.textContent = hit ? `${kind.toLowerCase()} ${number}: ${name} (${kind}${type})\n${this.coordinates(hit.point)}` : "";
    const x = Math.min(event.clientX - box.left + 14, box.width - this.hint.offsetWidth - 2);
    this.hint.style.transform = `translate(${x}px, ${event.clientY - box.top + 10}px)`;
  }

  // As many digits as a pixel is worth.
  coordinates(point) {
    const pixel = (2 * this.looking().zoom) / this.canvas.clientHeight, digits = Math.min(Math.max(Math.ceil(-Math.log10(pixel)), 0), 12);
    return `(${[...point].map((part) => part.toFixed(digits).replace(/^-(0\.?0*)$/, "$1")).join(", ")}) m`;
  }

  isClick(event) {
    return this.down && Math.hypot(event.clientX - this.down[0], event.clientY - this.down[1]) < CLICK;
  }

  // With shift, the two ends of a distance; otherwise an item.
  click(event, pane) {
    const hit = this.hit(event.clientX, event.clientY, pane);
    if (event.shiftKey) this.measure(hit);
    else this.pick(hit, event.button === 2);
  }

  pick(hit) {
    this.picked = hit && hit.number;
    this.mark();
    this.wish();
  }

  // Show something besides the objects of the scene, in the place of what had this name before.
  exchange(name, object) {
    const old = this[name];
    if (old) this.scene.remove(old), old.traverse(({ geometry, material }) => (geometry.dispose(), material.dispose()));
    this[name] = object;
    if (object) this.scene.add(object);
    this.wish();
  }

  // A line with its ends in front of everything, or none.
  join(name, points) {
    if (!points) return this.exchange(name, null);
    const shape = new BufferGeometry().setFromPoints(points), look = { color: RED, depthTest: false };
    const made = new Line(shape, new LineBasicMaterial(look));
    made.add(new Points(shape, new PointsMaterial({ ...look, size: END * window.devicePixelRatio, sizeAttenuation: false })));
    made.traverse((part) => Object.assign(part, { renderOrder: 1, frustumCulled: false }));
    this.exchange(name, made);
  }

  // A box around what is picked.
  mark() {
    const around = this.picked == null || !this.marks || !this.opacity(this.picked) ? new Box3() : this.around(this.picked);
    this.exchange("box", around.isEmpty() ? null : new Box3Helper(around, RED));
  }

  // The smallest box around an item.
  around(number) {
    const around = new Box3(), part = new Box3(), matrix = new Matrix4();
    for (const object of this.objects) {
      if (!object.isMesh) continue;
      object.userData.items.forEach((item, i) => {
        if (item !== number) return;
        if (!object.geometry.boundingBox || object.userData.deforms) object.geometry.computeBoundingBox();
        part.copy(object.geometry.boundingBox);
        if (object.isInstancedMesh) object.getMatrixAt(i, matrix), part.applyMatrix4(matrix);
        around.union(part);
      });
    }
    return around;
  }

  // Let an item fill half of the view.
  approach(number) {
    const around = this.around(number), size = around.getSize(new Vector3()).length();
    if (size) this.look({ ...this.looking(), center: [...around.getCenter(new Vector3())], zoom: size });
  }

  measure(hit) {
    if (!hit) this.ends = [];
    else this.ends = this.ends.length === 1 ? [this.ends[0], hit.point] : [hit.point];
    this.join("ruler", this.ends.length === 2 ? this.ends : null);
    if (this.ends.length === 2) {
      const [a, b] = this.ends, along = b.clone().sub(a), length = along.length();
      const parts = [...along].map((part) => (Math.abs(part) < ROUND_OFF * length ? "0" : part.toPrecision(4)));
      this.tell(`distance ${length.toPrecision(6)} m   (${parts.join(", ")})`);
    } else this.tell(hit ? "distance: shift and click at the other end" : "");
    this.wish();
  }

  // Below the time.
  tell(text) {
    this.distance = text;
    this.time.textContent = [this.words, text].filter(Boolean).join("\n");
  }

  // Texts at points: [text, place].
  write(texts, places) {
    const shown = Math.min(texts.length, 1000);
    while (this.labels.children.length > shown) this.labels.lastChild.remove();
    while (this.labels.children.length < shown) element(this.labels, "span");
    for (let i = 0; i < shown; ++i) {
      const [text, [red, green, blue]] = texts[i], label = this.labels.children[i];
      if (label.textContent !== text) label.textContent = text;
      label.style.color = this.isDark ? "inherit" : `rgb(${255 * red}, ${255 * green}, ${255 * blue})`;
    }
    Object.assign(this, { texts, places });
  }

  // Texts at one point stand below each other.
  placeLabels() {
    const point = new Vector3(), { clientWidth: width, clientHeight: height } = this.place, standing = new Map();
    [...this.labels.children].forEach((label, i) => {
      const { x, y, z } = point.fromArray(this.places, 3 * i).project(this.camera);
      const pixels = [Math.round(((x + 1) / 2) * width), Math.round(((1 - y) / 2) * height)], before = standing.get(String(pixels)) ?? 0;
      standing.set(String(pixels), before + 1);
      label.hidden = !(z <= 1); // nor is it somewhere
      label.style.transform = `translate(${pixels[0]}px, calc(${pixels[1]}px + ${before}lh))`;
    });
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.place;
    if (!width || !height) return;
    this.place.classList.toggle("narrow", width <= NARROW);
    this.place.style.setProperty("--bar", `${this.bar.offsetHeight}px`);
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.wish();
  }

  wish() {
    this.wanted = true;
  }

  step() {}

  // Give back what the browser has few of.
  end() {
    this.ended = true;
    this.watcher.disconnect();
    if (this.film) this.shoot();
    this.controls.dispose();
    for (const pane of this.panes) pane.end();
    this.floor?.end();
    this.bare = true;
    this.replace([], []);
    for (const name of ["box", "ruler", "string"]) this.exchange(name, null);
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  tick(now) {
    if (this.ended) return;
    requestAnimationFrame((next) => this.tick(next));
    this.step(now);
    if (!this.wanted) return;
    this.wanted = false;
    this.render();
    this.drawn += 1;
    if (this.drawn % AGAIN === 0) this.lay();
  }

  render() {
    this.renderer.render(this.scene, this.camera);
    for (const pane of this.panes) pane.render();
    this.axes(this.camera);
    this.placeLabels();
    this.film?.add();
  }
}
