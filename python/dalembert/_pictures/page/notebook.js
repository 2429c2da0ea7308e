// The widget of a notebook: the live page in a cell. Until the kernel answers nothing is shown, and the picture that is saved with the
// notebook (opening.py) stays where it is; when the kernel does, that is hidden.
import { Channel } from "./link.js";
import { Live } from "./live.js";
import { element } from "./view.js";

export function widget(style) {
  return {
    render({ model, el }) {
      const name = model.get("still"), root = el.attachShadow({ mode: "open" });
      el.dataset.lmSuppressShortcuts = "true"; // keys are those of the page here
      element(root, "style", { textContent: style });
      const place = element(root, "div", { className: "page inset", hidden: true });
      const link = new Channel(model);
      const live = new Live(place, link, { keys: place, first: () => show(true) });
      const rule = document.createElement("style"); // the picture may come later, or anew
      rule.textContent = `[data-dalembert-still="${name}"] { display: none }`;
      const show = (flag) => {
        place.hidden = !flag;
        if (flag) document.head.append(rule);
        else rule.remove();
        live.resize();
      };
      const { canvas, controls } = live; // the wheel scrolls the notebook, unless the reader has clicked
      controls.enableZoom = false;
      canvas.addEventListener("pointerdown", () => canvas.focus());
      canvas.addEventListener("focus", () => (controls.enableZoom = true));
      canvas.addEventListener("blur", () => (controls.enableZoom = false));
      if (document.body.dataset.jpThemeLight === "false") live.dark();
      const seen = () => live.send("seen", { flag: !document.hidden });
      document.addEventListener("visibilitychange", seen);
      el.live = live;
      return () => {
        document.removeEventListener("visibilitychange", seen);
        link.end();
        live.end();
        show(false);
      };
    },
  };
}
