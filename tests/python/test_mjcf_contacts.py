"""Contacts of MJCF files and of robots: analytic values, and pairs, masses and rest positions of MuJoCo."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_mjcf_dynamics import in_mujoco, solve

import dalembert as exu
from dalembert import itemInterface as items
from dalembert.robotics import Robot, RobotActuator, RobotContact, RobotLink
from dalembert.robotics._contacts import _sets, _touching, effective_masses
from dalembert.robotics._tendons import place_of
from dalembert.robotics.utilities import ReadRobot
from dalembert.utilities import HTrotateX, HTtranslate

G = 9.81
# A constant impedance of 0.9: MuJoCo's contact then rests like a spring of k = m / (0.1 T^2).
CONSTANT = 'solimp=".9 .9 .001"'
PER_MASS = 1 / (0.1 * 0.02**2)
FORMS = ("tree", "bodies")


def scene(bodies: str, floor: str = "", option: str = "", geom: str = "", after: str = "") -> str:
    default = f"<default><geom {geom}/></default>"
    plane = f'<geom name="floor" type="plane" size="5 5 1" {floor}/>'
    return f"<mujoco><option {option}/>{default}<worldbody>{plane}{bodies}</worldbody>{after}</mujoco>"


def free(geom: str, height: float = 0.1, body: str = "") -> str:
    return f'<body pos="0 0 {height}" {body}><freejoint/><geom mass="2" {geom}/></body>'


class Run:
    """A file that is read with contacts, as tree or as bodies, and its last body after a time."""

    def __init__(
        self, path: Path, text: str, form: str, duration: float, steps: int, recwarn: Any, baseHT: Any = None
    ) -> None:
        path.write_text(text)
        mbs = exu.SystemContainer().AddSystem()
        base = None
        if form == "bodies":
            place = [0, 0, 0] if baseHT is None else baseHT[:3, 3]
            ground = mbs.AddObject(items.ObjectGround())
            base = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=ground, localPosition=place))
        self.made = mbs.CreateRobot(path, contacts=True, graphics=False, baseMarker=base, baseHT=baseHT)
        self.told = [str(warning.message) for warning in recwarn]
        robot = self.made["robot"]
        last = robot.NumberOfLinks() - 1
        if base is None:
            place = np.asarray(robot.links[last].localHT)[:3, 3]
            tree = self.made["objectKinematicTree"]
            marker = items.MarkerKinematicTreeRigid(objectNumber=tree, linkNumber=last, localPosition=place)
        else:
            marker = items.MarkerBodyRigid(bodyNumber=self.made["bodyList"][last])
        marked = mbs.AddMarker(marker)
        sensors = []
        for variable in ("Position", "Velocity", "AngularVelocity"):
            output = getattr(exu.OutputVariableType, variable)
            sensor = items.SensorMarker(
                markerNumber=marked, outputVariableType=output, storeInternal=True, writeToFile=False
            )
            sensors.append(mbs.AddSensor(sensor))
        solve(mbs, duration, steps)
        self.position, self.velocity, self.omega = (mbs.GetSensorStoredData(each)[-1, 1:] for each in sensors)


def rest_in_mujoco(path: Path, duration: float = 3.0) -> Any:
    mujoco, made, data = in_mujoco(path)
    while data.time < duration:
        mujoco.mj_step(made, data)
    return mujoco, made, data


@pytest.mark.parametrize("form", FORMS)
def test_a_ball_rests_as_deep_as_in_mujoco(
    form: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, recwarn: Any
) -> None:
    """The plane has a million times the stiffness of the ball."""
    monkeypatch.chdir(tmp_path)
    text = scene(free('size=".1"'), geom=CONSTANT)
    run = Run(tmp_path / "robot.xml", text, form, 1, 1000, recwarn)
    assert run.told == []
    assert 0.1 - run.position[2] == pytest.approx(G / PER_MASS, rel=2e-6)
    assert 0.1 - rest_in_mujoco(tmp_path / "robot.xml")[2].qpos[2] == pytest.approx(G / PER_MASS, rel=2e-6)


@pytest.mark.parametrize("shape", ['size=".1"', 'type="box" size=".2 .2 .1"'])
@pytest.mark.parametrize(
    "law",
    [
        "",
        'solref=".03 .7" solimp=".8 .95 .002"',
        'solref="-3000 -70"',
        'solimp="0 .1 .01"',
        'solimp=".1 .9 .002 .2 3"',
        'solimp=".2 .8 .001 .9 1"',
        'solimp=".9 .5 .001"',
        'solimp=".8 .95 0"',
    ],
)
def test_penetrations_and_damping_follow_solref_and_solimp(
    shape: str, law: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, recwarn: Any
) -> None:
    """A ball rests as deep as in MuJoCo, with the stiffness of MuJoCo's impedance there.

    A box rests on four springs in MuJoCo, and is less deep, but deeper than a quarter of the depth on one of them if the
    impedance grows.
    """
    monkeypatch.chdir(tmp_path)
    if 'solref="-' in law:
        per_mass, ratio = 3000.0, 70 / (2 * np.sqrt(3000))
    else:
        time, ratio = (0.03, 0.7) if "solref" in law else (0.02, 1.0)
        per_mass = 1 / (time * ratio) ** 2
    run = Run(tmp_path / "robot.xml", scene(free(shape), geom=law), "bodies", 1, 2000, recwarn)
    assert run.told == []
    found = list(run.made["robot"].contacts.values())[1]
    assert found.damping == pytest.approx(2 * ratio * np.sqrt(2 * found.stiffness), rel=1e-12)
    assert 0.1 - run.position[2] == pytest.approx(2 * G / found.stiffness, rel=2e-6)
    _, made, data = rest_in_mujoco(tmp_path / "robot.xml")
    deep = 0.1 - data.qpos[2]
    if "box" in shape:
        grows = ".9 .5" not in law
        assert (4 * deep > 2 * G / found.stiffness * (1 - 1e-6)) == grows
        assert deep < 2 * G / found.stiffness
    else:
        most, impedance = made.geom_solimp[1][1], data.efc_KBIP[0, 2]
        assert deep == pytest.approx(2 * G / found.stiffness, rel=2e-6)
        exact = 2 * per_mass * (impedance / most) ** 2 / (1 - impedance)
        assert found.stiffness == pytest.approx(exact, rel=2e-6)


@pytest.mark.parametrize(("gravity", "used"), [("0 0 -1.62", 1.62), ("0 0 0", G)])
def test_depths_at_rest_are_those_of_the_gravity_of_the_file(gravity: str, used: float, tmp_path: Path) -> None:
    """The impedance d of this law is 10 times the depth p up to 0.1 m, where stiffness times depth is the weight."""
    text = scene(free('size=".1"'), option=f'gravity="{gravity}"', geom='solimp="0 .9999 .1 .5 1"')
    (tmp_path / "robot.xml").write_text(text)
    found = list(ReadRobot(tmp_path / "robot.xml", graphics=False, contacts=True).contacts.values())[1]
    p = 2 * used / found.stiffness
    d = 1e-4 + (0.9999 - 1e-4) * p / 0.1
    assert found.stiffness == pytest.approx(2 * (d / 0.9999) ** 2 / (1 - d) / 0.02**2, rel=1e-9)


@pytest.mark.parametrize("form", FORMS)
def test_a_ball_falls_freely_before_it_touches(form: str, tmp_path: Path, recwarn: Any) -> None:
    """Explicit Runge-Kutta methods integrate a parabola exactly."""
    run = Run(tmp_path / "robot.xml", scene(free('size=".1"', 0.5)), form, 0.25, 50, recwarn)
    assert run.position == pytest.approx([0, 0, 0.5 - G * 0.25**2 / 2], abs=1e-13)
    assert run.velocity == pytest.approx([0, 0, -G * 0.25], abs=1e-12)


def slope(geom: str, degrees: float, thickness: float) -> str:
    """Return a body that touches a plane which is turned about the x axis."""
    a = np.deg2rad(degrees)
    place = f"0 {-np.sin(a) * thickness} {np.cos(a) * thickness}"
    body = f'<body pos="{place}" euler="{degrees} 0 0"><freejoint/><geom mass="2" {geom}/></body>'
    return scene(body, f'euler="{degrees} 0 0" friction=".1"')


@pytest.mark.parametrize("form", FORMS)
def test_a_block_slides_down_a_slope(form: str, tmp_path: Path, recwarn: Any) -> None:
    """The acceleration is g (sin a - mu cos a), with the larger coefficient of the pair.

    Friction is smaller below a slip velocity of 1e-3 m/s, thus for less than 1 ms.
    """
    run = Run(
        tmp_path / "robot.xml", slope('type="box" size=".2 .2 .1" friction=".3"', 25, 0.1), form, 0.5, 2000, recwarn
    )
    a = np.deg2rad(25)
    down = np.array([0, -np.cos(a), -np.sin(a)])
    exact = G * (np.sin(a) - 0.3 * np.cos(a)) * 0.5
    assert run.velocity == pytest.approx(exact * down, abs=0.3 * G * 1e-3)
    assert run.omega == pytest.approx([0, 0, 0], abs=1e-3)


@pytest.mark.parametrize("form", FORMS)
def test_a_ball_rolls_down_a_slope(form: str, tmp_path: Path, recwarn: Any) -> None:
    """The acceleration is 5/7 g sin a, corrected for the arm of friction, which the penetration of 0.4 mm makes shorter.

    Rolling needs a slip velocity of 2/7 tan a / mu = 0.13 of the regular one of 1e-3 m/s.
    """
    run = Run(tmp_path / "robot.xml", slope('size=".1"', 25, 0.1), form, 0.5, 2000, recwarn)
    a = np.deg2rad(25)
    arm = 0.1 - 2 * G * np.cos(a) / list(run.made["robot"].contacts.values())[1].stiffness
    exact = rolling(arm) * G * np.sin(a) * 0.5
    assert exact == pytest.approx(5 / 7 * G * np.sin(a) * 0.5, rel=3e-3)
    assert run.velocity == pytest.approx(exact * np.array([0, -np.cos(a), -np.sin(a)]), abs=2e-4)
    assert run.omega == pytest.approx([exact / arm, 0, 0], abs=2e-3)


@pytest.mark.parametrize("form", FORMS)
def test_a_base_carries_its_shapes(form: str, tmp_path: Path, recwarn: Any) -> None:
    """On a base that is turned by 25 degrees and moved, the ball rolls down a plane that the file has level."""
    baseHT = np.asarray(HTtranslate([1, 2, 3]) @ HTrotateX(np.deg2rad(25)))
    run = Run(tmp_path / "robot.xml", scene(free('size=".1"')), form, 0.5, 2000, recwarn, baseHT)
    a = np.deg2rad(25)
    deep = 2 * G * np.cos(a) / list(run.made["robot"].contacts.values())[1].stiffness
    exact = rolling(0.1 - deep) * G * np.sin(a)
    assert run.velocity == pytest.approx(0.5 * exact * np.array([0, -np.cos(a), -np.sin(a)]), abs=2e-4)
    place = baseHT @ [0, -exact * 0.5**2 / 2, 0.1 - deep, 1]
    assert run.position == pytest.approx(place[:3], abs=2e-4)


def rolling(arm: float) -> float:
    """Return the share of the slope's acceleration that a ball of radius 0.1 has."""
    return 1 / (1 + 0.4 * (0.1 / arm) ** 2)


