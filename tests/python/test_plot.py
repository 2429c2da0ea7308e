"""Plots of sensors, files and arrays; headers of result files; vector images."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib.pyplot
import numpy as np
import pytest

from dalembert import plot

TIME = np.linspace(0, 1, 11)
DATA = np.column_stack([TIME, TIME**2, -TIME, 1 + TIME])

SENSOR_HEADER = """#dalembert implicit second order solver sensor output file
#measure Node number = 3
#OutputVariableType = Position
#columns contain: time, comma separated sensor values
#number of sensor values = 3
#
"""


class System:
    """Stands for a MainSystem with three sensors: stored, without data, of a load."""

    def GetSensor(self, number: int) -> dict[str, Any]:
        common = {"name": f"s{number}", "fileName": "", "writeToFile": True}
        if number == 2:
            return common | {"storeInternal": True, "sensorType": "Load", "loadNumber": 0}
        return common | {
            "storeInternal": number == 0,
            "sensorType": "Node",
            "outputVariableType": "OutputVariableType.Position",
        }

    def GetSensorNumber(self, name: str) -> int:
        return -1

    def GetLoad(self, number: int) -> dict[str, Any]:
        return {"loadType": "ForceVector"}

    def GetSensorStoredData(self, number: int) -> Any:
        return DATA

    def GetSensorValues(self, number: int) -> Any:
        return 10.0 * number if number == 7 else np.array([number, 2.0 * number])


@pytest.fixture
def mbs() -> Any:
    yield System()
    plot.PlotSensorDefaults().fontSize = 16
    matplotlib.pyplot.close("all")


def curves(axes: Any) -> list[Any]:
    return [(line.get_xdata(), line.get_ydata(), line.get_label()) for line in axes.get_lines()]


def test_sensor_over_time(mbs: Any) -> None:
    pyplot, figure, axes, line = plot.PlotSensor(mbs, 0, components=[0, 2, plot.componentNorm])
    (x, y0, label0), (_, y1, label1), (_, norm, _) = curves(axes)
    np.testing.assert_array_equal(x, TIME)
    np.testing.assert_array_equal(y0, TIME**2)
    np.testing.assert_array_equal(y1, 1 + TIME)
    np.testing.assert_allclose(norm, np.linalg.norm(DATA[:, 1:], axis=1))
    assert (label0, label1) == ("s0, PositionX", "s0, PositionZ")
    assert axes.get_xlabel() == "time (s)" and axes.get_ylabel() == "Position"
    assert pyplot is matplotlib.pyplot and figure.axes == [axes] and len(line) == 1


def test_load_sensor_is_named_by_its_load(mbs: Any) -> None:
    axes = plot.PlotSensor(mbs, [0, 2], components=0)[2]
    assert [label for *_, label in curves(axes)] == ["s0, PositionX", "s2, ForceX"]
    assert axes.get_ylabel() == "Position, Force (N)"


def test_factors_offsets_and_other_x(mbs: Any) -> None:
    axes = plot.PlotSensor(mbs, 0, components=1, componentsX=0, factors=2.0, offsets=3)[2]
    np.testing.assert_allclose(curves(axes)[0][0], TIME**2)
    np.testing.assert_allclose(curves(axes)[0][1], 2 * (3 - TIME))
    axes = plot.PlotSensor(mbs, DATA, components=1, offsets=-DATA)[2]
    np.testing.assert_array_equal(curves(axes)[0][1], 0)


def test_labels_of_axes(mbs: Any) -> None:
    """Also where that is not time: on the x-axis, and, for component -1, on the y-axis."""
    for arguments, expected in (
        ({"components": 1, "componentsX": 0}, ("PositionX", "Position")),
        ({"components": -1, "componentsX": 2}, ("PositionZ", "time (s)")),
        ({"components": [1, 2], "componentsX": [0, -1]}, ("PositionX, time (s)", "Position")),
        ({"components": 1, "componentsX": 0, "useXYZcomponents": False}, ("Position0", "Position")),
        ({"components": 1, "componentsX": 0, "xLabel": "a", "yLabel": "b"}, ("a", "b")),
        ({"sensorNumbers": 2, "components": 1, "componentsX": 0}, ("ForceX (N)", "Force (N)")),
    ):
        axes = plot.PlotSensor(mbs, **{"sensorNumbers": 0} | arguments)[2]
        assert (axes.get_xlabel(), axes.get_ylabel()) == expected


def test_styles_and_axes(mbs: Any) -> None:
    axes = plot.PlotSensor(
        mbs, [DATA] * 2, components=[0, 1], colors=["r", "b"], lineStyles=["--", ":"], lineWidths=2.5,
        markerStyles=["o ", "x"], markerSizes=[3, 4], markerDensity=5, labels=["a", "b"], rangeX=[0, 0.5],
        rangeY=[-1, 2], title="title", legendArgs="upper left", logScaleX=False, minorTicksXon=True,
    )[2]  # fmt: skip
    first, second = axes.get_lines()
    assert (first.get_color(), first.get_linestyle(), first.get_linewidth()) == ("r", "--", 2.5)
    assert (first.get_marker(), first.get_fillstyle(), first.get_markevery()) == ("o", "none", 3)
    assert (second.get_marker(), second.get_fillstyle(), second.get_markersize()) == ("x", "full", 4)
    assert axes.get_xlim() == (0, 0.5) and axes.get_ylim() == (-1, 2) and axes.get_title() == "title"
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["a", "b"]


def test_figures_and_subplots(mbs: Any, tmp_path: Path) -> None:
    file = tmp_path / "folder" / "figure.png"
    _, figure, _, _ = plot.PlotSensor(mbs, 0, subPlot=[2, 1, 1], closeAll=True, sizeInches=[3, 2])
    _, again, axes, _ = plot.PlotSensor(
        mbs, 0, 1, subPlot=[2, 1, 2], newFigure=False, sizeInches=[3, 2], fileName=str(file)
    )
    assert again is figure and len(figure.axes) == 2 and axes is figure.axes[1]
    np.testing.assert_allclose(figure.get_size_inches(), [6, 2])
    assert file.stat().st_size > 0


def test_defaults_are_taken_for_original_values(mbs: Any) -> None:
    plot.PlotSensorDefaults().fontSize = 9
    plot.PlotSensor(mbs, 0)
    assert matplotlib.rcParams["font.size"] == 9
    plot.PlotSensor(mbs, 0, fontSize=11)
    assert matplotlib.rcParams["font.size"] == 11
    assert "'fontSize': 9" in repr(plot.PlotSensorDefaults())


def test_sensor_file(mbs: Any, tmp_path: Path) -> None:
    file = tmp_path / "foot.txt"
    file.write_text(SENSOR_HEADER + "".join(",".join(map(str, row)) + "\n" for row in DATA))
    axes = plot.PlotSensor(None, str(file), components=[0, 1])[2]
    assert [label for *_, label in curves(axes)] == ["foot, PositionX", "foot, PositionY"]


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"sensorNumbers": [0, 0, 0], "components": [0, 1]}, "3 sensorNumbers and 2 components"),
        ({"sensorNumbers": 1}, "sensor 1 's1' keeps no data: create it with storeInternal=True"),
        ({"sensorNumbers": 0, "components": 3}, "has components 0 to 2 .-1: time., but not 3"),
        ({"sensorNumbers": 0, "componentsX": [0, 1]}, "componentsX has 2 entries, but there are 1 curves"),
        ({"sensorNumbers": 1.5}, "sensorNumbers: expected indices or numbers of sensors, .* received 1.5 .float."),
        ({"sensorNumbers": 0, "logScale": True}, "unknown argument 'logScale'"),
        ({"sensorNumbers": [0, 0], "factors": [1, 2, 3]}, "factors must be a number or a list with 2 entries, not 3"),
        ({"sensorNumbers": 0, "offsets": np.zeros((2, 2))}, r"offset has shape \(2, 2\), but the data has \(11, 4\)"),
        ({"sensorNumbers": 0, "rangeX": [1]}, r"rangeX: expected \[minimum, maximum\]"),
        ({"sensorNumbers": 0, "subPlot": [1, 2]}, r"subPlot: expected \[columns, rows, position\]"),
        *(
            ({"sensorNumbers": 0, name: value}, f"^PlotSensor: {name}: ")
            for name, value in [
                ("components", np.nan),
                ("componentsX", "x"),
                ("figureName", 1j),
                ("fontSize", -1),
                ("colors", "x"),
                ("lineStyles", "x"),
                ("lineWidths", [["a"]]),
                ("markerStyles", "\0"),
                ("markerStyles", [1]),
                ("markerSizes", [None]),
                ("majorTicksX", -1),
                ("majorTicksY", 10**30),
                ("offsets", [["a"]]),
                ("factors", [None]),
                ("sizeInches", None),
                ("sizeInches", [1, -1]),
                ("subPlot", [1, 1, 2]),
                ("legendArgs", -1),
                ("rangeY", ["a", 1]),
                ("useXYZcomponents", "yes"),
            ]
        ),
    ],
)
def test_errors(mbs: Any, arguments: dict[str, Any], text: str) -> None:
    with pytest.raises(ValueError, match=text):
        plot.PlotSensor(mbs, **arguments)


def test_spectrum() -> None:
    frequency = np.linspace(0, 10, 11)
    pyplot = plot.PlotFFT(frequency, frequency + 1, label="x", freqStart=2, freqEnd=5, logScaleX=False)
    line = pyplot.gca().get_lines()[0]
    np.testing.assert_array_equal(line.get_xdata(), [2, 3, 4, 5])
    assert pyplot.gca().get_yscale() == "log" and pyplot.gca().get_xscale() == "linear"
    pyplot.close("all")
    with pytest.raises(ValueError, match="vectors of one length"):
        plot.PlotFFT(frequency, [1, 2])


def test_data_array(mbs: Any) -> None:
    np.testing.assert_array_equal(plot.DataArrayFromSensorList(mbs, [1, 3]), [[0, 1, 2], [1, 3, 6]])
    np.testing.assert_array_equal(plot.DataArrayFromSensorList(mbs, [7], [0.5]), [[0.5, 70]])
    with pytest.raises(ValueError, match="2 sensorNumbers, but 1 entries"):
        plot.DataArrayFromSensorList(mbs, [1, 3], [0.5])
    with pytest.raises(ValueError, match="equally many values"):
        plot.DataArrayFromSensorList(mbs, [1, 7])


def test_headers() -> None:
    assert plot.ParseOutputFileHeader([]) == {}
    header = plot.ParseOutputFileHeader(SENSOR_HEADER.splitlines(keepends=True))
    assert header["columns"] == ["time", "Position0", "Position1", "Position2"]
    assert (header["type"], header["sensorType"], header["itemNumber"]) == ("sensor", "Node", 3)
    assert header["outputVariableType"] == "Position" and header["numberOfSensors"] == 3
    solution = plot.ParseOutputFileHeader([
        "#dalembert static solver solution file\n",
        "#number of written coordinates [nODE2, nVel2, nData] = [2,1,0]\n",
        "#number of time steps (planned) = 20\n",
        "0,1,2,3\n",
    ])  # fmt: skip
    assert solution["columns"] == ["time", "ODE2-0", "ODE2-1", "Vel2-0"] and solution["numberOfSteps"] == 20
    variation = plot.ParseOutputFileHeader([
        "#dalembert parameter variation results file:x.txt\n", "#columns:\n", "#globalIndex,value,mass\n",
        "#parameter ranges [...]:\n", "#(1, 10, 4);[1, 2, 5]\n", "0, 1.0, 3\n",
    ])  # fmt: skip
    assert variation["columns"] == ["globalIndex", "value", "mass"]
    assert variation["variableRanges"] == [[1, 10, 4], [1, 5, 3]]
    assert plot.ParseOutputFileHeader(["1,2,3"])["type"] == "unknown"
    for lines in (None, "text", [1, 2]):
        with pytest.raises(ValueError, match="ParseOutputFileHeader: lines: expected a list of lines of text"):
            plot.ParseOutputFileHeader(lines)  # type: ignore[arg-type]


def test_strip_spaces(tmp_path: Path) -> None:
    source, target = tmp_path / "a.txt", tmp_path / "b.txt"
    source.write_text("# comment  x \n 1.0   3.0 \n2.0  4.0")
    plot.FileStripSpaces(str(source), str(target), "#", " ")
    assert target.read_text() == "# comment  x \n1.0 3.0\n2.0 4.0\n"
    with pytest.raises(ValueError, match="must differ"):
        plot.FileStripSpaces(str(source), str(source))


IMAGE = """#dalembert text image export file
#COLOR
1,0,0,1
#LINE
0,0,0,1,0,0,1,1,0
#note
#TRIANGLE
0,0,0,1,0,0,0,1,0
#END
"""


@pytest.mark.parametrize("as_lines", [True, False])
def test_images(tmp_path: Path, as_lines: bool) -> None:
    file = tmp_path / "image.txt"
    file.write_text(IMAGE)
    image = plot.LoadImage(str(file), trianglesAsLines=as_lines)
    assert image["linePoints"][0] == [0, 0, 0, 1, 0, 0, 1, 1, 0] and image["lineColors"][0] == (1, 0, 0, 1)
    assert len(image["linePoints"]) == 1 + as_lines and len(image["triangles"]) == 1 - as_lines
    if as_lines:
        assert image["linePoints"][1][-3:] == [0, 0, 0]
    plot.PlotImage(
        image, HT=np.diag([2, 2, 2, 1]), plot3D=not as_lines, fileName=str(tmp_path / "i.png"), closeAll=True
    )
    assert (tmp_path / "i.png").exists()
    matplotlib.pyplot.close("all")


def test_incomplete_image(tmp_path: Path) -> None:
    file = tmp_path / "image.txt"
    file.write_text("#something\n#COLOR\n0,0,0,1\n")
    with pytest.warns(UserWarning, match="not a text image|incomplete"):
        plot.LoadImage(str(file))
    file.write_text("")
    with pytest.raises(ValueError, match="is empty"):
        plot.LoadImage(str(file))


def test_an_array_has_no_name_to_show() -> None:
    """A single curve has no legend; several are distinguished by components. Labels of ticks do not overlap."""
    data = np.column_stack([np.linspace(0, 0.2, 50), np.zeros(50), np.ones(50)])
    figure, axes = plot.PlotSensor(None, [data], components=0, sizeInches=[4, 3])[1:3]
    assert axes.get_legend() is None
    figure.canvas.draw()
    boxes = [tick.label1.get_window_extent() for tick in axes.xaxis.get_major_ticks()]
    assert len(boxes) >= 3 and all(a.x1 < b.x0 for a, b in zip(boxes, boxes[1:], strict=False))
    axes = plot.PlotSensor(None, [data, data], components=[0, 1])[2]
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["0", "1"]


def test_numbers_and_switches_of_spectra_that_are_none_are_named():
    for arguments, text in (
        ({"freqStart": None}, "PlotFFT: freqStart: expected a finite number, received None"),
        ({"freqEnd": [1, 2]}, r"PlotFFT: freqEnd: expected a finite number, received \[1, 2\]"),
        ({"logScaleX": "False"}, "PlotFFT: logScaleX: expected True or False, received 'False'"),
        ({"frequency": "text"}, "PlotFFT: frequency: expected an array of numbers, received 'text'"),
    ):
        with pytest.raises(ValueError, match=text):
            plot.PlotFFT(**{"frequency": [1, 2, 3], "data": [1, 2, 3], **arguments})


@pytest.mark.parametrize("mbs", [None, 3, "mbs"])
def test_invalid_systems_are_named(mbs: Any) -> None:
    for call in (lambda: plot.PlotSensor(mbs, 0), lambda: plot.PlotPhase(mbs, 0, 1)):
        with pytest.raises(ValueError, match="^Plot(Sensor|Phase): mbs: expected a system, of SC.AddSystem"):
            call()


def test_figures_without_an_ending_have_that_of_matplotlib(mbs: Any, tmp_path: Path) -> None:
    plot.PlotSensor(mbs, 0, fileName=str(tmp_path / "curve"))
    plot.PlotPhase(mbs, 0, 0, 0, 1, fileName=str(tmp_path / "phase"))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["curve.png", "phase.png"]


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"mbs": []}, "PlotPhase: mbs: expected a system, or a list of some"),
        ({"sensorX": None}, "PlotPhase: sensorX: expected indices or numbers"),
        ({"sensorY": {}}, "PlotPhase: sensorY: expected indices or numbers of sensors"),
        ({"componentX": 10**30}, "PlotPhase: componentX: expected an integer, of less than 9223372036854775808,"),
        ({"ax": "x"}, "PlotPhase: ax: expected axes of matplotlib"),
    ],
)
def test_errors_of_phase_plots_name_their_arguments(mbs: Any, arguments: dict[str, Any], text: str) -> None:
    with pytest.raises((ValueError, FileNotFoundError), match=f"^{text}"):
        plot.PlotPhase(**({"mbs": mbs, "sensorX": 0, "sensorY": 0} | arguments))


def test_a_legend_hides_no_curve(mbs: Any) -> None:
    """Within the axes where there is room; otherwise it is above them, or at the right of a title."""

    def place(data: Any, **arguments: Any) -> tuple[Any, Any]:
        axes = plot.PlotSensor(mbs, [data], labels="a long name", closeAll=True, **arguments)[2]
        axes.figure.canvas.draw()
        return axes.get_legend().get_window_extent(), axes.get_window_extent()

    legend, axes = place(DATA)
    assert axes.x0 < legend.x0 and legend.x1 < axes.x1 and axes.y0 < legend.y0 and legend.y1 < axes.y1
    t = np.linspace(0, 1, 500)
    dense = np.column_stack([t, np.sin(200 * t)])
    legend, axes = place(dense)
    assert legend.y0 > axes.y1 - 1
    legend, axes = place(dense, title="title")
    assert legend.x0 > axes.x1 - 1
