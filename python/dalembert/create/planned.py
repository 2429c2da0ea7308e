"""Create functions whose items are not there yet: they say so instead of failing somewhere inside."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NoReturn

_PLANNED = {
    "CreateSphereSphereContact": "contact between spheres (ObjectContactSphereSphere)",
    "CreateSphereQuadContact": "contact of a sphere with a quadrangle (ObjectContactSphereTriangle)",
    "CreateSphereTriangleContact": "contact of a sphere with a triangle (ObjectContactSphereTriangle)",
    "CreateKinematicTree": "the kinematic tree (ObjectKinematicTree)",
    "CreateFFRFReducedOrderObject": "flexible bodies in a floating frame (ObjectFFRFreducedOrder)",
}


def _planned(name: str, what: str) -> Callable[..., NoReturn]:
    def create(mbs: Any, *args: Any, **kwargs: Any) -> NoReturn:
        raise NotImplementedError(f"MainSystem.{name}(...): {what} is planned and not available in this version")

    create.__name__ = create.__qualname__ = name
    create.__doc__ = f"Planned: {what}; raises NotImplementedError."
    return create


functions = {name: _planned(name, what) for name, what in _PLANNED.items()}