def test_free_bodies_roll_any_way(tmp_path: Path, recwarn: Any) -> None:
    """Rigid bodies have no singular positions, which trees have after a quarter of a turn about y."""
    text = scene(free('size=".1"'), option='gravity="3 0 -9"')
    run = Run(tmp_path / "robot.xml", text, "bodies", 1.0, 2000, recwarn)
    made = run.made
    arm = 0.1 - 2 * 9 / list(made["robot"].contacts.values())[1].stiffness
    assert run.velocity == pytest.approx([rolling(arm) * 3, 0, 0], abs=2e-4)  # as above
    assert run.omega == pytest.approx([0, rolling(arm) * 3 / arm, 0], abs=2e-3)
    assert [entry is None for entry in made["nodeList"]] == [True] * 5 + [False]
    assert made["jointList"] == [None] * 6


LOWEST = {
    "sphere": ('size=".1"', lambda A: 0.1),
    "box": ('size=".1 .2 .3"', lambda A: np.abs(A[2]) @ [0.1, 0.2, 0.3]),
    "capsule": ('size=".1 .2"', lambda A: 0.1 + 0.2 * abs(A[2, 2])),
    "cylinder": ('size=".1 .2"', lambda A: 0.2 * abs(A[2, 2]) + 0.1 * np.hypot(A[2, 0], A[2, 1])),
}


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("kind", LOWEST)
def test_shapes_are_where_geoms_are(kind: str, form: str, tmp_path: Path, recwarn: Any) -> None:
    """Shapes that slide along z come to rest on their lowest point; single corners have a quarter of the stiffness."""
    size, lowest = LOWEST[kind]
    body = f'<body pos="0 0 1" euler="10 -20 30"><joint type="slide" axis="0 0 1" damping="20"/><geom type="{kind}" {size} mass="2" pos=".3 .2 -.1" euler="20 35 -40"/></body>'
    body = f'<body euler="-5 12 8"><frame pos=".1 0 .3">{body}</frame></body>'
    run = Run(tmp_path / "robot.xml", scene(body, geom='solref=".004 1"'), form, 3, 12000, recwarn)
    robot = run.made["robot"]
    (_, found) = robot.contacts.values()
    slid = robot.LinkHT([0.0])[-1]
    A = (slid @ np.asarray(found.HT))[:3, :3]
    start = slid[:3, 3]
    way = slid[:3, 2]  # the body moves along its own z axis
    middle = (slid @ np.asarray(found.HT))[:3, 3] + (run.position - start)
    deep = 2 * G * 4 / found.stiffness
    assert run.position - start == pytest.approx(way * ((run.position - start) @ way), abs=1e-9)
    assert 0 < lowest(np.asarray(A)) - middle[2] < deep / way[2] ** 2


