"""The code on pages and in the README works: examples run, error texts are the real ones, the example item is
complete."""

from __future__ import annotations

import doctest
import operator
import os
import re
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import example_runs
import item_drawings
import pytest

import dalembert as exu
from codegen.load import load

ROOT = Path(__file__).parents[2]
COMPARISON = re.compile(r"(.+): (-?[\d.]+) (\S+), .+ (-?[\d.]+) \3")  # what: value unit, according to what value unit
AGREEMENT = {  # relative difference of compared values, and how many there are
    "arm_from_mesh": (2e-4, 3),  # fixed-interface modes, with six of them
    "belt_drive": (1e-3, 2),  # friction grows with the velocity before it slides; the mean of a quarter of the time
    "cable_laying": (1e-4, 2),  # bending stiffness; the ground gives way by 25 mm of 100 m
    "channel_beam": (1e-3, 2),  # 32 elements whose error is quadratic; small rotations
    "clamped_plate": (3e-3, 5),  # meshes of 8 by 8 and 16 by 16 elements, and their limit
    "crane_with_rope": (1e-3, 1),  # the rope has 1 % of the mass of the load; small angles
    "leaf_spring": (2e-4, 1),  # the axial strain and the square of the load
    "band_brake": (4e-4, 2),  # the stiffness of the bent band
    "cart_on_terrain": (6e-3, 1),  # the wheels creep
    "box_tower": (1e-4, 2),  # motion that remains after 3 s; rounding of five digits
    "hopper": (1e-3, 2),  # a mean of 40 forces of a heap that creeps: 2e-4 to 7e-4 with starts and instruction sets
    "cantilever": (1e-3, 2),  # the bending of eight cubic elements; the axial strain of 3 N is below 3e-4
    "slider_crank": (2e-6, 2),  # rounding of six digits
    "four_bar": (2e-3, 2),  # accelerations of second order at 1 ms; extremes are sampled
    "gyroscope": (2e-4, 3),  # the disc turns by 0.04 rad in a step: 0.04^2 / 12
    "vehicle": (5e-3, 4),  # the balances leave out the pitch of the body and the drag of the steered wheels
    "six_axis_arm": (
        2e-4,
        4,
    ),  # the gripper is 0.3 mm off, as torques are constant for 2 ms; work is summed by trapezoids
    "quadruped": (
        4e-3,
        1,
    ),  # the gait is periodic to a part in a thousand after five periods; 0.7e-3 to 2.2e-3 with instruction sets
    "mobile_robot": (2e-4, 3),  # the column has 96 sides, which lie 0.2 mm inside
    "robot_arm": (1e-5, 4),  # constraints hold to Newton's tolerance; work is summed by trapezoids of 1 ms
    "wind_turbine_blade": (
        1.2e-2,
        6,
    ),  # Ritz leaves out shear and rotary inertia, a percent of the second flap frequency
    "parameter_study": (5e-4, 2),  # rounding of four digits; the maximum lies between two steps of 1 ms
    "three_bodies": (1e-5, 2),  # rounding of six digits
    "servo_drive": (1e-4, 2),  # transient that remains after 0.6 s; rounding
    "hoist": (1e-3, 2),  # the rope shortens a little less than it is wound, as it swings to rest
    "gear_pair": (2.5e-2, 2),  # teeth give way by 1.5 um, so that tips of radii of 10 mm touch 0.17 mm longer, of 11.8
    "cam_follower": (3e-3, 1),  # the stiffness of the contact under 190 N; sides of 0.5 mm
    "plate_modes": (1.5e-2, 4),  # a mesh of 12 x 12; its error falls with the square of the size
    "rolled_strip": (2e-4, 2),  # 30 micrometers of 318 mm: elements of 45 degrees; rounding of five digits
    "trolley_on_rope": (1.6e-2, 2),  # a rope bends over within an element; the trolley feels where elements meet
    "ball_in_ring": (1e-3, 2),  # squares of amplitudes: 0.05^2 / 16 of the ball, 0.0032 / 4 of the barrel
    "hydraulic_crane": (1e-3, 2),  # speed of the piston to four digits; the load creeps while it is lifted
    "newtons_cradle": (4e-3, 2),  # contacts last 60 microseconds, of 50 a step
    "scotch_yoke": (1e-5, 2),  # rounding of seven digits; constraints hold to Newton's tolerance
    "bead_on_cycloid": (2e-4, 3),  # cubic elements of 0.16 m between points of the curve
    "hanging_chain": (2e-3, 3),  # links of finite length: the square of 1/40, times that of the number of the mode
    "rolling_coin": (5e-5, 2),  # second order: 0.04 rad of spin in a step, squared over 12
    "governor": (1e-3, 2),  # the moment of inertia of the balls, of 1 kg and 1 mm, is not zero; it still creeps
    "spinning_bar": (1e-3, 1),  # the square of the strain, 7e-4
    "rubber_mount": (1e-3, 2),  # cubic elements; small angles
    "two_half_rods": (1e-3, 3),  # linear elements: the square of 3 pi / 80 over 24
    "rope_over_bar": (5e-3, 2),  # elements of 25 mm around a radius of 105 mm; the rope begins without tension
    "torsion_wire": (2e-4, 2),  # rounding of four digits
    "glass_and_mirrors": (8e-3, 1),  # half a pixel of 61
    "cable_car": (1.5e-2, 2),  # the bending stiffness of the rope; the cabin still swings a little
    "vibration_absorber": (1e-5, 3),  # rounding of six digits
    "timing_belt": (2e-3, 1),  # the wheel swings on the belt by a thousandth
    "ball_bearing": (1e-2, 2),  # balls creep under load; Stribeck's factor has three digits
    "identified_damper": (3e-2, 2),  # deviations of the measurement: 3.9 % of the stiffness, 2.1 % of the damping
    "shaped_cantilever": (3e-3, 4),  # the beam has 1.6 % of the mass at its tip
    "swing_up": (1e-5, 1),  # conditions at the end hold to the tolerance of the method, 1e-5
}


