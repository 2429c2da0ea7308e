"""The types of specs: their types in C++ and Python, and their built-in checks."""

from __future__ import annotations

from dataclasses import dataclass

# None: any length.
Shape = tuple[int | None, ...]


@dataclass(frozen=True)
class ParameterType:
    """A row of the table below; `storage` is an entry of `Storage` in reflection/storage.hpp."""

    name: str
    cpp: str
    storage: str
    python: str
    shape: Shape = ()
    check: str = "none"
    single: bool = False  # the interface keeps this value in single precision
    takes_number: bool = False  # a number is a vector or matrix with this one entry

    @property
    def real(self) -> bool:
        """Whether the type consists of floating point numbers: these rows have a unit."""
        return self.storage in _REAL

    @property
    def index(self) -> bool:
        """An item number, or several."""
        return self.storage.removesuffix("s") in ("node", "object", "marker", "load", "sensor")

    @property
    def function(self) -> bool:
        """A user function that the core calls."""
        return self.storage == "user_function"

    @property
    def complete(self) -> bool:
        """Has a default of its own, without which nothing is missing."""
        return self.index or self.function or self.opaque or self.storage in ("matrix_container", "beam_section")

    @property
    def opaque(self) -> bool:
        """Kept for Python; the core never looks into it."""
        return self.storage == "opaque"


_REAL = {
    "real", "vector2", "vector3", "vector4", "vector6", "vector7", "vector9", "matrix3", "matrix6", "vector", "matrix",
    "matrix_container", "vector3s", "matrix3s", "vector6s",
}  # fmt: skip


def _scalars() -> list[ParameterType]:
    real = [("Real", "none", False), ("UReal", "non_negative", False), ("PReal", "positive", False),
            ("float", "none", True), ("UFloat", "non_negative", True), ("PFloat", "positive", True)]  # fmt: skip
    integer = [("Int", "none"), ("Index", "non_negative"), ("UInt", "non_negative"), ("PInt", "positive")]
    return [
        ParameterType("Bool", "bool", "boolean", "bool"),
        *(ParameterType(name, "int", "integer", "int", check=check) for name, check in integer),
        *(ParameterType(name, "double", "real", "float", check=check, single=single) for name, check, single in real),
        ParameterType("String", "std::string", "text", "str"),
        ParameterType("FileName", "std::string", "text", "str"),
        ParameterType("OutputVariableType", "OutputVariableType", "output_variable", "OutputVariableType"),
    ]


def _arrays() -> list[ParameterType]:
    def vector(name: str, size: int, single: bool = False) -> ParameterType:
        return ParameterType(name, f"Vec<double, {size}>", f"vector{size}", "ArrayLike", (size,), single=single)

    def matrix(name: str, size: int, single: bool = False) -> ParameterType:
        cpp = f"Mat<double, {size}, {size}>"
        return ParameterType(name, cpp, f"matrix{size}", "ArrayLike", (size, size), single=single)

    def many(name: str, cpp: str, storage: str, python: str, *shape: int | None, single: bool = False) -> ParameterType:
        return ParameterType(name, f"std::vector<{cpp}>", storage, python, (None, *shape), single=single)

    return [
        *(vector(f"Vector{n}D", n) for n in (2, 3, 4, 6, 7, 9)),
        vector("Float3", 3, single=True),
        vector("Float4", 4, single=True),
        matrix("Matrix3D", 3),
        matrix("Matrix6D", 6),
        matrix("FloatMatrix3D", 3, single=True),
        many("Vector", "double", "vector", "ArrayLike"),
        ParameterType("NumpyVector", "std::vector<double>", "vector", "ArrayLike", (None,), takes_number=True),
        many("ArrayFloat", "double", "vector", "ArrayLike", single=True),
        ParameterType("NumpyMatrix", "DynamicMatrix<double>", "matrix", "ArrayLike", (None, None), takes_number=True),
        ParameterType("NumpyMatrixI", "DynamicMatrix<int>", "integer_matrix", "ArrayLike", (None, None)),
        ParameterType("PyMatrixContainer", "MatrixContainer", "matrix_container", "MatrixLike | None", (None, None)),
        many("Vector3DList", "Vec<double, 3>", "vector3s", "Sequence[ArrayLike] | Vector3DList", 3),
        many("Vector6DList", "Vec<double, 6>", "vector6s", "Sequence[ArrayLike] | Vector6DList", 6),
        many("Matrix3DList", "Mat<double, 3, 3>", "matrix3s", "Sequence[ArrayLike] | Matrix3DList", 3, 3),
        many("ArrayIndex", "int", "integers", "Sequence[int]"),
        many("StringList", "std::string", "texts", "Sequence[str]"),
        many("JointTypeList", "JointType", "joint_types", "Sequence[JointType]"),
    ]


