// Panels beside the scene: what is known of an item, settings, the widgets of a dialog, a cutting plane. All texts are set as text.
import { Plot } from "./plot.js";
import { element } from "./view.js";

const PLOT = [320, 190]; // pixels
const LISTED = 200; // items of a kind that are listed; others are found by their names
const VEILED = 0.3; // opacity

export class Panels {
  // `left` is called with the name of a panel that the reader has closed.
  constructor(place, send = () => {}, left = () => {}) {
    Object.assign(this, { place, send, left, open: {}, column: element(place, "div", { className: "column" }) });
  }

  close(name) {
    this.open[name]?.remove();
    delete this.open[name];
  }

  panel(name, title, right = false) {
    this.close(name);
    const beside = right && !this.place.classList.contains("narrow"); // otherwise, all are in one column
    const panel = (this.open[name] = element(beside ? this.place : this.column, "div", { className: beside ? "panel right" : "panel" }));
    panel.dataset.name = name;
    element(panel, "h2", { textContent: title });
    element(panel, "button", { className: "close", textContent: "×", title: "close", onclick: () => (this.close(name), this.left(name)) });
    return panel;
  }

  // Parameters and outputs of an item, with their units; a click on an output plots it, one on a number makes a slider for it.
  details({ title, parameters, outputs, units, time, numbers, item: [system, item, number] }) {
    const old = this.open.details, top = old?.dataset.title === title ? old.scrollTop : 0;
    const panel = this.panel("details", title, true);
    panel.dataset.title = title;
    for (const [name, rows] of [["parameters", parameters], ["outputs", outputs]]) {
      if (name === "outputs" && rows.length) element(panel, "h2", { textContent: `outputs, t = ${time.toPrecision(4)} s` });
      const table = element(panel, "table");
      for (const [key, value] of rows) {
        const line = element(table, "tr"), cell = element(line, "td");
        const link = (parent, title, onclick) => element(parent, "a", { textContent: key, title, onclick });
        if (name === "outputs") link(cell, "plot it", () => this.send("plot", { name: key }));
        else if (key in numbers) link(cell, "a slider for it", () => this.slider({ system, item, number, name: key }, numbers[key], units[name][key]));
        else cell.textContent = key;
        for (const text of [value, units[name][key] ?? ""]) element(line, "td", { textContent: text });
      }
    }
    panel.scrollTop = top;
  }

  // A slider, and a field, for a number of an item: {system, item, number, name}.
  slider(words, value, unit = "") {
    const panel = this.open.sliders ?? this.panel("sliders", "parameters"), key = JSON.stringify(words);
    for (const old of panel.querySelectorAll(".plotted")) if (old.dataset.key === key) old.remove();
    const row = element(panel, "div", { className: "plotted" });
    row.dataset.key = key;
    element(row, "div", { textContent: `${words.item.toLowerCase()} ${words.number}: ${words.name}${unit && ` (${unit})`}` });
    const ends = value ? [Math.min(2 * value, 0), Math.max(2 * value, 0)] : [-1, 1], [min, max] = ends;
    const slider = element(row, "input", { type: "range", min, max, step: (max - min) / 1000, value });
    const field = element(row, "input", { type: "text", value: value.toPrecision(6) });
    let last = value;
    const tell = (now) => this.send("parameter", { ...words, value: (last = now) });
    slider.oninput = () => ((field.value = Number(slider.value).toPrecision(6)), tell(Number(slider.value)));
    field.onchange = () => {
      const now = field.value.trim() ? Number(field.value) : NaN;
      if (Number.isFinite(now)) (slider.value = now), tell(now);
      else field.value = last.toPrecision(6); // it is no number
    };
    element(row, "button", { className: "close", textContent: "×", title: "remove", onclick: () => (row.remove(), panel.querySelector(".plotted") ?? this.close("sliders")) });
  }