# Bodies that all lie in one another: world, fixed, carried by one or two joints, and free ones.
HEAP = """<body name="fixed"><geom name="g1" size=".1"/></body>
<body name="a"><joint axis="1 0 0"/><geom name="g2" size=".1"/><geom name="g3" type="box" size=".1 .1 .1"/>
<body name="on a"><geom name="g4" type="capsule" size=".1 .1"/></body>
<body name="b"><joint axis="0 1 0"/><joint axis="0 0 1"/><geom name="g5" size=".11"/>
<body name="c"><joint axis="1 0 0"/><geom name="g6" type="cylinder" size=".1 .1"/><geom name="g7" size=".1" pos="0 0 .02"/></body></body></body>
<body name="d"><freejoint/><geom name="g8" size=".1" contype="2" conaffinity="4"/></body>
<body name="e"><freejoint/><geom name="g9" size=".1" contype="5" conaffinity="0"/><geom name="g10" type="box" size=".1 .1 .1" contype="0" conaffinity="2" pos=".05 0 0"/></body>
<body name="f"><freejoint/><geom name="g11" size=".1" contype="0" conaffinity="0"/><geom name="g12" size=".1"/></body>"""
EXCLUDED = (
    '<contact><exclude body1="a" body2="c"/><exclude body1="f" body2="world"/><exclude body1="b" body2="f"/></contact>'
)


