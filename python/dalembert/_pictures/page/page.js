// A page that shows a motion: turn, move and zoom by mouse, play and scrub, and see which item is under the mouse.
// Names of items are set as text, never as HTML. Nothing is loaded from anywhere.
import { AmbientLight, Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { axes } from "./axes.js";
import { read } from "./data.js";
import { shapes } from "./shapes.js";

const FIELD = 30; // degrees, of the camera

function element(parent, tag, properties = {}) {
  return parent.appendChild(Object.assign(document.createElement(tag), properties));
}

class Page {
  constructor(place, head, arrays) {
    Object.assign(this, { place, head, frame: 0, playing: head.plays, speed: 1, since: 0, drawn: 0 });
    this.renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(window.devicePixelRatio);
    place.appendChild(this.renderer.domElement);
    this.scene = new Scene();
    this.scene.background = new Color().setRGB(...head.background, "srgb");
    this.objects = shapes(head, arrays);
    this.scene.add(...this.objects);
    this.camera = new PerspectiveCamera(FIELD, 1, 0.01, 1000);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener("change", () => this.wish());
    this.light();
    this.tools();
    this.home();
    new ResizeObserver(() => this.resize()).observe(place);
    this.resize();
    this.show(0);
    window.addEventListener("keydown", (event) => this.key(event));
    this.renderer.domElement.addEventListener("pointermove", (event) => this.point(event));
    requestAnimationFrame((now) => this.tick(now));
  }

  light() {
    this.scene.add(new AmbientLight(0xffffff, 0.5), new HemisphereLight(0xffffff, 0x777777, 0.8));
    const key = new DirectionalLight(0xffffff, 1.6), fill = new DirectionalLight(0xffffff, 0.5);
    key.position.set(-0.5, 0.8, 1.1);
    fill.position.set(0.9, 0.1, 0.6);
    for (const lamp of [key, fill]) this.camera.add(lamp, lamp.target), lamp.target.position.set(0, 0, -1);
    this.scene.add(this.camera);
  }

  // The view that the picture would have: rows of the rotation are right, up and towards the viewer.
  home() {
    const { rotation, center, zoom } = this.head.camera;
    const towards = new Vector3(...rotation.slice(6, 9)), middle = new Vector3(...center);
    const distance = zoom / Math.tan((FIELD / 2) * (Math.PI / 180));
    const up = rotation.slice(3, 6), main = up.map(Math.abs).indexOf(Math.max(...up.map(Math.abs)));
    this.camera.up.set(...up.map((part, i) => (i === main ? Math.sign(part) : 0))); // it stays upright when it is turned
    this.camera.position.copy(middle).addScaledVector(towards, distance);
    Object.assign(this.camera, { near: distance / 200, far: distance * 50 });
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(middle);
    this.controls.update();
    this.wish();
  }

  tools() {
    const { head, place } = this, many = head.times.length > 1;
    this.axes = axes(place);
    this.hint = element(place, "div", { className: "hint" });
    this.time = element(place, "div", { className: "time" });
    const bar = element(place, "div", { className: "bar" });
    this.button = element(bar, "button", { title: "play or pause (space)", onclick: () => this.play(!this.playing), hidden: !many });
    this.slider = element(bar, "input", { type: "range", min: 0, max: head.times.length - 1, value: 0, hidden: !many });
    this.slider.oninput = () => (this.play(false), this.show(Number(this.slider.value)));
    const speeds = element(bar, "select", { title: "speed", hidden: !many });
    for (const speed of [0.1, 0.25, 0.5, 1, 2, 4]) element(speeds, "option", { value: speed, textContent: `${speed} x`, selected: speed === 1 });
    speeds.onchange = () => (this.speed = Number(speeds.value));
    element(bar, "button", { textContent: "view", title: "back to the first view (a)", onclick: () => this.home() });
    element(bar, "button", { textContent: "edges", title: "show edges (e)", onclick: () => this.edges() });
    element(bar, "button", { textContent: "dark", title: "dark or light (d)", onclick: () => this.dark() });
    element(bar, "button", { textContent: "picture", title: "save a picture", onclick: () => this.save() });
    if (head.contour) this.contour(head.contour);
    this.play(this.playing);
  }

  contour({ name, range, colors }) {
    const scale = element(this.place, "div", { className: "contour" });
    element(scale, "div", { textContent: name });
    colors.toReversed().forEach((color, i) => {
      const row = element(scale, "div", { className: "row" });
      element(row, "span").style.background = `rgb(${color.join(",")})`;
      const value = range[1] + ((range[0] - range[1]) * i) / (colors.length - 1);
      if (i % 3 === 0) element(row, "i", { textContent: value.toPrecision(4) });
    });
  }

  play(flag) {
    const last = this.head.times.length - 1;
    this.playing = flag && last > 0;
    if (this.playing && this.frame === last) this.frame = 0;
    this.button.textContent = this.playing ? "❚❚" : "▶";
    this.since = 0;
  }

  show(number) {
    this.frame = number;
    for (const object of this.objects) object.userData.go?.(number);
    this.slider.value = number;
    const caption = this.head.captions?.[number];
    this.time.textContent = caption ?? this.when(number);
    this.wish();
  }

  when(number) {
    return this.head.times.length > 1 ? `t = ${this.head.times[number].toPrecision(4)} s` : "";
  }

  edges() {
    for (const object of this.objects) if (object.userData.edges) object.visible = !object.visible;
    this.wish();
  }

  dark() {
    this.isDark = !this.isDark;
    this.place.classList.toggle("dark", this.isDark);
    this.scene.background = this.isDark ? new Color(0x1b1d22) : new Color().setRGB(...this.head.background, "srgb");
    this.wish();
  }

  save() {
    this.renderer.render(this.scene, this.camera);
    Object.assign(document.createElement("a"), { href: this.renderer.domElement.toDataURL(), download: "picture.png" }).click();
  }

  key(event) {
    const last = this.head.times.length - 1, step = event.shiftKey ? 10 : 1;
    const actions = {
      " ": () => this.play(!this.playing),
      ArrowRight: () => (this.play(false), this.show(Math.min(this.frame + step, last))),
      ArrowLeft: () => (this.play(false), this.show(Math.max(this.frame - step, 0))),
      Home: () => this.show(0),
      End: () => this.show(last),
      a: () => this.home(),
      e: () => this.edges(),
      d: () => this.dark(),
    };
    if (!actions[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    actions[event.key]();
  }

  // Which item is at a place of the window; null if there is none.
  itemAt(x, y) {
    const box = this.renderer.domElement.getBoundingClientRect(), ray = new Raycaster();
    ray.setFromCamera(new Vector2(((x - box.left) / box.width) * 2 - 1, 1 - ((y - box.top) / box.height) * 2), this.camera);
    const hit = ray.intersectObjects(this.objects.filter((object) => object.isMesh), false)[0];
    return hit ? this.head.items[hit.object.userData.items[hit.instanceId ?? 0]] : null;
  }

  // Where a point of the system is in the window.
  projected(point) {
    const { x, y } = new Vector3(...point).project(this.camera), box = this.renderer.domElement.getBoundingClientRect();
    return [box.left + ((x + 1) / 2) * box.width, box.top + ((1 - y) / 2) * box.height];
  }

  point(event) {
    if (event.buttons) return;
    const item = this.itemAt(event.clientX, event.clientY);
    this.hint.textContent = item ? `${item[0].toLowerCase()} ${item[1]}: ${item[3]} (${item[0]}${item[2]})` : "";
    this.hint.style.transform = `translate(${event.offsetX + 14}px, ${event.offsetY + 10}px)`;
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.place;
    if (!width || !height) return;
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.wish();
  }

  wish() {
    this.wanted = true;
  }

  tick(now) {
    requestAnimationFrame((next) => this.tick(next));
    if (this.playing) {
      if (!this.since) this.since = now - (this.frame / this.head.rate / this.speed) * 1000;
      const number = Math.floor(((now - this.since) / 1000) * this.head.rate * this.speed);
      if (number >= this.head.times.length) this.head.again ? ((this.since = now), this.show(0)) : this.play(false);
      else if (number !== this.frame) this.show(Math.max(number, 0));
    }
    if (!this.wanted) return;
    this.wanted = false;
    this.renderer.render(this.scene, this.camera);
    this.axes(this.camera);
    this.drawn += 1;
  }
}

read(document.getElementById("data").textContent.trim()).then(({ head, arrays }) => {
  document.title = head.title;
  window.page = new Page(document.getElementById("page"), head, arrays);
});
