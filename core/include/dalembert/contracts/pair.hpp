// Items between two markers of one shape, and loads on one: their frames come in, forces on them go out.
//
//   marker 0 ──frame──▶ ┌────────┐ ──force──▶ marker 0
//   marker 1 ──frame──▶ │ kernel │ ──force──▶ marker 1
//                       └────────┘
//
// Frames and forces are in global axes; forces act at the point of the marker, and moments about it (frames.hpp):
//
//   Port          frame of a marker: read by the kernel                          force on the marker: returned by the kernel
//   PointPort     position x, velocity v                                         force f
//   RigidPort     x, v, rotation A (marker axes to global), angular velocity w   force f, moment m
//   ScalarPort    value and rate of a coordinate                                 force along the coordinate
//
// A force is the power conjugate of its frame, P = f.v + m.w. The kernel gives the forces on both markers, and nobody balances them afterwards: action and
// reaction, f_0 + f_1 = 0 and m_0 + m_1 + (x_1 - x_0) x f_1 = 0, are its task.
//
// Example: a spring and damper that act in all directions (tests/core/pair.cpp compiles it, and compares the numbers below).
//
//   struct IsotropicSpring : NoPairHistory, NoPairOutputs, NoConnectorForms {
//     struct Parameters { double stiffness = 0, damping = 0; };  // for items, generated from the spec
//     using Port = PointPort;
//
//     template <class S>
//     static std::array<Force<S>, 2> forces(const Parameters& p, const Context&, const PointFrame<S>& m0, const PointFrame<S>& m1) {
//       const Vec3<S> f = p.stiffness * (m1.position - m0.position) + p.damping * (m1.velocity - m0.velocity);
//       return {Force<S>{f}, Force<S>{-f}};
//     }
//   };
//
// Let the stiffness be 100 N/m and the damping 2 N s/m; marker 0 rests in the origin, marker 1 is a mass point at (0.1, 0, 0) m with the velocity
// (0, 3, 0) m/s. An evaluation then has three steps:
//
//   1. Each marker writes its frame into the ports (system/ports.hpp), once for all items that use it. For tangents it also writes the derivatives of the
//      frame, and the Jacobian J of its velocity by the rates of coordinates: J = I for marker 1.
//   2. Residual, S = double: the batch (batches/connector.hpp) calls `forces`, which returns (10, 6, 0) N and (-10, -6, 0) N, and adds them to the ports.
//      Markers add -J^T f to the residual r of M a + ... = 0: marker 1 adds (10, 6, 0).
//   3. Tangent, S = Dual (math/dual.hpp): the frames carry derivatives along the unknowns, the forces come out with df, and the matrix gets -J^T df:
//      100 I in the rows and columns of marker 1 for derivatives by positions, 2 I for those by velocities.
//
// A connector states `forces`. Memory, such as the anchor of friction, is in the data coordinates of its node: `forces` reads them in c.data, and
// `update` writes them, after Newton's method has converged (contracts/switches.hpp: or `switch_over`, at events). A constraint states its number of `equations` and the `gap` g = 0 (or `gap_rate`, if it is
// nonholonomic); dual numbers give G = dg/d(frames) and the forces -G^T lambda of its multipliers (contracts/variation.hpp). A load states `force`.
//
// No member is optional. A kernel derives from one of the structs below for each missing part of the contract: a member that is missing,
// misspelt or has another signature does not compile. Closed forms of derivatives may be left out, for sweeps of dual numbers find the same numbers; a
// kernel names those that it has in `closed_forms`, and must have those that it names.
#pragma once

#include <array>
#include <concepts>
#include <vector>

#include "dalembert/contracts/context.hpp"
#include "dalembert/contracts/joint_equations.hpp"
#include "dalembert/contracts/linear_equations.hpp"
#include "dalembert/contracts/span_forces.hpp"
#include "dalembert/contracts/switches.hpp"
#include "dalembert/contracts/variation.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

// ---- connectors ---------------------------------------------------------------------------------------------------------
constexpr int any_data_coordinates = -1;  // number of data coordinates of the item's node

struct NoPairHistory : NoSwitches {
  static constexpr bool has_history = false;
  static constexpr int data_coordinates = 0;
  static bool needs_data(const auto&) { return false; }
  static PostNewton update(const auto&, const Context&, const auto&, const auto&, const double*, double*) { return {}; }
};
struct HasPairHistory {
  static constexpr bool has_history = true;
};
struct AlwaysNeedsData {
  static bool needs_data(const auto&) { return true; }
};
struct NoPairOutputs {
  static bool output(const auto&, const Context&, const auto&, const auto&, OutputVariableType, std::vector<double>&) {
    return false;
  }
};

struct ConnectorForms {
  bool tangent = false;  // contracts/span_forces.hpp
  bool law = false;  // likewise
};
struct NoConnectorForms {
  static constexpr ConnectorForms closed_forms{};
};