@pytest.mark.parametrize("after", ["", EXCLUDED])
def test_pairs_are_those_of_mujoco(after: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, recwarn: Any) -> None:
    """Each pair that touches is in one general contact, and no others are."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "robot.xml").write_text(scene(HEAP, after=after))
    robot = ReadRobot(tmp_path / "robot.xml", graphics=False, contacts=True)
    assert not list(recwarn)
    mujoco, made, data = in_mujoco(tmp_path / "robot.xml")
    mujoco.mj_forward(made, data)
    names = [mujoco.mj_id2name(made, mujoco.mjtObj.mjOBJ_GEOM, i) for i in range(made.ngeom)]
    wanted = {frozenset(names[i] for i in contact.geom) for contact in data.contact}
    links = [place_of(robot, each.frame)[0] for each in robot.contacts.values()]
    touch = _touching(robot, links)
    mine = list(robot.contacts)
    assert {frozenset((mine[i], mine[j])) for i, j in np.argwhere(touch)} == wanted
    of_markers = np.array(
        [
            i if each.shape == "sphere" else -link - 2
            for i, (each, link) in enumerate(zip(robot.contacts.values(), links, strict=True))
        ]
    )
    together = (of_markers[:, None] == of_markers) & (of_markers < 0)
    covered = np.zeros_like(touch, dtype=int)
    for chosen in _sets(touch, together):
        assert len(set(chosen)) == len(chosen)
        covered[np.ix_(chosen, chosen)] += ~together[np.ix_(chosen, chosen)] & ~np.eye(len(chosen), dtype=bool)
    np.testing.assert_array_equal(covered, touch)


def test_many_free_bodies_have_one_general_contact(tmp_path: Path) -> None:
    (tmp_path / "robot.xml").write_text(scene("".join(free('size=".1"', 1 + i) for i in range(20))))
    mbs = exu.SystemContainer().AddSystem()
    base = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=mbs.AddObject(items.ObjectGround())))
    made = mbs.CreateRobot(tmp_path / "robot.xml", contacts=True, baseMarker=base)
    assert [each.GetPythonObject()["numberOfSpheresMarkerBased"] for each in made["contacts"]] == [20]


def test_free_bodies_with_forces_on_their_coordinates_are_refused(tmp_path: Path) -> None:
    """Rigid bodies have no such coordinates. Links on a free body are no reason."""
    text = '<mujoco><worldbody><body name="b"><freejoint name="f"/><geom size=".1"/></body></worldbody></mujoco>'
    (tmp_path / "robot.xml").write_text(text)

    def made(change: Any) -> Any:
        robot = ReadRobot(tmp_path / "robot.xml", graphics=False)
        change(robot)
        mbs = exu.SystemContainer().AddSystem()
        base = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=mbs.AddObject(items.ObjectGround())))
        robot.CreateRedundantCoordinateMBS(mbs, base)
        return mbs

    def with_link(parent: int) -> Any:
        return lambda robot: robot.AddLink(RobotLink(1.0, [0, 0, 0], np.eye(3), parent=parent))

    assert made(lambda robot: None).systemData.NumberOfNodes() == 1
    assert made(with_link(5)).systemData.NumberOfNodes() == 2
    for change in (
        with_link(2),
        lambda robot: robot.AddActuator(RobotActuator("drive", "f:2")),
        lambda robot: setattr(robot.links[5], "damping", 3.0),
    ):
        with pytest.raises(ValueError, match="link 0 '' has no mass, which needs the coordinates of the joints"):
            made(change)


def test_effective_masses_are_those_of_mujoco(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The mass of a link that turns about its centre of mass is its own."""
    monkeypatch.chdir(tmp_path)
    arm = """<body name="a" pos="0 0 1"><joint axis="0 1 0" armature=".1"/><geom type="capsule" fromto="0 0 0 .5 0 0" size=".05"/>
    <body name="b" pos=".5 0 0" euler="20 0 10"><joint axis="0 1 .2"/><joint axis="1 0 0"/><geom type="box" size=".1 .1 .1" pos=".5 0 0"/>
    <body name="c" pos=".5 0 0"><joint type="slide" axis="0 1 0"/><geom size=".05" pos="0 .3 .2"/></body></body></body>"""
    (tmp_path / "robot.xml").write_text(scene(arm + free('size=".1"', 3, 'name="d"')))
    robot = ReadRobot(tmp_path / "robot.xml", graphics=False, contacts=True)
    _, made, _ = in_mujoco(tmp_path / "robot.xml")
    masses = effective_masses(robot)
    for i, link in enumerate(robot.links):
        if link.name in ("a", "b", "c", "d"):
            inverse = made.body("abcd"["abcd".index(link.name)]).id
            assert masses[i] == pytest.approx(1 / made.body_invweight0[inverse, 0], rel=1e-10)
    wheel = Robot()
    wheel.AddLink(RobotLink(3.0, [0, 0, 0], np.eye(3)))
    assert effective_masses(wheel).tolist() == [3.0]


