// Curves over each other, on axes with round numbers. A drag zooms, a double click shows all again; the point below the mouse is told.
import { element } from "./view.js";

const COLORS = ["#3359e6", "#d92626", "#26a633", "#c77700", "#8a3fd1", "#00838f"];
const LEFT = 64, RIGHT = 12, TOP = 22, BOTTOM = 36;
const NEAR = 20; // pixels from a point at which it is told
const ROUND_OFF = 1e-11; // of numbers: axes are not narrower than that, and their ticks differ

const power = (value) => 10 ** Math.floor(Math.log10(value));

const isWide = (low, high) => high - low > ROUND_OFF * Math.max(Math.abs(low), Math.abs(high));

function text(value) {
  const size = Math.abs(value);
  return size !== 0 && (size >= 1e5 || size < 1e-3) ? value.toExponential().replace("e+", "e") : String(value);
}

// Round numbers between two ends, some five of them.
function ticks(low, high, log) {
  if (log) {
    const found = [], wide = high - low;
    for (let k = Math.floor(low); k <= Math.ceil(high); k += Math.max(Math.ceil(wide / 8), 1))
      for (const part of wide < 2 ? [1, 2, 5] : [1]) found.push(part * 10 ** k);
    const inside = found.filter((value) => Math.log10(value) >= low - 1e-9 && Math.log10(value) <= high + 1e-9);
    if (inside.length > 1) return inside.map((value) => Number(value.toPrecision(3)));
    return ticks(10 ** low, 10 ** high, false);
  }
  const rough = (high - low) / 5, base = power(rough), step = base * [1, 2, 5, 10].find((part) => part * base >= rough * 0.999);
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) found.push(Number((k * step).toPrecision(12)));
  return found;
}

export class Plot {
  constructor(parent, width, height) {
    this.canvas = element(parent, "canvas", { className: "plot" });
    this.size(width, height);
    this.canvas.addEventListener("pointerdown", (event) => (this.from = this.to = this.at(event)));
    this.canvas.addEventListener("pointermove", (event) => this.point(event));
    this.canvas.addEventListener("pointerup", () => this.zoom());
    this.canvas.addEventListener("pointerleave", () => ((this.mouse = this.from = null), this.draw()));
    this.canvas.addEventListener("dblclick", () => ((this.window = null), this.draw()));
  }

  size(width, height) {
    const fine = window.devicePixelRatio || 1;
    Object.assign(this, { width, height, fine });
    Object.assign(this.canvas, { width: width * fine, height: height * fine });
    Object.assign(this.canvas.style, { width: `${width}px`, height: `${height}px` });
    this.draw();
  }

  // {title, xLabel, yLabel, logx, logy, marks, now, curves: [{name, x, y}]}; numbers may be null; `now` is a place to mark.
  set(data) {
    this.data = data;
    this.draw();
  }

  at({ offsetX, offsetY }) {
    return [offsetX, offsetY];
  }

  point(event) {
    this.mouse = this.at(event);
    if (this.from) this.to = this.mouse;
    this.draw();
  }

  zoom() {
    const { from, to } = this;
    this.from = null;
    if (from && Math.abs(from[0] - to[0]) > 5 && Math.abs(from[1] - to[1]) > 5) {
      const [a, b] = [from[0], to[0]].map((x) => this.back[0](x)).sort((p, q) => p - q);
      const [c, d] = [from[1], to[1]].map((y) => this.back[1](y)).sort((p, q) => p - q);
      if (isWide(a, b) && isWide(c, d)) this.window = [a, b, c, d];
    }
    this.draw();
  }

  // As it is drawn: logarithms on logarithmic axes; NaN for what cannot be drawn.
  scaled(value, log) {
    return value == null || (log && value <= 0) ? NaN : log ? Math.log10(value) : value;
  }

  range(name, log) {
    let low = Infinity, high = -Infinity;
    for (const curve of this.data.curves)
      for (const value of curve[name]) {
        const number = this.scaled(value, log);
        if (number < low) low = number;
        if (number > high) high = number;
      }
    if (low > high) return [0, 1];
    const wide = isWide(low, high), more = wide ? 0.03 * (high - low) : Math.max(0.5 * Math.abs(low), 0.5);
    return name === "x" && wide ? [low, high] : [low - more, high + more];
  }

