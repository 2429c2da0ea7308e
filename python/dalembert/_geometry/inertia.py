"""Mass, centre of mass and inertia tensor of rigid bodies; links of kinematic trees. Units kg, m, kg*m^2."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from math import hypot, isfinite, sqrt
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_matrix, as_number, as_rotation, as_transformation, as_vector, shape_error
from dalembert._core import _array, _is_plain_not_negative
from dalembert._geometry.rotations import Skew
from dalembert._geometry.transformations import HT0, HTtranslate, InertiaTensor2Inertia6D


class TreeLink:
    """A link with its joint, as used by MainSystem.CreateKinematicTree.

    jointType None means JointType.RevoluteZ; jointHT maps this link's joint frame to the frame of the parent link;
    parent is the index or name of the parent link, -1 for ground, None for the previous link; PDcontrol holds the
    control parameters; graphicsDataList None draws a default link, [] draws nothing. name and jointName can be used
    instead
    of the number of the link and of its coordinate.
    """

    def __init__(
        self,
        linkInertia: RigidBodyInertia,
        jointType: Any = None,
        jointHT: npt.ArrayLike = HT0(),
        parent: int | str | None = None,
        PDcontrol: Any = None,
        graphicsDataList: list[dict[str, Any]] | None = None,
        name: str = "",
        jointName: str = "",
    ) -> None:
        if jointType is None:
            import dalembert as exu

            jointType = exu.JointType.RevoluteZ
        if not isinstance(linkInertia, RigidBodyInertia):
            raise shape_error("TreeLink: linkInertia", "a RigidBodyInertia, e.g. InertiaCuboid(...)", linkInertia)
        self.jointType = jointType
        self.linkInertia = linkInertia
        self.jointHT = as_transformation("jointHT", jointHT).copy()
        self.parent = parent
        self.PDcontrol = PDcontrol
        self.graphicsDataList = graphicsDataList
        self.name = name
        self.jointName = jointName


class RigidBodyInertia:
    """Mass, centre of mass (com) and 3x3 inertia tensor of a rigid body in a body-fixed frame.

    The tensor is stored about the reference point, the origin of that frame; inertiaTensorAtCOM=True says that the
    tensor given here is about the centre of mass. Inertias about the same reference point add with +; - cuts holes.
    """

    def __init__(
        self,
        mass: float = 0,
        inertiaTensor: npt.ArrayLike = np.zeros([3, 3]),
        com: npt.ArrayLike = np.zeros(3),
        inertiaTensorAtCOM: bool = False,
    ) -> None:
        if not isinstance(inertiaTensorAtCOM, bool | int | np.bool_):
            raise shape_error("RigidBodyInertia: inertiaTensorAtCOM", "a bool", inertiaTensorAtCOM)
        tensor = as_matrix("RigidBodyInertia: inertiaTensor", inertiaTensor, (3, 3))
        if not all(map(isfinite, tensor.ravel().tolist())):
            raise shape_error("RigidBodyInertia: inertiaTensor", "a tensor of finite numbers", inertiaTensor)
        number, centre = as_number("RigidBodyInertia: mass", mass), as_vector("RigidBodyInertia: com", com, 3).copy()
        self._set(number, tensor.copy(), centre)
        if inertiaTensorAtCOM:
            self.inertiaTensor = tensor + self._steiner()
        self._judge(tensor)

    def _judge(self, tensor: FloatArray) -> None:
        """Refuse negative principal moments about the centre of mass; warn of others that no body has."""
        scale = hypot(*self.inertiaTensor.ravel().tolist())
        if scale == 0.0 or self.mass < 0.0:  # mass points, and negative masses that cut holes, are meant
            return
        (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = tensor.tolist()
        if hypot(xy - yx, xz - zx, yz - zy) > 1e-14 / sqrt(2.0) * scale:
            warnings.warn("RigidBodyInertia: inertiaTensor is not symmetric; use (J + J.T)/2", stacklevel=3)
            return
        moments: Any
        if xy == xz == yz == 0.0 and not any(self.com.tolist()):
            moments = np.array(sorted((xx, yy, zz)))
        else:
            about_centre = self.InertiaCOM()
            moments = np.linalg.eigvalsh(0.5 * (about_centre + about_centre.T))
        if moments[0] < -1e-8 * scale:
            raise shape_error(
                "RigidBodyInertia: inertiaTensor",
                "a tensor without negative principal moments about the centre of mass (inertiaTensorAtCOM=True says "
                f"that it is about that point), not {moments}",
                tensor,
            )
        if moments[0] + moments[1] < moments[2] - 1e-12 * scale:
            warnings.warn(
                f"RigidBodyInertia: principal moments of inertia {moments} violate the triangle inequality; "
                "no body has them, and the simulation may be unstable",
                stacklevel=3,
            )

    @staticmethod
    def _of(mass: float, inertiaTensor: FloatArray, com: FloatArray) -> RigidBodyInertia:
        """Return the inertia of these values about the reference point; intermediate sums may be physically
        impossible."""
        inertia = RigidBodyInertia.__new__(RigidBodyInertia)
        inertia._set(mass, inertiaTensor, com)
        return inertia

    def _set(self, mass: float, inertiaTensor: FloatArray, com: FloatArray) -> None:
        self.mass, self.com, self.inertiaTensor = mass, com, inertiaTensor
        self.data: dict[str, Any] = {"type": "RigidBodyInertia"}
        self._nTilesGraphics = 16
        self._roundnessGraphics = 0.0

    def _steiner(self, com: FloatArray | None = None) -> FloatArray:
        """Return the inertia tensor of the whole mass concentrated at com, about the reference point."""
        skew = Skew(self.com if com is None else com)
        return self.mass * (skew.T @ skew)

    def __add__(self, otherBodyInertia: RigidBodyInertia) -> RigidBodyInertia:
        """Return the inertia of both bodies together; frames and reference points must coincide."""
        if not isinstance(otherBodyInertia, RigidBodyInertia):
            return NotImplemented
        mass = self.mass + otherBodyInertia.mass
        moment = self.mass * self.com + otherBodyInertia.mass * otherBodyInertia.com
        if mass == 0.0 and np.any(moment != 0.0):
            raise ValueError("RigidBodyInertia: the masses cancel, but not their moments; centre of mass is undefined")
        com = moment / mass if mass != 0.0 else np.zeros(3)
        return self._of(mass, self.inertiaTensor + otherBodyInertia.inertiaTensor, com)

    def __sub__(self, otherBodyInertia: RigidBodyInertia) -> RigidBodyInertia:
        """Return the inertia of the body with the other one as a hole; frames and reference points must coincide."""
        if not isinstance(otherBodyInertia, RigidBodyInertia):
            return NotImplemented
        other = otherBodyInertia
        return self + self._of(-other.mass, -other.inertiaTensor, other.com)

    def SetWithCOMinertia(self, mass: float, inertiaTensorCOM: npt.ArrayLike, com: npt.ArrayLike) -> None:
        """Set mass, centre of mass and inertia from a 3x3 tensor about the centre of mass."""
        tensor = as_matrix("SetWithCOMinertia: inertiaTensorCOM", inertiaTensorCOM, (3, 3))
        self.com = as_vector("SetWithCOMinertia: com", com, 3).copy()
        self.mass = mass
        self.inertiaTensor = tensor + self._steiner()

    def Inertia(self) -> FloatArray:
        """Return the 3x3 inertia tensor about the reference point."""
        return self.inertiaTensor

    def InertiaCOM(self) -> FloatArray:
        """Return the 3x3 inertia tensor about the centre of mass."""
        return self.inertiaTensor - self._steiner()

    def COM(self) -> FloatArray:
        """Return the centre of mass relative to the reference point."""
        return self.com

    def Mass(self) -> float:
        """Return the mass."""
        return self.mass

    def _moved(self, A: FloatArray, r: FloatArray) -> RigidBodyInertia:
        com = A @ self.com + r
        return self._of(self.mass, A @ self.InertiaCOM() @ A.T + self._steiner(com), com)

    def _carry_data(self, moved: RigidBodyInertia, T: FloatArray) -> RigidBodyInertia:
        moved.data.update(self.data)
        moved.data["HT"] = self.data["HT"] @ T if "HT" in self.data else T.copy()
        return moved

    def Translated(self, vec: npt.ArrayLike) -> RigidBodyInertia:
        """Return the inertia of the body shifted by the 3D vector vec, about the unchanged reference point."""
        r = as_vector("Translated: vec", vec, 3)
        return self._carry_data(self._moved(np.eye(3), r), HTtranslate(r))

    def Rotated(self, rot: npt.ArrayLike) -> RigidBodyInertia:
        """Return the inertia of the body rotated by the 3x3 matrix rot, with tensor rot @ J @ rot.T.

        Raises ValueError if the centre of mass is not at the reference point; use Transformed then.
        """
        A = as_rotation("Rotated: rot", rot)
        if np.any(self.com != 0.0):
            raise ValueError(
                f"RigidBodyInertia.Rotated: expected com=[0,0,0], received com={self.com.tolist()}; "
                "use Transformed(HT) for a shifted centre of mass"
            )
        return self._moved(A, np.zeros(3))

    def Transformed(self, HT: npt.ArrayLike) -> RigidBodyInertia:
        """Return the inertia of the body rotated and then shifted by the 4x4 homogeneous transformation HT."""
        T = as_transformation("Transformed: HT", HT)
        return self._carry_data(self._moved(T[:3, :3], T[:3, 3]), T)

    def GetInertia6D(self) -> list[float]:
        """Return [Jxx, Jyy, Jzz, Jyz, Jxz, Jxy] about the reference point, as ObjectRigidBody expects it."""
        return InertiaTensor2Inertia6D(self.inertiaTensor)

    def GetTypeName(self) -> str:
        """Return the name of the class, e.g. 'InertiaCylinder'."""
        return self.__class__.__name__

    def GetSpecialData(self) -> dict[str, Any]:
        """Return the dictionary of the type-specific data, e.g. radius and density."""
        return self.data

    def GetGraphics(
        self, color: npt.ArrayLike, nTiles: int | None = None, roundness: float | None = None
    ) -> dict[str, Any] | None:
        """Return graphicsData of the shape of the inertia, placed at the centre of mass but not rotated.

        A colour of -1 selects the default body colour; None is returned for a general inertia.
        """
        from dalembert import graphics

        rgba = as_vector("GetGraphics: color", color, 4)
        if rgba[0] == -1:
            rgba = np.array(graphics.color.defaultBody, dtype=float)
        tiles = self._nTilesGraphics if nTiles is None else nTiles
        rounded = self._roundnessGraphics if roundness is None else roundness
        data, com = self.data, self.com
        match data["type"]:
            case "InertiaCylinder":
                vAxis = data["length"] * np.eye(3)[data["axis"]]
                inner = data["innerRadius"] if data["innerRadius"] > 0 else None
                return graphics.Cylinder(
                    com - 0.5 * vAxis, vAxis, data["outerRadius"], rgba, nTiles=2 * tiles, radiusInner=inner
                )
            case "InertiaCuboid":
                return graphics.Brick(com, data["sideLengths"], rgba, roundness=rounded)
            case "InertiaRodX":
                size = data["length"] * np.array([1.0, 0.01, 0.01])
                return graphics.Brick(com, size, rgba, roundness=rounded)
            case "InertiaMassPoint":
                radius = (0.75 * data["mass"] / (2000.0 * np.pi)) ** (1 / 3)  # sphere with density 2000 kg/m^3
                return graphics.Sphere(com, radius, rgba, nTiles=tiles)
            case "InertiaSphere" | "InertiaHollowSphere":
                return graphics.Sphere(com, data["radius"], rgba, nTiles=tiles)
        return None

    def __str__(self) -> str:
        return (
            f"mass = {self.mass}\nCOM = {self.com}\n"
            f"inertiaTensorAtOrigin = \n{self.inertiaTensor}\ninertiaTensorAtCOM = \n{self.InertiaCOM()}"
        )

    __repr__ = __str__


def _not_negative(where: str, **values: Any) -> None:
    """Raise ValueError if a density, mass, length or radius is negative or not finite."""
    for name, value in values.items():
        for number in value.tolist() if isinstance(value, np.ndarray) and value.ndim == 1 else [value]:
            if not _is_plain_not_negative(number):  # the usual case needs no text
                as_number(f"{where}: {name}", number, negative=False)


class InertiaCuboid(RigidBodyInertia):
    """Inertia of a homogeneous cuboid with density (kg/m^3) and three side lengths along the axes, about its centre."""

    def __init__(self, density: float, sideLengths: Sequence[float] | FloatArray) -> None:
        sides = as_vector("InertiaCuboid: sideLengths", sideLengths, 3)
        _not_negative("InertiaCuboid", density=density, sideLengths=sides)
        x, y, z = sides.tolist()
        mass = density * (x * y * z)
        squares = x * x + y * y + z * z
        xx, yy, zz = (mass / 12.0 * (squares - side * side) for side in (x, y, z))
        super().__init__(mass, _array(3, xx, 0.0, 0.0, 0.0, yy, 0.0, 0.0, 0.0, zz))
        self.data = {"type": "InertiaCuboid", "density": density, "sideLengths": sideLengths}


class InertiaRodX(RigidBodyInertia):
    """Inertia of a thin rod along the x axis, about its centre."""

    def __init__(self, mass: float, length: float) -> None:
        _not_negative("InertiaRodX", mass=mass, length=length)
        J = mass * length**2 / 12.0
        super().__init__(mass, np.diag([0.0, J, J]))
        self.data = {"type": "InertiaRodX", "mass": mass, "length": length}


class InertiaMassPoint(RigidBodyInertia):
    """Inertia of a mass point: no moments of inertia, so not sufficient for a rigid body with rotations."""

    def __init__(self, mass: float) -> None:
        _not_negative("InertiaMassPoint", mass=mass)
        super().__init__(mass)
        self.data = {"type": "InertiaMassPoint", "mass": mass}


class InertiaSphere(RigidBodyInertia):
    """Inertia of a homogeneous sphere about its centre, from its radius and either mass or density."""

    def __init__(self, mass: float | None = None, radius: float | None = None, density: float | None = None) -> None:
        if radius is None:
            raise shape_error("InertiaSphere: radius", "a number", radius)
        if (mass is None) == (density is None):
            raise ValueError(
                f"InertiaSphere: expected either mass or density, received mass={mass} and density={density}"
            )
        _not_negative("InertiaSphere", radius=radius, **({"density": density} if mass is None else {"mass": mass}))
        volume = 4.0 / 3.0 * np.pi * radius**3
        if mass is None:
            assert density is not None
            mass = density * volume
        else:
            density = mass / volume if volume != 0.0 else 0.0
        super().__init__(mass, 0.4 * mass * radius**2 * np.eye(3))
        self.data = {"type": "InertiaSphere", "mass": mass, "radius": radius, "density": density, "volume": volume}


class InertiaHollowSphere(RigidBodyInertia):
    """Inertia of a thin spherical shell about its centre."""

    def __init__(self, mass: float, radius: float) -> None:
        _not_negative("InertiaHollowSphere", mass=mass, radius=radius)
        super().__init__(mass, 2.0 / 3.0 * mass * radius**2 * np.eye(3))
        self.data = {"type": "InertiaHollowSphere", "mass": mass, "radius": radius}


class InertiaCylinder(RigidBodyInertia):
    """Inertia of a homogeneous (hollow) cylinder about its centre; axis 0, 1, 2 is the x, y, z axis."""

    def __init__(self, density: float, length: float, outerRadius: float, axis: int, innerRadius: float = 0) -> None:
        if axis not in (0, 1, 2):
            raise shape_error("InertiaCylinder: axis", "0, 1 or 2", axis)
        _not_negative(
            "InertiaCylinder", density=density, length=length, outerRadius=outerRadius, innerRadius=innerRadius
        )
        if innerRadius > outerRadius:
            raise shape_error("InertiaCylinder: innerRadius", f"at most outerRadius={outerRadius}", innerRadius)
        mass = density * length * np.pi * (outerRadius**2 - innerRadius**2)
        polar = 0.5 * mass * (outerRadius**2 + innerRadius**2)
        moments = np.full(3, 0.5 * polar + mass * length**2 / 12.0)
        moments[axis] = polar
        super().__init__(mass, np.diag(moments))
        self.data = {
            "type": "InertiaCylinder",
            "density": density,
            "length": length,
            "axis": axis,
            "outerRadius": outerRadius,
            "innerRadius": innerRadius,
        }
