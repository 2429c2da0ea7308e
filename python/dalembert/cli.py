"""The command dalembert: run models, look up items, show a first result."""

from __future__ import annotations

import argparse
import difflib
import os
import runpy
import sys
import textwrap
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from dalembert._io.files import replacing
from dalembert._version import __version__


def _existing(command: str, name: str) -> Path | None:
    model = Path(name)
    if model.is_file():
        return model
    print(f"dalembert {command}: there is no file '{model}'", file=sys.stderr)
    return None


def _run(arguments: argparse.Namespace) -> int:
    """Run a model as __main__ with its own arguments, or solve a model file; return the exit code."""
    model = _existing("run", arguments.model)
    if model is None:
        return 2
    if model.suffix == ".json":
        return _solve(model, arguments.arguments)
    _run_python(model, arguments.arguments)
    return 0


def _run_python(model: Path, arguments: Sequence[str] = ()) -> dict[str, Any]:
    """Run a Python file as __main__ and return its global names; exudyn is dalembert, in its processes too."""
    from dalembert import alias

    alias.install("exudyn")
    sys.argv = [str(model), *arguments]
    sys.path[:0] = [str(model.resolve().parent), str(Path(__file__).parent / "_tools/aliases")]
    return runpy.run_path(str(model), run_name="__main__")


def _loaded(model: Path, allowCode: bool = False) -> tuple[Any, Any]:
    """Return the system and the settings of a model file; errors are raised as SystemExit."""
    import dalembert as exu

    mbs: Any = exu.SystemContainer().AddSystem()
    try:
        return mbs, mbs.Load(model, allowCode=allowCode)
    except ValueError as error:
        raise SystemExit(str(error).replace("Pass allowCode=True", "Add --allow-code")) from None


def _solve(model: Path, arguments: Sequence[str]) -> int:
    """Solve a model file with the settings in it, or with the defaults; print values of sensors at the end."""
    parser = argparse.ArgumentParser(prog=f"dalembert run {model.name}")
    parser.add_argument("--allow-code", action="store_true", help="load user functions, which is to run their code")
    parser.add_argument("--static", action="store_true", help="find the equilibrium instead of the motion")
    from dalembert import SolverError

    options = parser.parse_args(arguments)
    mbs, settings = _loaded(model, options.allow_code)
    mbs.Assemble()
    solve = mbs.SolveStatic if options.static else mbs.SolveDynamic
    try:
        done = solve(*([settings] if settings is not None else []))
    except SolverError as error:
        print(error, file=sys.stderr)
        return 1
    for sensor in range(mbs.systemData.NumberOfSensors()):
        print(f"{mbs.GetSensorParameter(sensor, 'name')}: {mbs.GetSensorValues(sensor)}")
    return 0 if done else 1


class _SolverCalledError(Exception):
    """A model that is only checked has come to its solver."""


def _system_of(model: Path) -> Any:
    """Return the system of a Python file as it is when its first solver is called, or else its variable mbs."""
    import dalembert as exu

    def stop(mbs: Any, *args: Any, **kwargs: Any) -> None:
        raise _SolverCalledError(mbs)

    for name in ("SolveDynamic", "SolveStatic", "SolveVariations"):
        setattr(exu.MainSystem, name, stop)
        setattr(exu, name, stop)
    try:
        mbs = _run_python(model).get("mbs")
    except _SolverCalledError as called:
        return called.args[0]
    if isinstance(mbs, exu.MainSystem):
        return mbs
    raise SystemExit(f"dalembert check: {model} calls no solver and has no variable mbs")


def _check(arguments: argparse.Namespace) -> int:
    """Assemble a model and report likely mistakes; return 1 if there are any."""
    from dalembert._tools.model_check import figures, findings

    model = _existing("check", arguments.model)
    if model is None:
        return 2
    mbs = _loaded(model, arguments.allow_code)[0] if model.suffix == ".json" else _system_of(model)
    found = findings(mbs)
    if not any(text.startswith("Assemble()") for text in found):
        _print_table(figures(mbs))
    for text in found:
        print(f"- {text}")
    print(f"{len(found)} finding{'' if len(found) == 1 else 's'}" if found else "nothing looks wrong")
    return 1 if found else 0


