// The bar of recorded times: steps, replay, a slider and a speed.
import { element } from "./view.js";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 10]; // simulated time per time

export class Times {
  // Called with what readers want: `seek` with the number of the slider, `step` with -1 or 1, `play` with true or false, `pace` with a speed.
  constructor(bar, { seek, step, play, pace }) {
    this.bar = bar;
    const button = (textContent, title, onclick) => element(this.bar, "button", { textContent, title, onclick });
    this.button = button("▶", "play or pause the recorded motion", () => play(!this.playing));
    button("◂", "one recorded state back ([)", () => step(-1));
    button("▸", "one recorded state forward (])", () => step(1));
    this.slider = element(this.bar, "input", { type: "range", title: "time" });
    this.slider.oninput = () => seek(Number(this.slider.value));
    const speeds = element(this.bar, "select", { title: "speed of the replay, in parts of real time" });
    for (const speed of SPEEDS) element(speeds, "option", { value: speed, textContent: `${speed} x`, selected: speed === 1 });
    speeds.onchange = () => ((this.speed = Number(speeds.value)), pace(this.speed), speeds.blur());
    this.speed = 1;
  }

  // Ends of the slider, and the distance of its numbers.
  range(min, max, step, count) {
    Object.assign(this.slider, { min, max, step });
    this.bar.hidden = count < 2;
  }

  at(value) {
    this.slider.value = value;
  }

  plays(flag) {
    this.playing = flag;
    this.button.textContent = flag ? "❚❚" : "▶";
  }
}