  // Plots of outputs beside the view; each has a button that removes it.
  outputs(curves) {
    if (!curves.length) return this.close("outputs");
    const titles = JSON.stringify(curves.map(({ title }) => title));
    if (this.open.outputs?.dataset.titles !== titles) {
      const panel = this.panel("outputs", "plots");
      panel.dataset.titles = titles;
      this.chosen = curves.map((_, drop) => {
        const row = element(panel, "div", { className: "plotted" });
        element(row, "button", { className: "close", textContent: "×", title: "remove this plot", onclick: () => this.send("plot", { drop }) });
        return new Plot(row, ...PLOT);
      });
    }
    curves.forEach((data, i) => this.chosen[i].set({ ...data, now: this.chosen[i].data?.now }));
  }

  // Mark a time in plots of outputs.
  mark(now) {
    if (!this.open.outputs) return;
    for (const plot of this.chosen) plot.set({ ...plot.data, now });
  }

  settings(rows) {
    const panel = this.panel("settings", "visualization settings"), branches = { "": panel };
    for (const { path, branch, value, choices, help } of rows) {
      const at = path.lastIndexOf("."), name = path.slice(at + 1), parent = branches[path.slice(0, Math.max(at, 0))];
      if (branch) {
        branches[path] = element(parent, "details");
        element(branches[path], "summary", { textContent: name });
        continue;
      }
      const row = element(parent, "label", { title: help });
      element(row, "span", { textContent: `${name} ` });
      const set = (text) => this.send("set", { path, value: text });
      if (choices.length) {
        const select = element(row, "select", { onchange: () => set(select.value) });
        for (const text of choices) element(select, "option", { value: text, textContent: text, selected: text === value });
      } else {
        const input = element(row, "input", { type: "text", value, onchange: () => set(input.value) });
      }
    }
  }

  // All items of a view: a search, and for each item whether it is shown, transparent, or alone.
  items(view) {
    const words = this.open.items?.querySelector("input").value ?? "", panel = this.panel("items", "items");
    panel.shown = JSON.stringify(view.items);
    const opened = (this.opened ??= new Set(["Object"])), list = document.createElement("div");
    const refill = () => (fill(), view.canvas.focus());
    const fill = () => {
      list.replaceChildren();
      const kinds = {}, wanted = search.value.toLowerCase();
      view.items.forEach(([kind, number, type, name], i) => {
        if (`${kind} ${number} ${name} ${kind}${type}`.toLowerCase().includes(wanted)) (kinds[kind] ??= []).push(i);
      });
      for (const [kind, numbers] of Object.entries(kinds)) {
        const open = opened.has(kind) || !!wanted, group = element(list, "details", { open }), head = element(group, "summary");
        group.ontoggle = () => opened[group.open ? "add" : "delete"](kind);
        this.shown(head, view, numbers, `${kind.toLowerCase()}s (${numbers.length})`, refill);
        for (const i of numbers.slice(0, LISTED)) {
          const [, number, type, name] = view.items[i], row = element(group, "div", { className: "item" });
          this.shown(row, view, [i], "", refill);
          element(row, "a", { textContent: `${number} ${name}`, title: `${kind}${type}`, onclick: () => view.pick({ number: i, distance: 0 }) });
          const button = (textContent, title, act) => element(row, "button", { textContent, title, onclick: () => (act(), refill()) });
          button("◐", "transparent or not", () => view.veil([i], view.opacity(i) === VEILED ? 1 : VEILED));
          button("◉", "show this item only", () => (view.veil(view.items.keys(), 0), view.veil([i], 1)));
          button("⊕", "zoom to this item", () => view.approach(i));
        }
        if (numbers.length > LISTED) element(group, "div", { textContent: `${numbers.length - LISTED} more: search by number, name or type` });
      }
    };
    const search = element(panel, "input", { type: "text", value: words, placeholder: "number, name or type", oninput: fill });
    element(panel, "button", { textContent: "show all", onclick: () => (view.veil(view.items.keys(), 1), refill()) });
    panel.append(list);
    fill();
  }