def _info(arguments: argparse.Namespace) -> int:
    """Print the contents of a model file; by default versions, the location of the package and the number of items."""
    if arguments.model is not None:
        from dalembert._tools.model_check import figures

        model = _existing("info", arguments.model)
        if model is None:
            return 2
        loaded = model.suffix == ".json"
        _print_table(figures(_loaded(model, arguments.allow_code)[0] if loaded else _system_of(model)))
        return 0
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
    from dalembert._tools.item_packages import item_classes

    kinds = ("Node", "Object", "Marker", "Load", "Sensor")
    names = [name for name, value in item_classes().items() if value.__name__ == name]
    return {kind: [n for n in names if n.startswith(kind)] for kind in kinds}


def _count(names: Sequence[str]) -> str:
    """Return how many of these items run: '70 of 97', or '8' if all do."""
    from dalembert._planned_table import ITEMS

    run = sum(name not in ITEMS for name in names)
    return str(run) if run == len(names) else f"{run} of {len(names)}"


def _items(arguments: argparse.Namespace) -> int:
    """List all items, or describe one item: parameters with type, default, unit and meaning, and output variables."""
    from dalembert._planned_table import ITEMS
    from dalembert._tools import item_packages

    if arguments.name in _PACKAGE_COMMANDS:
        return _PACKAGE_COMMANDS[arguments.name](arguments.arguments)
    if arguments.arguments:
        print(f"dalembert items: one name, or one of {', '.join(_PACKAGE_COMMANDS)}", file=sys.stderr)
        return 2
    item_packages.load_installed()
    if arguments.name is None:
        for kind, names in _item_names().items():
            print(f"{kind} ({_count(names)} run)")
            for name in names:
                print(f"  {name}" + ("  (planned)" if name in ITEMS else ""))
        return 0
    from dalembert.create import functions

    created = {name.lower(): name for name in functions}
    if (made := created.get(arguments.name.lower())) is not None:
        told = f"mbs.{made}: {functions[made].__doc__}"
        print("\n".join(_wrapped(line) for line in told.splitlines()))
        return 0
    classes = item_packages.item_classes()
    known = list(classes)
    lower = {name.lower(): name for name in known}
    arguments.name = lower.get(arguments.name.lower(), arguments.name)
    if arguments.name not in known:
        near = _near(arguments.name, [name for name in [*known, *functions] if name not in ITEMS])
        print(f"dalembert items: there is no item '{arguments.name}'; {near}", file=sys.stderr)
        return 2
    cls = classes[arguments.name]
    state = " (planned: it is refused when it is added)" if cls.__name__ in ITEMS else ""
    summary, _, rest = (cls.__doc__ or "").partition("\n")
    print(f"{cls.__name__}: {summary}{state}")
    print("\n".join(_wrapped(line) for line in rest.splitlines()))
    return 0


def _package_command(usage: str, *arguments: tuple[str, dict[str, Any]]) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog=f"dalembert items {usage}")
    for name, options in arguments:
        parser.add_argument(name, **options)
    return parser


_DIRECTORY: tuple[str, dict[str, Any]] = (
    "directory",
    {"nargs": "?", "type": Path, "default": Path("."), "help": "the package (default: this directory)"},
)


def _new_item(given: Sequence[str]) -> int:
    """Start an item in a package, which is made if it does not exist."""
    from dalembert._tools import item_builds

    parser = _package_command(
        "new",
        ("package", {"type": Path, "help": "directory of the package; its name is that of the Python module"}),
        ("kind", {"help": "node, body, connector, constraint, joint, load, marker, sensor, finite_element, ..."}),
        ("name", {"help": "name of the item, e.g. HertzSpring"}),
    )
    options = parser.parse_args(given)
    return _reported("new", lambda: print("\n".join(item_builds.new(options.package, options.kind, options.name))))


def _item_from_law(given: Sequence[str]) -> int:
    """Write a law in Python as spec and kernel of an item in a package."""
    from dalembert._tools import law_kernels

    parser = _package_command(
        "from-law",
        ("package", {"type": Path, "help": "directory of the package, which is made if it does not exist"}),
        ("law", {"help": "module:function of a law, see dalembert.laws"}),
    )
    options = parser.parse_args(given)
    sys.path.insert(0, str(Path.cwd()))
    return _reported("from-law", lambda: print("\n".join(law_kernels.from_law(options.package, options.law))))


