"""Cables and beams between two points, and hydraulic cylinders, beside formulas of textbooks."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.beams import SectionRectangle

Variable = exu.OutputVariableType


@pytest.fixture
def mbs() -> Any:
    return exu.SystemContainer().AddSystem()


def solve_static(mbs: Any, steps: int = 1) -> None:
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.staticSolver.numberOfLoadSteps = steps
    settings.solutionSettings.writeSolutionToFile = False
    assert mbs.SolveStatic(settings)


def test_a_cantilever_bends_about_both_axes(mbs: Any) -> None:
    """Timoshenko: F L^3 / (3 E I) + F L / (k G A) with the shear factor 5/6 of a rectangle for zero Poisson's ratio."""
    E, width, height, length, force = 2e11, 0.02, 0.05, 1.0, 10.0
    beam = mbs.CreateBeam(
        start=[0, 0, 0], end=[length, 0, 0], width=width, height=height, numberOfElements=32, youngsModulus=E,
        poissonsRatio=0.0, supports=["clamped", "free"],
    )  # fmt: skip
    mbs.CreateForce(bodyNumber=beam["end"], loadVector=[0, force, force])
    solve_static(mbs)
    tip = np.asarray(mbs.GetMarkerOutput(beam["end"], Variable.Displacement))
    shear = force * length / (5 / 6 * E / 2 * width * height)
    for axis, (b, h) in ((1, (height, width)), (2, (width, height))):
        expected = force * length**3 / (3 * E * b * h**3 / 12) + shear
        assert tip[axis] == pytest.approx(expected, rel=1e-3)  # 32 elements of second order, small deflections


def test_sections_are_those_of_outlines(mbs: Any) -> None:
    given = [{"width": 0.02, "height": 0.05}, {"section": SectionRectangle(0.02, 0.05)}]
    beams = [mbs.CreateBeam(numberOfElements=1, **each) for each in given]
    sections = [mbs.GetObject(beam["elements"][0])["sectionData"] for beam in beams]
    np.testing.assert_array_equal(*(each.stiffnessMatrix for each in sections))


def test_a_hinged_bar_swings_as_a_physical_pendulum(mbs: Any) -> None:
    """A stiff cable about its upper end: omega^2 = 3 g / (2 L), without tension stiffening at these frequencies."""
    mbs.CreateCable(start=[0, 0, 0], end=[0, 0, -1], diameter=0.05, numberOfElements=4, gravity=[0, 0, -10],
                    supports=["hinged", "free"])  # fmt: skip
    mbs.Assemble()
    lowest = mbs.ComputeVibrationModes(2).eigenvalues.imag
    assert lowest == pytest.approx([np.sqrt(15)] * 2, rel=2e-4)


def test_a_cable_has_the_mass_and_stiffness_of_a_round_bar(mbs: Any) -> None:
    cable = mbs.CreateCable(end=[0, 2, 0], diameter=0.01, numberOfElements=4, youngsModulus=1e10, density=1000,
                            bendingStiffness=0.5, supports=["clamped", "free"])  # fmt: skip
    area = np.pi / 4 * 1e-4
    element = mbs.GetObject(cable["elements"][0])
    assert element["physicsAxialStiffness"] == pytest.approx(1e10 * area, rel=1e-14)
    assert element["physicsMassPerLength"] == pytest.approx(1000 * area, rel=1e-14)
    assert element["physicsBendingStiffness"] == 0.5 and element["physicsLength"] == pytest.approx(0.5, rel=1e-14)
    mbs.CreateForce(bodyNumber=cable["end"], loadVector=[0, 100, 0])
    solve_static(mbs)
    stretched = mbs.GetMarkerOutput(cable["end"], Variable.Displacement)[1]
    assert stretched == pytest.approx(2 * 100 / (1e10 * area), rel=1e-6)


def test_a_clamped_cable_on_a_slope(mbs: Any) -> None:
    """Small deflections of a thin cantilever in any direction: F L^3 / (3 EI)."""
    along, across = np.array([0.6, 0.0, 0.8]), np.array([-0.8, 0.0, 0.6])
    cable = mbs.CreateCable(end=along, numberOfElements=16, diameter=0.01, supports=["clamped", "free"])
    mbs.CreateForce(bodyNumber=cable["end"], loadVector=0.1 * across)
    solve_static(mbs)
    bending = 2.1e11 * np.pi / 64 * 1e-8
    moved = np.asarray(mbs.GetMarkerOutput(cable["end"], Variable.Displacement))
    assert moved @ across == pytest.approx(0.1 / (3 * bending), rel=1e-4)
    assert moved @ along == pytest.approx(0, abs=1e-6)


