"""Films: images one after the other, as files with numbers, or as one file."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image as Pillow

from dalembert._io.files import file_to_write, path_name, replacing
from dalembert._pictures.painting import Image

ANIMATIONS = (".gif", ".webp")  # by Pillow
MOST_IMAGES = 100_000  # more than an hour at 25 per second
VIDEOS = (".mp4", ".mkv", ".mov", ".avi", ".webm", ".m4v", ".mpg", ".ogv")  # by ffmpeg


def save_image(image: Image, name: str | Path, quickly: bool = False) -> None:
    """Save an image in the format that the ending of the name says; its folder is made if needed.

    quickly: images of a series, which are saved in half the time as larger files if they end with .png.
    """
    path = Path(file_to_write("fileName", name, newFolder=True))
    check_image_name(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    with replacing(path) as written:
        options: dict[str, Any] = {"compress_level": 1} if quickly else {}
        Pillow.fromarray(image).save(written, **options)


def check_image_name(name: str | Path, where: str = "fileName") -> None:
    """Raise an error for names that are not image files."""
    if Path(name).suffix.lower() not in Pillow.registered_extensions():
        raise ValueError(f"{where}: {str(name)!r} does not end as images do; give it the ending .png, .jpg or .webp")


def save_film(images: Iterable[Image], name: str | Path, rate: float) -> None:
    """Save images as one file: .gif or .webp by Pillow, .mp4 and other videos by ffmpeg; rate per second."""
    path = Path(file_to_write("fileName", name, newFolder=True))
    path.parent.mkdir(parents=True, exist_ok=True)
    if path.suffix.lower() in ANIMATIONS:
        frames = [Pillow.fromarray(image) for image in images]
        if path.suffix.lower() == ".gif":
            palette = _palette(frames[len(frames) // 2])
            frames = [frame.quantize(palette=palette, dither=Pillow.Dither.NONE) for frame in frames]
        with replacing(path) as written:
            frames[0].save(written, save_all=True, append_images=frames[1:], duration=round(1000 / rate), loop=0)
        return
    from dalembert.interactive import ConvertImages2Video

    require_ffmpeg(path)
    with tempfile.TemporaryDirectory() as folder:
        for number, image in enumerate(images):
            save_image(
                image[: image.shape[0] // 2 * 2, : image.shape[1] // 2 * 2],
                Path(folder, f"frame{number:05d}.png"),
                quickly=True,
            )
        whole = max(round(rate), 1)
        ConvertImages2Video(folder, outputFile=str(path.resolve()), inputFrameRate=whole, outputFrameRate=whole)


def _palette(frame: Pillow.Image) -> Pillow.Image:
    """Return the colors of a film; the color of the background is exact."""
    palette = frame.quantize(255, method=Pillow.Quantize.MEDIANCUT)
    colors, counts = np.unique(np.asarray(frame).reshape(-1, 3), axis=0, return_counts=True)
    background = colors[counts.argmax()].astype(int)
    chosen = np.array((palette.getpalette() or [])[: 3 * 255]).reshape(-1, 3)
    chosen[np.abs(chosen - background).max(axis=1) < 8] = background  # Pillow does not distinguish closer colors
    palette.putpalette([*chosen.ravel().tolist(), *background.tolist()])
    return palette


def make_video(
    where: str, folder: Any, pattern: Any, output: Any, rates: list[float], quality: int, first: int, count: int | None
) -> None:
    """Make a video of numbered images in a folder by ffmpeg; rates of the images and of the video, per second."""
    import subprocess

    folder = Path(path_name(f"{where} workingDir", folder, "the name of a folder"))
    pattern = path_name(f"{where} inputPattern", pattern, "the names of images")
    name_of = numbered(pattern, f"{where} inputPattern")
    output = path_name(f"{where} outputFile", output)
    if not folder.is_dir():
        raise FileNotFoundError(f"{where} workingDir: there is no folder '{folder}'")
    output = os.path.abspath(file_to_write(f"{where} outputFile", folder / output))
    image = folder / name_of(first)
    if not image.is_file():
        raise FileNotFoundError(
            f"{where} there is no image '{image}', the first one by workingDir, inputPattern and startNumber"
        )
    if (program := shutil.which("ffmpeg")) is None:
        raise FileNotFoundError(f"{where} the program ffmpeg is not installed, or not in the search path")
    command = [program, "-y", "-framerate", f"{rates[0]:g}", "-start_number", str(first), "-i"]
    command += [os.path.join(".", pattern)]  # a leading "-" would be an option
    even = "crop=trunc(iw/2)*2:trunc(ih/2)*2"  # required by the format
    command += ["-vcodec", "libx264", "-crf", str(quality), "-vf", f"fps={rates[1]:g},{even},format=yuv420p"]
    command += [] if count is None else ["-frames:v", str(count)]
    texts: dict[str, Any] = {"capture_output": True, "text": True, "errors": "replace"}
    result = subprocess.run([*command, output], cwd=folder, stdin=subprocess.DEVNULL, check=False, **texts)
    if result.returncode != 0:
        raise RuntimeError(f"{where} ffmpeg failed: {result.stderr.strip()[-500:]}")


def check_name(path: Path, where: str) -> None:
    """Raise an error, before anything is drawn, for invalid film names, and for videos without ffmpeg."""
    if path.suffix.lower() not in (*ANIMATIONS, *VIDEOS):
        raise ValueError(
            f"{where}: {str(path)!r} does not end as films do; give it the ending .gif, .webp or .mp4, "
            "or a number for each image, as in 'frame%05d.png'"
        )
    require_ffmpeg(path, where)


def numbered(name: str, where: str = "fileName") -> Callable[[int], str]:
    """Return the names of images by their numbers; refused if the place of the number is not to be understood."""
    try:
        if name % 0 != name % 1:
            return lambda number: name % number
    except (TypeError, ValueError):
        pass
    raise ValueError(f"{where}: {name!r} has no place for the numbers of images; write one, as in 'frame%05d.png'")


def require_ffmpeg(path: Path, where: str = "fileName") -> None:
    """Refuse videos where there is no ffmpeg."""
    if path.suffix.lower() not in ANIMATIONS and shutil.which("ffmpeg") is None:
        raise FileNotFoundError(
            f"{where}: for {str(path)!r}, the program ffmpeg is needed, which is not installed, "
            "or not in the search path; names that end with .gif or .webp need no other program"
        )


def times_of(where: str, begin: float, end: float, rate: float, speed: float) -> np.ndarray[Any, Any]:
    """Return the times of the images of a film that shows `speed` seconds in each second; refused if it is endless."""
    count = max(np.floor((end - begin) / speed * rate + 1e-9) + 1, 1)
    if not count <= MOST_IMAGES:
        raise ValueError(
            f"{where}: at framesPerSecond = {rate:g} and speed = {speed:g}, a solution of {end - begin:g} s would be "
            f"{count:.4g} images, more than {MOST_IMAGES}; choose others"
        )
    return begin + np.arange(int(count)) * speed / rate
