// Nodes, bodies, elements and sensors are refused when a member is missing, misspelt or has another signature, closed forms among them.
#include "dalembert/contracts/element.hpp"
#include "dalembert/contracts/sensor.hpp"

using namespace dalembert;

namespace {

struct Parameters {};

// ---- nodes --------------------------------------------------------------------------------------------------------------
struct Point {
  using Parameters = ::Parameters;
  static constexpr std::string_view item = "Point";
  static constexpr int size = 3;
  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    return {.position = x.q, .velocity = x.v, .acceleration = x.a};
  }
  template <class S>
  static Vec<S, size> pull_back(const Coordinates<S, size>&, const Vec3<S>& force, const Vec3<S>&) {
    return force;
  }
};
struct PlainTraits {
  static constexpr NodeTraits traits{.translations = 3, .constant_jacobian = true};
};
struct CompletePoint : Point, PlainTraits, NoCheck, NoNodeOutputs {};
static_assert(NodeKernel<CompletePoint>);
struct PointWithoutTraits : Point, NoCheck, NoNodeOutputs {};
static_assert(!NodeKernel<PointWithoutTraits>);

struct MisspeltCheck : Point, PlainTraits, NoNodeOutputs {
  static void chek(const Parameters&, const ItemLabel&) {}
};
static_assert(!NodeKernel<MisspeltCheck>);
struct OutputsOfAnotherType : Point, PlainTraits, NoCheck {
  static void output(OutputVariableType, const NodeView&, std::vector<double>&) {}
};
static_assert(!NodeKernel<OutputsOfAnotherType>);

struct Turning : Point, NoCheck, NoNodeOutputs {
  static constexpr NodeTraits traits{.translations = 3, .rotation_alone = true};
};
struct RotationMisspelt : Turning {
  template <class S>
  static Mat3<S> rotatoin(const Coordinates<S, size>&) {
    return identity<S>();
  }
};
struct RotationThere : Turning {
  template <class S>
  static Mat3<S> rotation(const Coordinates<S, size>&) {
    return identity<S>();
  }
};
struct RotationNotNamed : RotationThere {
  static constexpr NodeTraits traits{.translations = 3};
};
static_assert(NodeKernel<RotationThere>);
static_assert(!NodeKernel<RotationMisspelt>);
static_assert(!NodeKernel<RotationNotNamed>);
struct TangentNotThere : Point, NoCheck, NoNodeOutputs {
  static constexpr NodeTraits traits{.translations = 3, .rotation_tangent = true};
};
static_assert(!NodeKernel<TangentNotThere>);

// ---- bodies -------------------------------------------------------------------------------------------------------------
struct Mass {
  using Parameters = ::Parameters;
  static constexpr BodyTraits traits{.constant_mass = true, .pure_inertia = true};
  template <class S>
  static Wrench<S> residual(const Parameters&, const Context&, const Motion<S>& node) {
    return {.force = node.acceleration};
  }
  template <class S>
  static Wrench<S> mass_load(const Parameters&, const Motion<S>&, const Vec3<S>& g) {
    return {.force = g};
  }
};
struct CompleteMass : Mass, NoCheck, NoDoubt, NoElementOutputs {};
static_assert(BodyKernel<CompleteMass>);
static_assert(OutputsOf<CompleteMass, 3>);
static_assert(!OutputsOf<Mass, 3>);
static_assert(!BodyKernel<Mass>);
struct MisspeltDoubt : Mass, NoCheck, NoElementOutputs {
  static std::string doubts(const Parameters&) { return {}; }
};
static_assert(!BodyKernel<MisspeltDoubt>);
struct FactsOfAnElement : CompleteMass {
  static constexpr ElementTraits traits{};
};
static_assert(!BodyKernel<FactsOfAnElement>);

// ---- elements -----------------------------------------------------------------------------------------------------------
static_assert(ElementKernel<OnNode<CompleteMass, CompletePoint>>);
static_assert(OnNode<CompleteMass, CompletePoint>::traits.diagonal);

struct Rod : OnNode<CompleteMass, CompletePoint> {};
struct RodWithTangent : Rod {
  static Mat<double, 3, 3> tangent(const Parameters&, const NothingPrepared&, const Context&,
                                   const Coordinates<double, 3>&, const Weights&) {
    return {};
  }
};
struct RodThatSaysSo : RodWithTangent {
  static constexpr ElementTraits traits{.tangent = true};
};
struct RodThatOnlySaysSo : Rod {
  static constexpr ElementTraits traits{.tangent = true};
};
static_assert(!ElementKernel<RodWithTangent>);
static_assert(ElementKernel<RodThatSaysSo>);
static_assert(!ElementKernel<RodThatOnlySaysSo>);

// ---- sensors ------------------------------------------------------------------------------------------------------------
struct Gauge {
  using Parameters = ::Parameters;
  static void measure(System&, const Parameters&, int, ConfigurationType, std::vector<double>&) {}
};
struct CompleteGauge : Gauge, NoSubject {};
static_assert(SensorKernel<CompleteGauge>);
static_assert(!SensorKernel<Gauge>);

}  // namespace

int main() { return 0; }