def test_joints_accept_handles_of_markers() -> None:
    model = exu.Model()
    cable = model.create_cable(end=[1, 0, 0], gravity=[0, 0, -10], supports=["hinged", "free"])
    ball = model.create_sphere(radius=0.1, mass=2, reference_position=[1, 0, 0])
    joint = model.create_spherical_joint(body_numbers=[cable["end"], ball])
    model.solve(end_time=0.01, step_size=1e-3)
    assert joint.force_on(ball) == pytest.approx(-joint.force_on(cable["end"]), abs=1e-9)


def test_bodies_hang_on_the_ends(mbs: Any) -> None:
    cable = mbs.CreateCable(name="rope", end=[1, 0, 0], supports=["hinged", "free"], gravity=[0, 0, -10])
    ball = mbs.CreateSphere(radius=0.1, mass=2, referencePosition=[1, 0, 0])
    mbs.CreateSphericalJoint(bodyNumbers=[cable["end"], ball])
    mbs.Assemble()
    assert mbs.GetMarker("rope:end")["nodeNumber"] == cable["nodes"][-1]
    assert len(cable["elements"]) == len(cable["loads"]) == 10 and len(cable["nodes"]) == 11


@pytest.mark.parametrize(
    ("name", "arguments", "text"),
    [
        ("CreateBeam", {}, "'width': expected one of width and height, diameter, and section"),
        ("CreateBeam", {"width": 0.1}, "one of width and height"),
        ("CreateBeam", {"diameter": 0.1, "section": SectionRectangle(1, 1)}, "one of width and height"),
        ("CreateBeam", {"section": "I"}, "'section': expected an outline such as SectionI"),
        ("CreateBeam", {"diameter": 0.1, "end": [0, 0, 0]}, "'end': expected another point than start"),
        ("CreateBeam", {"diameter": 0.1, "supports": ["fixed", "free"]}, "two of 'free', 'hinged' and 'clamped'"),
        ("CreateCable", {"numberOfElements": 0}, "'numberOfElements': expected a whole number greater than zero"),
        ("CreateCable", {"diameter": 0}, "'diameter'.*greater than zero"),
        ("CreateCable", {"gravity": 9.81}, "'gravity'.*3 finite components"),
    ],
)
def test_wrong_lines_are_refused(mbs: Any, name: str, arguments: dict[str, Any], text: str) -> None:
    with pytest.raises(ValueError, match=text):
        getattr(mbs, name)(**arguments)
    assert mbs.systemData.NumberOfNodes() == 0


# ---- hydraulic cylinders ---------------------------------------------------------------------------------------------
def lift(mbs: Any, **arguments: Any) -> tuple[Any, Any]:
    """A weight of 500 kg on a vertical cylinder."""
    ground = mbs.CreateGround()
    load = mbs.CreateMassPoint(referencePosition=[0, 1, 0], physicsMass=500, gravity=[0, -10, 0])
    for coordinate in (0, 2):
        mbs.CreateCoordinateConstraint(bodyNumbers=[None, load], coordinates=[None, coordinate])
    return load, mbs.CreateHydraulicCylinder(bodyNumbers=[ground, load], initialForce=5000, **arguments)


def solve(mbs: Any, end: float, steps: int) -> None:
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = end, steps
    assert mbs.SolveDynamic(settings)


def test_a_closed_cylinder_carries_its_initial_force(mbs: Any) -> None:
    load, cylinder = lift(mbs, pistonDiameter=0.08, rodDiameter=0.04, actuatorDamping=1e4)
    solve(mbs, 0.5, 500)
    assert mbs.GetObjectOutputBody(load, Variable.Displacement, [0, 0, 0])[1] == pytest.approx(0, abs=1e-12)
    assert mbs.GetObjectOutput(cylinder, Variable.Force)[1] == pytest.approx(-5000, rel=1e-12)


