// The directions of the global axes, in a corner of the page.
import { Vector3 } from "three";

const COLORS = ["#d92626", "#26a633", "#3359e6"];

export function axes(place) {
  const canvas = place.appendChild(document.createElement("canvas")), size = 90, fine = window.devicePixelRatio || 1;
  canvas.className = "axes";
  canvas.width = canvas.height = size * fine;
  const pen = canvas.getContext("2d"), direction = new Vector3();
  return (camera) => {
    pen.setTransform(fine, 0, 0, fine, 0, 0);
    pen.clearRect(0, 0, size, size);
    const seen = [0, 1, 2].map((i) => {
      direction.set(i === 0, i === 1, i === 2).transformDirection(camera.matrixWorldInverse);
      return { i, x: direction.x, y: -direction.y, z: direction.z };
    });
    for (const { i, x, y } of seen.sort((a, b) => a.z - b.z)) {
      pen.strokeStyle = pen.fillStyle = COLORS[i];
      pen.lineWidth = 2;
      pen.beginPath();
      pen.moveTo(size / 2, size / 2);
      pen.lineTo(size / 2 + 28 * x, size / 2 + 28 * y);
      pen.stroke();
      pen.font = "13px sans-serif";
      pen.textAlign = "center";
      pen.textBaseline = "middle";
      pen.fillText("xyz"[i], size / 2 + 37 * x, size / 2 + 37 * y);
    }
  };
}
