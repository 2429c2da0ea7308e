// Contact of circles with planar cables.
#include "dalembert/contact/general_contact.hpp"

#include <algorithm>
#include <cmath>

#include "dalembert/finite_elements/ancf_cable_2d_parameters.hpp"
#include "dalembert/model/model.hpp"
#include "dalembert/system/system.hpp"
#include "meetings.hpp"

namespace dalembert {

void GeneralContact::enter(const System& system, const Model& model) {
  system_ = &system;
  for (const ContactCable& cable : set_->cables) {
    CableShape shape;
    std::ranges::copy(system.object_ltg(cable.object, System::Coordinates::ode2), shape.dofs.begin());
    shape.length = model.item(ItemKind::object, cable.object).as<ObjectANCFCable2DRecord>().parameters.physicsLength;
    cables_.push_back(shape);
  }
}

// Includes the bounding box: a cubic lies within its control points.
void GeneralContact::take_cables(const double* q, const double* v) const {
  cables_now_.resize(cables_.size());
  for (std::size_t c = 0; c < cables_.size(); ++c) {
    CableNow& now = cables_now_[c];
    now.q = cables_[c].numbers(q);
    now.v = cables_[c].numbers(v);
    const double third = cables_[c].length / 3, half = set_->cables[c].half_height;
    now.box = {};
    for (const auto& [end, side] : {std::pair<std::size_t, double>{0, 0}, {0, third}, {4, 0}, {4, -third}}) {
      const double x = now.q[end] + side * now.q[end + 2], y = now.q[end + 1] + side * now.q[end + 3];
      now.box.add({x - half, y - half, -half});
      now.box.add({x + half, y + half, half});
    }
  }
}

// Called for queries between evaluations.
void GeneralContact::take_cables_of_system(ConfigurationType configuration) const {
  if (cables_.empty()) return;
  const State& now = system_->state(configuration);
  std::vector<double> q = system_->state(ConfigurationType::Reference).q;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] += now.q[i];
  take_cables(q.data(), now.v.data());
}

void GeneralContact::find_cable_touches(std::vector<HeldContact>& found) const {
  found.clear();
  each_cable_near(0, [&](int i, int c) {
    const SphereAt& s = pairs_.at[static_cast<std::size_t>(i)];
    const auto number = static_cast<std::size_t>(c);
    std::array<Stretch1D, 4> stretches;
    const int n = stretches_within(cables_[number], cables_now_[number].q, {s.x, s.y},
                                   s.radius + set_->cables[number].half_height, stretches);
    for (int k = 0; k < n; ++k)
      found.push_back({i, set_->first_cable() + c, true, stretches[static_cast<std::size_t>(k)]});
  });
}

ContactPairing GeneralContact::cable_pairing(const HeldContact& c) const {
  return set_->pairing(sphere(c.sphere).surface,
                       set_->cables[static_cast<std::size_t>(c.other - set_->first_cable())].surface);
}

namespace {

// Current end of an interval that was found in another state, by Newton's method, with its derivative with respect to
// the coordinates. Ends of the element do not move, nor does an end that the circle has left.
template <class S>
S end_now(const CableShape& cable, double x, bool is_begin, const std::array<S, 8>& q, const Vec<S, 2>& centre,
          double reach) {
  constexpr int most_iterations = 12;
  constexpr double settled = 1e-13;
  if (x == (is_begin ? 0 : cable.length)) return S(x);
  std::array<double, 8> places{};
  for (std::size_t i = 0; i < 8; ++i) places[i] = value_of(q[i]);
  double growth = 0;  // derivative of the squared distance along the cable
  for (int i = 0; i < most_iterations; ++i) {
    const Vec<double, 2> place = cable.at(cable.weights(x), places), slope = cable.at(cable.slope_weights(x), places);
    const double dx = place[0] - value_of(centre[0]), dy = place[1] - value_of(centre[1]);
    growth = 2 * (dx * slope[0] + dy * slope[1]);
    if (!(is_begin ? growth < 0 : growth > 0)) return S(x);
    const double moved = (dx * dx + dy * dy - reach * reach) / growth;
    x -= moved;
    if (!(x > 0 && x < cable.length)) return S(is_begin ? 0 : cable.length);
    if (std::abs(moved) <= settled * cable.length) break;
  }
  const Vec<S, 2> place = cable.at(cable.weights(x), q);
  const S dx = place[0] - centre[0], dy = place[1] - centre[1];
  return S(x) - (1 / growth) * (dx * dx + dy * dy - reach * reach);
}

}  // namespace

