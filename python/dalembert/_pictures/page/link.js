// How a live page reaches the viewer that draws for it: by the socket of the server that it came from, or by the channel of a notebook.
import { message } from "./data.js";

const AGAIN = 1000; // ms until a lost connection is tried again

export class Socket {
  constructor(token) {
    this.token = token;
  }

  start(live) {
    this.live = live;
    this.socket = new WebSocket(`ws://${location.host}/socket`);
    this.socket.binaryType = "arraybuffer";
    this.socket.onopen = () => {
      this.socket.send(JSON.stringify({ kind: "hello", token: this.token }));
      sessionStorage.setItem("token", this.token); // of this tab, for when it is loaded again
      live.opened();
    };
    this.socket.onmessage = ({ data }) => (typeof data === "string" ? live.take(JSON.parse(data)) : live.draw(message(data)));
    this.socket.onclose = ({ code, reason }) => {
      live.closed(code === 1008 ? `refused: ${reason}` : "no connection");
      if (code !== 1008 && !live.stopped) setTimeout(() => this.start(live), AGAIN);
    };
  }

  send(words) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(words));
  }
}

// One view of a widget among several: messages of the kernel name the page that they are for, or none.
export class Channel {
  constructor(model) {
    this.model = model;
    this.page = Math.random().toString(36).slice(2);
  }

  start(live) {
    this.take = ({ page, words }, buffers) => {
      if (page && page !== this.page) return;
      if (words) live.take(words);
      else if (buffers.length) live.draw(message(whole(buffers[0])));
    };
    this.model.on("msg:custom", this.take);
    live.opened();
    this.send({ kind: "hello" });
  }

  send(words) {
    this.model.send({ ...words, page: this.page });
  }

  end() {
    this.model.off("msg:custom", this.take);
    this.send({ kind: "bye" });
  }
}

// The bytes of a part of a buffer, as a buffer of its own: numbers are read where they are aligned.
function whole({ buffer, byteOffset, byteLength }) {
  return buffer.slice(byteOffset, byteOffset + byteLength);
}
