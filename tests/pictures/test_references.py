"""Pictures are those that are stored, which were looked at: bodies, beams with contour, contact, the ray tracer, texts."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image as Pillow
from reference_pictures import FOLDER, MODELS, SIZE, Image, drawn, stored

# Mean difference of color values, of 255. The core gives the same bytes for the same numbers anywhere; a last digit of a sine of another
# library may move an edge over one of the four samples of a pixel, which is 0.01 of the picture at most, and letters are smoothed by
# another version of FreeType. Everything that is wrong is more: see the last test.
TOLERANCE = 0.3


def difference(image: Image, reference: Image) -> float:
    return float(np.abs(image.astype(int) - reference).mean())


@pytest.mark.parametrize("name", MODELS)
def test_pictures_are_those_that_are_stored(name: str) -> None:
    image, reference = drawn(name), stored(name)
    assert image.shape == reference.shape == (SIZE[1], SIZE[0], 3)
    if (found := difference(image, reference)) > TOLERANCE:
        apart = np.minimum(4 * np.abs(image.astype(int) - reference), 255).astype(np.uint8)
        path = Path(f"{name}_stored_drawn_difference.png").resolve()
        Pillow.fromarray(np.hstack([reference, image, apart])).save(path)
        pytest.fail(
            f"the picture {name!r} differs from the stored one by {found:.2f} of 255 in the mean, more than {TOLERANCE}: look at {path}; "
            "if the new one is right, python tests/pictures/reference_pictures.py stores it"
        )


def test_nothing_else_is_stored() -> None:
    assert {path.stem for path in FOLDER.iterdir()} == set(MODELS)
    assert sum(path.stat().st_size for path in FOLDER.iterdir()) < 100_000


CHANGES = {
    "bodies": lambda SC: setattr(SC.visualizationSettings.openGL.light0, "diffuse", 0.4),
    "beams": lambda SC: setattr(SC.visualizationSettings.contour, "outputVariableComponent", 0),
    "contact": lambda SC: setattr(SC.visualizationSettings.contact, "showBoundingBoxes", False),
    "rays": lambda SC: setattr(SC.visualizationSettings.openGL.light0, "shadow", 0.0),
    "text": lambda SC: setattr(SC.visualizationSettings.nodes, "showNumbers", False),
}


@pytest.mark.parametrize("name", MODELS)
def test_changed_pictures_are_found(name: str) -> None:
    """Differences below those of any mistake: another light, another component, a box that is missing."""
    assert difference(drawn(name, CHANGES[name]), stored(name)) > 3 * TOLERANCE