def test_bodies_and_trees_have_the_same_impacts(tmp_path: Path, recwarn: Any) -> None:
    """Two hinged bars fall on the floor; both forms are integrated with errors far below the tolerance."""
    bars = """<body pos="0 0 .4"><joint axis="0 1 0"/><geom type="capsule" fromto="0 0 0 .5 0 0" size=".04"/>
    <body pos=".5 0 0"><joint axis="0 1 0"/><geom type="box" size=".2 .05 .04" pos=".2 0 0"/></body></body>"""
    text = scene(bars, geom='solref=".05 .5"')
    tree, bodies = (Run(tmp_path / "robot.xml", text, form, 0.5, 4000, recwarn) for form in FORMS)
    assert tree.position[2] < 0.1
    np.testing.assert_allclose(bodies.position, tree.position, atol=1e-6)


def test_friction_of_pairs_needs_one_rough_geom(tmp_path: Path, recwarn: Any) -> None:
    """condim 1 of both geoms: no friction; of one: the larger coefficient, as in MuJoCo."""
    for floor, exact in (('condim="1"', 2.0), ('friction=".1"', 2.0 - 0.2 * G)):
        text = scene(free('type="box" size=".2 .2 .1" friction=".2" condim="1"'), floor, f'gravity="2 0 -{G}"')
        run = Run(tmp_path / "robot.xml", text, "bodies", 1.0, 1000, recwarn)
        assert run.velocity[0] == pytest.approx(exact, abs=0.2 * G * 1e-3)  # as on the slope


