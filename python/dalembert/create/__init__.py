"""The Create functions of MainSystem: an item with all that belongs to it, such as nodes and markers, in one call.

Their modules are loaded, and checks and documentation are made, when one of them is first used.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from dalembert.create._arguments import Check

    functions: dict[str, Callable[..., Any]]  # what MainSystem gets, by the name of the method

MODULES = {
    "bodies": ("CreateGround", "CreateMassPoint", "CreateRigidBody"),
    "shapes": ("CreateBox", "CreateCylinder", "CreateSphere"),
    "connectors": (
        "CreateSpringDamper",
        "CreateCartesianSpringDamper",
        "CreateRigidBodySpringDamper",
        "CreateTorsionalSpringDamper",
        "CreateLinearSpringDamper",
        "CreateDistanceConstraint",
        "CreateCoordinateConstraint",
    ),
    "contacts": ("CreateSphereSphereContact", "CreateSphereTriangleContact", "CreateSphereQuadContact"),
    "drives": (
        "CreateMotor",
        "CreatePIDController",
        "CreateJointStops",
        "CreatePrescribedMotion",
        "CreateForceFromTable",
        "CreateTorqueFromTable",
    ),
    "flexible": ("CreateFFRFReducedOrderObject",),
    "joints": (
        "CreateRevoluteJoint",
        "CreatePrismaticJoint",
        "CreateSphericalJoint",
        "CreateGenericJoint",
        "CreateFixedJoint",
        "CreateCylindricalJoint",
        "CreateUniversalJoint",
        "CreateRollingDisc",
        "CreateRollingDiscPenalty",
    ),
    "lines": ("CreateCable", "CreateBeam", "CreateHydraulicCylinder"),
    "ropes": ("CreateRope", "CreateBelt"),
    "loads": ("CreateForce", "CreateTorque"),
    "trees": ("CreateKinematicTree",),
    "sensors": ("CreateDistanceSensorGeometry", "CreateDistanceSensor"),
    "robots": ("CreateRobot",),
}
_MODULE_OF = {name: module for module, names in MODULES.items() for name in names}


def checks(function: Callable[..., Any]) -> dict[str, Check]:
    """Return the checks of the arguments of a Create function, by name."""
    from dalembert.create._arguments import COMMON
    from dalembert.create._mirrors import checks_of, of_module

    return checks_of(function) | COMMON | of_module(function, "CHECKS")


@cache
def method(name: str) -> Callable[..., Any]:
    """Return a Create function with checks and documentation of its arguments."""
    from dalembert.create._arguments import checked
    from dalembert.create._mirrors import documentation, other_names

    function = getattr(import_module(f"{__name__}.{_MODULE_OF[name]}"), name)
    tests = checks(function)
    made = checked(function, tests, other_names(function))
    made.__doc__ = documentation(function, tests)
    return made


def __getattr__(name: str) -> Any:
    if name == "functions":
        return {each: method(each) for each in _MODULE_OF}
    if name in MODULES:
        return import_module(f"{__name__}.{name}")
    raise AttributeError(f"module '{__name__}' has no attribute '{name}'", name=name)
