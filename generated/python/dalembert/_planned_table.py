# Generated from specs/ by codegen/templates/planned_table.py.j2. Do not edit; run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.
"""What the interface has and the package does not have yet."""

from typing import NamedTuple


class Planned(NamedTuple):
    """What it is for, what to do until it is there, and which members are planned if it is not the whole."""

    what: str
    instead: str
    members: tuple[str, ...]


ITEMS = (
    "NodeGenericAE",
)
MODULES: dict[str, Planned] = {
}
FUNCTIONS = {
    "SolverFileData": Planned('files of a solver', '', ()),
    "SolverLocalData": Planned('vectors and matrices of a solver', 'the state of the system is in mbs.systemData, and solvers have GetSystemJacobian and GetSystemMassMatrix', ()),
}