template <class K>
concept PairConnectorKernel = requires(
    const typename K::Parameters& p, const Context& c, const typename K::Port::template Frame<double>& m,
    const double* start, double* data, Switches& switches, OutputVariableType variable, std::vector<double>& values) {
  { K::template forces<double>(p, c, m, m) } -> std::same_as<std::array<typename K::Port::template Force<double>, 2>>;
  requires std::same_as<decltype(K::has_history), const bool>;
  requires std::same_as<decltype(K::data_coordinates), const int>;
  { K::needs_data(p) } -> std::same_as<bool>;  // or it does without its node
  {
    K::update(p, c, m, m, start, data)
  } -> std::same_as<PostNewton>;  // data after Newton's method, from those at the start of the step
  requires std::same_as<decltype(K::has_switches), const bool>;
  requires K::has_switches == requires {
    { K::switch_count(p) } -> std::same_as<int>;
    { K::find_switches(p, c, m, m, switches) } -> std::same_as<void>;  // so many
  };
  requires K::switches_by_update != requires {
    { K::switch_over(p, c, m, m, start, data) } -> std::same_as<void>;
  };
  requires K::settles == requires {
    { K::settle(p, c, m, m, start, data) } -> std::same_as<PostNewton>;
  };
  { K::output(p, c, m, m, variable, values) } -> std::same_as<bool>;
  requires std::same_as<decltype(K::closed_forms), const ConnectorForms>;
  requires K::closed_forms.tangent == SpanConnector<K>;
  requires K::closed_forms.law == SpanLawConnector<K>;
};

// ---- constraints --------------------------------------------------------------------------------------------------------
struct ConstrainsAll {
  static bool constrains(const auto&, int) { return true; }
};
struct Holonomic {
  static constexpr bool nonholonomic = false;
};
struct VaryingDirections {
  static constexpr bool fixed_directions = false;
};
struct NoConstraintOutputs {
  static bool output(const auto&, const Context&, const auto&, const auto&, const auto&, OutputVariableType,
                     std::vector<double>&) {
    return false;
  }
};

struct ConstraintForms {
  bool gap_rate = false;  // of a constraint with a gap
  bool reaction = false;
  bool table = false;  // contracts/joint_equations.hpp
  bool linear = false;  // contracts/linear_equations.hpp
};
struct NoConstraintForms {
  static constexpr ConstraintForms closed_forms{};
};

template <class K>
concept PairConstraintKernel =
    requires(const typename K::Parameters& p, const Context& c, const typename K::Port::template Frame<double>& m,
             const Vec<double, K::equations>& lambda, OutputVariableType variable, std::vector<double>& values) {
      { K::constrains(p, 0) } -> std::same_as<bool>;  // equation k
      requires std::same_as<decltype(K::nonholonomic), const bool>;
      requires std::same_as<decltype(K::fixed_directions), const bool>;  // translations do not vary the reaction
      { K::output(p, c, m, m, lambda, variable, values) } -> std::same_as<bool>;
      requires std::same_as<decltype(K::closed_forms), const ConstraintForms>;
      requires(K::closed_forms.gap_rate || K::nonholonomic) == StatesGapRate<K>;
      requires(K::closed_forms.reaction || K::nonholonomic) == StatesReaction<K>;
      requires K::closed_forms.table == TabulatedJoint<K>;
      requires K::closed_forms.linear == LinearConstraint<K>;
    };

// ---- loads --------------------------------------------------------------------------------------------------------------
// The force is the same wherever the marker is: it has no tangent.
struct ReadsNoMarker {
  static constexpr bool is_constant = true;
  static bool reads_marker(const auto&) { return false; }
};
struct ReadsMarker {
  static constexpr bool is_constant = false;
  static bool reads_marker(const auto&) { return true; }
};
// No variant of the kernel for a vector that turns with the marker, which asks more of it.
struct NoFollower {
  using BodyFixed = void;
};

template <class K>
concept ForceOnMarker =
    requires(const typename K::Parameters& p, const Context& c, const typename K::Port::template Frame<double>& m) {
      { K::template force<double>(p, c, m) } -> std::same_as<typename K::Port::template Force<double>>;
      requires std::same_as<decltype(K::is_constant), const bool>;
      { K::reads_marker(p) } -> std::same_as<bool>;
    };
template <class B>
concept FollowerKernel = std::is_void_v<B> || (ForceOnMarker<B> && requires(const typename B::Parameters& p) {
                           { B::applies(p) } -> std::same_as<bool>;
                         });
template <class K>
concept LoadKernel = ForceOnMarker<K> && FollowerKernel<typename K::BodyFixed> &&
                     requires(const typename K::Parameters& p, const Context& c) {
                       K::value(p, c).x;  // the numbers of the load at a time
                     };

}  // namespace dalembert
