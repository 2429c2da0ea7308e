// The picture of a view that is saved: what is drawn, and the texts, the bar of colors and the frames of other views in front of it.
const SHOWN = ".pane, .axes, .contour span, .time, .labels span, .contour div, .contour i";

export function flat(place, canvas) {
  const { left, top, width } = canvas.getBoundingClientRect(), fine = canvas.width / width;
  const made = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height }), pen = made.getContext("2d");
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
