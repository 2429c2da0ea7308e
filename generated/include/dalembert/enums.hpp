// Generated from specs/enums/ by codegen/templates/enums.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace dalembert {

// derivatives and integrals of kinematic quantities that an object offers to markers
enum class AccessFunctionType : std::uint32_t {
  _None = 0,
  TranslationalVelocity_qt = 32,
  AngularVelocity_qt = 64,
  Coordinate_q = 128,
  DisplacementLineIntegral_q = 512,
  DisplacementSurfaceIntegral_q = 1024,
  DisplacementVolumeIntegral_q = 2048,
  DisplacementMassIntegral_q = 4096,
  DisplacementSurfaceNormalIntegral_q = 8192,
};

// the state of the model that an output or a vector of coordinates is taken from
enum class ConfigurationType : std::uint32_t {
  _None = 0,
  Initial = 1,
  Current = 2,
  Reference = 3,
  StartOfStep = 4,
  Visualization = 5,
  EndOfEnumList = 6,
};

// kinds of contact partners in general contact, as indices
enum class ContactTypeIndex : std::uint32_t {
  IndexSpheresMarkerBased = 0,
  IndexANCFCable2D = 1,
  IndexTrigsRigidBodyBased = 2,
  IndexEndOfEnumList = 3,
  IndexConvexMarkerBased = 4,
  IndexPlanesRigidBodyBased = 5,
};

// shape of the cross section of a beam, for drawing and contact
enum class CrossSectionType : std::uint32_t {
  Polygon = 1,
  Circular = 2,
};

// time integration methods
enum class DynamicSolverType : std::uint32_t {
  GeneralizedAlpha = 1,
  TrapezoidalIndex2 = 2,
  ExplicitEuler = 3,
  ExplicitMidpoint = 4,
  RK33 = 5,
  RK44 = 6,
  RK67 = 7,
  ODE23 = 8,
  DOPRI5 = 9,
  DVERK6 = 10,
  VelocityVerlet = 11,
  DOP853 = 12,
  ESDIRK43 = 13,
};

// the five kinds of items
enum class ItemTypeCode : std::uint32_t {
  _None = 0,
  Node = 1,
  Object = 2,
  Marker = 3,
  Load = 4,
  Sensor = 5,
};

// joints of a kinematic tree, each with one coordinate; axes are those of the joint frame
enum class JointType : std::uint32_t {
  _None = 0,
  RevoluteX = 1,
  RevoluteY = 2,
  RevoluteZ = 3,
  PrismaticX = 4,
  PrismaticY = 5,
  PrismaticZ = 6,
};

// keys without a character, as passed to a key press user function; keys with a character are passed as that character's code
enum class KeyCode : std::uint32_t {
  SPACE = 32,
  ENTER = 257,
  TAB = 258,
  BACKSPACE = 259,
  RIGHT = 262,
  LEFT = 263,
  DOWN = 264,
  UP = 265,
  F1 = 291,
  F2 = 292,
  F3 = 293,
  F4 = 294,
  F5 = 295,
  F6 = 296,
  F7 = 297,
  F8 = 298,
  F9 = 299,
  F10 = 300,
};

// direct solvers for linear systems of equations
enum class LinearSolverType : std::uint32_t {
  _None = 0,
  EXUdense = 1,
  EigenSparse = 2,
  EigenSparseSymmetric = 4,
  EigenDense = 8,
};

// kinds of coordinates that a node has; values can be joined
enum class NodeGroup : std::uint32_t {
  _None = 0,
  ODE1variables = 1,
  ODE2variables = 2,
  AEvariables = 4,
  DataVariables = 8,
};

// capabilities of a node; values can be combined
enum class NodeType : std::uint32_t {
  _None = 0,
  Ground = 1,
  Position2D = 2,
  Orientation2D = 4,
  Point2DSlope1 = 8,
  Position = 16,
  Orientation = 32,
  RigidBody = 64,
  RotationEulerParameters = 128,
  RotationRxyz = 256,
  RotationRotationVector = 512,
  LieGroupWithDirectUpdate = 1024,
  GenericODE2 = 4096,
  GenericODE1 = 8192,
  GenericAE = 16384,
  GenericData = 32768,
  PointSlope1 = 65536,
  PointSlope12 = 131072,
  PointSlope23 = 262144,
};

// categories of an object; values can be combined
enum class ObjectType : std::uint32_t {
  _None = 0,
  Ground = 2,
  Constraint = 4,
  Connector = 8,
  Body = 16,
  SingleNoded = 32,
  MultiNoded = 64,
  FiniteElement = 128,
  SuperElement = 256,
  EndOfEnumList = 1024,
};

// quantities that items offer to outputs and sensors; the page of an item lists those that it has, with size and frame
enum class OutputVariableType : std::uint64_t {
  _None = 0,
  Distance = 1,
  Position = 2,
  Displacement = 4,
  DisplacementLocal = 8,
  Velocity = 16,
  VelocityLocal = 32,
  Acceleration = 64,
  AccelerationLocal = 128,
  RotationMatrix = 256,
  Rotation = 8192,
  AngularVelocity = 512,
  AngularVelocityLocal = 1024,
  AngularAcceleration = 2048,
  AngularAccelerationLocal = 4096,
  CoordinatesTotal = 16384,
  Coordinates = 32768,
  Coordinates_t = 65536,
  Coordinates_tt = 131072,
  SlidingCoordinate = 262144,
  Director1 = 524288,
  Director2 = 1048576,
  Director3 = 2097152,
  Force = 4194304,
  ForceLocal = 8388608,
  Torque = 16777216,
  TorqueLocal = 33554432,
  NonUniqueReactions = 67108864,
  WrenchOnMarker0 = 134217728,
  WrenchOnMarker1 = 134217729,
  WrenchOnMarker0Local = 134217730,
  WrenchOnMarker1Local = 134217731,
  StrainLocal = 268435456,
  StressLocal = 536870912,
  CurvatureLocal = 1073741824,
  ConstraintEquation = 2147483648,
  KineticEnergy = 4294967296,
  PotentialEnergy = 8589934592,
  HomogeneousTransformation = 17179869184,
  HomogeneousTransformationLocal = 34359738368,
};

struct EnumEntry {
  std::string_view name;
  std::uint64_t value;
};

struct EnumTable {
  std::string_view name;  // as users write it
  std::span<const EnumEntry> entries;
};

// All enumerations; `Row::enumeration` is a number in this table.
std::span<const EnumTable> enum_tables();

}  // namespace dalembert
