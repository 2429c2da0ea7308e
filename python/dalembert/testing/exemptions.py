"""Exceptions of the tests of all items: check by check, item by item, with the reason that the spec of the item gives
under
[scene.exempt]. `test_exemptions.py` holds each of them against the check, so that one which is not needed any more fails."""

from __future__ import annotations

from dalembert.testing import motions


def exempt(check: str, kind: str = "") -> dict[str, str]:
    """Item -> reason."""
    named = [item for item in motions.ITEMS.values() if item.ready and check in item.scene.exempt]
    return {item.name: item.scene.exempt[check] for item in named if kind in ("", item.kind)}


NO_MOMENT = exempt("moments")
GLOBAL_AXES = exempt("rotations", "object")
GLOBAL_MARKER = exempt("rotations", "marker")
GLOBAL_WHEN_PARTIAL = exempt("partial_rotations")
GLOBAL_FUNCTIONS = exempt("function_rotations")
NONHOLONOMIC = exempt("holonomic")
NOT_OF_VALUES = exempt("values")
NOT_OF_RATES = exempt("rates")
WITH_COORDINATES = exempt("coordinates")
VELOCITY_LEVEL = exempt("rates_on_velocity_level")
HOLDS_JACOBIAN = exempt("user_jacobian")
ODD_IN_JOINTS = exempt("joints")
NO_FORCES = exempt("forces")
OUT_OF_THE_PLANE = exempt("plane")
DATA_OF_ANY_SIZE = exempt("data_size")
WITHOUT_DATA = exempt("without_data")
NEEDS_FUNCTIONS = exempt("without_functions")
WITHOUT_EFFECT = {
    (item.name, parameter): reason
    for item in motions.ITEMS.values()
    if item.ready
    for parameter, reason in item.scene.exempt_parameters.items()
}
RATE_OF_OUTPUTS = {
    (item.name, output): reason
    for item in motions.ITEMS.values()
    if item.ready
    for output, reason in item.scene.exempt_outputs.items()
}
