// The live page: it shows what the viewer sends, tells when it has drawn it, and passes on keys, choices and views.
import { joined, read } from "./data.js";
import { Grip } from "./grip.js";
import { Motion } from "./motion.js";
import { Pane } from "./panes.js";
import { Panels } from "./panels.js";
import { lines, mesh, spheres } from "./shapes.js";
import { Times } from "./times.js";
import { MOUSE, View, element } from "./view.js";

const GROUPS = [["n", "nodes"], ["b", "bodies"], ["c", "connectors"], ["m", "markers"], ["l", "loads"], ["s", "sensors"]];
// Rows are right, up and towards the viewer; the second of each pair is seen from behind.
const PLANES = {
  1: [[1, 0, 0], [0, 1, 0]], 2: [[1, 0, 0], [0, 0, 1]], 3: [[0, 1, 0], [0, 0, 1]],
  4: [[0, 1, 0], [1, 0, 0]], 5: [[0, 0, 1], [1, 0, 0]], 6: [[0, 0, 1], [0, 1, 0]],
};
const NAMES = { 1: "x, y", 2: "x, z", 3: "y, z", 4: "y, x", 5: "z, x", 6: "z, y" };
const KEYS = [
  ...MOUSE, ["ctrl or cmd, left button", "pull a body while a solver runs; wheel: stiffer, softer"], ["space", "pause or go on"], ["Q; escape", "stop the solver; close the page as well"], ["[ ]", "recorded state before, after"], ["A", "see all"],
  ["N B C M L S", "nodes, bodies, connectors, markers, loads, sensors; with ctrl, alt or shift their numbers"], ["F; R, J", "forces; frames of nodes, of joints"], ["O", "perspective or parallel"],
  ["T", "faces, transparent faces, edges"], ["ctrl or alt, 1 to 6", "look along an axis; with shift from behind"], ["arrows; keypad", "move; turn"],
  [". ,", "zoom"], ["1 to 5", "draw every 0.02 to 100 s"], ["V", "settings"], ["F2", "keys go to the user function"], ["?", "this help"],
];
const SENT = 100; // ms between what is told of mouse and view

const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

function rows(number, behind = false) {
  const [right, up] = PLANES[number], side = behind ? right.map((part) => -part) : right;
  return [...side, ...up, ...cross(side, up)];
}

export class Live extends View {
  // `link` reaches the viewer, `keys` is what they are taken from, `first` is called before the first picture.
  constructor(place, link, { keys = window, first = () => {} } = {}) {
    super(place);
    Object.assign(this, { link, first, frames: 0, number: -1, steps: [0.1, 5, 1.15] });
    this.panels = new Panels(place, (kind, words) => this.send(kind, words), (name) => {
      if (name === "details") this.pick(null);
      if (name === "outputs") this.send("plot", { drop: null });
    });
    this.grip = new Grip(this);
    this.equip();
    this.controls.addEventListener("change", () => (this.turned ||= !this.led));
    this.reports = setInterval(() => this.report(), SENT);
    this.deaf = new AbortController();
    for (const kind of ["keydown", "keyup"]) keys.addEventListener(kind, (event) => this.key(event), { signal: this.deaf.signal });
    link.start(this);
  }

  end() {
    clearInterval(this.reports);
    this.deaf.abort();
    this.close();
    super.end();
  }