def _indices() -> list[ParameterType]:
    kinds = ("Node", "Object", "Marker", "Load", "Sensor")
    single = [ParameterType(f"{kind}Index", f"{kind}Index", kind.lower(), f"{kind}Index | int | str") for kind in kinds]
    several = [
        ParameterType(
            f"Array{kind}Index",
            f"std::vector<{kind}Index>",
            f"{kind.lower()}s",
            f"Sequence[{kind}Index | int | str]",
            (None,),
        )
        for kind in kinds
    ]
    nodes = [
        ParameterType(f"NodeIndex{n}", "std::vector<NodeIndex>", "nodes", "Sequence[NodeIndex | int | str]", (n,))
        for n in (2, 3, 4)
    ]
    return single + several + nodes


def _foreign() -> list[ParameterType]:
    """User functions, and things that only Python looks into."""
    functions = (
        "MatrixContainerMbsScalarIndex2Vector",
        "MatrixContainerMbsScalarIndex2Vector2Scalar",
        "MatrixContainerMbsScalarIndex2VectorBool",
        "MatrixMbsScalarIndex2Vector",
        "MbsScalar2",
        "MbsScalarIndexScalar",
        "MbsScalarIndexScalar5",
        "MbsScalarIndexScalar9",
        "MbsScalarIndexScalar11",
        "Vector3DmbsScalarIndexScalar4Vector3D",
        "Vector3DmbsScalarVector3D",
        "Vector6DmbsScalarIndex4Vector3D2Matrix6D2Matrix3DVector6D",
        "Vector6DmbsScalarIndexVector6D",
        "VectorMbsScalarArrayIndexVectorConfiguration",
        "VectorMbsScalarIndex2Vector",
        "VectorMbsScalarIndex2VectorBool",
        "VectorMbsScalarIndex3Vector",
        "VectorMbsScalarIndex4VectorVector3D2Matrix6D2Matrix3DVector6D",
        "VectorMbsScalarIndexVector",
    )
    call = "Callable[..., Any] | Literal[0]"
    return [
        *(ParameterType(f"PyFunction{name}", "UserFunction", "user_function", call) for name in functions),
        ParameterType("PyFunctionGraphicsData", "Opaque", "opaque", call),
        ParameterType("KeyPressUserFunction", "Opaque", "opaque", call),
        ParameterType("BodyGraphicsData", "Opaque", "opaque", "Sequence[dict[str, Any]]", (None,)),
        ParameterType("BodyGraphicsDataList", "Opaque", "opaque", "Sequence[Sequence[dict[str, Any]]]", (None, None)),
        ParameterType("BeamSection", "BeamSection", "beam_section", "BeamSection"),
        ParameterType("BeamSectionGeometry", "Opaque", "opaque", "BeamSectionGeometry"),
    ]


TYPES: dict[str, ParameterType] = {row.name: row for row in _scalars() + _arrays() + _indices() + _foreign()}


@dataclass(frozen=True)
class ValueType:
    """An argument or the result of a user function; `kind` is an entry of `Signature::Kind` in reflection/row.hpp.

    `python` is the type of arguments; results may have any convertible type.
    """

    name: str
    kind: str
    python: str
    shape: Shape = ()

    @property
    def real(self) -> bool:
        """Made of floating point numbers."""
        return self.kind in ("scalar", "vector", "matrix", "open_vector", "open_matrix")

    @property
    def plain(self) -> bool:
        """A single integer or truth value."""
        return self.kind in ("integer", "boolean")


VALUE_TYPES: dict[str, ValueType] = {
    row.name: row
    for row in (
        ValueType("Real", "scalar", "float"),
        ValueType("Index", "integer", "int"),
        ValueType("Bool", "boolean", "bool"),
        ValueType("Vector", "open_vector", "Array", (None,)),
        ValueType("Vector3D", "vector", "Array", (3,)),
        ValueType("Vector6D", "vector", "Array", (6,)),
        ValueType("Matrix3D", "matrix", "Array", (3, 3)),
        ValueType("Matrix6D", "matrix", "Array", (6, 6)),
        ValueType("Matrix", "open_matrix", "Array", (None, None)),
        ValueType("MatrixContainer", "open_matrix", "MatrixContainer", (None, None)),
        ValueType("ArrayIndex", "index_list", "list[int]", (None,)),
        ValueType("ConfigurationType", "configuration", "ConfigurationType"),
        ValueType("GraphicsDataList", "none", "list[dict[str, Any]]", (None,)),
    )
}
