// The picture of a view that is saved: what is drawn, and the texts, the bar of colors and the frames of other views in front of it.
const SHOWN = ".pane, .axes, .contour span, .time, .labels span, .contour div, .contour i";

const RATE = 30; // pictures of a film per second, at most
const BITS = 8e6; // per second of a film
const KEPT = 60000; // ms that a film is kept for the browser to save it
const FILMS = ["video/mp4", "video/webm"]; // the first that the browser can make

export function download(href, name) {
  Object.assign(document.createElement("a"), { href, download: name }).click();
}

// A film of a view, in real time.
export class Film {
  constructor(place, canvas) {
    Object.assign(this, { place, canvas, made: document.createElement("canvas"), parts: [] });
    this.add();
    this.type = FILMS.find((type) => MediaRecorder.isTypeSupported(type));
    this.recorder = new MediaRecorder(this.made.captureStream(RATE), { mimeType: this.type, videoBitsPerSecond: BITS });
    this.recorder.ondataavailable = ({ data }) => this.parts.push(data);
    this.recorder.onstop = () => {
      const address = URL.createObjectURL(new Blob(this.parts, { type: this.type }));
      download(address, `film.${this.type.slice(6)}`);
      setTimeout(() => URL.revokeObjectURL(address), KEPT);
    };
    this.recorder.start();
  }

  add() {
    flat(this.place, this.canvas, this.made);
  }

  end() {
    this.recorder.stop();
    for (const track of this.recorder.stream.getTracks()) track.stop();
  }
}

export function flat(place, canvas, made = document.createElement("canvas")) {
  const { left, top, width } = canvas.getBoundingClientRect(), fine = canvas.width / width, pen = made.getContext("2d");
  if (made.width !== canvas.width || made.height !== canvas.height) Object.assign(made, { width: canvas.width, height: canvas.height });
  pen.resetTransform();
  pen.drawImage(canvas, 0, 0);
  pen.scale(fine, fine);
  pen.translate(-left, -top);
  for (const part of place.querySelectorAll(SHOWN)) if (part.closest(".page") === place) add(pen, part);
  return made;
}

function add(pen, part) {
  const style = getComputedStyle(part), box = part.getBoundingClientRect();
  if (style.visibility === "hidden" || !box.width) return;
  if (part.tagName === "CANVAS") return pen.drawImage(part, box.left, box.top, box.width, box.height);
  pen.fillStyle = style.backgroundColor;
  pen.fillRect(box.left, box.top, box.width, box.height);
  pen.strokeStyle = style.borderTopColor;
  if (parseFloat(style.borderTopWidth)) pen.strokeRect(box.left, box.top, box.width, box.height);
  if (part.children.length) return; // these have the texts
  pen.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
  pen.fillStyle = style.color;
  const lines = part.textContent.split("\n"), height = box.height / lines.length;
  pen.textBaseline = "middle";
  lines.forEach((line, i) => pen.fillText(line, box.left, box.top + (i + 0.5) * height));
}