def test_open_valves_lift_with_the_flow_of_the_pump(mbs: Any) -> None:
    """The steady speed is the flow through the valve over the area of the piston: v A0 = Q sqrt(p_s - p0), and the flow of the rod
    chamber leaves through the other valve, v A1 = Q sqrt(p1 - p_t), with p0 A0 - p1 A1 = m g + d v."""
    load, cylinder = lift(mbs, pistonDiameter=0.08, rodDiameter=0.04, actuatorDamping=2e4, strokeLength=1.5,
                          systemPressure=1.6e7, tankPressure=1e5, nominalFlow=2e-7)  # fmt: skip
    mbs.SetObjectParameter(cylinder, "valveOpening0", 1.0)
    mbs.SetObjectParameter(cylinder, "valveOpening1", -1.0)
    solve(mbs, 2, 4000)
    A0, A1 = np.pi / 4 * 0.08**2, np.pi / 4 * (0.08**2 - 0.04**2)
    v = mbs.GetObjectOutput(cylinder, Variable.VelocityLocal)
    p0, p1 = 1.6e7 - (v * A0 / 2e-7) ** 2, 1e5 + (v * A1 / 2e-7) ** 2
    assert v > 0.05
    assert p0 * A0 - p1 * A1 == pytest.approx(5000 + 2e4 * v, rel=1e-4)


def test_a_cylinder_that_pulls_has_the_pressure_on_the_side_of_the_rod(mbs: Any) -> None:
    """A hanging load: p1 A1 = F + p_t A0."""
    ground = mbs.CreateGround(referencePosition=[0, 2, 0])
    load = mbs.CreateMassPoint(referencePosition=[0, 1, 0], physicsMass=500, gravity=[0, -10, 0])
    for coordinate in (0, 2):
        mbs.CreateCoordinateConstraint(bodyNumbers=[None, load], coordinates=[None, coordinate])
    cylinder = mbs.CreateHydraulicCylinder(bodyNumbers=[ground, load], initialForce=-5000, actuatorDamping=1e4)
    pressures = mbs.GetNode(mbs.GetObject(cylinder)["nodeNumbers"][0])["initialCoordinates"]
    piston, rod = np.pi / 4 * 0.05**2, np.pi / 4 * 0.03**2
    assert pressures == pytest.approx([1e5, (5000 + 1e5 * piston) / (piston - rod)], rel=1e-12)
    solve(mbs, 0.2, 200)
    assert mbs.GetObjectOutputBody(load, Variable.Displacement, [0, 0, 0])[1] == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"rodDiameter": 0.06}, "'rodDiameter': expected a diameter below pistonDiameter=0.05"),
        ({"strokeLength": 0.5, "offsetLength": 0.2}, "stroke is from 0 to 0.5: the points are 1 m apart"),
        ({"strokeLength": 3.0}, "'offsetLength'.*the points are 1 m apart"),
        ({"hoseVolume": 0.0}, "'hoseVolume'.*greater than zero"),
        ({"tankPressure": 2e7}, "'tankPressure': expected a pressure below systemPressure=1e.07"),
        ({"pistonDiameter": 0.02, "rodDiameter": 0.01}, "'initialForce': expected a force that systemPressure"),
    ],
)
def test_wrong_cylinders_are_refused(mbs: Any, arguments: dict[str, Any], text: str) -> None:
    with pytest.raises(ValueError, match=text):
        lift(mbs, **arguments)


def atwood(mbs: Any, **arguments: Any) -> tuple[Any, Any, Any]:
    """Two masses on a rope over a pulley of radius 0.3 m."""
    ground = mbs.CreateGround()
    loads = [
        mbs.CreateBox(size=[0.2] * 3, mass=mass, referencePosition=[x, -1, 0], gravity=[0, -9.81, 0])
        for mass, x in ((11, -0.3), (10, 0.3))
    ]
    positions = [[-0.3, -0.9, 0], [0, 0, 0], [0.3, -0.9, 0]]
    given = {"bodyNumbers": [loads[0], ground, loads[1]], "positions": positions, "radii": [-0.3], **arguments}
    return *loads, mbs.CreateRope(**given)


