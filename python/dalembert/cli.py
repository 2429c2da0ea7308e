"""The command dalembert: run models, look up items, show a first result."""

from __future__ import annotations

import argparse
import difflib
import runpy
import sys
import textwrap
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from dalembert._io.files import replacing


def _run(arguments: argparse.Namespace) -> int:
    """Run a model as __main__ with its own arguments; imports of exudyn give dalembert."""
    from dalembert import alias

    model = Path(arguments.model)
    if not model.is_file():
        print(f"dalembert run: there is no file '{model}'", file=sys.stderr)
        return 2
    alias.install("exudyn")
    sys.argv = [str(model), *arguments.arguments]
    sys.path.insert(0, str(model.resolve().parent))
    runpy.run_path(str(model), run_name="__main__")
    return 0


def _info(arguments: argparse.Namespace) -> int:
    """Print versions, the location of the package and the number of items."""
    import platform

    import numpy as np

    import dalembert

    rows = [
        ("dalembert", dalembert.__version__),
        ("interface", dalembert.interface_version),
        ("location", str(Path(dalembert.__file__).parent)),
        ("compiled core", str(dalembert._core.__file__)),
        ("items", ", ".join(f"{_count(names)} {kind.lower()} types" for kind, names in _item_names().items())),
        ("Python", f"{platform.python_version()} on {platform.system()} {platform.machine()}"),
        ("numpy", np.__version__),
    ]
    _print_table(rows)
    return 0


def _print_table(rows: Iterable[Sequence[Any]]) -> None:
    """Print rows of texts in columns; the last column is not padded."""
    cells = [[str(cell) for cell in row] for row in rows]
    widths = [max(len(row[i]) for row in cells) for i in range(len(cells[0]) - 1)]
    for row in cells:
        print("  ".join([*(cell.ljust(width) for cell, width in zip(row, widths, strict=False)), row[-1]]).rstrip())


def _item_names() -> dict[str, list[str]]:
    """Return the names of all item classes, without the V... classes and short names, by kind."""
    from dalembert import itemInterface

    kinds = ("Node", "Object", "Marker", "Load", "Sensor")
    names = [name for name, value in vars(itemInterface).items() if getattr(value, "__name__", "") == name]
    return {kind: [n for n in names if n.startswith(kind)] for kind in kinds}


def _count(names: Sequence[str]) -> str:
    """Return how many of these items run: '70 of 97', or '8' if all do."""
    from dalembert._planned_table import ITEMS

    run = sum(name not in ITEMS for name in names)
    return str(run) if run == len(names) else f"{run} of {len(names)}"


def _items(arguments: argparse.Namespace) -> int:
    """List all items, or what one item is: parameters with type, default, unit and meaning, and output variables."""
    from dalembert import itemInterface
    from dalembert._planned_table import ITEMS

    if arguments.name is None:
        for kind, names in _item_names().items():
            print(f"{kind} ({_count(names)} run)")
            for name in names:
                print(f"  {name}" + ("  (planned)" if name in ITEMS else ""))
        return 0
    known = [name for name, value in vars(itemInterface).items() if isinstance(value, type)]
    if arguments.name not in known:
        running = [name for name in known if getattr(itemInterface, name).__name__.removeprefix("V") not in ITEMS]
        near = difflib.get_close_matches(arguments.name, running, 3)
        hint = f"; did you mean {', '.join(near)}?" if near else "; 'dalembert items' lists all"
        print(f"dalembert items: there is no item '{arguments.name}'{hint}", file=sys.stderr)
        return 2
    cls = getattr(itemInterface, arguments.name)
    state = " (planned: it is refused when it is added)" if cls.__name__ in ITEMS else ""
    summary, _, rest = (cls.__doc__ or "").partition("\n")
    print(f"{cls.__name__}: {summary}{state}")
    print("\n".join(_wrapped(line) for line in rest.splitlines()))
    return 0


