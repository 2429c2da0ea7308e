// Other views of the same scene, in small windows at the right edge of the main one: each is turned, moved and zoomed by itself.
import { PerspectiveCamera, Vector2 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { element, look, looking, planes, reach } from "./view.js";

export class Pane {
  // `number` is that of the view, from 1 to 3; `clip` a plane that cuts the scene in this view, as cut() of views takes it.
  constructor(view, number, camera, clip) {
    this.view = view;
    this.number = number;
    this.clip = planes(...clip);
    this.window = element(view.place, "div", { className: "pane", tabIndex: 0, title: `view ${number}` });
    this.window.style.top = `${4 + 29 * (number - 1)}%`;
    this.camera = new PerspectiveCamera(view.camera.fov, 1, 0.01, 1000);
    this.controls = new OrbitControls(this.camera, this.window);
    this.controls.addEventListener("change", () => (reach(this.camera, this.controls), (this.turned ||= !this.led), view.wish()));
    this.window.addEventListener("pointermove", (event) => view.point(event, this));
    this.window.addEventListener("pointerdown", (event) => (view.down = [event.clientX, event.clientY]));
    this.window.addEventListener("pointerup", (event) => view.isClick(event) && view.click(event, this));
    this.window.addEventListener("contextmenu", (event) => event.preventDefault());
    view.scene.add(this.camera);
    this.lead(camera);
  }

  // Look as it is said; it need not be told.
  lead(camera) {
    this.led = true;
    look(this.camera, this.controls, camera);
    this.led = false;
    this.view.wish();
  }

  looking() {
    return looking(this.camera, this.controls);
  }

  // What the canvas shows where the window is; lamps go from camera to camera.
  render() {
    const { renderer, scene, lamps, canvas } = this.view, { offsetLeft: left, offsetTop: top, clientWidth: width, clientHeight: height } = this.window;
    if (!width || !height) return;
    if (Math.abs(this.camera.aspect - width / height) > 1e-6) {
      this.camera.aspect = width / height;
      this.camera.updateProjectionMatrix();
    }
    const others = renderer.clippingPlanes, size = renderer.getSize(new Vector2());
    const place = [left, canvas.clientHeight - top - height, width, height];
    this.camera.add(...lamps);
    renderer.clippingPlanes = this.clip;
    renderer.setViewport(...place);
    renderer.setScissor(...place);
    renderer.setScissorTest(true);
    renderer.render(scene, this.camera);
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, size.x, size.y);
    renderer.clippingPlanes = others;
    this.view.camera.add(...lamps);
  }

  end() {
    this.view.scene.remove(this.camera);
    this.controls.dispose();
    this.window.remove();
  }
}