def test_a_rope_over_a_pulley(mbs: Any) -> None:
    """Atwood's machine: the force is F = 2 m0 m1 g / (m0 + m1), and the stretch of the rope F L / EA."""
    heavy, light, rope = atwood(mbs, stiffness=1e6, damping=5e3)
    length = 1.8 + np.pi * 0.3
    assert mbs.GetObjectParameter(rope, "referenceLength") == pytest.approx(length, rel=1e-14)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 500, 0.5
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    force = 2 * 11 * 10 / 21 * 9.81
    moved = [mbs.GetObjectOutputBody(each, Variable.Displacement, [0, 0, 0]) for each in (heavy, light)]
    # the rope pulls both with the same force
    assert 11 * moved[0][1] - 10 * moved[1][1] == pytest.approx(-(11 - 10) * 9.81 * 0.5**2 / 2, rel=1e-9)
    assert -(moved[0] + moved[1])[1] == pytest.approx(force * length / 1e6, rel=2e-3)  # damped to 1e-3
    assert mbs.GetObjectOutput(rope, Variable.ForceLocal) == pytest.approx(force, rel=1e-6)


def test_a_rope_over_a_turned_block(mbs: Any) -> None:
    """Two falls carry a block: each has half of its weight. The frame of the block is turned, its axis is not."""
    ground = mbs.CreateGround()
    block = mbs.CreateBox(
        size=[0.2] * 3, mass=10, referencePosition=[0, -1, 0], gravity=[0, -9.81, 0],
        referenceRotationMatrix=exu.utilities.RotationMatrixX(0.7) @ exu.utilities.RotationMatrixZ(0.3),
    )  # fmt: skip
    mbs.CreatePrismaticJoint(bodyNumbers=[ground, block], position=[0, -1, 0], axis=[0, 1, 0])
    rope = mbs.CreateRope(
        bodyNumbers=[ground, block, ground], positions=[[-0.2, 0, 0], [0, -1, 0], [0.2, 0, 0]], radii=[0.2],
        axis=[0, 0, 2], stiffness=1e6,
    )  # fmt: skip
    solve_static(mbs)
    assert mbs.GetObjectOutput(rope, Variable.ForceLocal) == pytest.approx(10 * 9.81 / 2, rel=1e-8)
    moved = mbs.GetObjectOutputBody(block, Variable.Displacement, [0, 0, 0])
    assert moved[1] == pytest.approx(-10 * 9.81 / 2 * (2 + np.pi * 0.2) / 1e6 / 2, rel=1e-3)  # arcs stay


@pytest.mark.parametrize(
    ("given", "text"),
    [
        ({"bodyNumbers": [0]}, "'bodyNumbers': expected a list of at least two body numbers"),
        ({"positions": [[0, 0, 0]]}, "'positions': expected a point for each of the 3 bodies"),
        ({"radii": []}, "'radii': expected a radius for each of the 1 pulleys between the ends"),
        ({"radii": [2.0]}, "'positions': expected points 0 and 1 more than 2 m apart"),
        ({"axis": [0, 0, 0]}, "'axis': expected a vector with 3 components that is not zero"),
        ({"length": -1.0}, "'length': expected a finite number greater than zero"),
    ],
)
def test_wrong_arguments_of_ropes(mbs: Any, given: dict[str, Any], text: str) -> None:
    with pytest.raises(ValueError, match=f"CreateRope.*{text}"):
        atwood(mbs, **given)


def test_an_axis_in_the_plane_of_the_rope_is_announced(mbs: Any) -> None:
    with pytest.warns(
        UserWarning, match="CreateRope: axis: the line from point . to point . is inclined by 42 degrees"
    ):
        atwood(mbs, axis=[0, 1, 1])  # asin(0.9 / hypot(0.9, 0.3) / sqrt(2))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for degrees in (0, 25):
            atwood(mbs, axis=[0, np.sin(np.radians(degrees)), np.cos(np.radians(degrees))])


def test_the_line_and_the_pulley_that_are_inclined_are_named(mbs: Any) -> None:
    ends = mbs.CreateGround(), mbs.CreateBox(mass=1, referencePosition=[1, -1, 0])
    for positions, line in (
        ([[0, -1, 0], [0.5, 0, 0], [0.5, -1, 2]], "1 to point 2"),
        ([[0, -1, 2], [0.5, 0, 0], [1, -1, 0]], "0 to point 1"),
    ):
        with pytest.warns(UserWarning, match=f"the line from point {line} is inclined by 6.* to the plane of pulley 1"):
            mbs.CreateRope(bodyNumbers=[ends[0], ends[0], ends[1]], positions=positions, radii=[0.1], axis=[0, 0, 1])