def _wrapped(line: str) -> str:
    """Return a line of a docstring, folded to the width of a page below its own beginning."""
    indent = " " * (len(line) - len(line.lstrip()))
    return textwrap.fill(line, 110, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def _slider_crank(endTime: float) -> tuple[Any, list[Any]]:
    """Return a slider-crank with a driven crank, solved, and its sensors: crank tip position and slider velocity."""
    import numpy as np

    import dalembert as exu
    from dalembert import itemInterface as eii
    from dalembert.rigidBodyUtilities import InertiaCuboid

    crank, rod, width = 0.1, 0.3, 0.02  # lengths in m
    speed = 4 * np.pi  # rad/s
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    planar: dict[str, Any] = {"create2D": True, "gravity": [0, -9.81, 0]}

    def bar(length: float, center: float, velocity: list[float], omega: float) -> Any:
        return mbs.CreateRigidBody(
            referencePosition=[center, 0, 0],
            initialVelocity=velocity,
            initialAngularVelocity=[0, 0, omega],
            inertia=InertiaCuboid(density=7800, sideLengths=[length, width, width]),
            **planar,
        )

    crank_body = bar(crank, crank / 2, [0, speed * crank / 2, 0], speed)
    rod_body = bar(rod, crank + rod / 2, [0, speed * crank / 2, 0], -speed * crank / rod)
    slider = mbs.CreateMassPoint(referencePosition=[crank + rod, 0, 0], physicsMass=0.5, create2D=True)

    def marker(body: Any, x: float) -> Any:
        return mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=body, localPosition=[x, 0, 0]))

    pairs = [
        (marker(ground, 0), marker(crank_body, -crank / 2)),
        (marker(crank_body, crank / 2), marker(rod_body, -rod / 2)),
        (marker(rod_body, rod / 2), marker(slider, 0)),
    ]
    for pair in pairs:
        mbs.AddObject(eii.ObjectJointRevolute2D(markerNumbers=list(pair)))
    mbs.CreateCoordinateConstraint(bodyNumbers=[None, slider], coordinates=[None, 1])
    mbs.CreateCoordinateConstraint(
        bodyNumbers=[None, crank_body],
        coordinates=[None, 2],
        offsetUserFunction=lambda mbs, t, item, offset: speed * t,
    )
    variables = exu.OutputVariableType
    sensors = [
        mbs.AddSensor(eii.SensorBody(bodyNumber=body, localPosition=local, storeInternal=True, outputVariableType=kind))
        for body, local, kind in (
            (crank_body, [crank / 2, 0, 0], variables.Position),
            (slider, [0, 0, 0], variables.Position),
            (slider, [0, 0, 0], variables.Velocity),
        )
    ]
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = endTime
    settings.timeIntegration.numberOfSteps = 1000
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = endTime / 500
    mbs.SolveDynamic(settings)
    return mbs, sensors


def _demo(arguments: argparse.Namespace) -> int:
    """Simulate a slider-crank and write a plot of its motion."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    mbs, (tip, slider, velocity) = _slider_crank(endTime=1.0)
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    path, position, speed = (mbs.GetSensorStoredData(sensor) for sensor in (tip, slider, velocity))
    left.plot(path[:, 1], path[:, 2], label="crank tip")
    left.plot(position[:, 1], position[:, 2], label="slider")
    left.set(xlabel="x in m", ylabel="y in m", aspect="equal", title="paths")
    left.legend()
    right.plot(position[:, 0], position[:, 1], label="position in m")
    right.plot(speed[:, 0], speed[:, 1], label="velocity in m/s")
    right.set(xlabel="t in s", title="slider")
    right.legend()
    target = Path(arguments.output).resolve()
    with replacing(target) as written:
        figure.savefig(written, dpi=120)
    plt.close(figure)
    print(f"slider-crank simulated, plot written to {target}")
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="dalembert", description="Flexible multibody dynamics.")
    commands = parser.add_subparsers(required=True, metavar="command")

    run = commands.add_parser("run", help="run a model; its imports of exudyn give dalembert")
    run.add_argument("model", help="a Python file")
    run.add_argument("arguments", nargs=argparse.REMAINDER, help="arguments of the model")
    run.set_defaults(function=_run)

    commands.add_parser("info", help="versions and places").set_defaults(function=_info)

    items = commands.add_parser("items", help="list all items, or the parameters of one")
    items.add_argument("name", nargs="?", help="an item, e.g. NodePoint")
    items.set_defaults(function=_items)

    demo = commands.add_parser("demo", help="simulate a slider-crank and write a plot")
    demo.add_argument("-o", "--output", default="slider_crank.png", help="the PNG file to write")
    demo.set_defaults(function=_demo)
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command with the given arguments (default: those of the process) and return its exit code."""
    options = _parser().parse_args(arguments)
    return int(options.function(options))
