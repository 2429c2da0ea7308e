# Contact of many things with each other.

from typing import Any, Literal, NoReturn, overload

from numpy.typing import ArrayLike

from dalembert._core_base import MarkerIndex, ObjectIndex, _Bound
from dalembert._core_enums import ConfigurationType, ContactTypeIndex
from dalembert._core_main_system import MainSystem
from dalembert._core_types import Array, Indices

class VisuGeneralContact(_Bound):
    def Reset(self) -> None: ...

class GeneralContact(_Bound):
    def __init__(self, *args: Any, **kwargs: Any) -> NoReturn: ...
    isActive: bool
    sphereSphereContact: bool
    frictionProportionalZone: float
    minRelDistanceSpheresTriangles: float
    verboseMode: int
    resetSearchTreeInterval: int
    sphereSphereFrictionRecycle: bool
    excludeOverlappingTrigSphereContacts: bool
    excludeDuplicatedTrigSphereContactPoints: bool
    computeExactStaticTriangleBins: bool
    computeContactForces: bool
    ancfCableUseExactMethod: bool
    ancfCableNumberOfContactSegments: int
    ancfCableMeasuringSegments: int
    parallelTaskSplit: int
    parallelTaskSplitBoundingBoxes: int
    parallelTaskSplitThreshold: int
    parallelTaskSplitBoundingBoxesThreshold: int
    @property
    def visualization(self) -> VisuGeneralContact: ...
    def AddSphereWithMarker(
        self,
        markerIndex: MarkerIndex | int | str,
        radius: float,
        contactStiffness: float,
        contactDamping: float,
        frictionMaterialIndex: int,
    ) -> int: ...
    def AddTrianglesRigidBodyBased(
        self,
        rigidBodyMarkerIndex: MarkerIndex | int | str,
        contactStiffness: float,
        contactDamping: float,
        frictionMaterialIndex: int,
        pointList: ArrayLike,
        triangleList: ArrayLike,
        staticTriangles: bool = False,
    ) -> int: ...
    def AddANCFCable(
        self,
        objectIndex: ObjectIndex | int | str,
        halfHeight: float,
        contactStiffness: float,
        contactDamping: float,
        frictionMaterialIndex: int,
    ) -> int: ...
    def AddBoxWithMarker(
        self,
        markerIndex: MarkerIndex | int | str,
        size: ArrayLike,
        contactStiffness: float,
        contactDamping: float,
        frictionMaterialIndex: int,
        centerPoint: ArrayLike = [0.0, 0.0, 0.0],
    ) -> int: ...
    def AddCylinderWithMarker(
        self,
        markerIndex: MarkerIndex | int | str,
        radius: float,
        vAxis: ArrayLike,
        contactStiffness: float,
        contactDamping: float,
        frictionMaterialIndex: int,
        pAxis: ArrayLike | None = None,
    ) -> int: ...
    def AddCapsuleWithMarker(
        self,
        markerIndex: MarkerIndex | int | str,
        radius: float,
        vAxis: ArrayLike,
        contactStiffness: float,
        contactDamping: float,
        frictionMaterialIndex: int,
        pAxis: ArrayLike | None = None,
    ) -> int: ...
    def AddConvexHullWithMarker(
        self,
        markerIndex: MarkerIndex | int | str,
        pointList: ArrayLike,
        contactStiffness: float,
        contactDamping: float,
        frictionMaterialIndex: int,
    ) -> int: ...
    def AddPlane(
        self,
        rigidBodyMarkerIndex: MarkerIndex | int | str,
        normal: ArrayLike,
        contactStiffness: float,
        contactDamping: float,
        frictionMaterialIndex: int,
        point: ArrayLike = [0.0, 0.0, 0.0],
    ) -> int: ...
    def AddHeightField(
        self,
        rigidBodyMarkerIndex: MarkerIndex | int | str,
        heights: ArrayLike,
        cellSize: ArrayLike,
        contactStiffness: float,
        contactDamping: float,
        frictionMaterialIndex: int,
        origin: ArrayLike = [0.0, 0.0, 0.0],
    ) -> int: ...
    def GetConvexContacts(self) -> dict[str, Any]: ...
    def SetFrictionPairings(self, frictionPairings: ArrayLike) -> None: ...
    def SetFrictionProportionalZone(self, frictionProportionalZone: float) -> None: ...
    def SetFrictionBristles(
        self, stiffnessRatio: float, dampingRatio: float = 1.0, staticRatio: float = 1.0
    ) -> None: ...
    def SetSearchTreeCellSize(self, numberOfCells: ArrayLike) -> None: ...
    def SetSearchTreeBox(self, pMin: ArrayLike, pMax: ArrayLike) -> None: ...
    def GetItemsInBox(self, pMin: ArrayLike, pMax: ArrayLike) -> dict[str, Indices] | Literal[False]: ...
    def GetSphereMarkerBased(self, localIndex: int, addData: bool = False) -> dict[str, Any]: ...
    def SetSphereMarkerBased(
        self,
        localIndex: int,
        contactStiffness: float = -1.0,
        contactDamping: float = -1.0,
        radius: float = -1.0,
        frictionMaterialIndex: int = -1,
    ) -> None: ...
    def GetTriangleRigidBodyBased(self, localIndex: int) -> dict[str, Any]: ...
    def SetTriangleRigidBodyBased(
        self, localIndex: int, points: ArrayLike, contactRigidBodyIndex: int = -1
    ) -> None: ...
    @overload
    def ShortestDistanceAlongLine(
        self,
        pStart: ArrayLike = ...,
        direction: ArrayLike = ...,
        minDistance: float = -1e-7,
        maxDistance: float = 1e7,
        *,
        asDictionary: Literal[True],
        cylinderRadius: float = 0,
        typeIndex: ContactTypeIndex | None = None,
    ) -> dict[str, Any]: ...
    @overload
    def ShortestDistanceAlongLine(
        self,
        pStart: ArrayLike = [0.0, 0.0, 0.0],
        direction: ArrayLike = [1.0, 0.0, 0.0],
        minDistance: float = -1e-7,
        maxDistance: float = 1e7,
        asDictionary: Literal[False] = False,
        cylinderRadius: float = 0,
        typeIndex: ContactTypeIndex | None = None,
    ) -> float: ...
    def UpdateContacts(self, mainSystem: MainSystem) -> None: ...
    def GetActiveContacts(self, typeIndex: ContactTypeIndex, itemIndex: int) -> Indices: ...
    def GetSystemODE2RhsContactForces(self, copy: bool = False) -> Array: ...
    def _pushes(self, configuration: ConfigurationType) -> tuple[Indices, Array, Array]: ...
    def GetPythonObject(self) -> dict[str, Any]: ...
    def Reset(self, freeMemory: bool = True) -> None: ...
