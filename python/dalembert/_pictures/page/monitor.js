// The page of the results monitor: curves of a file, which come anew whenever it has grown.
import { Plot } from "./plot.js";
import { element } from "./view.js";

export class Monitor {
  constructor(place, link) {
    Object.assign(this, { place, link, plots: [], updates: 0 });
    place.classList.add("monitor");
    this.title = element(place, "h2");
    this.state = element(place, "div", { className: "words" });
    this.grid = element(place, "div", { className: "grid" });
    element(place, "button", { className: "corner", textContent: "dark", title: "dark or light", onclick: () => this.dark() });
    this.watcher = new ResizeObserver(() => this.resize());
    this.watcher.observe(this.grid);
    link.start(this);
  }

  opened() {}

  closed(words) {
    this.state.textContent = this.stopped ? "closed" : words;
  }

  draw() {}

  take(words) {
    if (words.kind === "stopped") this.stopped = true;
    if (words.kind !== "curves") return;
    document.title = this.title.textContent = words.title;
    this.state.textContent = words.state;
    words.plots.forEach((data, i) => {
      this.plots[i] ??= new Plot(this.grid, ...this.extent(words.plots.length));
      this.plots[i].set(data);
    });
    for (const plot of this.plots.splice(words.plots.length)) plot.canvas.remove();
    this.updates += 1;
  }

  // Width and height of each plot, so that all are seen.
  extent(count) {
    const { clientWidth: width, clientHeight: height } = this.grid, columns = Math.min(count, Math.max(Math.round(width / 420), 1));
    return [Math.max(width / columns - 12, 240), Math.max(Math.min(height / Math.ceil(count / columns) - 12, 0.8 * width / columns), 180)];
  }

  resize() {
    for (const plot of this.plots) plot.size(...this.extent(this.plots.length));
  }

  dark() {
    this.place.classList.toggle("dark");
    for (const plot of this.plots) plot.draw();
  }
}
