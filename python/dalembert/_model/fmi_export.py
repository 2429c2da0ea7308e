"""model.export_fmu: a model as an FMU for co-simulation, by the packages pythonfmu (FMI 2.0) and pythonfmu3 (3.0)."""

from __future__ import annotations

import importlib
import json
import os
import re
import shutil
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from uuid import uuid4

from dalembert import _version
from dalembert._checks import as_number, shape_error
from dalembert._core import ConfigurationType, DynamicSolverType, SimulationSettings
from dalembert._io.files import file_to_write, replacing
from dalembert._model import words
from dalembert._model.assembly import assemble_if_needed
from dalembert._model.fmi_import import events_of
from dalembert._model.fmi_signals import (
    Parameter,
    check_names,
    missing_package,
    parameters_of,
    signal_of,
    warn_of_inertia,
)
from dalembert._model.fmi_slave import Slave
from dalembert._model.solve import _settings

_SCRIPT = '''"""A model of dalembert {package} as a slave of co-simulation."""

import {module}
from {module}.enums import Fmi{n}Status
from {module} import Fmi{n}Slave

try:
    from dalembert._model.fmi_slave import connect, with_initial_unknowns
except ImportError as error:
    raise ImportError("this FMU needs the Python package dalembert {package}: pip install dalembert") from error


class {identifier}(Fmi{n}Slave):
    def __init__(self, **options):
        super().__init__(**options)
        self.model = connect(self, {module}, "{n}")

    def to_xml(self, *options):
        return with_initial_unknowns(super().to_xml(*options))

    def setup_experiment(self, start_time, *others):
        self.model.time = start_time

    def exit_initialization_mode(self):
        self.run(self.model.start)

    def do_step(self, current_time, step_size):
        return self.run(self.model.do_step, current_time, step_size)

    def terminate(self):
        for text in self.model.stop():
            self.log(text, Fmi{n}Status.warning)

    def run(self, function, *arguments):
        try:
            function(*arguments)
        except Exception as error:
            self.log("; ".join([str(error), *getattr(error, "__notes__", [])]), Fmi{n}Status.error)
            {failed}
        return True
'''


def export_fmu(
    model: Any,
    file_name: str | os.PathLike[str],
    inputs: Mapping[str, Any],
    outputs: Mapping[str, Any],
    step_size: float,
    *,
    parameters: Mapping[str, Any] | None = None,
    version: str = "2.0",
    method: str | DynamicSolverType = "generalized_alpha",
    settings: SimulationSettings | None = None,
) -> None:
    where = "model.export_fmu"
    if version not in ("2.0", "3.0"):
        raise ValueError(f"{where}: version: received {version!r}, but expected '2.0' or '3.0'")
    step = as_number(f"{where}: step_size", step_size)
    if step <= 0:
        raise shape_error(f"{where}: step_size", "a positive number", step_size)
    path = Path(file_to_write(f"{where}: file_name", file_name))
    if path.suffix.lower() != ".fmu":
        raise ValueError(f"{where}: file_name: expected a name that ends with .fmu, received '{file_name}'")
    used = _settings(where, settings)
    kind = words.member(DynamicSolverType, method, f"{where}: method")
    if used.continuation.restartFileName or used.continuation.ifAvailable:
        raise ValueError(f"{where}: settings.continuation: a solution of an FMU cannot be continued from a file")
    if events_of(model.system):
        raise ValueError(f"{where}: the model has FMUs itself; connect them in the program that imports the new one")
    used.timeIntegration.verboseMode = 0 if settings is None else used.timeIntegration.verboseMode
    used.solutionSettings.writeSolutionToFile = used.solutionSettings.sensorsStoreAndWriteFiles = False
    assemble_if_needed(model.system)
    facts = _facts(model, inputs, outputs, parameters or {}, where)
    facts |= {"stepSize": step, "method": kind.name, "package": _version.__version__}
    module = "pythonfmu" if version == "2.0" else "pythonfmu3"
    try:
        builder = importlib.import_module(f"{module}.builder").FmuBuilder
    except ImportError:
        raise missing_package(where, module) from None
    if not builder.has_binary():
        raise RuntimeError(f"{where}: the package {module} has no library for this operating system and processor")
    with tempfile.TemporaryDirectory(prefix="dalembert") as folder:
        model.system.Save(Path(folder, "model.json"), used, sourceOfFunctions=True)
        Path(folder, "signals.json").write_text(json.dumps(facts), "utf-8")
        _require_start(Path(folder), where)
        made = _built(builder, module, version[0], path, Path(folder))
        with replacing(path) as written:
            shutil.copyfile(made, written)


