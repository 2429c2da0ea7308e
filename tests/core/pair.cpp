// Kernels between two markers, and loads, are refused when a member is missing, misspelt or has another signature.
#include "dalembert/contracts/pair.hpp"

using namespace dalembert;

namespace {

struct Parameters {};

// ---- connectors ---------------------------------------------------------------------------------------------------------
struct Spring {
  using Parameters = ::Parameters;
  using Port = PointPort;
  template <class S>
  static std::array<Force<S>, 2> forces(const Parameters&, const Context&, const PointFrame<S>&, const PointFrame<S>&) {
    return {};
  }
};
struct CompleteSpring : Spring, NoPairHistory, NoPairOutputs, NoConnectorForms {};
static_assert(PairConnectorKernel<CompleteSpring>);
static_assert(!PairConnectorKernel<Spring>);

struct WithTangent : Spring, NoPairHistory, NoPairOutputs {
  static constexpr ConnectorForms closed_forms{.tangent = true};
  static bool has_tangent(const Parameters&) { return true; }
};
struct MisspeltTangent : WithTangent {
  static SpanTangent<3> tangents(const Parameters&, const PointFrame<double>&, const PointFrame<double>&) { return {}; }
};
struct CompleteTangent : WithTangent {
  static SpanTangent<3> tangent(const Parameters&, const PointFrame<double>&, const PointFrame<double>&) { return {}; }
};
struct TangentNotNamed : CompleteTangent {
  static constexpr ConnectorForms closed_forms{};
};
static_assert(PairConnectorKernel<CompleteTangent>);
static_assert(!PairConnectorKernel<MisspeltTangent>);
static_assert(!PairConnectorKernel<TangentNotNamed>);

struct WithHistory : Spring, HasPairHistory, NoSwitches, AlwaysNeedsData, NoPairOutputs, NoConnectorForms {
  static constexpr int data_coordinates = 1;
};
struct MisspeltHistory : WithHistory {
  static PostNewton updates(const Parameters&, const Context&, const PointFrame<double>&, const PointFrame<double>&, const double*, double*) {
    return {};
  }
};
struct CompleteHistory : WithHistory {
  static PostNewton update(const Parameters&, const Context&, const PointFrame<double>&, const PointFrame<double>&, const double*, double*) {
    return {};
  }
};
static_assert(PairConnectorKernel<CompleteHistory>);
static_assert(!PairConnectorKernel<MisspeltHistory>);

struct WithSwitches : CompleteHistory, SwitchesByUpdate {
  static constexpr bool has_switches = SwitchesByUpdate::has_switches, switches_by_update = SwitchesByUpdate::switches_by_update,
                        settles = SwitchesByUpdate::settles;
  static int switch_count(const Parameters&) { return 0; }
};
struct CompleteSwitches : WithSwitches {
  static void find_switches(const Parameters&, const Context&, const PointFrame<double>&, const PointFrame<double>&, Switches&) {}
};
struct MissesSettle : CompleteSwitches {
  static constexpr bool settles = true;
};
struct MissesSwitchOver : CompleteSwitches {
  static constexpr bool switches_by_update = false;
};
static_assert(PairConnectorKernel<CompleteSwitches>);
static_assert(!PairConnectorKernel<WithSwitches>);
static_assert(!PairConnectorKernel<MissesSettle>);
static_assert(!PairConnectorKernel<MissesSwitchOver>);

struct OneForceOnly : NoPairHistory, NoPairOutputs, NoConnectorForms {
  using Parameters = ::Parameters;
  using Port = PointPort;
  template <class S>
  static Force<S> forces(const Parameters&, const Context&, const PointFrame<S>&, const PointFrame<S>&) {
    return {};
  }
};
static_assert(!PairConnectorKernel<OneForceOnly>);

// ---- constraints --------------------------------------------------------------------------------------------------------
struct Joint : Holonomic, VaryingDirections, NoConstraintOutputs {
  using Parameters = ::Parameters;
  using Port = PointPort;
  static constexpr int equations = 1;
};
struct CompleteJoint : Joint, NoConstraintForms {
  static bool constrains(const Parameters&, int) { return true; }
};
struct MisspeltAxes : Joint, NoConstraintForms {
  static bool constrians(const Parameters&, int) { return true; }
};
struct AxesOfAnotherType : Joint, NoConstraintForms {
  static void constrains(const Parameters&, int) {}
};
static_assert(PairConstraintKernel<CompleteJoint>);
static_assert(!PairConstraintKernel<MisspeltAxes>);
static_assert(!PairConstraintKernel<AxesOfAnotherType>);

template <class Reaction>
struct WithReaction : CompleteJoint, Reaction {
  static constexpr ConstraintForms closed_forms{.reaction = true};
};
struct Misspelt {
  template <class S>
  static std::array<Force<S>, 2> reactions(const Parameters&, const Context&, const PointFrame<S>&, const PointFrame<S>&, const auto&) {
    return {};
  }
};
struct Stated {
  template <class S>
  static std::array<Force<S>, 2> reaction(const Parameters&, const Context&, const PointFrame<S>&, const PointFrame<S>&, const auto&) {
    return {};
  }
};
struct NotNamed : WithReaction<Stated> {
  static constexpr ConstraintForms closed_forms{};
};
static_assert(PairConstraintKernel<WithReaction<Stated>>);
static_assert(!PairConstraintKernel<WithReaction<Misspelt>>);
static_assert(!PairConstraintKernel<NotNamed>);

// ---- loads --------------------------------------------------------------------------------------------------------------
struct Weight {
  using Parameters = ::Parameters;
  using Port = PointPort;
  template <class S>
  static Force<S> force(const Parameters&, const Context&, const PointFrame<S>&) {
    return {};
  }
  static Vec3<double> value(const Parameters&, const Context&) { return {}; }
};
struct CompleteWeight : Weight, ReadsNoMarker, NoFollower {};
struct WithoutFollower : Weight, ReadsNoMarker {};
struct WithoutReading : Weight, NoFollower {};
static_assert(LoadKernel<CompleteWeight>);
static_assert(!LoadKernel<WithoutFollower>);
static_assert(!LoadKernel<WithoutReading>);

}  // namespace

int main() { return 0; }
