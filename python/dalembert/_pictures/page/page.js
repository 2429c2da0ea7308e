// Which page it is: that of a motion has its data in it, the live one gets them from the server that it came from, and a widget from its kernel.
import { read } from "./data.js";
import { Socket } from "./link.js";
import { Live } from "./live.js";
import { Monitor } from "./monitor.js";
import { Motion } from "./motion.js";

export { widget } from "./notebook.js";

const place = document.currentScript && document.getElementById("page"), data = document.getElementById("data"); // a widget is a module
if (place && data) {
  read(data.textContent.trim()).then(({ head, arrays }) => {
    document.title = head.title;
    window.page = new Motion(place, head, arrays);
  });
} else if (place) {
  const token = location.hash.slice(1);
  history.replaceState(null, "", "/"); // it is not to be seen, nor to be in the history
  const link = new Socket(token || sessionStorage.getItem("token") || "");
  window.page = place.dataset.shows === "monitor" ? new Monitor(place, link) : new Live(place, link);
}
