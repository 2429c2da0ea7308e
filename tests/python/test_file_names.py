"""Functions with a file name raise errors with the name of the argument and the reason."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import FEM, graphics, plot, processing, results, utilities
from dalembert.resultsMonitor import Monitor
from dalembert.robotics.utilities import LoadURDFrobot, ReadRobot

Named = Callable[[Any], Any]


def system() -> Any:
    return exu.SystemContainer().AddSystem()


def solved() -> Any:
    mbs = system()
    mbs.CreateMassPoint("mass", [1, 0, 0], physicsMass=1)
    mbs.AddSensor(
        exu.SensorBody("s", bodyNumber="mass", storeInternal=True, outputVariableType=exu.OutputVariableType.Position)
    )
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    return mbs


def meshed() -> FEM.FEMinterface:
    fem = FEM.FEMinterface()
    fem.SetMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], {"Tet4": [[0, 1, 2, 3]]})
    fem.AssembleMatrices(FEM.KirchhoffMaterial(1e9, 0.3, 1000))
    return fem


def studied(**options: Any) -> Any:
    return processing.ParameterVariation(lambda p: p["a"], {"a": (0, 1, 2)}, showProgress=False, **options)


READ: dict[str, Named] = {
    "LoadSolutionFile: fileName": utilities.LoadSolutionFile,
    "LoadBinarySolutionFile: fileName": utilities.LoadBinarySolutionFile,
    "InitializeFromRestartFile: restartFileName": lambda file: utilities.InitializeFromRestartFile(
        system(), exu.SimulationSettings(), file
    ),
    "RecoverSolutionFile: fileName": lambda file: utilities.RecoverSolutionFile(file, "new.txt"),
    "LoadDictFromHDF5: fileName": lambda file: exu.advancedUtilities.LoadDictFromHDF5(file),
    "mbs.Load(...): fileName": lambda file: system().Load(file),
    "ReadMatrixFromAnsysMMF: fileName": FEM.ReadMatrixFromAnsysMMF,
    "ReadMatrixDOFmappingVectorFromAnsysTxt: fileName": FEM.ReadMatrixDOFmappingVectorFromAnsysTxt,
    "ReadNodalCoordinatesFromAnsysTxt: fileName": FEM.ReadNodalCoordinatesFromAnsysTxt,
    "ReadElementsFromAnsysTxt: fileName": FEM.ReadElementsFromAnsysTxt,
    "ReadNodesFromAbaqusInp: fileName": FEM.ReadNodesFromAbaqusInp,
    "FEMinterface.ImportFromAbaqusInputFile: fileName": lambda file: FEM.FEMinterface().ImportFromAbaqusInputFile(file),
    "FEMinterface.ReadMassMatrixFromAbaqus: fileName": lambda file: FEM.FEMinterface().ReadMassMatrixFromAbaqus(file),
    "FEMinterface.ReadStiffnessMatrixFromAnsys: fileName": lambda file: FEM.FEMinterface().ReadStiffnessMatrixFromAnsys(
        file, "map.txt"
    ),
    "FEMinterface.LoadFromFile: fileName": lambda file: FEM.FEMinterface().LoadFromFile(file),
    "ObjectFFRFreducedOrderInterface.LoadFromFile: fileName": lambda file: (
        FEM.ObjectFFRFreducedOrderInterface().LoadFromFile(file)
    ),
    "SolutionToXarray: fileName": results.SolutionToXarray,
    "SolutionToPandas: fileName": results.SolutionToPandas,
    "LoadHDF5: fileName": results.LoadHDF5,
    "SaveHDF5: solutionFile": lambda file: results.SaveHDF5(solved(), "new.h5", solutionFile=file),
    "LoadImage: fileName": plot.LoadImage,
    "FromSTLfile: fileName": graphics.FromSTLfile,
    "FromSTLfileASCII: fileName": graphics.FromSTLfileASCII,
    "ReadRobot: fileName": ReadRobot,
    "CreateRobot: fileName": lambda file: system().CreateRobot(file),
    "LoadURDFrobot: urdfFilePath": lambda file: LoadURDFrobot(file, "."),
    "resultsMonitor: fileName": Monitor,
    "FileStripSpaces: filename": lambda file: plot.FileStripSpaces(file, "new.txt"),
}
WRITTEN: dict[str, Named] = {
    "mbs.Save(...): fileName": lambda file: system().Save(file),
    "SaveDictToHDF5: fileName": lambda file: exu.advancedUtilities.SaveDictToHDF5(file, {}),
    "RecoverSolutionFile: newFileName": lambda file: utilities.RecoverSolutionFile("some.txt", file),
    "SaveHDF5: fileName": lambda file: results.SaveHDF5(solved(), file),
    "SaveHTML: fileName": lambda file: solved().SaveHTML(file),
    "SaveGLB: fileName": lambda file: solved().SaveGLB(file),
    "SaveVTU: fileName": lambda file: solved().SaveVTU(file),
    "DrawSolution: fileName": lambda file: solved().DrawSolution(file),
    "Draw: fileName": lambda file: solved().Draw(file),
    "PlotSensor: fileName": lambda file: solved().PlotSensor("s", fileName=file),
    "PlotPhase: fileName": lambda file: plot.PlotPhase(solved(), "s", "s", fileName=file),
    "PlotSensorFFT: fileName": lambda file: plot.PlotSensorFFT(solved(), "s", fileName=file),
    "FEMinterface.SaveToFile: fileName": lambda file: meshed().SaveToFile(file),
    "ExportSTL: fileName": lambda file: graphics.ExportSTL(graphics.Sphere(), file),
    "ParameterVariation: resultsFile": lambda file: studied(resultsFile=file),
    "ProcessParameterList: resultsFile": lambda file: processing.ProcessParameterList(
        lambda p: 1, [{"a": 1}], False, resultsFile=file
    ),
    "GeneticOptimization: resultsFile": lambda file: processing.GeneticOptimization(
        lambda p: p["a"], {"a": (0, 1)}, 2, 2, showProgress=False, resultsFile=file
    ),
    "Minimize: resultsFile": lambda file: processing.Minimize(
        lambda p: p["a"], {"a": (0, 1)}, showProgress=False, resultsFile=file
    ),
    "FileStripSpaces: outputFilename": lambda file: plot.FileStripSpaces("some.txt", file),
}
OPTIONAL = {"Draw", "PlotSensor", "PlotPhase", "PlotSensorFFT"}  # None and "" stand for no file
MAKE_FOLDERS = OPTIONAL | {"SaveHTML", "SaveGLB", "SaveVTU", "DrawSolution", "FEMinterface.SaveToFile"}
STUDIES = {"ParameterVariation", "ProcessParameterList", "GeneticOptimization", "Minimize"}
MAY_BE_EMPTY = {"resultsMonitor", "FileStripSpaces"}  # it waits for the first row


@pytest.fixture(autouse=True)
def in_a_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("folder.txt").mkdir()
    for ending in (".npz", ".h5"):
        Path(f"folder{ending}").mkdir()
    Path("some.txt").write_text("1, 2\n")


def refused(function: Named, file: Any, kind: type[Exception]) -> str:
    before = sorted(os.listdir())
    with np.errstate(all="ignore"), pytest.raises(kind) as caught:
        function(file)
    assert sorted(os.listdir()) == before
    return str(caught.value)


@pytest.mark.parametrize(("name", "function"), [*READ.items(), *WRITTEN.items()])
def test_invalid_names(name: str, function: Named) -> None:
    where = name.partition(":")[0]
    for given in (3, None, ["a.txt"], ""):
        if (given in (None, "") and where in OPTIONAL | STUDIES) or (given is None and "solutionFile" in name):
            continue
        text = refused(function, given, ValueError if given == "" else TypeError)
        assert f"{name}: expected the name of a file, received {given!r}" in text, text


@pytest.mark.parametrize(("name", "function"), [*READ.items(), *WRITTEN.items()])
def test_a_folder(name: str, function: Named) -> None:
    text = refused(function, "folder.npz" if "SaveToFile" in name or "LoadFrom" in name else "folder.txt", OSError)
    assert f"{name}: expected a file, but this is a folder: 'folder" in text


@pytest.mark.parametrize(("name", "function"), READ.items())
def test_a_file_that_is_not_there(name: str, function: Named) -> None:
    text = refused(function, "sone.txt", FileNotFoundError)
    assert f"{name}: there is no such file in the folder '{os.getcwd()}'" in text and "'sone.txt" in text
    if "LoadFromFile" not in name:  # it adds an ending
        assert "Did you mean 'some.txt'?" in text
    assert "nor the folder" in refused(function, "nowhere/some.txt", FileNotFoundError)


@pytest.mark.parametrize(("name", "function"), READ.items())
def test_an_empty_file(name: str, function: Named) -> None:
    if name.partition(":")[0] in MAY_BE_EMPTY:
        return
    Path("empty.npz").touch()
    assert f"{name}: the file 'empty.npz' is empty" in refused(function, "empty.npz", ValueError)


@pytest.mark.parametrize(("name", "function"), WRITTEN.items())
def test_a_folder_that_is_not_there(name: str, function: Named) -> None:
    where = name.partition(":")[0]
    if where in MAKE_FOLDERS | STUDIES:
        return
    assert f"{name}: there is no folder '{os.getcwd()}/nowhere'" in refused(
        function, "nowhere/a.txt", FileNotFoundError
    )


def test_paths_are_names() -> None:
    mbs = solved()
    mbs.Save(Path("model.json"))
    system().Load(Path("model.json"))
    mbs.Draw(Path("picture.png"))
    mbs.PlotSensor("s", fileName=Path("new/plot.png"))  # type: ignore[arg-type]
    studied(resultsFile=Path("new/study.txt"))
    assert Path("picture.png").stat().st_size and Path("new/plot.png").exists() and Path("new/study.txt").exists()
