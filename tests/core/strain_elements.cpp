// Elements with quadrature: the pull-back of every family is the transposed derivative of its strains, and tangents are the
// automatic derivatives of residuals.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "dalembert/batches/strain_element.hpp"
#include "dalembert/items/finite_elements/ancf_beam.hpp"
#include "dalembert/items/finite_elements/ancf_cable.hpp"
#include "dalembert/items/finite_elements/ancf_cable_2d.hpp"
#include "dalembert/items/finite_elements/ancf_thin_plate.hpp"
#include "dalembert/items/finite_elements/beam_geometrically_exact.hpp"
#include "dalembert/items/finite_elements/beam_geometrically_exact_2d.hpp"
#include "dalembert/items/nodes/rigid_body_rot_vec_lg.hpp"

using namespace dalembert;

namespace {

using Beam = ObjectBeamGeometricallyExact::On<NodeRigidBodyRotVecLG>;
int failures = 0;

void expect_small(double difference, const char* what, const char* element, int variant) {
  if (difference < 1e-11) return;
  std::printf("%s of %s, variant %d: %g\n", what, element, variant, difference);
  ++failures;
}

// Anything, and always the same.
double number(int i, double scale) { return scale * std::sin(1.7 * i * i + 0.3 * i + 0.4); }
template <int N>
Vec<double, N> numbers(int first, double scale) {
  return vector_of<N>([&](int i) { return number(first + i, scale); });
}

// A law that depends on all strains and rates.
class Law final : public Callback {
 public:
  void call(double, int, std::span<const Argument> arguments, std::span<double> results) const override {
    double sum = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) sum += static_cast<double>(i + 1) * std::sin(*arguments[i].data);
    results[0] = sum;
  }
  std::vector<double> call_any(double, int, std::span<const Argument>) const override { return {}; }
};

// Variants: rules of integration, damping, user functions.
template <class P>
P cable(int variant) {
  P p;
  p.physicsLength = 0.7;
  p.physicsMassPerLength = 2;
  p.physicsBendingStiffness = 3;
  p.physicsAxialStiffness = 1e4;
  p.physicsBendingDamping = variant & 1 ? 0.4 : 0;
  p.physicsAxialDamping = variant & 1 ? 5 : 0;
  p.physicsReferenceAxialStrain = 0.05;
  p.strainIsRelativeToReference = 0.5;
  p.useReducedOrderIntegration = variant / 4;
  if constexpr (requires { p.axialForceUserFunction; })
    if (variant & 2) p.axialForceUserFunction = p.bendingMomentUserFunction = UserFunction{std::make_shared<Law>()};
  return p;
}
template <class E>
typename E::Parameters parameters(int variant) {
  return cable<typename E::Parameters>(variant);
}
template <class P>
P beam(int variant) {
  P p;
  p.physicsLength = 0.7;
  p.sectionData.massPerLength = 2;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      p.sectionData.stiffnessMatrix(i, j) = (i == j ? 10 + i : 0) + number(i + j, 1);
      p.sectionData.dampingMatrix(i, j) = variant & 1 ? (i == j ? 1 : 0) + number(i + j, 0.1) : 0;
    }
  for (int i = 0; i < 3; ++i) p.sectionData.inertia(i, i) = 1 + i;
  if constexpr (requires { p.crossSectionDamping; })
    p.crossSectionDamping = {0, 0.1 * (variant & 1), 0.2 * (variant & 1)};
  return p;
}
template <>
ObjectBeamGeometricallyExactParameters parameters<Beam>(int variant) {
  return beam<ObjectBeamGeometricallyExactParameters>(variant);
}
template <>
ObjectANCFBeamParameters parameters<ObjectANCFBeam>(int variant) {
  return beam<ObjectANCFBeamParameters>(variant);
}
// Sections normal to the axis or turned as the nodes are.
template <int nodes>
typename ObjectBeamGeometricallyExact2D::On<nodes>::Parameters planar(int variant) {
  typename ObjectBeamGeometricallyExact2D::On<nodes>::Parameters p;
  p.physicsLength = 0.7;
  p.physicsMassPerLength = 2;
  p.physicsCrossSectionInertia = 0.3;
  p.physicsBendingStiffness = 3;
  p.physicsAxialStiffness = 100;
  p.physicsShearStiffness = 50;
  p.physicsBendingDamping = p.physicsAxialDamping = p.physicsShearDamping = variant & 1 ? 0.4 : 0;
  p.includeReferenceRotations = variant & 2;
  for (int i = 0; i < nodes; ++i)
    p.reference[3 * i] = 0.7 * i / (nodes - 1), p.reference[3 * i + 1] = 0.1 * i * i, p.reference[3 * i + 2] = 0.2 * i;
  return p;
}
template <>
ObjectBeamGeometricallyExact2D::On<2>::Parameters parameters<ObjectBeamGeometricallyExact2D::On<2>>(int variant) {
  return planar<2>(variant);
}
template <>
ObjectBeamGeometricallyExact2D::On<3>::Parameters parameters<ObjectBeamGeometricallyExact2D::On<3>>(int variant) {
  return planar<3>(variant);
}
// A quadrangle that is no rectangle, and not flat.
constexpr Vec<double, 36> plate_reference{0, 0, 0,   1, 0, 0.1, 0,   1, 0, 0.9,  0.1, 0,   1, 0.1, 0, 0, 1, 0.1,
                                          1, 1, 0.1, 1, 0, 0,   0.1, 1, 0, -0.1, 0.9, 0.1, 1, 0,   0, 0, 1, 0};
