"""Names of the interface whose classes are planned: they exist, and making an object says what is missing."""

from __future__ import annotations

from typing import Any, NoReturn

__all__ = ["GeneralContact", "SolverFileData", "SolverLocalData", "VisuGeneralContact"]


class _Planned:
    _advice = ""

    def __init__(self, *args: Any, **kwargs: Any) -> NoReturn:
        raise NotImplementedError(f"{type(self).__name__} is planned and not available yet{self._advice}")


class GeneralContact(_Planned):
    """Contact of many spheres, triangles and cables with each other; planned."""

    _advice = "; single contacts are objects, e.g. ObjectContactSphereSphere"


class VisuGeneralContact(_Planned):
    """How GeneralContact is drawn; planned."""


class SolverFileData(_Planned):
    """Files of a solver; planned."""


class SolverLocalData(_Planned):
    """Vectors and matrices of a solver; planned."""

    _advice = "; the state of the system is in mbs.systemData"
