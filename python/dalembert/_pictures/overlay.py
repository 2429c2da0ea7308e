"""Overlay of a picture: texts, the axes of the global frame in a corner, the color bar."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
from PIL import Image as Pillow
from PIL import ImageDraw, ImageFont

from dalembert._pictures import contour
from dalembert._pictures.camera import Camera
from dalembert._pictures.looks import Looks
from dalembert._pictures.pen import BLUE, GREEN, RED
from dalembert._pictures.scene import Scene

FINE = 4  # the axes are drawn larger by this factor, for smooth lines


@lru_cache(maxsize=16)
def font(size: int) -> Any:
    """Return the font that comes with matplotlib."""
    import matplotlib

    return ImageFont.truetype(str(Path(matplotlib.get_data_path(), "fonts/ttf/DejaVuSans.ttf")), max(size, 1))


def _bytes(color: Any) -> tuple[int, ...]:
    return tuple(round(255 * min(max(float(c), 0.0), 1.0)) for c in color[:3])


def add(image: npt.NDArray[np.uint8], scene: Scene, camera: Camera, looks: Looks, view: Any) -> npt.NDArray[np.uint8]:
    """Return the image with texts, axes and bar of colors."""
    canvas = Pillow.fromarray(image)
    size = min(float(view.window.globalFontSize), float(max(canvas.size)))  # larger letters are not seen
    ink = _bytes(looks.setting("general.textColor"))
    _add_labels(canvas, scene, camera, looks, size)
    lines = list(scene.information)
    if looks.setting("general.renderWindowString"):
        lines.insert(0, str(looks.setting("general.renderWindowString")))
    if (
        view.window.showComputationInfo
        and looks.setting("general.showSolverTime")
        and (scene.time != 0 or scene.of_motion)
    ):
        lines.append(f"t = {scene.time:.{max(int(looks.setting('general.rendererPrecision')), 1)}g} s")
    if lines:
        ImageDraw.Draw(canvas).text((1.2 * size, size), "\n".join(lines), ink, font(round(1.15 * size)))
    if int(view.scene.drawCoordinateSystem) > 0 and min(canvas.size) > 150:
        _add_axes(canvas, camera, looks, size)
    if scene.value_name and looks.setting("contour.advanced.showColorBar"):
        _add_bar(canvas, scene, looks, size, ink)
    return np.asarray(canvas)


def _add_labels(canvas: Pillow.Image, scene: Scene, camera: Camera, looks: Looks, size: float) -> None:
    if not scene.labels:
        return
    draw = ImageDraw.Draw(canvas)
    largest = float(max(canvas.size))
    places = camera.pixels(np.array([label.place for label in scene.labels]), *canvas.size)
    standing: dict[tuple[int, int], float] = {}  # how far down texts at one point reach
    for label, (x, y, _) in zip(scene.labels, places, strict=True):
        if not (-largest < x < 2 * largest and -largest < y < 2 * largest):
            continue  # far from the image, or nowhere
        height = round(min(max(label.size or size, 4), largest))
        letters, point = font(height), (round(x), round(y))
        below = standing.get(point, 0.0)
        standing[point] = below + 1.2 * height
        at = (x + label.shift[0] * size + 2, y - label.shift[1] * size - 2 + below)
        halo = 2 if looks.setting("general.textHasBackground") else 1
        draw.text(at, label.text, _bytes(label.color), letters, "ls", stroke_width=halo, stroke_fill=(255, 255, 255))


def _add_axes(canvas: Pillow.Image, camera: Camera, looks: Looks, size: float) -> None:
    """Draw the directions of the global axes in the lower left corner, the nearest one last."""
    half = round(min(float(looks.setting("general.coordinateSystemSize")) * size * 0.9, 0.5 * min(canvas.size)))
    if half < 1:
        return
    sheet = Pillow.new("RGBA", (2 * half * FINE, 2 * half * FINE), (255, 255, 255, 0))
    draw, middle = ImageDraw.Draw(sheet), half * FINE
    axes = camera.rotation.T  # a row per axis: right, up, towards the viewer
    for i in np.argsort(axes[:, 2]):
        color = (*_bytes((RED, GREEN, BLUE)[i]), 255)
        along = axes[i, :2] * [1, -1]
        length = float(np.linalg.norm(along))
        tip = middle + 0.68 * middle * along
        if length > 0.05:
            across = np.array([-along[1], along[0]]) / length * 0.05 * middle
            neck = middle + (0.68 - 0.2 * min(1, 1 / length)) * middle * along
            draw.line([(middle, middle), tuple(neck)], color, round(0.035 * middle))
            draw.polygon([tuple(tip), tuple(neck + 1.3 * across), tuple(neck - 1.3 * across)], color)
        if length > 0.15 or axes[i, 2] > 0:
            at = (
                middle + (0.68 * along + (0.17 * along / length if length > 0.15 else np.array([-0.16, 0.16]))) * middle
            )
            draw.text(tuple(at), "xyz"[i], color, font(round(size * FINE)), "mm")
    sheet = sheet.resize((2 * half, 2 * half), Pillow.Resampling.BOX)
    canvas.paste(sheet, (0, canvas.height - 2 * half), sheet)


def numbers_of_bar(low: float, high: float, digits: int) -> list[str]:
    """Return the numbers of the color bar, from bottom to top; round-off of zero is shown as zero.

    There is a single one if all values are the same.
    """
    if low == high:
        return [f"{low:.{digits}g}"]
    numbers = low + (high - low) * np.arange(7) / 6
    numbers[np.abs(numbers) < 1e-9 * max(abs(low), abs(high))] = 0.0
    return [f"{number:.{digits}g}" for number in numbers]


def _add_bar(canvas: Pillow.Image, scene: Scene, looks: Looks, size: float, ink: Any) -> None:
    """Draw the bar of colors at the right edge, with numbers."""
    tiles = max(int(looks.setting("contour.advanced.colorBarTiling")), 2)
    digits = max(int(looks.setting("contour.advanced.colorBarPrecision")), 1)
    low, high = scene.value_range
    top, bottom = 0.14 * canvas.height, 0.78 * canvas.height
    texts = numbers_of_bar(low, high, digits)
    letters = font(round(size))
    wide = max(letters.getlength(text) for text in texts)
    left = canvas.width - wide - 3.6 * size
    draw = ImageDraw.Draw(canvas)
    shades = contour.colors(looks, low + (high - low) * (np.arange(tiles) + 0.5) / tiles, scene.value_range)
    if len(texts) == 1:
        shades[:] = contour.colors(looks, np.array([low]), scene.value_range)
    for k, shade in enumerate(shades):
        y0, y1 = (bottom + (top - bottom) * j / tiles for j in (k + 1, k))
        draw.rectangle([left, y0, left + 1.4 * size, y1], _bytes(shade))
    for k, text in enumerate(texts):
        part = k / 6 if len(texts) > 1 else 0.5
        draw.text((left + 2 * size, bottom + (top - bottom) * part), text, ink, letters, "lm")
    draw.text((canvas.width - size, top - 1.2 * size), scene.value_name, ink, letters, "rs")
