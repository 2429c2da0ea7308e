// Which page it is: that of a motion has its data in it, the live one gets them from the server that it came from.
import { read } from "./data.js";
import { Live } from "./live.js";
import { Motion } from "./motion.js";

const place = document.getElementById("page"), data = document.getElementById("data");
if (data) {
  read(data.textContent.trim()).then(({ head, arrays }) => {
    document.title = head.title;
    window.page = new Motion(place, head, arrays);
  });
} else {
  const token = location.hash.slice(1);
  history.replaceState(null, "", "/"); // it is not to be seen, nor to be in the history
  window.page = new Live(place, token || sessionStorage.getItem("token") || "");
}