  draw() {
    if (!this.data) return;
    const pen = this.canvas.getContext("2d"), { width, height, data } = this, { curves, logx, logy } = data;
    const [a, b, c, d] = this.window ?? [...this.range("x", logx), ...this.range("y", logy)];
    const across = (value) => LEFT + ((value - a) / (b - a)) * (width - LEFT - RIGHT);
    const down = (value) => TOP + ((d - value) / (d - c)) * (height - TOP - BOTTOM);
    this.back = [(x) => a + ((x - LEFT) / (width - LEFT - RIGHT)) * (b - a), (y) => d - ((y - TOP) / (height - TOP - BOTTOM)) * (d - c)];
    pen.setTransform(this.fine, 0, 0, this.fine, 0, 0);
    pen.clearRect(0, 0, width, height);
    pen.font = "11px system-ui, sans-serif";
    pen.lineWidth = 1;
    this.axes(pen, [a, b, c, d], across, down);
    pen.save();
    pen.beginPath();
    pen.rect(LEFT, TOP, width - LEFT - RIGHT, height - TOP - BOTTOM);
    pen.clip();
    this.drawn = curves.map(({ x, y }, k) => this.curve(pen, x, y, COLORS[k % COLORS.length], across, down));
    pen.fillStyle = getComputedStyle(this.canvas).color;
    if (data.now != null) pen.fillRect(across(data.now), TOP, 1, height - TOP - BOTTOM);
    pen.restore();
    this.legend(pen);
    this.hint(pen);
    if (this.from) pen.strokeRect(this.from[0], this.from[1], this.to[0] - this.from[0], this.to[1] - this.from[1]);
  }

  axes(pen, [a, b, c, d], across, down) {
    const { width, height, data } = this, ink = getComputedStyle(this.canvas).color;
    pen.fillStyle = pen.strokeStyle = ink;
    for (const [low, high, log, place, upright] of [[a, b, data.logx, across, true], [c, d, data.logy, down, false]]) {
      for (const value of ticks(low, high, log)) {
        const at = place(log ? Math.log10(value) : value);
        pen.globalAlpha = 0.15;
        pen.beginPath();
        if (upright) pen.moveTo(at, TOP), pen.lineTo(at, height - BOTTOM);
        else pen.moveTo(LEFT, at), pen.lineTo(width - RIGHT, at);
        pen.stroke();
        pen.globalAlpha = 1;
        pen.textAlign = upright ? "center" : "right";
        pen.fillText(text(value), upright ? at : LEFT - 5, upright ? height - BOTTOM + 14 : at + 4);
      }
    }
    pen.strokeRect(LEFT, TOP, width - LEFT - RIGHT, height - TOP - BOTTOM);
    pen.textAlign = "center";
    pen.fillText(data.xLabel ?? "", (LEFT + width - RIGHT) / 2, height - 5);
    pen.textAlign = "left";
    pen.fillText(data.title || data.yLabel || "", 4, 13);
  }

  // Draw a curve, with gaps where there is no number; return its points in pixels.
  curve(pen, xs, ys, color, across, down) {
    const { logx, logy, marks } = this.data, points = [];
    pen.strokeStyle = pen.fillStyle = color;
    pen.lineWidth = 1.5;
    pen.beginPath();
    let inside = false;
    for (let i = 0; i < xs.length; ++i) {
      const x = across(this.scaled(xs[i], logx)), y = down(this.scaled(ys[i], logy)), known = Number.isFinite(x + y);
      if (known) inside ? pen.lineTo(x, y) : pen.moveTo(x, y);
      if (known) points.push([x, y, xs[i], ys[i]]);
      inside = known;
    }
    pen.stroke();
    const last = points.at(-1);
    if (last && (marks || points.length === 1)) {
      pen.beginPath();
      pen.arc(last[0], last[1], 3.5, 0, 7);
      pen.fill();
    }
    return points;
  }

  legend(pen) {
    const named = this.data.curves.filter(({ name }) => name).slice(0, 14);
    pen.textAlign = "right";
    named.forEach(({ name }, k) => {
      pen.fillStyle = COLORS[k % COLORS.length];
      pen.fillText(name, this.width - RIGHT - 6, TOP + 14 + 14 * k);
    });
  }

  hint(pen) {
    if (!this.mouse || this.from) return;
    let best = null, distance = NEAR;
    for (const points of this.drawn)
      for (const point of points) {
        const off = Math.hypot(point[0] - this.mouse[0], point[1] - this.mouse[1]);
        if (off < distance) (distance = off), (best = point);
      }
    this.told = best && `${text(Number(best[2].toPrecision(6)))}, ${text(Number(best[3].toPrecision(6)))}`;
    if (!best) return;
    pen.fillStyle = getComputedStyle(this.canvas).color;
    pen.beginPath();
    pen.arc(best[0], best[1], 3, 0, 7);
    pen.fill();
    pen.textAlign = best[0] > this.width / 2 ? "right" : "left";
    pen.fillText(this.told, best[0] + (best[0] > this.width / 2 ? -8 : 8), best[1] - 8);
  }
}