  equip() {
    const { tools: bar } = this;
    this.times = new Times(this.timeline, {
      seek: (time) => this.seek({ time, plays: false }),
      step: (step) => this.seek({ time: this.now, step, plays: false }),
      play: (plays) => this.seek({ time: this.back ? this.now : Number(this.times.slider.min), plays }),
      pace: () => this.back && this.times.playing && this.seek({ time: this.now, plays: true }),
    });
    this.times.range(0, 0, "any", 0);
    this.present = element(this.times.bar, "button", { textContent: "live", title: "back to the present state", onclick: () => this.seek({ time: null }) });
    const button = (text, title, onclick) => element(bar, "button", { textContent: text, title, onclick: () => (onclick(), this.canvas.focus()) });
    this.pause = button("❚❚", "pause or go on (space)", () => this.press(" "));
    button("stop", "stop the solver (Q)", () => this.press("q"));
    this.state = element(bar, "span", { className: "state" });
    const choice = (first, entries, chosen) => {
      const select = element(bar, "select", { title: first, onchange: () => (chosen(select.value), (select.selectedIndex = 0), select.blur()) });
      element(select, "option", { textContent: first, value: "" });
      for (const [value, text] of entries) element(select, "option", { value, textContent: text });
    };
    choice("view", [["home", "all (A)"], ...Object.entries(NAMES), ...Object.entries(NAMES).map(([n, name]) => [-n, `${name}, from behind`])],
      (value) => (value === "home" ? this.home() : this.plane(Math.abs(value), value < 0)));
    choice("views", [["one", "one"], ["four", "three more"]], (value) => this.split(value === "one" ? [] : this.sides()));
    choice("show", [...GROUPS.map(([key, name]) => [key, `${name} (${key.toUpperCase()})`]), ...GROUPS.map(([key, name]) => [`${key}#`, `numbers of ${name}`]), ["r", "frames of nodes (R)"], ["j", "frames of joints (J)"]],
      (value) => this.press(value[0], value.length > 1));
    button("items", "list of items: search, hide, isolate", () => this.panels.items(this));
    button("forces", "forces of loads, joints, connectors and contacts as arrows (F)", () => this.send("forces"));
    button("faces", "faces, transparent faces, edges (T)", () => this.press("t"));
    button("cut", "leave out what is beyond a plane", () => this.panels.cut((plane) => this.cut(...plane), this.extent()));
    button("dark", "dark or light", () => this.dark());
    button("floor", "floor or none", () => this.ground());
    button("parallel", "perspective or parallel lines (O)", () => this.parallel());
    button("picture", "save a picture", () => this.save());
    this.filmed = button("film", "begin or end a film", () => this.shoot());
    button("settings", "visualization settings (V)", () => this.send("settings"));
    button("?", "mouse and keys (?)", () => this.panels.help(KEYS));
    this.canvas.tabIndex = 0;
    this.notice = element(this.place, "div", { className: "notice", onclick: () => (this.notice.textContent = "") });
  }

  // Middle and size of what is seen.
  extent() {
    const { center, zoom } = this.looking();
    return { center, size: 2 * zoom };
  }

  // Show these other views: number, camera, plane that cuts.
  split(views) {
    this.grip.release(); // perhaps in a view that ends
    for (const pane of this.panes) pane.end();
    this.panes = views.map(({ number, camera, clip }) => new Pane(this, number, camera, clip));
    this.place.classList.toggle("split", views.length > 0); // the bar of colors makes room
    this.wish();
  }

  // What is seen from the front, from the right and from above.
  sides() {
    const now = this.looking();
    return [1, 3, 2].map((plane, i) => ({ number: i + 1, camera: { ...now, rotation: rows(plane) }, clip: this.clip ?? [0, 0, 0, 0] }));
  }

  // Look back at a recorded state: {time, step, plays}; time null is the present state.
  seek(words) {
    this.send("seek", { speed: this.times.speed, ...words });
  }

  // A solution that the reader looks through, in front of what is live.
  async replay(data) {
    const { head, arrays } = await read(data);
    this.close(); // another one may have come meanwhile
    if (this.ended) return;
    const place = element(this.place, "div", { className: "page replay" });
    this.motion = new Motion(place, head, arrays);
    element(this.motion.tools, "button", { textContent: "live", title: "back to the live view (Escape)", onclick: () => this.close() });
  }

  close() {
    this.motion?.end();
    this.motion?.place.remove();
    this.motion = null;
  }

  opened() {
    this.number = -1;
  }

  closed(words) {
    this.grip.drop(); // the viewer has released it
    this.state.textContent = this.stopped ? "closed" : words;
  }

  send(kind, words = {}) {
    this.link.send({ kind, ...words });
  }

  // ---- what the viewer sends

  draw({ head, arrays }) {
    if (head.kind === "scene" && head.scene !== this.number) this.build(head, arrays);
    else if (head.scene !== this.number) return this.send("shown"); // of a scene that is not here any more
    let next = 0;
    for (const { put, shaded } of this.movers) {
      const points = arrays[next++], shades = shaded ? arrays[next++] : undefined;
      if (points || shades) put(points ?? this.last.get(put), shades);
      if (shaded && points) this.last.set(put, points);
    }
    const [sent, counts, places] = arrays.slice(next, next + 3), curves = sent && head.kept ? joined(sent, head.kept, this.points) : sent;
    if (curves || counts) this.curves(curves ?? this.points, counts ?? this.counts);
    if (curves) this.points = curves;
    if (counts) this.counts = counts;
    if (places) this.write(this.texts, places);
    this.range?.(...head.range);
    this.now = head.time;
    this.times.at(head.time);
    this.panels.mark(head.time);
    this.measurePace(head.time);
    this.caption();
    this.mark();
    this.wish();
    this.frames += 1;
  }

