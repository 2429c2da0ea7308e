"""Small models with solutions that are known in closed form."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

import dalembert as exu
from dalembert.itemInterface import (
    LoadCoordinate,
    MarkerNodeCoordinate,
    Mass1D,
    Node1D,
    NodeGenericData,
    NodePointGround,
    ObjectConnectorCoordinateSpringDamper,
    ObjectConnectorCoordinateSpringDamperExt,
    SensorNode,
)

Variable = exu.OutputVariableType
STIFFNESS, DAMPING, MASS, START, SPEED = 80.0, 1.5, 2.0, 0.3, -0.7


class Oscillator(NamedTuple):
    mbs: Any
    node: Any
    ground: Any  # marker of a resting coordinate
    marker: Any  # marker of the coordinate
    sensor: Any

    @property
    def position(self) -> float:
        return float(self.mbs.GetNodeOutput(self.node, Variable.Coordinates))

    @property
    def speed(self) -> float:
        return float(self.mbs.GetNodeOutput(self.node, Variable.Coordinates_t))

    def table(self) -> np.ndarray:
        """Time and position, as the sensor has stored them."""
        return np.asarray(self.mbs.GetSensorStoredData(self.sensor))

    def load(self, force: float) -> None:
        self.mbs.AddLoad(LoadCoordinate(markerNumber=self.marker, load=force))


def mass(position: float = START, speed: float = SPEED, physics_mass: float = MASS) -> Oscillator:
    """A mass with one coordinate, without forces; not yet assembled."""
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(
        Node1D(name="foot", referenceCoordinates=[0], initialCoordinates=[position], initialVelocities=[speed])
    )
    mbs.AddObject(Mass1D(nodeNumber=node, physicsMass=physics_mass))
    rest = mbs.AddNode(NodePointGround())
    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=rest, coordinate=0))
    marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    sensor = mbs.AddSensor(SensorNode(nodeNumber=node, storeInternal=True, outputVariableType=Variable.Coordinates))
    return Oscillator(mbs, node, ground, marker, sensor)


def oscillator(
    stiffness: float = STIFFNESS, damping: float = DAMPING, law: Callable[..., float] | int = 0, **start: float
) -> Oscillator:
    """A mass on a spring to ground; `law` takes the place of the spring's force."""
    model = mass(**start)
    model.mbs.AddObject(
        ObjectConnectorCoordinateSpringDamper(
            name="spring",
            markerNumbers=[model.ground, model.marker],
            stiffness=stiffness,
            damping=damping,
            springForceUserFunction=law,
        )
    )
    return model


def friction_or_stop(model: Oscillator, slips: float = 0, **parameters: Any) -> Any:
    """Add a connector with history to ground; `slips` is the direction of sliding at the start, 0 for sticking."""
    history = model.mbs.AddNode(NodeGenericData(initialCoordinates=[slips, 0, 0], numberOfDataCoordinates=3))
    return model.mbs.AddObject(
        ObjectConnectorCoordinateSpringDamperExt(
            markerNumbers=[model.ground, model.marker], nodeNumber=history, **parameters
        )
    )


def exact_oscillation(time: float, damping: float = DAMPING) -> tuple[float, float]:
    """Position and speed of the damped oscillator from START and SPEED."""
    decay, square = damping / (2 * MASS), STIFFNESS / MASS
    frequency = np.sqrt(square - decay**2)
    sine_part = (SPEED + decay * START) / frequency
    c, s, factor = np.cos(frequency * time), np.sin(frequency * time), np.exp(-decay * time)
    position = factor * (START * c + sine_part * s)
    speed = factor * (frequency * (sine_part * c - START * s)) - decay * position
    return float(position), float(speed)


def dynamic_settings(end: float, steps: int, tolerance: float = 1e-12) -> Any:
    settings = exu.SimulationSettings()
    integration = settings.timeIntegration
    integration.endTime, integration.numberOfSteps = end, steps
    integration.newton.relativeTolerance = tolerance
    integration.newton.absoluteTolerance = tolerance
    integration.automaticStepSize = False
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = end / steps
    return settings
