// The page of a motion: play and scrub.
import { frame } from "./data.js";
import { lines, mesh, spheres } from "./shapes.js";
import { Panels } from "./panels.js";
import { Times } from "./times.js";
import { MOUSE, View, element } from "./view.js";

// The numbers of all places in one frame, out of arrays that have all frames of one place each.
function gathered(places, size, arrays, target) {
  return (number) => {
    places.forEach((place, i) => frame(arrays[place], size, number, target.subarray(i * size, (i + 1) * size)));
    return target;
  };
}

// An object goes to the frame of a number.
function moving(entry, arrays) {
  const made = mesh(entry, arrays), shape = made[0];
  if (entry.frames == null) {
    const now = gathered(entry.places, 12, arrays, new Float32Array(12 * entry.items.length));
    return [made, (number) => shape.userData.put(now(number))];
  }
  const points = new Float32Array(3 * shape.geometry.getAttribute("position").count);
  const shades = entry.frameColors == null ? null : arrays[entry.frameColors];
  return [made, (number) => {
    const at = shades && Math.min(number, shades.length / points.length - 1) * points.length;
    shape.userData.put(frame(arrays[entry.frames], points.length, number, points), shades?.subarray(at, at + points.length));
  }];
}

function balls(entry, arrays, drawnBy) {
  const made = spheres(entry, arrays, drawnBy);
  if (!made.length) return [made, () => {}];
  const now = gathered(entry.places, 4, arrays, new Float32Array(4 * entry.items.length));
  return [made, (number) => made[0].userData.put(now(number))];
}

function curves(entries, arrays) {
  const total = entries.reduce((sum, entry) => sum + entry.count, 0);
  const made = lines(entries.map((entry) => entry.color.map((part) => 255 * part)), entries.map((entry) => entry.item));
  const points = new Float32Array(3 * total), counts = entries.map((entry) => entry.count);
  return [made, (number) => {
    let start = 0;
    for (const entry of entries) {
      frame(arrays[entry.frames], 3 * entry.count, number, points.subarray(start, start + 3 * entry.count));
      start += 3 * entry.count;
    }
    made[0].userData.put(points, counts);
  }];
}

const KEYS = [
  ...MOUSE, ["space", "play or pause"], ["← →, [ ]", "a frame back or forward; with shift ten"], ["home, end", "first and last frame"],
  ["a", "first view"], ["o", "perspective or parallel"], ["e", "edges"], ["d", "dark or light"], ["?", "this help"],
];

const SAMPLES = 8; // of a motion, for its floor

export class Motion extends View {
  constructor(place, head, arrays) {
    super(place);
    Object.assign(this, { head, frame: 0, playing: head.plays, since: 0 });
    this.panels = new Panels(place);
    const parts = [...head.meshes.map((entry) => moving(entry, arrays)), balls(head.spheres, arrays, this.drawnBy), curves(head.lines, arrays)];
    this.movers = [...parts.map(([, go]) => go), this.writing(head.labels, arrays)];
    this.replace(parts.flatMap(([made]) => made), head.items);
    this.dress(head);
    this.cut(...head.clip);
    this.contour(head.contour, head.contour?.range);
    this.equip();
    this.look(head.camera);
    for (let k = SAMPLES; k >= 0; --k) this.show(Math.floor((k / SAMPLES) * (head.times.length - 1))), this.lay(); // the floor is below all of the motion
    this.pressed = (event) => this.key(event);
    window.addEventListener("keydown", this.pressed);
  }

  end() {
    window.removeEventListener("keydown", this.pressed);
    super.end();
  }

  // Texts go where they are in the frame of a number.
  writing({ texts, frames }, arrays) {
    const places = new Float32Array(3 * texts.length);
    return (number) => this.write(texts, frame(arrays[frames], places.length, number, places));
  }

  equip() {
    const { head, tools: bar } = this, count = head.times.length;
    const seek = (number) => (this.play(false), this.show(number)), play = (flag) => this.play(flag);
    this.times = new Times(this.timeline, { seek, step: (step) => this.go(step), play, pace: () => (this.since = 0) });
    this.times.range(0, count - 1, 1, count);
    element(bar, "button", { textContent: "view", title: "back to the first view (a)", onclick: () => this.look(head.camera) });
    element(bar, "button", { textContent: "items", title: "list of items: search, hide, isolate", onclick: () => this.panels.items(this) });
    element(bar, "button", { textContent: "edges", title: "show edges (e)", onclick: () => this.edges() });
    element(bar, "button", { textContent: "dark", title: "dark or light (d)", onclick: () => this.dark() });
    element(bar, "button", { textContent: "floor", title: "floor or none", onclick: () => this.ground() });
    element(bar, "button", { textContent: "parallel", title: "perspective or parallel lines (o)", onclick: () => this.parallel() });
    element(bar, "button", { textContent: "picture", title: "save a picture", onclick: () => this.save() });
    this.filmed = element(bar, "button", { textContent: "film", title: "save a film of the motion", onclick: () => this.shoot(), hidden: count < 2 });
    element(bar, "button", { textContent: "?", title: "mouse and keys (?)", onclick: () => this.panels.help(KEYS) });
    this.play(this.playing);
  }

  // The film is of the motion from the beginning to the end.
  shoot() {
    super.shoot();
    this.show(0);
    this.play(!!this.film);
  }

  play(flag) {
    const last = this.head.times.length - 1;
    this.playing = flag && last > 0;
    if (this.playing && this.frame === last) this.frame = 0;
    this.times.plays(this.playing);
    this.since = 0;
  }

  // So many frames further.
  go(step) {
    this.play(false);
    this.show(Math.min(Math.max(this.frame + step, 0), this.head.times.length - 1));
  }

  show(number) {
    this.frame = number;
    for (const go of this.movers) go(number);
    this.times.at(number);
    this.words = this.head.captions?.[number] ?? this.when(number);
    this.tell(this.distance);
    this.mark();
    this.wish();
  }

  when(number) {
    return this.head.times.length > 1 ? `t = ${this.head.times[number].toPrecision(4)} s` : "";
  }

  key(event) {
    const last = this.head.times.length - 1, step = event.shiftKey ? 10 : 1;
    const actions = {
      " ": () => this.play(!this.playing),
      ArrowRight: () => this.go(step),
      ArrowLeft: () => this.go(-step),
      "]": () => this.go(1),
      "[": () => this.go(-1),
      Home: () => this.show(0),
      End: () => this.show(last),
      a: () => this.look(this.head.camera),
      o: () => this.parallel(),
      "?": () => this.panels.help(KEYS),
      e: () => this.edges(),
      d: () => this.dark(),
    };
    if (!actions[event.key] || event.ctrlKey || event.metaKey || event.target.type === "text") return;
    event.preventDefault();
    actions[event.key]();
  }

  step(now) {
    if (!this.playing) return;
    if (!this.since) this.since = now - (this.frame / this.head.rate / this.times.speed) * 1000;
    const number = Math.floor(((now - this.since) / 1000) * this.head.rate * this.times.speed);
    if (number >= this.head.times.length && this.film) this.shoot();
    else if (number >= this.head.times.length) this.head.again ? ((this.since = now), this.show(0)) : this.play(false);
    else if (number !== this.frame) this.show(Math.max(number, 0));
  }
}