  build(head, arrays) {
    if (!this.frames) this.first();
    this.number = head.scene;
    this.last = new Map();
    const first = !this.objects.length;
    const made = head.meshes.map((entry) => [entry, mesh(entry, arrays)]);
    const balls = spheres(head.spheres, arrays, this.drawnBy);
    const shades = arrays[head.lines.colors], colors = head.lines.items.map((_, i) => shades.subarray(3 * i, 3 * i + 3));
    const drawn = lines(colors, head.lines.items);
    const picked = this.picked == null ? null : JSON.stringify(this.items[this.picked]);
    this.movers = made.map(([entry, [shape]]) => ({ put: shape.userData.put, shaded: entry.shaded }));
    this.movers.push({ put: balls.length ? balls[0].userData.put : () => {} });
    this.curves = drawn[0].userData.put;
    this.texts = head.labels;
    const found = picked == null ? -1 : head.items.findIndex((item) => JSON.stringify(item) === picked);
    this.picked = found < 0 ? null : found;
    this.marks = head.marks;
    this.replace([...made.flatMap(([, objects]) => objects), ...balls, ...drawn], head.items);
    this.steps = head.steps;
    this.forces = head.forces;
    this.dress(head);
    this.contour(head.contour);
    if (String(head.clip) !== String(this.clip)) this.cut(...(this.clip = head.clip));
    if (first) this.lead(head.camera);
  }

  take(words) {
    const actions = {
      state: () => {
        this.state.textContent = words.text;
        this.solves = words.text === "solving";
        this.pause.textContent = words.text && words.text !== "solving" ? "▶" : "❚❚";
      },
      times: () => this.recorded(words),
      camera: () => this.lead(words.camera),
      views: () => this.split(words.views),
      notice: () => (this.notice.textContent = words.text),
      stopped: () => ((this.stopped = true), (this.state.textContent = "closed")),
      alive: () => this.send("alive"),
      grip: () => this.grip.tell(words),
      details: () => this.picked != null && this.panels.details(words),
      outputs: () => this.panels.outputs(words.curves),
      settings: () => this.panels.settings(words.rows),
      controls: () => this.panels.controls(words),
      plots: () => this.panels.plot(words.curves),
      motion: () => this.replay(words.data),
    };
    actions[words.kind]?.();
  }

  // Simulated time per time, over a second each, while a solver is watched.
  measurePace(time) {
    const now = performance.now() / 1000, [then, before] = this.began ?? [now, time];
    if (!this.solves || this.back || time < before) this.pace = this.began = null;
    else if (now - then > 1) (this.pace = `${((time - before) / (now - then)).toPrecision(2)} x real time`), (this.began = [now, time]);
    else this.began ??= [now, time];
  }

  // Which times can be looked back to, and whether readers do.
  recorded({ first, last, count, back, plays }) {
    this.back = back;
    this.times.range(first, last, "any", count);
    this.times.at(this.now);
    this.times.plays(plays);
    this.present.disabled = !back;
  }

  // What is below the time.
  caption() {
    this.words = [this.now == null ? "" : this.when(this.now), this.pace, this.forces, this.grip.words].filter(Boolean).join("\n");
    this.tell(this.distance);
  }

  // Look as the viewer says; it need not be told.
  lead(camera) {
    this.led = true;
    this.look(camera);
    this.led = false;
  }

  when(time) {
    return `t = ${time.toPrecision(4)} s`;
  }

  // ---- what readers do

  home() {
    this.press("a"); // the viewer knows from where all is seen
  }

  plane(number, behind) {
    this.look({ ...this.looking(), rotation: rows(number, behind) });
  }

  pick(hit, full) {
    super.pick(hit);
    if (hit) this.send("select", { item: hit.number, scene: this.number, depth: hit.distance, full });
    else this.send("select", { item: -1, scene: this.number, depth: 0 }), this.panels.close("details");
  }

