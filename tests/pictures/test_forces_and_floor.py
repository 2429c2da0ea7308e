"""Images with arrows of forces and a floor: what they add, where, and that nothing has changed without them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from page_reader import settings
from PIL import Image

from dalembert import graphics
from dalembert._pictures import floor
from dalembert._pictures.forces import COLOR
from dalembert._pictures.studio import Studio
from dalembert.utilities import InertiaCuboid


@pytest.fixture
def pulled(mbs: Any) -> Any:
    """A white brick from -0.4 to 0.4 m above z = -0.25 m, which is pulled to the right."""
    body = mbs.CreateRigidBody(
        inertia=InertiaCuboid(1000, [0.8, 0.5, 0.5]),
        graphicsDataList=[graphics.Brick(size=[0.8, 0.5, 0.5], color=[1, 1, 1, 1])],
    )
    mbs.CreateForce(bodyNumber=body, loadVector=[20, 0, 0], localPosition=[0.4, 0, 0])
    mbs.Assemble()
    return mbs


def arrows(image: Any) -> int:
    """Pixels with the hue of arrows of forces."""
    red, green, blue = np.moveaxis(np.asarray(image, int)[:, :, :3], 2, 0)
    hue = COLOR[1] / COLOR[0]
    return int(((red > 60) & (np.abs(green / np.maximum(red, 1) - hue) < 0.1) & (blue < 0.1 * red)).sum())


def test_draw_adds_them_on_request(pulled: Any) -> None:
    plain = np.asarray(pulled.Draw())
    assert arrows(plain) == 0
    np.testing.assert_array_equal(pulled.Draw(forces=False, floor=False), plain)
    assert arrows(pulled.Draw(forces=True)) > 300
    with_floor = np.asarray(pulled.Draw(floor=True))
    grey = round(255 * (0.25 * 0.53 + 0.75))
    lines = (np.abs(with_floor.astype(int) - grey).max(axis=2) <= 2) & (plain == 255).all(axis=2)
    assert arrows(with_floor) == 0 and lines.sum() > 1000
    assert ((plain != with_floor).any(axis=2) & (plain[:, :, 0] < 250)).sum() < 100  # it is behind the brick, and below


def test_the_floor_is_below_everything_and_has_round_numbers() -> None:
    box = np.array([[-0.4, -0.25, -0.25], [0.4, 0.25, 0.25]])
    for up in (1, 2):
        across = [axis for axis in range(3) if axis != up]
        points = np.array([ends for ends, *_ in floor.lines(box, up)])
        assert points.shape == (42, 2, 3)
        np.testing.assert_allclose(points[:, :, up], -0.3)  # cells of 0.1 m: an eighth of 0.8 m
        for axis in across:
            np.testing.assert_allclose(np.unique(np.round(points[:, :, axis], 9)), np.linspace(-1, 1, 21), atol=1e-9)
    assert floor.lines(None, 2) == [] and floor.lines(np.zeros((2, 3)), 2) == []


def test_the_renderer_draws_them_as_its_state_says(SC: Any, pulled: Any) -> None:
    plain, drawn = SC.renderer.RedrawAndGetImage(), np.asarray(pulled.Draw())
    assert arrows(plain) == 0
    SC.renderer.SetState({"showForces": True, "showFloor": True})
    both = SC.renderer.RedrawAndGetImage()
    assert arrows(both) > 300
    np.testing.assert_array_equal(pulled.Draw(), np.asarray(pulled.Draw(forces=True, floor=True)))
    np.testing.assert_array_equal(pulled.Draw(forces=False, floor=False), drawn)
    assert SC.renderer.GetState()["showForces"] is True
    SC.visualizationSettings.exportImages.saveImageSingleFile = True
    SC.visualizationSettings.exportImages.saveImageFileName = "saved"
    SC.renderer.RedrawAndSaveImage()
    np.testing.assert_array_equal(np.asarray(Image.open("saved.png").convert("RGB")), both)
    SC.renderer.ResetState()
    np.testing.assert_array_equal(SC.renderer.RedrawAndGetImage(), plain)
    with pytest.raises(ValueError, match=r"SetState\(...\): showForces: expected True or False, received 1"):
        SC.renderer.SetState({"showForces": 1})
    for draw, name in ((pulled.Draw, "forces"), (pulled.Draw, "floor"), (pulled.DrawSolution, "forces")):
        with pytest.raises(ValueError, match=f"{draw.__name__}: {name}: expected True, False, or None .*received 'no'"):
            draw("image%d.png", **{name: "no"})
    SC.renderer.SetState({"showFloor": True})
    SC.renderer.SetState(SC.renderer.GetState(), viewID=1)  # a view is copied
    assert "showFloor" not in SC.renderer.GetState(1) and SC.renderer.GetState()["showFloor"]


def test_the_scale_is_written(pulled: Any) -> None:
    studio = Studio(pulled.GetSystemContainer(), [pulled])
    assert studio.scene().information == []
    studio.show(forces=True)
    (words,) = studio.scene().information
    assert words.startswith("arrows: ") and words.endswith(" m for 20 N")


def test_films_and_recorded_images_have_them(SC: Any, pulled: Any) -> None:
    """The floor of a film stays where it is: below all frames."""
    known = settings(20, 0.2)
    known.solutionSettings.solutionWritePeriod = 0.05
    known.solutionSettings.writeSolutionToFile = True
    known.solutionSettings.recordImagesInterval = 0.1
    SC.visualizationSettings.exportImages.saveImageFileName = "recorded"
    SC.renderer.SetState({"showForces": True})
    pulled.SolveDynamic(known)
    assert min(arrows(Image.open(name)) for name in sorted(Path().glob("recorded*.png"))) > 300
    SC.renderer.SetState({"showForces": False})
    pulled.DrawSolution("film%d.png", framesPerSecond=10, windowSize=[400, 300], forces=True, floor=True)
    pulled.DrawSolution("plain%d.png", framesPerSecond=10, windowSize=[400, 300])
    films, plain = (
        [np.asarray(Image.open(f"{name}{k}.png").convert("RGB"), int) for k in range(2)] for name in ("film", "plain")
    )
    assert all(arrows(image) > 20 for image in films) and not any(map(arrows, plain))
    grey = round(255 * (0.25 * 0.53 + 0.75))
    first, second = ((np.abs(image - grey).max(axis=2) <= 2) for image in films)
    shared = (first & second).sum()
    assert shared > 300 and shared > 0.9 * max(first.sum(), second.sum()) - 200
