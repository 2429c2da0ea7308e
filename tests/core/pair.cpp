// Kernels between two markers, and loads, are refused when a member is missing, misspelt or has another signature. The example of
// contracts/pair.hpp has the forces and derivatives of its comments.
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
  static PostNewton updates(const Parameters&, const Context&, const PointFrame<double>&, const PointFrame<double>&,
                            const double*, double*) {
    return {};
  }
};
struct CompleteHistory : WithHistory {
  static PostNewton update(const Parameters&, const Context&, const PointFrame<double>&, const PointFrame<double>&,
                           const double*, double*) {
    return {};
  }
};
static_assert(PairConnectorKernel<CompleteHistory>);
static_assert(!PairConnectorKernel<MisspeltHistory>);

struct WithSwitches : CompleteHistory, SwitchesByUpdate {
  static constexpr bool has_switches = SwitchesByUpdate::has_switches,
                        switches_by_update = SwitchesByUpdate::switches_by_update, settles = SwitchesByUpdate::settles;
  static int switch_count(const Parameters&) { return 0; }
};
struct CompleteSwitches : WithSwitches {
  static void find_switches(const Parameters&, const Context&, const PointFrame<double>&, const PointFrame<double>&,
                            Switches&) {}
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
  static std::array<Force<S>, 2> reactions(const Parameters&, const Context&, const PointFrame<S>&,
                                           const PointFrame<S>&, const auto&) {
    return {};
  }
};
struct Stated {
  template <class S>
  static std::array<Force<S>, 2> reaction(const Parameters&, const Context&, const PointFrame<S>&, const PointFrame<S>&,
                                          const auto&) {
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

// ---- the example --------------------------------------------------------------------------------------------------------
struct IsotropicSpring : NoPairHistory, NoPairOutputs, NoConnectorForms {
  struct Parameters {
    double stiffness = 0, damping = 0;
  };
  using Port = PointPort;

  template <class S>
  static std::array<Force<S>, 2> forces(const Parameters& p, const Context&, const PointFrame<S>& m0,
                                        const PointFrame<S>& m1) {
    const Vec3<S> f = p.stiffness * (m1.position - m0.position) + p.damping * (m1.velocity - m0.velocity);
    return {Force<S>{f}, Force<S>{-f}};
  }
};
static_assert(PairConnectorKernel<IsotropicSpring>);

// Derivatives by the three positions of marker 1, and by its three velocities.
int example() {
  using S = Dual<6>;
  const Vec3<double> position{0.1, 0, 0}, velocity{0, 3, 0}, expected{10, 6, 0};
  PointFrame<S> m0, m1;
  for (int i = 0; i < 3; ++i) m1.position[i] = S::seed(position[i], i), m1.velocity[i] = S::seed(velocity[i], 3 + i);
  const auto forces = IsotropicSpring::forces<S>({100, 2}, Context(), m0, m1);
  int failures = 0;
  for (int i = 0; i < 3; ++i) {
    failures += forces[0].force[i].value != expected[i] || forces[1].force[i].value != -expected[i];
    for (int j = 0; j < 3; ++j)  // -df_1
      failures += -forces[1].force[i].d[j] != (i == j ? 100 : 0) || -forces[1].force[i].d[3 + j] != (i == j ? 2 : 0);
  }
  return failures;
}

}  // namespace

int main() { return example(); }