IGNORED = {
    "contact of geoms of type ellipsoid 'e'": (free('type="ellipsoid" size=".1 .2 .1" name="e"'), "", ""),
    "torsional and rolling friction (condim 4 and 6) of geoms 'e', 'f'": (
        free('size=".1" name="e" condim="4"') + free('size=".1" name="f" condim="6"'),
        "",
        "",
    ),
    "margin of geoms 'e', gap of geoms 'e', priority of geoms 'e'": (
        free('size=".1" name="e" margin=".1" gap=".2" priority="2"'),
        "",
        "",
    ),
    "mixing of different solref and solimp of geoms 'e', 'f'": (
        free('size=".1" name="e" solref=".03 1"') + free('size=".1" name="f" solimp=".8 .9 .001"'),
        "",
        "",
    ),
    "flags of <option> 'filterparent', 'override'": (
        free('size=".1"'),
        '<option><flag filterparent="disable" override="enable"/></option>',
        "",
    ),
    "<pair> of <contact> 'p', 'e'": (
        free('size=".1" name="e"'),
        "",
        '<contact><pair name="p" geom1="e" geom2="floor"/><pair geom1="e" geom2="floor"/></contact>',
    ),
}


@pytest.mark.parametrize("what", IGNORED)
def test_ignored_parts_are_named(what: str, tmp_path: Path, recwarn: Any) -> None:
    bodies, before, after = IGNORED[what]
    path = tmp_path / "robot.xml"
    path.write_text(scene(bodies, after=after).replace("<default>", before + "<default>"))
    ReadRobot(path, graphics=False, contacts=True)
    assert [str(warning.message) for warning in recwarn] == [f"{path}: ignored elements: {what}"]


@pytest.mark.parametrize("option", ['<flag contact="disable"/>', '<flag constraint="disable"/>'])
def test_contacts_that_are_switched_off_are_left_out(option: str, tmp_path: Path, recwarn: Any) -> None:
    (tmp_path / "robot.xml").write_text(scene(free('size=".1"')).replace("<option />", f"<option>{option}</option>"))
    assert ReadRobot(tmp_path / "robot.xml", contacts=True).contacts == {}
    assert not list(recwarn)


