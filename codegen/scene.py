"""The [scene] table of an item: its models in the tests of all items.

It defines the nodes, markers and values of its models, options with different equations, and exemptions from tests,
with
the reason.

Tests read it through `Item.scene`; only the drawing of items of packages depends on it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

# Meaning of the coordinates of a node for a motion of its frame; python/dalembert/testing/motions.py has the formulas.
FRAMES = ("point", "ep", "rxyz", "rotation_vector", "angle", "slope", "slopes12", "slopes23")
# Symbols of objects of packages between their markers; python/dalembert/_pictures/connectors.py draws them.
DRAWINGS = ("spring", "rod", "line", "spheres", "boxes", "frames")
# Checks with possible exemptions, and their requirements.
EXEMPT = {
    "moments": "what acts between two bodies leaves their angular momentum alone",
    "rotations": "a model that is turned as a whole moves in the turned way",
    "partial_rotations": "the same, with some of the axes free",
    "function_rotations": "the same, with user functions",
    "forces": "a force on it in any direction has an effect",
    "plane": "its equations are independent in plane models",
    "holonomic": "reactions are the virtual work of the gaps",
    "values": "rates of its markers' values are their rates",
    "rates": "reactions are the virtual work of the rates",
    "coordinates": "all of its unknowns are multipliers",
    "rates_on_velocity_level": "the same, for equations of velocities",
    "user_jacobian": "the tangent is complete with the Jacobian of a user",
    "joints": "it can follow any joint of frames",
    "data_size": "a data node of another size is refused",
    "without_data": "it needs its data node",
    "without_functions": "it acts without user functions",
}


@dataclass(frozen=True)
class End:
    """Carrier of a marker, or an additional body: `MarkerBodyRigid on ObjectRigidBody on NodeRigidBodyEP`.

    The node is omitted if the body has only one type of node, or none; the body is omitted for markers on nodes.
    """

    marker: str
    body: str
    node: str

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(filter(None, (self.marker, self.body, self.node)))


@dataclass(frozen=True)
class NodePlace:
    """A node of a body or connector: its type (default: that of the model), its position in the axes of the body, rows.

    `below`: not a new one, but the last node of the body at this position of the pair.
    `mesh`: its reference position in the frame of the body, in which it is displaced a little.
    """

    type: str = ""
    at: tuple[float, ...] = (0.0, 0.0, 0.0)
    values: Mapping[str, Any] = field(default_factory=dict)
    below: int = -1
    mesh: tuple[float, ...] = ()


@dataclass(frozen=True)
class SceneTable:
    # nodes
    frame: str = ""
    # bodies
    nodes: tuple[NodePlace, ...] = ()
    small_deformations: bool = False
    bent: bool = False
    isotropic: Mapping[str, list[list[float]]] = field(default_factory=dict)
    local: tuple[tuple[float, ...], ...] = ()
    # markers
    every_body: bool = False
    beside: tuple[End, ...] = ()
    # connectors, contacts, constraints, joints, loads
    fits: tuple[str, ...] | None = None
    planar: bool = False
    data: int = 3
    per_marker: Mapping[str, list[Any]] = field(default_factory=dict)
    closed: Mapping[str, str] = field(default_factory=dict)
    power: tuple[tuple[str, str], ...] = ()
    force_equations: int = 3
    second_body: str = ""
    drawing: str = ""
    # all
    pairs: tuple[tuple[End, ...], ...] = ()
    values: Mapping[str, Any] = field(default_factory=dict)
    options: tuple[Mapping[str, Any], ...] = ({},)
    exempt: Mapping[str, str] = field(default_factory=dict)
    exempt_outputs: Mapping[str, str] = field(default_factory=dict)
    global_outputs: tuple[str, ...] = ()
    relative_outputs: tuple[str, ...] = ()
    exempt_parameters: Mapping[str, str] = field(default_factory=dict)

    @property
    def ends(self) -> Iterator[tuple[str, End]]:
        """All places that it names, with the key that does."""
        yield from (("pairs", end) for pair in self.pairs for end in pair)
        yield from (("beside", end) for end in self.beside)
