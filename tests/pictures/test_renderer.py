"""SC.renderer, mbs.Draw() and films: sizes, files, views, and rejected arguments."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import dalembert as exu
from dalembert import graphics
from dalembert._pictures import notices
from dalembert._pictures.looks import Looks
from dalembert._pictures.making import SceneMaker
from dalembert._pictures.studio import Studio
from dalembert.itemInterface import NodePoint, SensorBody


@pytest.fixture
def pendulum(mbs: Any) -> Any:
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(referencePosition=[1, 0, 0], physicsMass=1, gravity=[0, -9.81, 0], drawSize=0.2)
    mbs.CreateDistanceConstraint(bodyNumbers=[ground, mass])
    mbs.Assemble()
    return mbs


def solve(mbs: Any, **solution: Any) -> None:
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = 0.5
    settings.timeIntegration.numberOfSteps = 50
    settings.solutionSettings.solutionWritePeriod = 0.01
    for name, value in solution.items():
        setattr(settings.solutionSettings, name, value)
    mbs.SolveDynamic(settings)


def test_image(SC: Any, pendulum: Any) -> None:
    image = SC.renderer.RedrawAndGetImage()
    assert image.shape == (768, 1024, 3) and image.dtype == np.uint8
    assert SC.renderer.GetRenderCount() == 1
    assert (image != SC.visualizationSettings.general.backgroundColor[0] * 255).any()
    SC.visualizationSettings.view0.window.renderWindowSize = [320, 200]
    assert SC.renderer.RedrawAndGetImage().shape == (200, 320, 3)
    SC.visualizationSettings.view1.window.renderWindowSize = [64, 48]
    assert SC.renderer.RedrawAndGetImage(viewID=1).shape == (48, 64, 3)
    np.testing.assert_array_equal(SC.renderer.RedrawAndGetImage(), SC.renderer.RedrawAndGetImage())


def test_a_container_without_systems_gives_an_empty_image(SC: Any) -> None:
    assert (SC.renderer.RedrawAndGetImage() == 255).all()


def test_saved_images_are_numbered(SC: Any, pendulum: Any) -> None:
    export = SC.visualizationSettings.exportImages
    SC.visualizationSettings.view0.window.renderWindowSize = [322, 201]
    SC.renderer.RedrawAndSaveImage()
    SC.RedrawAndSaveImage()
    assert export.saveImageFileCounter == 2
    assert sorted(p.name for p in Path("images").iterdir()) == ["frame00000.png", "frame00001.png"]
    assert Image.open("images/frame00000.png").size == (320, 200)  # multiples of 4 and 2
    export.saveImageSingleFile, export.saveImageFileName = True, "only"
    SC.renderer.RedrawAndSaveImage()
    assert Path("only.png").exists()
    export.widthAlignment, export.heightAlignment = 50, 30
    SC.renderer.RedrawAndSaveImage()
    assert Image.open("only.png").size == (300, 180)
    export.saveImageFormat = "TGA"
    with pytest.raises(ValueError, match="saveImageFormat: expected 'PNG', received 'TGA'"):
        SC.renderer.RedrawAndSaveImage()


def test_a_solver_records_images(SC: Any, pendulum: Any) -> None:
    SC.visualizationSettings.view0.window.renderWindowSize = [160, 120]
    SC.visualizationSettings.general.showSolverTime = False
    solve(pendulum, recordImagesInterval=0.1)
    images = sorted(Path("images").glob("*.png"))
    assert len(images) in (5, 6)
    first, last = (np.asarray(Image.open(images[i])) for i in (0, -1))
    assert (first != last).any()


def test_an_error_while_recording_ends_the_solution(SC: Any, pendulum: Any) -> None:
    Path("images").write_text("not a folder")
    with pytest.raises(OSError):
        solve(pendulum, recordImagesInterval=0.1)


def test_results_are_the_same_with_and_without_images(SC: Any, pendulum: Any) -> None:
    SC.visualizationSettings.view0.window.renderWindowSize = [160, 120]
    solve(pendulum)
    alone = pendulum.systemData.GetODE2Coordinates()
    solve(pendulum, recordImagesInterval=0.02)
    np.testing.assert_array_equal(pendulum.systemData.GetODE2Coordinates(), alone)


def test_draw_returns_and_saves_an_image(pendulum: Any) -> None:
    image = pendulum.Draw("pictures/system.png", windowSize=[400, 300])
    assert image.size == (400, 300)
    assert image._repr_png_()  # output in notebooks
    np.testing.assert_array_equal(np.asarray(Image.open("pictures/system.png")), np.asarray(image))


@pytest.mark.parametrize("view", ["front", "back", "left", "right", "top", "bottom", "axonometric", np.eye(3)])
def test_views(pendulum: Any, view: Any) -> None:
    image = np.asarray(pendulum.Draw(view=view, windowSize=[200, 150]))
    assert len(np.unique(image.reshape(-1, 3), axis=0)) > 10


def test_named_views_are_rotations() -> None:
    from dalembert._pictures.camera import axonometric, named

    for name in ("front", "back", "left", "right", "top", "bottom"):
        matrix = named(name)
        assert np.allclose(matrix @ matrix.T, np.eye(3)) and np.linalg.det(matrix) == pytest.approx(1)
    for up in (1, 2):
        matrix = axonometric(up)
        assert np.allclose(matrix @ matrix.T, np.eye(3)) and np.linalg.det(matrix) == pytest.approx(1)
        assert matrix[1, up] > 0.8 and (np.abs(matrix[:2]).max(axis=0) > 0.2).all()


def test_wrong_arguments_of_draw(pendulum: Any) -> None:
    for arguments, text in (
        ({"view": "above"}, "view: expected front, .* or a rotation matrix, received 'above'"),
        ({"view": np.ones((3, 3))}, "view: expected a 3x3 rotation matrix"),
        ({"windowSize": [0, 100]}, "windowSize: expected width and height in pixels"),
        ({"zoom": 0}, "zoom: expected a positive number"),
        ({"zoom": "2"}, "zoom: expected a finite number, received '2'"),
    ):
        with pytest.raises(ValueError, match=text):
            pendulum.Draw(**arguments)


def test_around_an_object(mbs: Any) -> None:
    near = mbs.CreateMassPoint(referencePosition=[0, 0, 0], physicsMass=1)
    far = mbs.CreateMassPoint(referencePosition=[100, 0, 0], physicsMass=1)
    for body in (near, far):
        mbs.SetObjectParameter(body, "Vshow", True)
    SC = mbs.GetSystemContainer()
    SC.visualizationSettings.nodes.show = False
    wide, close = (np.asarray(mbs.Draw(around=a)) for a in (None, near))
    assert (close != 255).any(axis=2).sum() > 20 * (wide != 255).any(axis=2).sum() > 0


def test_films(pendulum: Any) -> None:
    solve(pendulum)
    for name in ("film.gif", "film.webp"):
        pendulum.DrawSolution(name, framesPerSecond=10, windowSize=[80, 60])
        film = Image.open(name)
        assert film.n_frames == 6 and film.size == (80, 60)
    pendulum.DrawSolution("frames/f%03d.png", framesPerSecond=10, speed=0.5, windowSize=[80, 60])
    assert len(list(Path("frames").glob("f*.png"))) == 11
    frames = [np.asarray(Image.open(f"frames/f{n:03d}.png")) for n in (0, 5, 10)]
    assert all((a != b).any() for a, b in zip(frames[:-1], frames[1:], strict=True))


def test_films_follow_a_marker(SC: Any, mbs: Any) -> None:
    """An object that flies away keeps its position in the picture, if it is tracked."""
    shape = [graphics.Sphere(radius=0.1, color=[0.2, 0.2, 0.2, 1], nTiles=16)]
    ball = mbs.CreateMassPoint(initialVelocity=[2, 1, 0], physicsMass=1, graphicsDataList=shape)
    marker = mbs.AddMarker(exu.itemInterface.MarkerBodyPosition(bodyNumber=ball))
    mbs.Assemble()
    solve(mbs)
    show, follow = SC.visualizationSettings, SC.visualizationSettings.view0.camera
    show.nodes.show = show.markers.show = show.general.showSolverTime = show.view0.window.showComputationInfo = False
    show.view0.scene.drawCoordinateSystem = 0

    def places() -> Any:
        mbs.DrawSolution("f%d.png", framesPerSecond=8, windowSize=[90, 60], view="front")
        dark = [np.argwhere((np.asarray(Image.open(f"f{n}.png")) < 200).any(axis=2)) for n in range(5)]
        return np.array([pixels.mean(axis=0)[::-1] for pixels in dark])

    across, up = np.ptp(places(), axis=0)
    assert across > 15 and up > 8
    follow.trackMarker = int(marker)
    assert places() == pytest.approx(np.tile([44.5, 29.5], (5, 1)), abs=0.6)  # the middle, up to half a pixel
    follow.trackMarkerPosition = [1, 0, 0]
    moved = places()
    assert np.ptp(moved[:, 0]) < 0.6 and np.ptp(moved[:, 1]) == pytest.approx(up, abs=1)


@pytest.mark.parametrize("name", ["film", "film.xyz", "film.png", "f%s%d.png", "f%q.png", "f%%.png"])
def test_names_of_no_film_are_refused_before_it_is_drawn(pendulum: Any, name: str) -> None:
    with pytest.raises(ValueError, match=r"fileName: '.*' (does not end as films do|has no place for the numbers)"):
        pendulum.DrawSolution(name)


def test_videos_need_ffmpeg(pendulum: Any) -> None:
    solve(pendulum)
    if shutil.which("ffmpeg") is None:
        with pytest.raises(
            FileNotFoundError, match=r"DrawSolution: fileName: for 'film.mp4', the program ffmpeg.*\.gif"
        ):
            pendulum.DrawSolution("film.mp4")
    else:
        pendulum.DrawSolution("film.mp4", windowSize=[80, 60], framesPerSecond=10)
        assert Path("film.mp4").stat().st_size > 500


def test_a_film_shows_its_time_from_the_first_image_on(SC: Any, pendulum: Any) -> None:
    """The image at time 0 differs from that without times; a picture before any simulation shows none."""
    start = np.asarray(pendulum.Draw(windowSize=[200, 150], view="front"))
    solve(pendulum)
    settings, first = SC.visualizationSettings.general, {}
    for shown in (True, False):
        settings.showSolverTime = shown
        pendulum.DrawSolution("f%d.png", windowSize=[200, 150], view="front")
        first[shown] = np.asarray(Image.open("f0.png"))
    rows = np.argwhere((first[True] != first[False]).any(axis=2))[:, 0]
    assert len(rows) > 0 and rows.max() < 30  # letters at the top
    pendulum.Assemble()
    np.testing.assert_array_equal(start, np.asarray(pendulum.Draw(windowSize=[200, 150], view="front")))


def test_the_background_of_a_film_is_that_of_its_images(SC: Any, pendulum: Any) -> None:
    solve(pendulum)
    SC.visualizationSettings.general.backgroundColor = [0.9, 0.8, 0.7, 1]
    pendulum.DrawSolution("film.gif", windowSize=[80, 60])
    with Image.open("film.gif") as film:
        for number in range(film.n_frames):
            film.seek(number)
            assert film.convert("RGB").getpixel((40, 2)) == (230, 204, 179)


def test_one_number_has_one_tick_and_no_invented_range(SC: Any, mbs: Any) -> None:
    """All nodes have the same displacement, up to round-off; the whole bar has the color of the bodies."""
    from dalembert._pictures import contour
    from dalembert._pictures.overlay import numbers_of_bar

    nodes = [mbs.AddNode(exu.NodePoint(referenceCoordinates=[x, 0, 0], initialCoordinates=[0.1, 0, 0])) for x in (0, 1)]
    for node in nodes:
        mbs.AddObject(exu.ObjectMassPoint(physicsMass=1, nodeNumber=node))
    mbs.Assemble()
    settings = SC.visualizationSettings.contour
    settings.outputVariable, settings.outputVariableComponent = exu.OutputVariableType.Displacement, 0
    maker = SceneMaker(mbs, SC.visualizationSettings)
    assert maker.scene().value_range == (0.1, 0.1)
    looks = Looks(SC.visualizationSettings)
    noise = np.array([0.1, 0.1 * (1 + 1e-15), 0.1 * (1 - 1e-15)])
    low, high = contour.Contour(looks).range(noise)
    assert low == high == noise.min()
    shades = contour.shades(looks, noise, (low, high))
    assert (shades == shades[0]).all()
    np.testing.assert_allclose(contour.colors(looks, noise, (low, high))[:, :3] * 255, shades, atol=0.5)
    for value in (0.1, 0.0, -2e6):
        assert numbers_of_bar(value, value, 4) == [f"{value:.4g}"]
    assert len(numbers_of_bar(0.0, 5e-7, 4)) == 7
    picture = np.asarray(mbs.Draw(windowSize=[400, 300]))
    column = picture[60:220, :][:, 300:].reshape(-1, 3)
    bar = np.abs(column.astype(int) - shades[0]).max(axis=1) <= 1
    assert bar.sum() > 1000
    settings.minValue = settings.maxValue = 0.1
    settings.automaticRange = False
    assert np.isfinite(contour.colors(looks, noise, (0.1, 0.1))).all()


def test_round_off_is_zero_on_the_bar_of_colors() -> None:
    from dalembert._pictures.overlay import numbers_of_bar

    assert numbers_of_bar(-3e-4, 3e-4 + 1e-19, 4) == [
        "-0.0003",
        "-0.0002",
        "-0.0001",
        "0",
        "0.0001",
        "0.0002",
        "0.0003",
    ]
    assert numbers_of_bar(-1.5e-28, 0.6, 2) == ["0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6"]
    assert numbers_of_bar(1e-12, 7e-12, 2)[0] == "1e-12"


def test_a_film_needs_a_solution(pendulum: Any) -> None:
    with pytest.raises(ValueError, match="DrawSolution: no simulation has been run yet"):
        pendulum.DrawSolution("film.gif")
    mbs = pendulum
    for arguments, words in (
        ({"framesPerSecond": 0}, "framesPerSecond: expected a positive number"),
        ({"framesPerSecond": np.inf}, "framesPerSecond: expected a finite number"),
        ({"speed": -1}, "speed: expected a positive number"),
    ):
        with pytest.raises(ValueError, match=words):
            mbs.DrawSolution("film.gif", **arguments)


def test_films_without_end_are_refused_before_they_are_drawn(pendulum: Any) -> None:
    solve(pendulum)
    for arguments in ({"framesPerSecond": 1e12}, {"speed": 1e-12}):
        with pytest.raises(ValueError, match=r"DrawSolution: at framesPerSecond = .* images, more than 100000"):
            pendulum.DrawSolution("film.gif", **arguments)


def test_names_below_a_file_are_refused(pendulum: Any) -> None:
    Path("file").write_text("")
    for save, ending in ((pendulum.Draw, "png"), (pendulum.SaveHTML, "html"), (pendulum.SaveVTU, "vtu")):
        with pytest.raises(NotADirectoryError, match=rf"{save.__name__}: fileName: '.*file' is a file, no folder"):
            save(f"file/folder/name.{ending}")
    settings = pendulum.GetSystemContainer().visualizationSettings.exportImages
    settings.saveImageFileName = "file/image"
    with pytest.raises(NotADirectoryError, match=r"exportImages\.saveImageFileName: '.*file' is a file, no folder"):
        pendulum.GetSystemContainer().renderer.RedrawAndSaveImage()


@pytest.mark.parametrize("value", [5, "Current", exu.ConfigurationType._None])
def test_configurations_that_are_none_are_named_as_arguments(pendulum: Any, value: Any) -> None:
    with pytest.raises(ValueError, match="Draw: configuration: expected one of ConfigurationType: Current, Initial"):
        pendulum.Draw(configuration=value)


def test_images_of_odd_sizes_become_videos(monkeypatch: Any) -> None:
    """A program in place of ffmpeg records its arguments."""
    Path("folder").mkdir()
    Path("program").mkdir()
    program = Path("program", "ffmpeg")
    program.write_text('#!/bin/sh\nprintf "%s\\n" "$PWD" "$@" > asked.txt\n')
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{program.parent.resolve()}{os.pathsep}{os.environ['PATH']}")
    with pytest.raises(FileNotFoundError, match=r"there is no image 'folder/-a00003.png', the first one by"):
        exu.interactive.ConvertImages2Video("folder", "-a%05d.png", "-b.mp4", startNumber=3)
    Path("folder", "-a00003.png").touch()
    exu.interactive.ConvertImages2Video("folder", "-a%05d.png", "-b.mp4", startNumber=3, totalFrames=2)
    folder, *asked = Path("folder", "asked.txt").read_text().splitlines()
    assert Path(folder).name == "folder" and {"./-a%05d.png", "-frames:v"} < set(asked)
    assert asked[-1] == str(Path("folder", "-b.mp4").resolve())
    assert "crop=trunc(iw/2)*2:trunc(ih/2)*2" in " ".join(asked)


def test_solutions_of_other_systems_are_rejected_everywhere(pendulum: Any) -> None:
    """The error has the reason: another model, a row that is damaged, no rows."""
    mbs = pendulum
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 10
    settings.timeIntegration.verboseMode = 0
    mbs.SolveDynamic(settings)
    solution = exu.utilities.LoadSolutionFile("coordinatesSolution.txt", verbose=False)
    data = np.asarray(solution["data"], float)
    broken = data.copy()
    broken[3, 1] = np.nan
    uses = {
        "SolutionViewer": lambda s: mbs.SolutionViewer(s),
        "SaveHTML": lambda s: mbs.SaveHTML("a.html", solution=s),
        "SaveGLB": lambda s: mbs.SaveGLB("a.glb", solution=s),
        "DrawSolution": lambda s: mbs.DrawSolution("a.gif", solution=s),
    }
    cases = (
        ({"data": broken}, r"row 3 \(time .* s\) has numbers that are not finite"),
        ({"data": data[:0]}, "it has no rows"),
        ({"data": data[:, :3]}, f"expected rows of {data.shape[1]} numbers, as columnsExported says, received 3"),
    )
    for name, use in uses.items():
        for change, words in cases:
            with pytest.raises(ValueError, match=f"{name}: solution: {words}"):
                use(solution | change)
    mbs.CreateMassPoint(physicsMass=1)
    mbs.Assemble()
    for name, use in uses.items():
        with pytest.raises(ValueError, match=rf"{name}: solution: it has \d+ ODE2Coordinates, but the system has \d+"):
            use(solution)


@pytest.mark.parametrize(
    ("state", "words"),
    [
        (5, "expected a dictionary, as of GetState, received 5"),
        ({"zoom": "a"}, "zoom: expected a finite number"),
        ({"zoom": np.nan}, "zoom: expected a finite number"),
        ({"modelRotation": np.zeros((3, 3))}, "modelRotation: expected a rotation matrix"),
        ({"modelRotation": np.eye(2)}, "modelRotation: expected a 3x3 matrix"),
    ],
)
def test_views_that_show_nothing_are_refused(SC: Any, pendulum: Any, state: Any, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        SC.renderer.SetState(state)
    assert "zoom" in SC.renderer.GetState()


def test_images_and_letters_have_limits(SC: Any, pendulum: Any) -> None:
    window = SC.visualizationSettings.view0.window
    SC.visualizationSettings.general.textSize = 1e5
    window.renderWindowSize = [160, 160]
    assert SC.renderer.RedrawAndGetImage().shape == (160, 160, 3)
    window.renderWindowSize = [60, 40]
    assert SC.renderer.RedrawAndGetImage().shape == (40, 60, 3)
    for part in (1e9, 1e-9, 1.0):
        SC.visualizationSettings.general.coordinateSystemSize = part
        SC.renderer.RedrawAndGetImage()
    SC.visualizationSettings.general.textSize = 1e-3
    texts = [
        exu.graphics.Text(point=[x, 0, 0], text="far", fontSize=size) for x in (0, 1e200, -1e12) for size in (0, 1e6)
    ]
    pendulum.CreateGround(graphicsDataList=texts)
    SC.renderer.SetState({"zoom": 1.0, "centerPoint": [0, 0, 0]})
    window.renderWindowSize = [200, 200]
    assert SC.renderer.RedrawAndGetImage().shape == (200, 200, 3)
    window.renderWindowSize = [20000, 40]
    with pytest.raises(
        ValueError, match="view0.window.renderWindowSize: expected from 1 to 16000 pixels each, received 20000 x 40"
    ):
        SC.renderer.RedrawAndGetImage()
    window.renderWindowSize = [200, -100]
    with pytest.raises(ValueError, match="view0.window.renderWindowSize: expected from 1 to 16000 .* 200 x -100"):
        pendulum.Draw()


@pytest.mark.parametrize(
    "name, words",
    [
        ("trackMarker", "trackMarker: expected a number of the 3 markers of system 0, received 5"),
        ("trackMarkerMbsNumber", "trackMarkerMbsNumber: expected a number of the 1 systems, received 5"),
    ],
)
def test_markers_that_are_not_there_are_not_followed(SC: Any, pendulum: Any, name: str, words: str) -> None:
    camera = SC.visualizationSettings.view0.camera
    camera.trackMarker = 0
    setattr(camera, name, 5)
    with pytest.raises(ValueError, match=f"visualizationSettings.view0.camera.{words}"):
        SC.renderer.RedrawAndGetImage()


def test_sensors_that_are_not_there_leave_no_traces(SC: Any, pendulum: Any) -> None:
    traces = SC.visualizationSettings.sensors.traces
    traces.showPositionTrace, traces.listOfVectorSensors = True, [7]
    with pytest.raises(ValueError, match="sensors.traces.listOfVectorSensors: expected numbers of the .* received 7"):
        SC.renderer.RedrawAndGetImage()


def test_sensors_without_a_trace_are_reported_once(SC: Any, pendulum: Any, capfd: Any, monkeypatch: Any) -> None:
    monkeypatch.setattr(notices, "_told", set())
    for stores in (True, False):
        pendulum.AddSensor(
            SensorBody(
                bodyNumber=1,
                outputVariableType=exu.OutputVariableType.Position,
                storeInternal=stores,
                writeToFile=False,
            )
        )
    pendulum.Assemble()
    solve(pendulum)
    traces = SC.visualizationSettings.sensors.traces
    traces.showPositionTrace = traces.showVectors = traces.showTriads = True
    traces.listOfPositionSensors, traces.listOfVectorSensors, traces.listOfTriadSensors = [0], [1], [0]
    capfd.readouterr()
    for _ in range(2):
        SC.renderer.RedrawAndGetImage()
    lines = [line for line in capfd.readouterr().out.splitlines() if "WARNING" in line]
    assert len(lines) == 2
    assert "sensors.traces: sensor 1 stores nothing that could be drawn: it needs storeInternal=True" in lines[0]
    assert "sensors.traces: sensor 0 has 3 values at a time, where 9 are to be drawn" in lines[1]


def test_pictures_follow_a_marker(SC: Any, pendulum: Any) -> None:
    """Behaviour is that of films; the surroundings of an object remain in the middle."""
    plain, near = np.asarray(pendulum.Draw()), np.asarray(pendulum.Draw(around=0))
    SC.visualizationSettings.view0.camera.trackMarker = 2
    assert (np.asarray(pendulum.Draw()) != plain).any()
    assert (np.asarray(pendulum.Draw(around=0)) == near).all()


def test_pictures_start_where_settings_say_if_nothing_is_fitted(SC: Any, pendulum: Any) -> None:
    start = SC.visualizationSettings.openGL.advanced
    SC.visualizationSettings.general.autoFitScene = False
    seen = [np.asarray(pendulum.Draw()) for start.initialZoom in (3.0, 6.0)]
    start.initialCenterPoint = [0.5, 0, 0]
    assert len({image.tobytes() for image in [*seen, np.asarray(pendulum.Draw())]}) == 3
    with pytest.raises(ValueError, match=r"initialZoom.*greater than 0"):
        start.initialZoom = 0.0


def test_settings_of_systems_are_those_of_their_numbers_when_one_of_them_is_drawn(SC: Any, pendulum: Any) -> None:
    """A highlighted mass of the second system, and the marker of the first that the camera follows."""
    other = SC.AddSystem()
    for x in (5, 7):
        other.CreateMassPoint(referencePosition=[x, 6, 0], physicsMass=1, drawSize=1)
    other.Assemble()
    settings = SC.visualizationSettings
    plain = [np.asarray(mbs.Draw(windowSize=[80, 60])) for mbs in (pendulum, other)]
    settings.interactive.highlightItemIndex, settings.interactive.highlightMbsNumber = 0, 1
    settings.interactive.highlightItemType = exu.ItemType.Object
    seen = [np.asarray(mbs.Draw(windowSize=[80, 60])) for mbs in (pendulum, other)]
    assert [(a != b).any() for a, b in zip(plain, seen, strict=True)] == [False, True]
    settings.view0.camera.trackMarker = 0
    found = Studio(SC, [other]).tracked()
    assert found is not None and found[0] == pytest.approx([1, 0, 0])


def test_states_of_views(SC: Any, pendulum: Any) -> None:
    free = SC.renderer.GetState()
    assert free["zoom"] > 0.3 and free["maxSceneSize"] > 0.9
    SC.renderer.SetState({"zoom": 3.0, "modelRotation": np.eye(3), "centerPoint": [1, 2, 3]})
    assert SC.renderer.GetState()["zoom"] == 3
    assert list(SC.renderer.GetState()["centerPoint"]) == [1, 2, 3]
    assert SC.renderer.GetState(viewID=1)["zoom"] == free["zoom"]
    SC.renderer.ZoomAll()
    assert SC.renderer.GetState()["zoom"] == free["zoom"]
    SC.renderer.ResetState()
    assert SC.renderer.GetState()["zoom"] == free["zoom"]
    for call, text in (
        (lambda: SC.renderer.SetModelView(zoom=-1), "zoom: expected a length, or 0"),
        (lambda: SC.renderer.SetModelView(rotationVector=[1, 2]), "rotationVector: expected a vector with 3"),
        (lambda: SC.renderer.SetState({"modelRotation": [1, 2]}), "modelRotation: expected a 3x3 matrix"),
        (lambda: SC.renderer.GetState(viewID=4), "viewID: expected 0, 1, 2 or 3, received 4"),
    ):
        with pytest.raises(ValueError, match=text):
            call()


def test_containers_with_views_can_be_copied(SC: Any, pendulum: Any) -> None:
    SC.renderer.SetModelView(zoom=2, centerPoint=[1, 0, 0])
    again = exu.SystemContainer()
    again.SetDictionary(SC.GetDictionary())
    assert again.renderer.GetState()["zoom"] == 2


def test_a_renderer_without_its_container(mbs: Any) -> None:
    mbs.AddNode(NodePoint())
    renderer = exu.SystemContainer().renderer
    with pytest.raises(RuntimeError, match="the SystemContainer does not exist any more"):
        renderer.RedrawAndGetImage()


def test_there_is_no_window(SC: Any) -> None:
    assert SC.renderer.Start() is False
    assert SC.renderer.IsActive() is False
    assert SC.renderer.DoIdleTasks() is False
    assert SC.renderer.GetItemSelection() == (-1, -1, -1, 0.0)
    SC.renderer.Stop()