  point(event, pane) {
    super.point(event, pane);
    if (!pane) this.mouse = event;
  }

  // Mouse and view, now and then.
  report() {
    if (this.mouse) {
      const { offsetX: x, offsetY: y } = this.mouse, { zoom } = this.looking(), { clientWidth: width, clientHeight: height } = this.place;
      this.send("mouse", { pixels: [x, y], place: [((2 * x - width) / height) * zoom, ((height - 2 * y) / height) * zoom] });
      this.mouse = null;
    }
    if (this.turned && this.frames) this.send("camera", this.looking());
    this.turned = false;
    for (const pane of this.panes) {
      if (pane.turned && this.frames) this.send("camera", { ...pane.looking(), view: pane.number });
      pane.turned = false;
    }
  }

  press(key, numbers = false) {
    this.send("key", { key, control: numbers, shift: false, alt: false, action: 1 });
  }

  key(event) {
    if (this.motion) return event.key === "Escape" ? this.close() : undefined; // it has keys of its own
    if (/^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName) || event.metaKey) return;
    if (event.ctrlKey && /^[c]$/i.test(event.key) && String(getSelection())) return; // a text is copied
    const { key, ctrlKey: control, shiftKey: shift, altKey: alt } = event, down = event.type === "keydown";
    if (["Control", "Shift", "Alt", "F5", "F11", "F12"].includes(key)) return;
    event.preventDefault();
    if (down && this.moveBy(key, event)) return;
    this.send("key", { key, control, shift, alt, action: down ? (event.repeat ? 2 : 1) : 0 });
  }

  // Keys that move the view; true if this was one.
  moveBy(key, { code, ctrlKey: control, altKey: alt, shiftKey: shift }) {
    const small = control ? 0.1 : 1, [shiftStep, turn, zoom] = this.steps, digit = /^Digit([1-6])$/.exec(code)?.[1];
    if (key === "?") return this.panels.help(KEYS), true;
    if (/^o$/i.test(key) && !control) return this.parallel(), true;
    if (/^f$/i.test(key) && !control) return this.send("forces"), true;
    if (key === "[" || key === "]") return this.seek({ time: this.now, step: key === "]" ? 1 : -1 }), true;
    if (digit && (control || alt)) return this.plane(digit, shift), true;
    const move = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[key];
    if (move && !code.startsWith("Numpad")) return this.shift(move.map((part) => part * shiftStep * small)), true;
    const axis = { Numpad2: [0, 1], Numpad8: [0, -1], Numpad4: [1, 1], Numpad6: [1, -1], Numpad1: [2, 1], Numpad9: [2, -1] }[code];
    if (axis) return this.turn(axis[0], axis[1] * turn * small), true;
    const factor = { ".": 1 / zoom, NumpadAdd: 1 / zoom, ",": zoom, NumpadSubtract: zoom }[code === "NumpadAdd" || code === "NumpadSubtract" ? code : key];
    if (factor) return this.look({ ...this.looking(), zoom: this.looking().zoom * factor ** small }), true;
    const actions = { a: () => this.home(), v: () => this.send("settings") };
    if (control || alt || !actions[key.toLowerCase()]) return false;
    actions[key.toLowerCase()]();
    return true;
  }

  // The scene moves by parts of the window.
  shift([right, up]) {
    const now = this.looking(), size = 2 * now.zoom;
    const center = now.center.map((part, i) => part - size * (right * now.rotation[i] + up * now.rotation[3 + i]));
    this.look({ ...now, center });
  }

  // The scene turns about an axis of the window: 0 to the right, 1 up, 2 towards the reader.
  turn(axis, degrees) {
    const now = this.looking(), rows = [now.rotation.slice(0, 3), now.rotation.slice(3, 6), now.rotation.slice(6)];
    const [i, j] = [(axis + 1) % 3, (axis + 2) % 3], c = Math.cos((degrees * Math.PI) / 180), s = Math.sin((degrees * Math.PI) / 180);
    const [a, b] = [rows[i], rows[j]];
    rows[i] = a.map((part, k) => c * part - s * b[k]);
    rows[j] = a.map((part, k) => s * part + c * b[k]);
    this.look({ ...now, rotation: rows.flat() });
  }

  step() {
    if (this.frames !== this.told && !this.wanted) {
      this.told = this.frames;
      this.send("shown");
    }
  }
}