def _build_items(given: Sequence[str]) -> int:
    """Generate and compile the items of a package; only changed files are compiled."""
    from dalembert._tools import item_builds

    output = ("--output", {"type": Path, "help": "folder of the extension module (default: the Python package)"})
    options = _package_command("build", _DIRECTORY, output).parse_args(given)
    return _reported("build", lambda: print(item_builds.build(options.directory, options.output)))


def _check_items(given: Sequence[str]) -> int:
    """Build a package and run the generated tests of its items."""
    from dalembert._tools import item_builds

    parser = _package_command("check", _DIRECTORY)
    options, of_pytest = parser.parse_known_args(given)
    return _reported("check", lambda: item_builds.check(options.directory, of_pytest))


def _list_packages(given: Sequence[str]) -> int:
    """List the installed item packages, their versions, locations and items."""
    from dalembert._tools import item_packages

    _package_command("list").parse_args(given)
    item_packages.load_installed()
    packages = item_packages.installed()
    if not packages:
        print("no item packages are installed")
    for package in packages:
        module = sys.modules.get(package.module)
        place = "cannot be imported" if module is None else str(Path(str(module.__file__)).parent)
        print(f"{package.module} {package.version}  {place}")
        classes = item_packages.item_classes().items()
        for name in sorted(n for n, cls in classes if cls.__module__ == package.module and n == cls.__name__):
            if not name.startswith("V"):
                print(f"  {name}")
    return 0


def _reported(command: str, run: Callable[[], int | None]) -> int:
    """Run a command of packages and print its error, if there is one."""
    from dalembert._tools.item_builds import BuildError

    try:
        return run() or 0
    except BuildError as error:
        print(f"dalembert items {command}: {error}", file=sys.stderr)
        return 1


def _print_schema(given: Sequence[str]) -> int:
    """Print the JSON Schema of model files, with the items of all installed packages."""
    import json

    from dalembert._io.model_files import Schema

    _package_command("schema").parse_args(given)
    print(json.dumps(Schema(), indent=1, ensure_ascii=False))
    return 0


_PACKAGE_COMMANDS = {
    "new": _new_item,
    "from-law": _item_from_law,
    "build": _build_items,
    "check": _check_items,
    "list": _list_packages,
    "schema": _print_schema,
}


def _near(name: str, names: Iterable[str]) -> str:
    """Return a hint for an unknown item: items with a similar name, or help() of a method."""
    import dalembert

    if hasattr(dalembert.MainSystem, name):
        return f"it is a method: help(exu.MainSystem.{name}) in Python"
    if hasattr(dalembert, name):
        return f"help(exu.{name}) in Python describes it"
    shown = [each for each in names if not each.startswith("V")]  # visualization is listed with the items
    near = difflib.get_close_matches(name, shown, 3)
    return f"did you mean {', '.join(near)}?" if near else "'dalembert items' lists all"