def test_contacts_of_attached_models_come_along(tmp_path: Path, recwarn: Any) -> None:
    """Excluded pairs have prefixed names; classes of geoms are those of the attached file."""
    child = scene(
        '<body name="a"><joint name="j"/><geom name="g" size=".1"/><body name="b"><joint name="k"/><geom size=".1"/></body></body><body name="no"/>',
        geom='friction=".4"',
        after='<contact><exclude body1="a" body2="b"/><exclude body1="a" body2="no"/></contact>',
    )
    (tmp_path / "child.xml").write_text(child)
    text = scene('<attach model="m" body="a" prefix="p/"/>').replace(
        "<worldbody>", '<asset><model name="m" file="child.xml"/></asset><worldbody>'
    )
    (tmp_path / "robot.xml").write_text(text)
    robot = ReadRobot(tmp_path / "robot.xml", contacts=True)
    assert not list(recwarn)
    assert list(robot.contacts) == ["floor", "p/g", "sphere"]
    assert [each.friction for each in robot.contacts.values()] == [1.0, 0.4, 0.4]
    assert robot.contactExclusions == [("p/a", "p/b")]


def test_wrong_contacts_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "robot.xml"
    for geom, after, text in (
        ('size=".1" solref=".02 -1"', "", "<geom>: solref: expected two positive or two negative numbers, received 0.02 and -1"),
        ('size=".1"', '<contact><exclude body1="x" body2="world"/></contact>', "<exclude>: there is no body 'x'; there are: world, body1"),
    ):  # fmt: skip
        path.write_text(scene(free(geom), after=after))
        with pytest.raises(ValueError, match=text):
            ReadRobot(path, contacts=True)
    (tmp_path / "robot.urdf").write_text('<robot><link name="base"/></robot>')
    with pytest.raises(ValueError, match="contacts: received True, but URDF files have neither stiffness nor friction"):
        ReadRobot(tmp_path / "robot.urdf", contacts=True)
    robot = Robot()
    robot.AddLink(RobotLink(1.0, [0, 0, 0], np.eye(3), name="a"))
    for change, text in (
        ({"shape": "cone"}, "RobotContact 's': shape: .*expected one of sphere, box, cylinder, capsule, plane"),
        ({"size": [0.1, 0.2]}, "RobotContact 's': size"),
        ({"size": [-0.1]}, "RobotContact 's': size: .*positive finite numbers"),
        ({"size": [np.nan]}, "RobotContact 's': size: .*positive finite numbers"),
        ({"stiffness": "stiff"}, "RobotContact 's': stiffness: expected a finite number, received 'stiff'"),
        ({"groups": 2**33}, "RobotContact 's': groups: expected an integer from -2147483648 to 4294967295"),
        ({"stiffness": 0.0}, "RobotContact 's': stiffness: .*a positive number, or infinity for a rigid shape"),
        ({"damping": -1.0}, "RobotContact 's': damping"),
        ({"HT": np.eye(3)}, "RobotContact 's': HT"),
    ):
        with pytest.raises(ValueError, match=text):
            RobotContact(**{"name": "s", "frame": "a", "shape": "sphere", "size": [0.1], **change})
    for wrong in ({"groups": 1.5}, {"partners": "all"}, {"smooth": "no"}):
        with pytest.raises(TypeError, match=f"RobotContact 's': {next(iter(wrong))}: expected an? (integer|bool)"):
            RobotContact("s", "a", "sphere", [0.1], **wrong)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="there is no link or joint 'b'"):
        robot.AddContact(RobotContact("s", "b", "sphere", [0.1]))
    with pytest.raises(ValueError, match="there is no link or joint 'b'"):
        robot.ExcludeContacts("a", "b")
    with pytest.raises(TypeError, match=r"Robot.AddContact: received 3, but expected a RobotContact\(...\)"):
        robot.AddContact(3)  # type: ignore[arg-type]
    robot.AddContact(RobotContact("s", "a", "sphere", [0.1]))
    with pytest.raises(ValueError, match="Robot.AddContact: there is another 's' already; names must differ"):
        robot.AddContact(RobotContact("s", "a", "sphere", [0.1]))
    with pytest.raises(ValueError, match="Robot: contacts: all shapes are rigid, such as 's'; give some a stiffness"):
        robot.CreateKinematicTree(exu.SystemContainer().AddSystem())
