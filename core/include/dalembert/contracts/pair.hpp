// Items between two markers of one shape, and loads on one: their frames come in, forces on them go out.
//
//   marker 0 ──frame──▶ ┌────────┐ ──force──▶ marker 0
//   marker 1 ──frame──▶ │ kernel │ ──force──▶ marker 1
//                       └────────┘
//
// A connector states `forces`, a constraint its `equations` and `gap` (or `gap_rate`, if it is nonholonomic), a load `force`.
// What a kernel does without, it says by deriving from one of the structs below: a member that is missing, misspelt or has
// another signature does not compile. Closed forms may be left out, for sweeps of dual numbers find the same numbers; those that a
// kernel has it names in `closed_forms`, and what is named has to be there.
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
constexpr int any_data_coordinates = -1;  // as many as the node of the item has

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
  static bool output(const auto&, const Context&, const auto&, const auto&, OutputVariableType, std::vector<double>&) { return false; }
};

struct ConnectorForms {
  bool tangent = false;  // contracts/span_forces.hpp
  bool law = false;      // likewise
};
struct NoConnectorForms {
  static constexpr ConnectorForms closed_forms{};
};

template <class K>
concept PairConnectorKernel = requires(const typename K::Parameters& p, const Context& c, const typename K::Port::template Frame<double>& m,
                                       const double* start, double* data, Switches& switches, OutputVariableType variable,
                                       std::vector<double>& values) {
  { K::template forces<double>(p, c, m, m) } -> std::same_as<std::array<typename K::Port::template Force<double>, 2>>;
  requires std::same_as<decltype(K::has_history), const bool>;
  requires std::same_as<decltype(K::data_coordinates), const int>;
  { K::needs_data(p) } -> std::same_as<bool>;  // or it does without its node
  { K::update(p, c, m, m, start, data) } -> std::same_as<PostNewton>;  // data after Newton's method, from those at the start of the step
  requires std::same_as<decltype(K::has_switches), const bool>;
  requires K::has_switches == requires {
    { K::switch_count(p) } -> std::same_as<int>;
    { K::find_switches(p, c, m, m, switches) } -> std::same_as<void>;  // so many
  };
  requires K::switches_by_update != requires { { K::switch_over(p, c, m, m, start, data) } -> std::same_as<void>; };
  requires K::settles == requires { { K::settle(p, c, m, m, start, data) } -> std::same_as<PostNewton>; };
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
  static bool output(const auto&, const Context&, const auto&, const auto&, const auto&, OutputVariableType, std::vector<double>&) {
    return false;
  }
};

struct ConstraintForms {
  bool gap_rate = false;  // of a constraint with a gap
  bool reaction = false;
  bool table = false;     // contracts/joint_equations.hpp
  bool linear = false;    // contracts/linear_equations.hpp
};
struct NoConstraintForms {
  static constexpr ConstraintForms closed_forms{};
};

template <class K>
concept PairConstraintKernel = requires(const typename K::Parameters& p, const Context& c, const typename K::Port::template Frame<double>& m,
                                        const Vec<double, K::equations>& lambda, OutputVariableType variable, std::vector<double>& values) {
  { K::constrains(p, 0) } -> std::same_as<bool>;  // equation k
  requires std::same_as<decltype(K::nonholonomic), const bool>;
  requires std::same_as<decltype(K::fixed_directions), const bool>;  // translations do not vary the reaction
  { K::output(p, c, m, m, lambda, variable, values) } -> std::same_as<bool>;
  requires std::same_as<decltype(K::closed_forms), const ConstraintForms>;
  requires (K::closed_forms.gap_rate || K::nonholonomic) == StatesGapRate<K>;
  requires (K::closed_forms.reaction || K::nonholonomic) == StatesReaction<K>;
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
concept ForceOnMarker = requires(const typename K::Parameters& p, const Context& c, const typename K::Port::template Frame<double>& m) {
  { K::template force<double>(p, c, m) } -> std::same_as<typename K::Port::template Force<double>>;
  requires std::same_as<decltype(K::is_constant), const bool>;
  { K::reads_marker(p) } -> std::same_as<bool>;
};
template <class B>
concept FollowerKernel = std::is_void_v<B> || (ForceOnMarker<B> && requires(const typename B::Parameters& p) {
  { B::applies(p) } -> std::same_as<bool>;
});
template <class K>
concept LoadKernel = ForceOnMarker<K> && FollowerKernel<typename K::BodyFixed> && requires(const typename K::Parameters& p, const Context& c) {
  K::value(p, c).x;  // the numbers of the load at a time
};

}  // namespace dalembert