def _wrapped(line: str) -> str:
    """Return a line of a docstring, folded to the width of a page below its own beginning."""
    indent = " " * (len(line) - len(line.lstrip()))
    return textwrap.fill(line, 110, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def _slider_crank(endTime: float) -> tuple[Any, list[Any], Any]:
    """Return a container with a driven slider-crank, sensors of the crank tip and the slider, and the solution."""
    import numpy as np

    import dalembert as exu
    from dalembert import graphics
    from dalembert import itemInterface as eii
    from dalembert._io.solution_states import LoadSolutionFile
    from dalembert.rigidBodyUtilities import InertiaCuboid

    crank, rod, width = 0.1, 0.3, 0.02  # lengths in m
    speed = 4 * np.pi  # rad/s
    SC = exu.SystemContainer()
    mbs = SC.AddSystem()
    rail = graphics.Brick(
        [crank + rod - 0.03, -1.2 * width, 0], [0.26, 0.3 * width, 2 * width], color=[0.4, 0.4, 0.4, 1]
    )
    bearing = graphics.Cylinder([0, 0, -2 * width], [0, 0, 1.5 * width], width, color=[0.4, 0.4, 0.4, 1], nTiles=48)
    ground = mbs.CreateGround(graphicsDataList=[rail, bearing])
    planar: dict[str, Any] = {"create2D": True, "gravity": [0, -9.81, 0]}

    def bar(length: float, center: float, velocity: list[float], omega: float, layer: int, color: Any) -> Any:
        """Add a bar along x; bars are drawn in layers, one in front of the other."""
        begin, end = ([side * length / 2, 0, 0.9 * width * layer] for side in (-1, 1))
        axis = [0, 0, 1]
        shape = graphics.RigidLink(
            begin, end, axis, axis, [0.8 * width] * 2, 0.8 * width, [1.1 * width] * 2, color=color, nTiles=32
        )
        return mbs.CreateRigidBody(
            referencePosition=[center, 0, 0],
            initialVelocity=velocity,
            initialAngularVelocity=[0, 0, omega],
            inertia=InertiaCuboid(density=7800, sideLengths=[length, width, width]),
            graphicsDataList=[shape],
            **planar,
        )

    color = graphics.color
    crank_body = bar(crank, crank / 2, [0, speed * crank / 2, 0], speed, 0, color.orange)
    rod_body = bar(rod, crank + rod / 2, [0, speed * crank / 2, 0], -speed * crank / rod, 1, color.dodgerblue)
    slider = mbs.CreateMassPoint(
        referencePosition=[crank + rod, 0, 0],
        physicsMass=0.5,
        create2D=True,
        graphicsDataList=[graphics.Brick(size=[3 * width, 2 * width, 1.2 * width], color=color.lightgrey)],
    )

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
    settings.solutionSettings.solutionWritePeriod = 0.02
    settings.solutionSettings.sensorsWritePeriod = endTime / 500
    with TemporaryDirectory() as folder:
        settings.solutionSettings.coordinatesSolutionFileName = f"{folder}/solution.txt"
        mbs.SolveDynamic(settings)
        return SC, sensors, LoadSolutionFile(f"{folder}/solution.txt", verbose=False)


def _plot(arguments: argparse.Namespace) -> int:
    """Plot columns of files over time."""
    import matplotlib.pyplot as plt

    from dalembert._plots.sensor_curves import columns_of_file
    from dalembert.plot import PlotSensor

    try:
        chosen = None if arguments.columns is None else [int(number) for number in arguments.columns.split(",")]
    except ValueError:
        print(f"dalembert plot: --columns: expected numbers as 0,1; received {arguments.columns}", file=sys.stderr)
        return 2
    try:
        pairs = []
        for name in arguments.file:
            pairs += [(name, column) for column in (chosen or range(columns_of_file("dalembert plot", name)))]
        files, columns = zip(*pairs, strict=True)
        labels = [f"{name}, {column}" for name, column in pairs]
        scale = {"logScaleY": True} if arguments.log_y else {}
        named = {"title": arguments.title, "fileName": arguments.save, "labels": labels, **scale}
        PlotSensor(None, list(files), list(columns), **named)
    except (OSError, ValueError) as error:
        print(f"dalembert plot: {error}", file=sys.stderr)
        return 1
    if not arguments.save:
        plt.show()
    return 0


def _dialogs(arguments: argparse.Namespace) -> int:
    """Say what there is instead of dialogs."""
    text = "there are no dialogs; the page of a model has its settings (SC.renderer.Start()), and so has help(settings)"
    print(f"dalembert dialogs: {text}", file=sys.stderr)
    return 2


def _demo(arguments: argparse.Namespace) -> int:
    """Simulate a slider-crank; write a picture of it with plots of its motion, and show the motion in the browser."""
    import webbrowser

    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    from dalembert._pictures.showing import has_display

    SC, (tip, slider, velocity), recorded = _slider_crank(endTime=1.1)
    mbs, settings = SC.GetSystem(0), SC.visualizationSettings
    figure, (picture, paths, motion) = plt.subplots(
        1, 3, figsize=(14, 4), layout="constrained", width_ratios=[1.3, 1, 1]
    )
    settings.loads.show = settings.markers.show = settings.connectors.show = False
    settings.sensors.traces.showPositionTrace = True
    picture.imshow(mbs.Draw(view="axonometric", windowSize=[900, 620], zoom=1.1))
    picture.set_axis_off()
    path, position, speed = (mbs.GetSensorStoredData(sensor) for sensor in (tip, slider, velocity))
    paths.plot(path[:, 1], path[:, 2], label="crank tip")
    paths.plot(position[:, 1], position[:, 2], label="slider")
    paths.set(xlabel="x (m)", ylabel="y (m)", aspect="equal", title="paths")
    paths.legend()
    motion.plot(position[:, 0], position[:, 1], label="position (m)")
    motion.plot(speed[:, 0], speed[:, 1], label="velocity (m/s)")
    motion.set(xlabel="time (s)", title="slider", ylim=(-1.5, 1.9))
    motion.legend(loc="upper center", ncols=2)
    target = Path(arguments.output).resolve()
    with replacing(target) as written:
        figure.savefig(written, dpi=120)
    plt.close(figure)
    moving = target.with_suffix(".html")
    mbs.SaveHTML(moving, solution=recorded, framesPerSecond=50, view="axonometric", title="slider-crank")
    print(f"slider-crank simulated, picture and plots written to {target}")
    if has_display() and webbrowser.open(moving.as_uri()):
        print(f"it moves in the browser: {moving}")
    else:
        print(f"it moves in {moving}: open it in a browser")
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="dalembert", description="Flexible multibody dynamics.")
    parser.add_argument("--version", action="version", version=f"dalembert {__version__}")
    commands = parser.add_subparsers(required=True, metavar="command")

    run = commands.add_parser("run", help="run a model, whose imports of exudyn give dalembert, or solve a model file")
    run.add_argument("model", help="a Python file, or a JSON file of mbs.Save(...)")
    run.add_argument("arguments", nargs=argparse.REMAINDER, help="arguments of the model")
    run.set_defaults(function=_run)

    info = commands.add_parser("info", help="versions and places; of a model: items, degrees of freedom, mass")
    info.add_argument("model", nargs="?", help="a JSON file of mbs.Save(...), or a Python file")
    info.set_defaults(function=_info)

    check = commands.add_parser("check", help="assemble a model and report likely mistakes, without solving it")
    check.add_argument("model", help="a Python file, or a JSON file of mbs.Save(...)")
    check.set_defaults(function=_check)

    for command in (info, check):
        words = "load user functions of a model file, which is to run their code"
        command.add_argument("--allow-code", action="store_true", help=words)

    items = commands.add_parser(
        "items", help="list all items, or describe one: parameters, outputs, example; packages with items of your own"
    )
    words = "an item or Create function: NodePoint, Point, CreateRigidBody; or new, build, check, list, schema"
    items.add_argument("name", nargs="?", help=words)
    items.add_argument("arguments", nargs=argparse.REMAINDER, help="of these commands, which are for item packages")
    items.set_defaults(function=_items)

    demo = commands.add_parser(
        "demo", help="simulate a slider-crank; write a picture with plots, and show a page that moves"
    )
    demo.add_argument("-o", "--output", default="slider_crank.png", help="the PNG file to write")
    demo.set_defaults(function=_demo)

    from dalembert import resultsMonitor

    plot = commands.add_parser("plot", help="plot files of sensors or solutions")
    plot.add_argument("file", nargs="+", help="a file of a sensor or a solution")
    plot.add_argument("-c", "--columns", help="columns as I,J; 0 is the first one after time (default: all)")
    plot.add_argument("--log-y", action="store_true", help="logarithmic y-axis")
    plot.add_argument("--title", default="", help="title of the plot")
    plot.add_argument("--save", default="", help="file for the plot, such as plot.png or plot.pdf")
    plot.set_defaults(function=_plot)

    dialogs = commands.add_parser("dialogs", help="left out: there are no dialogs; says where settings are found")
    dialogs.add_argument("what", nargs="?", help="ignored")
    dialogs.set_defaults(function=_dialogs)

    monitor = commands.add_parser("monitor", help="show a file of a sensor, a solution or a study while it is written")
    resultsMonitor.add_arguments(monitor)
    monitor.set_defaults(function=lambda given: resultsMonitor.show(given, monitor))
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command with the given arguments (default: those of the process) and return its exit code."""
    options = _parser().parse_args(arguments)
    try:
        return int(options.function(options))
    except BrokenPipeError:  # the reader has closed the pipe, for example head
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