@pytest.mark.parametrize("path", example_runs.EXAMPLES, ids=[path.stem for path in example_runs.EXAMPLES])
def test_example_runs_plots_and_agrees(path: Path) -> None:
    folder = example_runs.run(path)  # the pages show these results
    wanted = set(re.findall(r'(?:fileName=|file_name=|savefig\()"(\w+\.png)"', path.read_text()))
    assert wanted and wanted == {plot.name for plot in folder.glob("*.png")}
    printed = (folder / "printed.txt").read_text("utf-8")
    compared = [match.groups() for line in printed.splitlines() if (match := COMPARISON.fullmatch(line))]
    tolerance, number = AGREEMENT.get(path.stem, (0.0, 0))
    assert len(compared) == number
    for what, value, _, reference in compared:
        assert float(value) == pytest.approx(float(reference), rel=tolerance), what


def test_readme_shows_the_first_example() -> None:
    (shown,) = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL)
    assert (ROOT / "examples/first_model.py").read_text().endswith("\n\n" + shown)


PAGES = {path.relative_to(ROOT / "docs").as_posix(): path for path in sorted((ROOT / "docs").rglob("*.rst"))}
WRITTEN = {name: path for name, path in PAGES.items() if not name.startswith("_generated/")}
SESSIONS = [name for name, path in WRITTEN.items() if ">>> " in path.read_text()]
BLOCK = re.compile(r"^\.\. (?:shown-before: |checked: |code-block:: )python\n\n((?:(?:   .*)?\n)+)", re.MULTILINE)
BLOCKS = {name: blocks for name, path in WRITTEN.items() if (blocks := BLOCK.findall(path.read_text() + "\n"))}


@pytest.mark.parametrize("page", SESSIONS)
def test_pages_show_the_real_texts(page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    failed, tried = doctest.testfile(str(PAGES[page]), module_relative=False)
    assert tried >= PAGES[page].read_text().count(">>> ") and failed == 0


@pytest.mark.parametrize("page", BLOCKS)
def test_code_of_pages_runs(page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """All blocks of a page, one after the other; comments of the page have the code before them `.. shown-before:
    python`."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    code = "\n".join(textwrap.dedent(block) for block in BLOCKS[page])
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, env=os.environ)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("kind", ["SimulationSettings", "VisualizationSettings"])
def test_first_settings_exist(kind: str) -> None:
    text = (ROOT / f"docs/_extensions/first_settings/{kind}.rst").read_text()
    names = re.findall(r"``([a-z]\w*(?:\.\w+)+|linearSolverType)``", text)
    assert len(names) > 12
    settings = exu.SimulationSettings() if kind == "SimulationSettings" else exu.SystemContainer().visualizationSettings
    for name in names:
        if not name.startswith("mbs."):
            operator.attrgetter(name)(settings)  # AttributeError if there is none


def test_drawings_are_of_items() -> None:
    ready = {item.name for item in load(ROOT).items if item.ready and item.example is not None}
    assert len(item_drawings.DRAWINGS) >= 20 and item_drawings.DRAWINGS.keys() <= ready


def test_the_example_of_a_new_item_is_complete(tmp_path: Path) -> None:
    for folder in ("specs", "examples"):  # specs name examples
        shutil.copytree(ROOT / folder, tmp_path / folder)
    shutil.copy(ROOT / "docs/developer/hertz_spring.toml", tmp_path / "specs/connectors")
    item = next(item for item in load(tmp_path).items if item.stem == "connectors/hertz_spring")
    assert item.ready and item.beyond_reference
    kernel = (ROOT / "docs/developer/hertz_spring.hpp").read_text()
    assert kernel.startswith(f"// {item.name}, {item.path}\n")
    assert f"struct {item.name} " in kernel
