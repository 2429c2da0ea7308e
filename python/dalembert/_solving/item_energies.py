"""Energies of single items as outputs and sensors, and their sum over a system."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from dalembert._core import (
    ConfigurationType,
    LoadIndex,
    MainSystem,
    ObjectIndex,
    OutputVariableType,
    SensorIndex,
    SensorUserFunction,
)

_CURRENT = ConfigurationType.Current
_RIGID = ("MassPoint", "MassPoint2D", "Mass1D", "RigidBody", "RigidBody2D")


def _displacement(mbs: Any, marker: Any, configuration: ConfigurationType, variable: OutputVariableType) -> Any:
    """Return how far an output of a marker is from its reference value; markers without the output give None."""
    try:
        end = mbs.GetMarkerOutput(marker, variable, configuration)
        return np.asarray(end) - mbs.GetMarkerOutput(marker, variable, ConfigurationType.Reference)
    except ValueError:
        return None


def LoadPotentialEnergy(mbs: MainSystem, loadNumber: Any, configuration: ConfigurationType = _CURRENT) -> float | None:
    """Return the potential energy (J) of a constant load: minus its work since the reference configuration.

    None for loads without a potential that is known: torques, follower loads, user functions, and weight of bodies
    that are neither rigid nor mass points. mbs.ComputeEnergies() integrates the forces of any system.
    """
    load = mbs.GetLoad(loadNumber)
    kind, marker = load["loadType"], load["markerNumber"]
    if any(load.get(name, 0) != 0 for name in ("loadUserFunction", "loadVectorUserFunction")) or load.get("bodyFixed"):
        return None
    if kind == "ForceVector":
        displacement = _displacement(mbs, marker, configuration, OutputVariableType.Position)
        return None if displacement is None else -float(np.dot(load["loadVector"], displacement))
    if kind == "Coordinate":
        place = mbs.GetMarker(marker)
        if place["markerType"] != "NodeCoordinate":
            return None
        node = mbs.GetNodeOutput(place["nodeNumber"], OutputVariableType.Coordinates, configuration)
        if configuration == ConfigurationType.Reference:
            return 0.0
        return -float(load["load"] * np.atleast_1d(node)[place["coordinate"]])
    if kind == "MassProportional":
        body = mbs.GetMarker(marker)["bodyNumber"]
        item = mbs.GetObject(body)
        if item["objectType"] not in _RIGID:
            return None
        centre = np.zeros(3)
        if "physicsCenterOfMass" in item:
            centre[: len(item["physicsCenterOfMass"])] = item["physicsCenterOfMass"]
        ends = [
            np.asarray(mbs.GetObjectOutputBody(body, OutputVariableType.Position, centre, each))
            for each in (configuration, ConfigurationType.Reference)
        ]
        return -float(item["physicsMass"] * np.dot(load["loadVector"], ends[0] - ends[1]))
    return None


def _add_sensor(
    mbs: Any, measure: Callable[[Any], list[float]], storeInternal: bool, writeToFile: bool, fileName: str
) -> SensorIndex:
    def measured(mbs: Any, t: float, sensorNumbers: Any, factors: Any, configuration: Any) -> list[float]:
        return measure(configuration)

    sensor = SensorUserFunction(
        sensorUserFunction=measured, storeInternal=storeInternal, writeToFile=writeToFile, fileName=fileName
    )
    index: SensorIndex = mbs.AddSensor(sensor)
    return index


def CreateLoadEnergySensor(
    mbs: MainSystem, loadNumber: Any, storeInternal: bool = True, writeToFile: bool = False, fileName: str = ""
) -> SensorIndex:
    """Add a sensor of LoadPotentialEnergy(mbs, loadNumber); ValueError if that is not known."""
    load = mbs.GetLoad(loadNumber)
    try:
        known = LoadPotentialEnergy(mbs, loadNumber)
    except RuntimeError:  # not assembled
        known = 0.0
    if known is None:
        raise ValueError(
            f"CreateLoadEnergySensor: the potential energy of load '{load['name']}' ({load['loadType']}) is not known"
            ": expected a constant force, a load on a coordinate, or the weight of a rigid body or mass point"
        )

    def measure(configuration: Any) -> list[float]:
        energy = LoadPotentialEnergy(mbs, loadNumber, configuration)
        return [float("nan") if energy is None else energy]

    return _add_sensor(mbs, measure, storeInternal, writeToFile, fileName)


class SystemEnergy:
    """Energies of a system as sums over its items; the lists of items are made once.

    kineticObjects, potentialObjects, loads: numbers of items whose energies are known.
    unavailable: (number, type, output variable, reason) of items whose energy is not known, such as connectors with
        user functions; ValueError instead if skipUnavailable is False.
    mbs.ComputeEnergies() integrates the forces of any system instead, which takes longer.
    """

    def __init__(self, mbs: MainSystem, skipUnavailable: bool = True) -> None:
        self.mbs = mbs
        self.kineticObjects: list[int] = []
        self.potentialObjects: list[int] = []
        self.loads: list[int] = []
        self.unavailable: list[tuple[int, str, OutputVariableType, str]] = []
        kinds = {
            OutputVariableType.KineticEnergy: self.kineticObjects,
            OutputVariableType.PotentialEnergy: self.potentialObjects,
        }
        for number in range(mbs.systemData.NumberOfObjects()):
            for variable, found in kinds.items():
                try:
                    mbs.GetObjectOutput(ObjectIndex(number), variable)
                    found.append(number)
                except ValueError as error:
                    if "has no output variable" not in str(error):
                        kind = str(mbs.GetObject(number)["objectType"])
                        self.unavailable.append((number, kind, variable, str(error)))
        for number in range(mbs.systemData.NumberOfLoads()):
            if LoadPotentialEnergy(mbs, LoadIndex(number)) is None:
                reason, kind = "its potential is not known", str(mbs.GetLoad(number)["loadType"])
                self.unavailable.append((number, kind, OutputVariableType.PotentialEnergy, reason))
            else:
                self.loads.append(number)
        if self.unavailable and not skipUnavailable:
            number, kind, variable, reason = self.unavailable[0]
            raise ValueError(f"SystemEnergy: {variable.name} of item {number} ({kind}) is not available: {reason}")

    def _sum(self, numbers: list[int], variable: OutputVariableType, configuration: ConfigurationType) -> float:
        return float(sum(self.mbs.GetObjectOutput(ObjectIndex(n), variable, configuration) for n in numbers))

    def ComputeSystemEnergies(self, configuration: ConfigurationType = _CURRENT) -> list[float]:
        """Return [kinetic, potential of objects, potential of loads, total] in J."""
        kinetic = self._sum(self.kineticObjects, OutputVariableType.KineticEnergy, configuration)
        potential = self._sum(self.potentialObjects, OutputVariableType.PotentialEnergy, configuration)
        found = [LoadPotentialEnergy(self.mbs, LoadIndex(number), configuration) for number in self.loads]
        of_loads = float(sum(energy for energy in found if energy is not None))
        return [kinetic, potential, of_loads, kinetic + potential + of_loads]

    def AddSensor(self, storeInternal: bool = True, writeToFile: bool = False, fileName: str = "") -> SensorIndex:
        """Add a sensor of ComputeSystemEnergies(); call mbs.Assemble() again."""
        return _add_sensor(self.mbs, self.ComputeSystemEnergies, storeInternal, writeToFile, fileName)