  // A check box that shows and hides items.
  shown(parent, view, numbers, text, changed) {
    const label = element(parent, "label"), checked = numbers.some((number) => view.opacity(number));
    element(label, "input", { type: "checkbox", checked, title: "show", onchange: ({ target }) => (view.veil(numbers, target.checked ? 1 : 0), changed()) });
    element(label, "span", { textContent: text });
  }

  // Keys and what the mouse does: [key, action].
  help(rows) {
    if (this.open.help) return this.close("help");
    const table = element(this.panel("help", "mouse and keys"), "table");
    for (const row of rows) {
      const line = element(table, "tr");
      for (const textContent of row) element(line, "td", { textContent });
    }
  }

  // A plane across one axis; what is beyond it is left out.
  cut(apply, { center, size }) {
    const panel = this.panel("cut", "cut");
    const choice = element(panel, "select");
    for (const name of ["x", "y", "z", "-x", "-y", "-z"]) element(choice, "option", { textContent: name, value: name });
    const slider = element(panel, "input", { type: "range", min: -1, max: 1, step: 0.005, value: 0 });
    const go = () => {
      const axis = "xyz".indexOf(choice.value.at(-1)), sign = choice.value.length > 1 ? -1 : 1, normal = [0, 0, 0];
      normal[axis] = sign;
      apply([...normal, sign * (center[axis] + Number(slider.value) * size)]);
    };
    choice.onchange = slider.oninput = go;
    element(panel, "button", { textContent: "whole", onclick: () => (apply([0, 0, 0, 0]), this.close("cut")) });
    go();
  }

  // The widgets of a dialog in their grid: {type, text, grid: [row, column], name, value, low, high, step, options}.
  controls({ title, widgets, values = {} }) {
    if (!widgets) return this.close("controls"); // the dialog is over
    const panel = this.panel("controls", title);
    const grid = element(panel, "div");
    Object.assign(grid.style, { display: "grid", gap: "4px 10px", alignItems: "center" });
    for (const widget of widgets) {
      const cell = element(grid, "div");
      if (widget.grid) [cell.style.gridRow, cell.style.gridColumn] = widget.grid.map((place) => place + 1);
      this.widget(cell, { ...widget, value: values[widget.name] ?? widget.value });
    }
    this.curves = element(panel, "div");
    this.plots = [];
  }

  widget(cell, { type, text, name, value, low, high, step, options }) {
    const tell = (now) => this.send("control", { name, value: now });
    if (type === "label") element(cell, "span", { textContent: text });
    else if (type === "button") element(cell, "button", { textContent: text, onclick: () => this.send("control", { name, pressed: true }) });
    else if (type === "check") {
      const row = element(cell, "label"), box = element(row, "input", { type: "checkbox", checked: !!value, onchange: () => tell(box.checked) });
      element(row, "span", { textContent: ` ${text ?? ""}` });
    } else if (type === "radio") {
      for (const [label, choice] of options) {
        const row = element(cell, "label");
        element(row, "input", { type: "radio", name, checked: choice === value, onchange: () => tell(choice) });
        element(row, "span", { textContent: ` ${label}` });
      }
    } else if (type === "slider") {
      const shown = element(cell, "span", { textContent: Number(value).toPrecision(4) });
      const slider = element(cell, "input", { type: "range", min: low, max: high, step, value });
      slider.oninput = () => ((shown.textContent = Number(slider.value).toPrecision(4)), tell(Number(slider.value)));
    } else if (type === "entry") {
      const input = element(cell, "input", { type: "text", value, onchange: () => tell(input.value) });
    }
  }

  // Curves: [{title, x, y: [numbers of each curve]}].
  plot(curves) {
    if (!this.open.controls) return;
    curves.forEach(({ title, x, y }, i) => {
      const plot = (this.plots[i] ??= new Plot(this.curves, ...PLOT));
      plot.set({ title, curves: y.map((numbers) => ({ x, y: numbers })) });
    });
  }
}