template <>
ObjectANCFThinPlate::Parameters parameters<ObjectANCFThinPlate>(int variant) {
  ObjectANCFThinPlate::Parameters p;
  p.physicsThickness = {0.1};
  p.physicsDensity = 5;
  p.physicsMassProportionalDamping = variant & 1 ? 0.3 : 0;
  p.useReducedOrderIntegration = variant / 2;
  p.physicsStrainCoefficients = {Mat3<double>{20, 5, 0, 5, 30, 1, 0, 1, 10}};
  for (int i = 0; i < 4; ++i)
    p.physicsCurvatureCoefficients.push_back(Mat3<double>{2. + i, 0.5, 0, 0.5, 3, 0.1, 0, 0.1, 1});
  p.reference = plate_reference;
  return p;
}

template <class E>
void check_tangent(const char* name, int variant, const Vec<double, E::Map::size>& reference) {
  using Element = StrainElement<E>;
  constexpr int n = Element::size;
  const auto p = parameters<E>(variant);
  const auto k = Element::prepare(p, reference);
  Coordinates<double, n> x{.q = numbers<n>(1, 0.3), .v = numbers<n>(50, 3), .a = numbers<n>(90, 2)};
  x.q += reference;
  const Weights w{.q = 0.3, .v = 2.1, .a = 7};
  const auto tangent = Element::tangent(p, k, {}, x, w);
  const auto moving = Element::template residual<Dual<n>>(p, k, {}, seeded<Element>(x, w));
  double difference = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      difference = std::max(difference, std::abs(tangent(i, j) - moving[i].d[j]) / (1 + std::abs(tangent(i, j))));
  expect_small(difference, "tangent", name, variant);
}

// stress . d(strain) = pull_back(stress) . d(fields), direction by direction.
template <class E, class F>
void check_family(const char* name, int number_of_family) {
  constexpr int D = E::Map::dimension;
  const auto k = E::constants(parameters<E>(0));
  Vectors<double, D, F::fields> fields;
  for (int f = 0; f < F::fields; ++f) fields[f] = numbers<D>(10 * f + 3, 1.1);
  const auto stress = numbers<F::stresses>(70, 2);
  const auto force = F::pull_back(k, fields, stress);
  const auto strain = F::strain(k, moving_from<D * F::fields>(0, fields, 1));
  double difference = 0;
  for (int i = 0; i < D * F::fields; ++i) {
    double work = 0;
    for (int s = 0; s < F::stresses; ++s) work += stress[s] * strain[s].d[i];
    difference = std::max(difference, std::abs(work - force[i / D][i % D]) / (1 + std::abs(work)));
  }
  expect_small(difference, "pull-back", name, number_of_family);
}
template <class E, class... F>
void check_families(const char* name, std::tuple<F...>) {
  int number_of_family = 0;
  (check_family<E, F>(name, number_of_family++), ...);
}

template <class E>
void check(const char* name, int variants, const Vec<double, E::Map::size>& reference) {
  for (int variant = 0; variant < variants; ++variant) check_tangent<E>(name, variant, reference);
  check_families<E>(name, typename E::Families{});
  check_families<E>(name, typename E::CallingFamilies{});
}

}  // namespace

int main() {
  check<ObjectANCFCable2D>("ObjectANCFCable2D", 12, {0, 0, 1, 0.1, 0.7, 0.05, 0.9, -0.2});
  check<ObjectANCFCable>("ObjectANCFCable", 12, {0, 0, 0, 1, 0.1, -0.1, 0.7, 0.05, 0.1, 0.9, -0.2, 0.3});
  check<Beam>("ObjectBeamGeometricallyExact", 2, {0, 0, 0, 0.1, 0.2, 0.3, 0.7, 0, 0, 0.2, 0.1, -0.4});
  check<ObjectANCFBeam>("ObjectANCFBeam", 2, {0, 0, 0, 0, 1, 0.1, 0, 0, 1, 0.7, 0.05, 0, -0.1, 1, 0, 0.1, 0, 0.9});
  check<ObjectBeamGeometricallyExact2D::On<2>>("ObjectBeamGeometricallyExact2D, two nodes", 4, planar<2>(0).reference);
  check<ObjectBeamGeometricallyExact2D::On<3>>("ObjectBeamGeometricallyExact2D, three nodes", 4,
                                               planar<3>(0).reference);
  check<ObjectANCFThinPlate>("ObjectANCFThinPlate", 4, plate_reference);
  return failures;
}
