// Readers pull a body: with control or command and the left button they hold it at a point, and a spring leads from there to the mouse,
// in the plane through that point that is parallel to the window. Solvers compute the force; the line shows where it acts.
import { Plane, Vector3 } from "three";

const GRAVITY = 9.81; // m/s^2
const PULL = 5; // times gravity: acceleration of a body from which the mouse is half the height of the view away
const BODIES = ["Object", "Node"]; // nodes stand for the bodies on them

export class Grip {
  constructor(view) {
    Object.assign(this, { view, held: null, factor: 1, count: 0, name: Math.random().toString(36).slice(2) });
    const hear = (kind, act) => view.place.addEventListener(kind, act, { capture: true, passive: false }); // before the view turns
    hear("pointerdown", (event) => this.take(event));
    hear("pointermove", (event) => this.move(event));
    for (const kind of ["pointerup", "pointercancel", "lostpointercapture"]) hear(kind, (event) => this.leave(event));
    hear("wheel", (event) => this.stiffen(event));
  }

  take(event) {
    const { view } = this, pane = view.panes.find(({ window }) => window === event.target);
    if (this.held || event.button || !(event.ctrlKey || event.metaKey) || !(pane || event.target === view.canvas)) return;
    const hit = view.hit(event.clientX, event.clientY, pane, BODIES);
    if (!hit) return; // the view moves
    event.stopPropagation();
    event.target.setPointerCapture(event.pointerId);
    const { camera } = pane ?? view, plane = new Plane().setFromNormalAndCoplanarPoint(camera.getWorldDirection(new Vector3()), hit.point);
    const stiffness = (PULL * GRAVITY) / (pane ?? view).looking().zoom; // per mass
    this.held = { pointer: event.pointerId, id: `${this.name} ${++this.count}`, pane, hit, plane, stiffness, scene: view.number, time: view.now, target: null };
    this.point = hit.point;
    view.down = [event.clientX, event.clientY];
  }

  move(event) {
    const { held, view } = this;
    if (held?.pointer !== event.pointerId) return;
    event.stopPropagation();
    if (!held.target && view.isClick(event)) return;
    const target = view.ray(event.clientX, event.clientY, held.pane).ray.intersectPlane(held.plane, new Vector3());
    if (target) this.pull(target);
  }

  pull(target) {
    const { held, view } = this, { id, hit, scene, time } = held, begins = held.target ? {} : { item: hit.number, scene, time, point: [...hit.point] };
    held.target = target;
    view.send("pull", { id, ...begins, target: [...target], strength: this.strength() });
    this.draw();
  }

  strength() {
    return this.factor * this.held.stiffness;
  }

  // Without a drag it was a click.
  leave(event) {
    const { held, view } = this;
    if (held?.pointer !== event.pointerId) return;
    event.stopPropagation();
    this.release();
    if (!held.target && event.type === "pointerup" && view.isClick(event)) view.click(event, held.pane);
  }

  // Let go of what is held.
  release() {
    const { held } = this;
    this.drop();
    if (held?.target) this.view.send("release", { id: held.id });
  }

  stiffen(event) {
    if (!this.held) return;
    event.preventDefault(); // with control, the browser would zoom
    event.stopPropagation();
    this.factor *= event.deltaY < 0 ? 2 : 0.5;
    if (this.held.target) this.pull(this.held.target);
  }

  // Where a body is held now, by this reader or by one of another page; no point: it has been released.
  tell({ id, point, target }) {
    if (this.held && this.held.id !== id) return; // of one before, or of another page
    if (point) (this.point = new Vector3(...point)), this.draw(this.held?.target ?? new Vector3(...target));
    else this.drop();
  }

  draw(target = this.held.target) {
    this.view.join("string", [this.point, target]);
    this.words = this.held?.target ? `pull: ${(this.strength() * this.point.distanceTo(target)).toPrecision(3)} m/s² x mass (wheel: stiffer, softer)` : "";
    this.view.caption();
  }

  drop() {
    this.held = null;
    this.words = "";
    this.view.join("string", null);
    this.view.caption();
  }
}