def _require_start(folder: Path, where: str) -> None:
    """Begin a solution with the files of the FMU: importers give errors of models without their texts."""
    slave = Slave(str(folder))
    try:
        slave.start()
    except Exception as error:
        hint = "; functions must define or import all that they use" if isinstance(error, NameError) else ""
        raise RuntimeError(f"{where}: the exported model cannot start: {error}{hint}") from error
    finally:
        slave.stop()


def _facts(model: Any, inputs: Any, outputs: Any, parameters: Any, where: str) -> dict[str, Any]:
    """Return the signals, and the initial state, for the file in the FMU."""
    settable: dict[str, Parameter] = {}
    tunable: list[str] = []
    for argument, given in (("inputs", inputs), ("parameters", parameters)):
        check_names(f"{where}: {argument}", given, "{'torque': load}")
        for name, each in given.items():
            found = parameters_of(model, each, name, f"{where}: {argument}['{name}']")
            if again := [one for one in found if one in settable]:
                raise ValueError(f"{where}: {argument}: '{again[0]}' is also the name of an input")
            for one in found.values():
                if twice := [key for key, other in settable.items() if other.plain() == one.plain()]:
                    raise ValueError(
                        f"{where}: {argument}['{name}']: '{twice[0]}' sets {one.name} of {one.handle!r} as well"
                    )
            settable |= found
            tunable += found if argument == "parameters" else []
    warn_of_inertia(where, settable.values())
    check_names(f"{where}: outputs", outputs, "{'angle': sensor}")
    sources, names = [], []
    for name, each in outputs.items():
        source = signal_of(model, each, f"{where}: outputs['{name}']")
        size = len(source.values())
        sources.append(source.plain())
        names += [name] if size == 1 else [f"{name}[{i + 1}]" for i in range(size)]
    if taken := [each for each in names if each in settable]:
        raise ValueError(f"{where}: outputs: '{taken[0]}' is also the name of an input or parameter")
    data, initial = model.system.systemData, ConfigurationType.Initial
    state = [*data.GetSystemState(initial), data.GetODE2Coordinates_tt(initial)]
    return {
        "parameters": {name: each.plain() for name, each in settable.items()},
        "tunable": tunable,
        "outputs": sources,
        "names": names,
        "state": [each.tolist() for each in state],
    }


def _built(builder: Any, module: str, n: str, path: Path, folder: Path) -> Path:
    """Return the FMU in a folder that has the files of the model."""
    identifier = re.sub(r"\W", "_", path.stem, flags=re.ASCII)
    identifier = identifier if identifier[:1].isalpha() else f"fmu_{identifier}"
    # Importers keep modules by name; another FMU with this name would get this one.
    name = f"{identifier}_{uuid4().hex}"
    script = folder / f"{name}.py"
    failed = "raise" if n == "2" else "return pythonfmu3.Fmi3StepResult(status=Fmi3Status.error)"
    text = _SCRIPT.format(package=_version.__version__, module=module, n=n, identifier=identifier, failed=failed)
    script.write_text(text, "utf-8")
    files = [each for each in folder.iterdir() if each != script]
    paths = list(sys.path)
    try:
        made = builder.build_FMU(script, folder, project_files=files)
    finally:
        sys.path[:] = paths
        sys.modules.pop(name, None)
    return Path(made)
