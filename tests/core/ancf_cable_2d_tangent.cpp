// The closed-form tangent of ObjectANCFCable2D is the automatic derivative of its residual.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "dalembert/batches/strain_element.hpp"
#include "dalembert/items/finite_elements/ancf_cable_2d.hpp"

using namespace dalembert;

namespace {

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

ObjectANCFCable2DParameters cable(int rule, bool damped, bool user) {
  ObjectANCFCable2DParameters p;
  p.physicsLength = 0.7;
  p.physicsMassPerLength = 2;
  p.physicsBendingStiffness = 3;
  p.physicsAxialStiffness = 1e4;
  p.physicsBendingDamping = damped ? 0.4 : 0;
  p.physicsAxialDamping = damped ? 5 : 0;
  p.physicsReferenceCurvature = 0.2;
  p.strainIsRelativeToReference = 0.5;
  p.useReducedOrderIntegration = rule;
  if (user) p.axialForceUserFunction = p.bendingMomentUserFunction = UserFunction{std::make_shared<Law>()};
  return p;
}

double largest_difference(const ObjectANCFCable2DParameters& p) {
  using E = StrainElement<ObjectANCFCable2D>;
  const auto k = E::prepare(p, {0, 0, 1, 0.1, 0.7, 0.05, 0.9, -0.2});
  Coordinates<double, 8> x;
  x.q = {0.1, 0.2, 0.8, 0.3, 0.6, 0.5, 0.7, 0.6};
  x.v = {1, 2, 3, -4, 5, -1, 2, 0.5};
  x.a = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
  const Weights w{.q = 0.3, .v = 2.1, .a = 7};
  const auto tangent = E::tangent(p, k, {}, x, w);
  const auto moving = E::residual<Dual<8>>(p, k, {}, seeded<E>(x, w));
  double difference = 0;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      difference = std::max(difference, std::abs(tangent(i, j) - moving[i].d[j]) / (1 + std::abs(tangent(i, j))));
  return difference;
}

}  // namespace

int main() {
  int failures = 0;
  for (int rule = 0; rule < 3; ++rule)
    for (const bool damped : {false, true})
      for (const bool user : {false, true}) {
        const double difference = largest_difference(cable(rule, damped, user));
        if (difference < 1e-11) continue;
        std::printf("rule %d, damped %d, user %d: %g\n", rule, damped, user, difference);
        ++failures;
      }
  return failures;
}
