"""Dialogs that let users drive a simulation or browse a solution; they also run without a viewer."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert import _core
from dalembert._calls import check_given
from dalembert._checks import as_number, as_positive, check_integer, check_type, shape_error
from dalembert._core import ConfigurationType, OutputVariableType, Print
from dalembert._io.output_paths import OutputFilePath
from dalembert._io.solution_states import LoadSolutionFile, SetSolutionState, check_solution, check_solution_of
from dalembert._tools import dialog_items
from dalembert._tools.user_interface import UIWindowSuppressed

_noticed: set[str] = set()


def _notice_once(what: str) -> None:
    """Say once per process that something runs without a window."""
    if what not in _noticed:
        _noticed.add(what)
        Print(f"{what}: there is no window to open, continuing without it")


MOST_IMAGES = 10_000  # images of one oscillation


class LabelText:
    """The text of a label in a dialog, which the simulation may set; the page shows it when it shows curves anew."""

    def __init__(self, item: dict[str, Any]) -> None:
        self._item = item

    def set(self, text: Any) -> None:
        """Change the text."""
        self._item["text"] = str(text)

    def get(self) -> str:
        """Return the text."""
        return str(self._item.get("text", ""))


def _check_function(name: str, value: Any) -> None:
    if not callable(value):
        raise shape_error(name, "a function of the system and the dialog", value)


class InteractiveDialog:
    """A simulation in periods of real time, with values that dialog items set in mbs.variables (or mbs.sys).

    The live viewer (SC.renderer.Start) shows the dialog until it is closed or Q is pressed. If there is no viewer,
    all dialog items keep their initial values; runOnStart then runs the simulation from startTime to endTime of the
    settings (if there is no time integration, simulationFunction is called once).
    """

    def __init__(
        self,
        mbs: Any,
        simulationSettings: Any,
        simulationFunction: Callable[[Any, Any], Any],
        dialogItems: list[dict[str, Any]],
        plots: Any = None,
        period: float = 0.04,
        realtimeFactor: float = 1,
        userStartSimulation: Callable[[bool], Any] | None = None,
        title: str = "",
        showTime: bool = False,
        fontSize: int = 12,
        doTimeIntegration: bool = True,
        runOnStart: bool = False,
        addLabelStringVariables: bool = False,
        addSliderVariables: bool = False,
        checkRenderEngineStopFlag: bool = True,
        userOnChange: Callable[[Any, Any], Any] | None = None,
        useSysVariables: bool = False,
        windowSize: Any = None,
    ) -> None:
        """Store the arguments, initialize the solver and, if runOnStart is set, run; period in s.

        fontSize and windowSize have no effect: the browser sets them.
        """
        check_given(InteractiveDialog.__init__, locals().items())
        here = "InteractiveDialog:"
        check_type(f"{here} mbs", mbs, _core.MainSystem)
        check_type(f"{here} simulationSettings", simulationSettings, _core.SimulationSettings)
        check_type(f"{here} title", title, str)
        period = as_positive(f"{here} period", period)
        realtimeFactor = as_positive(f"{here} realtimeFactor", realtimeFactor)
        _check_function(f"{here} simulationFunction", simulationFunction)
        for name, function in (("userStartSimulation", userStartSimulation), ("userOnChange", userOnChange)):
            if function is not None:
                _check_function(f"{here} {name}", function)
        dialog_items.check_plots(f"{here} plots", mbs, plots)
        dialog_items.check_items(f"{here} dialogItems", dialogItems)
        self.mbs, self.SC = mbs, mbs.GetSystemContainer()
        self.simulationSettings, self.simulationFunction = simulationSettings, simulationFunction
        self.dialogItems, self.plots = dialogItems, plots or []
        self.period, self.realtimeFactor, self.title = period, realtimeFactor, title
        self.userStartSimulation, self.userOnChange = userStartSimulation, userOnChange
        self.doTimeIntegration = doTimeIntegration
        self.checkRenderStop = checkRenderEngineStopFlag
        integration = simulationSettings.timeIntegration
        self.endTime = float(integration.endTime)
        self.stepSize = integration.endTime / integration.numberOfSteps
        self.counter = 0
        self.simulationStopped = True
        self.values = {item["variable"]: dialog_items.initial_value(item) for item in dialogItems if "variable" in item}
        labels = (item for item in dialogItems if item["type"] == "label")
        self.labelStringVariables = [LabelText(item) for item in labels] if addLabelStringVariables else []
        self._variables = mbs.sys if useSysVariables else mbs.variables

        self.InitializeSolver()
        self.InitializePlots()
        self.ProcessWidgetStates()
        if self._has_readers():
            from dalembert._live import dialogs, viewer

            dialogs.run(self, viewer.start(self.SC), runOnStart)
        else:
            _notice_once(title or "InteractiveDialog")
            if runOnStart:
                self.StartSimulation()
        self.FinalizeSolver()

    def _has_readers(self) -> bool:
        """Return whether a viewer is open and its messages are received."""
        if not self.SC.renderer.IsActive() or UIWindowSuppressed("Dialogs", "InteractiveDialog"):
            return False
        from dalembert._live import viewer

        found = viewer.start(self.SC).server.answers()
        if not found:
            Print("dalembert: pages cannot be heard while this cell runs; first SC.renderer.Start() in another cell.")
        return found

    def OnQuit(self, event: Any = None) -> None:
        """Stop the simulation."""
        self.simulationStopped = True

    def StartSimulation(self, event: Any = None) -> None:
        """Start the simulation, or stop it if it runs."""
        self.simulationStopped = not self.simulationStopped
        if self.userStartSimulation is not None:
            self.userStartSimulation(self.simulationStopped)
        self.ContinuousRunFunction()

    def ProcessWidgetStates(self) -> None:
        """Hand the values of the dialog items to the system; userOnChange is called if one of them is new."""
        if any(self._variables.get(name, self) != value for name, value in self.values.items()):
            self._variables.update(self.values)
            if self.userOnChange is not None:
                self.userOnChange(self.mbs, self)

    def ContinuousRunFunction(self, event: Any = None) -> None:
        """Run period after period until the end time, or until something stops the simulation."""
        integration = self.simulationSettings.timeIntegration
        while not self.simulationStopped:
            if self.mbs.GetRenderEngineStopFlag() and self.checkRenderStop:
                self.OnQuit()
                return
            self.RunSimulationPeriod()
            self.counter += 1
            if not self.doTimeIntegration or integration.startTime >= self.endTime * (1 - 1e-12):
                self.OnQuit()

    def InitializePlots(self) -> None:
        """Do nothing: there is no window for plots."""

    def UpdatePlots(self) -> None:
        """Do nothing: there is no window for plots."""

    def InitializeSolver(self) -> None:
        """Create the implicit solver mbs.sys['solver'] and initialize it."""
        if self.doTimeIntegration:
            self.mbs.sys["solver"] = _core.MainSolverImplicitSecondOrder()
            self.mbs.sys["solver"].InitializeSolver(self.mbs, self.simulationSettings)

    def FinalizeSolver(self) -> None:
        """Close the files of the solver."""
        if self.doTimeIntegration:
            self.mbs.sys["solver"].FinalizeSolver(self.mbs, self.simulationSettings)

    def RunSimulationPeriod(self) -> float:
        """Call simulationFunction, integrate over one period and return the time (s) that is reached."""
        self.simulationFunction(self.mbs, self)
        self.UpdatePlots()
        integration = self.simulationSettings.timeIntegration
        if self.doTimeIntegration:
            data, solver = self.mbs.systemData, self.mbs.sys["solver"]
            integration.numberOfSteps = max(int(self.period / self.stepSize), 1)
            integration.endTime = integration.startTime + self.period
            accelerations = data.GetODE2Coordinates_tt(configuration=ConfigurationType.Current)
            solver.InitializeSolverInitialConditions(self.mbs, self.simulationSettings)
            data.SetODE2Coordinates_tt(coordinates=accelerations)
            solver.SolveSteps(self.mbs, self.simulationSettings)
            data.SetSystemState(systemStateList=data.GetSystemState(), configuration=ConfigurationType.Initial)
            integration.startTime += self.period
        return float(integration.endTime)


def AnimateModes(
    systemContainer: Any,
    mainSystem: Any,
    nodeNumber: Any,
    period: float = 0.04,
    stepsPerPeriod: int = 30,
    showTime: bool = True,
    renderWindowText: str = "",
    runOnStart: bool = False,
    runMode: int = 0,
    scaleAmplitude: float = 1,
    title: str = "",
    fontSize: int = 12,
    checkRenderEngineStopFlag: bool = True,
    systemEigenVectors: Any = None,
) -> None:
    """Show the modes of a node with modal coordinates, or eigenvectors (columns) of the system if nodeNumber is None.

    Notebooks, browsers on a display, or the open live viewer show all modes one after the other, each for one
    oscillation of stepsPerPeriod images, `period` seconds apart. Otherwise the first mode, with a small amplitude,
    becomes the visualization state. ValueError without modes.
    """
    check_type("AnimateModes: systemContainer", systemContainer, _core.SystemContainer)
    check_type("AnimateModes: mainSystem", mainSystem, _core.MainSystem)
    check_type("AnimateModes: title", title, str)
    check_type("AnimateModes: renderWindowText", renderWindowText, str)
    period = as_positive("AnimateModes: period", period)
    check_integer("AnimateModes: runMode", runMode, 0, 3)
    check_integer("AnimateModes: stepsPerPeriod", stepsPerPeriod, 1, MOST_IMAGES)
    amplitude = 0.05 * as_number("AnimateModes: scaleAmplitude", scaleAmplitude)
    check_given(AnimateModes, locals().items())
    data = mainSystem.systemData
    base, modes = _modes(mainSystem, nodeNumber, systemEigenVectors)
    data.SetODE2Coordinates(base + amplitude * modes[0], ConfigurationType.Visualization)

    from dalembert._pictures.showing import show_solution

    phases = np.sin(2 * np.pi * np.arange(stepsPerPeriod) / stepsPerPeriod)
    states = [base + amplitude * phase * mode for mode in modes for phase in phases]
    rows = np.column_stack([period * np.arange(len(states)), np.array(states)])
    solution = {"data": rows, "nRows": len(rows), "columnsExported": [len(base), 0, 0, 0, 0, 0, 0]}
    captions = [f"mode {number}" for number in range(len(modes)) for _ in phases]
    if not show_solution(mainSystem, solution, period, title or "modes", runOnStart, 1, captions):
        _notice_once(title or "AnimateModes")


def _modes(mbs: Any, nodeNumber: Any, eigenvectors: Any) -> tuple[Any, Any]:
    """Return the coordinates around which modes are shown, and a mode per row."""
    data = mbs.systemData
    size = data.ODE2Size()
    if nodeNumber is not None:
        from dalembert._tools.found_items import index_of

        nodeNumber = index_of(mbs, "Node", nodeNumber, "AnimateModes: nodeNumber")
        reference = (OutputVariableType.Coordinates, ConfigurationType.Reference)
        number = len(np.atleast_1d(mbs.GetNodeOutput(nodeNumber, *reference)))
        if number == 0:
            raise ValueError(f"AnimateModes: nodeNumber: node {nodeNumber} has no modal coordinates")
        first = mbs.GetNodeODE2Index(nodeNumber)
        return np.array(data.GetODE2Coordinates(), dtype=float), np.eye(size)[first : first + number]
    columns = eigenvectors.T if isinstance(eigenvectors, np.ndarray) else eigenvectors
    try:
        modes = [np.real(np.asarray(mode, complex)) for mode in columns]
    except (TypeError, ValueError):
        modes = []
    if not modes or any(mode.ndim != 1 or len(mode) < size or not np.isfinite(mode).all() for mode in modes):
        expected = (
            f"an array with modes in columns, or a list of modes, with at least {size} finite components each, "
            "because nodeNumber is None"
        )
        raise shape_error("AnimateModes: systemEigenVectors", expected, eigenvectors)
    return np.zeros(size), np.array([mode[:size] for mode in modes])


def solution_of_last_simulation(mbs: Any, caller: str) -> dict[str, Any]:
    """Return the solution file of the last simulation; ValueError if it has not written one."""
    if "simulationSettings" not in mbs.sys:
        raise ValueError(f"{caller}: no simulation has been run yet; solve first or pass a solution")
    settings = mbs.sys["simulationSettings"].solutionSettings
    if not settings.writeSolutionToFile:
        raise ValueError(f"{caller}: the last simulation had solutionSettings.writeSolutionToFile = False")
    name = settings.coordinatesSolutionFileName
    if "." not in name:
        name += ".sol" if settings.binarySolutionFile else ".txt"
    return LoadSolutionFile(OutputFilePath(name))


def SolutionViewer(
    mainSystem: Any,
    solution: dict[str, Any] | None = None,
    rowIncrement: int = 1,
    timeout: float = 0.04,
    runOnStart: bool = True,
    runMode: int = 2,
    fontSize: int = 12,
    title: str = "",
    checkRenderEngineStopFlag: bool = True,
    windowSize: Any = None,
) -> None:
    """Browse a solution (from LoadSolutionFile), or that of the last simulation if solution is None.

    Notebooks play it in the cell; on a display, the browser plays it, otherwise the open live viewer. If there is
    no viewer, the first row becomes the visualization state. `rowIncrement` skips rows,
    `timeout` is the time (s) between shown rows, `runOnStart` starts to play, `runMode` 0 plays once, 1 and 2
    again and again. fontSize and windowSize have no effect. ValueError if there is no solution, unless viewers are
    suppressed.
    """
    check_given(SolutionViewer, locals().items())
    check_type("SolutionViewer: mainSystem", mainSystem, _core.MainSystem)
    check_type("SolutionViewer: title", title, str)
    timeout = as_positive("SolutionViewer: timeout", timeout)
    check_integer("SolutionViewer: runMode", runMode, 0, 2)
    suppressed = UIWindowSuppressed("SolutionViewer")
    if suppressed and solution is None and "simulationSettings" not in mainSystem.sys:
        return
    data = solution_of_last_simulation(mainSystem, "SolutionViewer") if solution is None else solution
    check_solution("SolutionViewer", data)
    check_solution_of(mainSystem, "SolutionViewer", data)
    check_integer("SolutionViewer: rowIncrement", rowIncrement, 1, data["nRows"])
    from dalembert._pictures.showing import show_solution

    rows = {**data, "data": np.asarray(data["data"], float)[::rowIncrement]}
    if suppressed or not show_solution(mainSystem, rows, timeout, title, runOnStart, runMode):
        SetSolutionState(mainSystem, data, 0, ConfigurationType.Visualization)
        _notice_once(title or "SolutionViewer")


def ConvertImages2Video(
    workingDir: str = "images",
    inputPattern: str = "frame%05d.png",
    outputFile: str = "animation.mp4",
    inputFrameRate: int = 25,
    outputFrameRate: int = 25,
    compressionCRF: int = 28,
    startNumber: int = 0,
    totalFrames: int | None = None,
) -> None:
    """Make a video (H.264) of numbered images by the program ffmpeg; rates in frames per second.

    compressionCRF: 0 is lossless, larger values give smaller files. FileNotFoundError if ffmpeg is not installed,
    RuntimeError with its message if it fails.
    """
    check_given(ConvertImages2Video, locals().items())
    here = "ConvertImages2Video:"
    rates = [as_positive(f"{here} {name}", rate) for name, rate in (
        ("inputFrameRate", inputFrameRate), ("outputFrameRate", outputFrameRate),
    )]  # fmt: skip
    check_integer(f"{here} compressionCRF", compressionCRF, 0, 51)
    check_integer(f"{here} startNumber", startNumber, 0)
    if totalFrames is not None:
        check_integer(f"{here} totalFrames", totalFrames, 1)
    from dalembert._pictures.films import make_video

    make_video(here, workingDir, inputPattern, outputFile, rates, compressionCRF, startNumber, totalFrames)


def InteractiveImages2Video(closeAfterCreation: bool = False, fontSize: int = 11) -> None:
    """Say that there is no window; ConvertImages2Video does the same without one."""
    _notice_once("InteractiveImages2Video")