// Forces per length at both ends and in the middle of the stretch, by the rule of Simpson; they act at the axis of the cable.
template <class S>
GeneralContact::CableForces<S> GeneralContact::cable_forces(const HeldContact& c, const RigidFrame<S>& circle,
                                                            const std::array<S, 8>& q, const std::array<S, 8>& v,
                                                            std::optional<bool> sticks) const {
  const auto number = static_cast<std::size_t>(c.other - set_->first_cable());
  const CableShape& cable = cables_[number];
  const ContactPairing pairing = cable_pairing(c);
  const double reach = sphere(c.sphere).radius + set_->cables[number].half_height;
  CableForces<S> result;
  const Vec<S, 2> centre{circle.position[0], circle.position[1]};
  const S begin = end_now(cable, c.along.begin, true, q, centre, reach),
          length = end_now(cable, c.along.end, false, q, centre, reach) - begin;
  if (!(value_of(length) > 0)) return result;
  for (int k = 0; k < 3; ++k) {
    const S x = begin + (0.5 * k) * length, share = ((k == 1 ? 4 : 1) / 6.0) * length;
    const std::array<S, 4> weights = cable.weights(x);
    const Vec<S, 2> place = cable.at(weights, q), rate = cable.at(weights, v);
    Meeting<S> at;
    at.arm0 = {place[0] - circle.position[0], place[1] - circle.position[1], S(0)};
    const S distance = norm(at.arm0);
    if (value_of(distance) == 0) continue;
    at.normal = (1.0 / distance) * at.arm0;
    at.gap = distance - reach;
    const Vec3<S> planar{circle.velocity[0], circle.velocity[1], S(0)};
    const Vec3<S> velocity =
        Vec3<S>{rate[0], rate[1], S(0)} - planar - circle.angular_velocity[2] * Vec3<S>{-at.arm0[1], at.arm0[0], S(0)};
    const Vec3<S> f = share * force(pairing, at, velocity, sticks);
    result.on_circle.force += f;
    result.on_circle.moment += cross(at.arm0, f);
    for (std::size_t i = 0; i < 8; ++i)
      result.on_cable[i] = result.on_cable[i] - weights[i / 2] * f[static_cast<int>(i % 2)];
    const double away = value_of(dot(at.normal, velocity));
    result.normal_force -= (pairing.stiffness * value_of(at.gap) + pairing.damping * away) / 3;
    if (pairing.friction != 0) result.slip = std::max(result.slip, value_of(norm(velocity - away * at.normal)));
  }
  return result;
}

void GeneralContact::add_cable(const HeldContact& c, Ports& ports, std::optional<bool> sticks, double* r) const {
  const auto number = static_cast<std::size_t>(c.other - set_->first_cable());
  const int marker = sphere(c.sphere).marker;
  const CableForces<double> forces =
      cable_forces(c, frame_of(marker, ports), cables_now_[number].q, cables_now_[number].v, sticks);
  double* to = ports.force(marker);
  add_vector(to, 1.0, forces.on_circle.force);
  if (turns(c.sphere)) add_vector(to + 3, 1.0, forces.on_circle.moment);
  for (std::size_t i = 0; i < 8; ++i) r[cables_[number].dofs[i]] -= forces.on_cable[i];
}

void GeneralContact::add_cable_tangent(const HeldContact& c, const Block& block, const Weights& weights,
                                       const Ports& ports, double* values) const {
  const auto number = static_cast<std::size_t>(block.number);
  const int marker = sphere(c.sphere).marker, own = ports.ports[static_cast<std::size_t>(marker)].n, total = own + 8;
  const int* slot = slots.data() + block.first_slot;
  for (int first = 0; first < total; first += sweep_width) {
    std::array<SweepDual, 8> q, v;
    for (int i = 0; i < 8; ++i) {
      const auto k = static_cast<std::size_t>(i);
      q[k] = SweepDual(cables_now_[number].q[k]);
      v[k] = SweepDual(cables_now_[number].v[k]);
      const int column = own + i - first;
      if (column < 0 || column >= sweep_width) continue;
      q[k].d[static_cast<std::size_t>(column)] = weights.q;
      v[k].d[static_cast<std::size_t>(column)] = weights.v;
    }
    const CableForces<SweepDual> forces = cable_forces(c, moving_frame(ports, marker, 0, first), q, v, c.sticks);
    scatter(ports, marker, 0, total, first, forces.on_circle, slot, values);
    for (int i = 0; i < 8; ++i)
      for (int k = 0; k < std::min(sweep_width, total - first); ++k) {
        const int at = slot[(own + i) * total + first + k];
        if (at >= 0) values[at] -= forces.on_cable[static_cast<std::size_t>(i)].d[static_cast<std::size_t>(k)];
      }
  }
}

}  // namespace dalembert
