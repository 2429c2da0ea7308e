"""Joints that lock all rotations, with frames turned by more than a right angle: their equations accept half a turn."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from dalembert._core import ConfigurationType, OutputVariableType, _item_counts
from dalembert._solving.diagnosis import listed

_TYPES = ("JointGeneric", "JointPrismaticX")


def _locks_all_rotations(item: dict[str, Any]) -> bool:
    """Return whether the equations of a joint are three products of axes that vanish."""
    if not item.get("activeConnector", False):
        return False
    if item["objectType"] == "JointPrismaticX":
        return True
    if item["objectType"] != "JointGeneric" or item["alternativeConstraints"] or item["offsetUserFunction"]:
        return False
    return all(item["constrainedAxes"][3:])


def objects_of_types(mbs: Any, types: tuple[str, ...], constraints: bool = False) -> list[int]:
    """Return the numbers of objects of these types, kept as long as numbers of items stay.

    constraints: only objects with algebraic equations are looked at.
    """
    counts, key = _item_counts(mbs), f"objects of types {', '.join(types)}"
    known = mbs.sys.get(key)
    if known is None or known[0] != counts:
        data = mbs.systemData
        numbers = [i for i in range(data.NumberOfObjects()) if not constraints or data.GetObjectLTGAE(i)]
        known = mbs.sys[key] = counts, [i for i in numbers if mbs.GetObject(i)["objectType"] in types]
    return list(known[1])


def turned_joints(mbs: Any, configuration: ConfigurationType) -> list[str]:
    """Return a text for each joint whose frames are on the way to half a turn, or there."""
    found = []
    for number in objects_of_types(mbs, _TYPES, constraints=True):
        item = mbs.GetObject(number)
        if not _locks_all_rotations(item):
            continue
        axes = [
            mbs.GetMarkerOutput(marker, OutputVariableType.RotationMatrix, configuration).reshape(3, 3)
            @ np.asarray(item[f"rotationMarker{i}"])
            for i, marker in enumerate(item["markerNumbers"])
        ]
        relative = axes[0].T @ axes[1]
        if np.diag(relative).min() < -1e-9:
            angle = np.degrees(np.arccos(np.clip((np.trace(relative) - 1) / 2, -1, 1)))
            name = f"object {number} '{item['name']}' ({item['objectType']})"
            found.append(f"{name}: frames turned by {angle:.4g} degrees")
    return found


def warn_of_half_turns(function: str, mbs: Any, configuration: ConfigurationType, when: str) -> None:
    """Warn of fixed joints that are, or may be, assembled with a rotation of 180 degrees."""
    if mbs.systemData.AEsize() == 0:
        return
    if found := turned_joints(mbs, configuration):
        advice = (
            "Turn rotationMarker0 or rotationMarker1 by as much as the bodies are meant to be turned, correct initial "
            "rotations, or set alternativeConstraints=True"
        )
        lines = [
            f"{function}: {when}, joints lock rotations whose equations also hold for half a turn:",
            *listed(found),
            f"  {advice}",
        ]
        warnings.warn("\n".join(lines), stacklevel=4)
