// Bodies on rotating nodes: they read the motion that the node has found, and leave their inertia forces there.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "dalembert/batches/element.hpp"
#include "dalembert/batches/groups.hpp"

namespace dalembert {

// Adds the derivative of the inertia forces by values[slot[row * n + column]]. The wrench is held fixed in the maps to
// coordinates: that part is the node's.
template <RotatingBody Body, RotatingNode Node>
void add_inertia_tangent(const typename Body::Parameters& p, const SpinMotion<double>& motion,
                         const RotationTangent<Node::size - 3>& t, const Weights& w, const int* slot, double* values) {
  constexpr int n = Node::size, r = n - 3;
  const InertiaTangent b = Body::inertia_tangent(Body::mass_properties(p), motion);
  const auto add = [&](int row, int column, double x) { values[slot[row * n + column]] += x; };
  for (int i = 0; i < 3; ++i) add(i, i, w.a * b.mass);
  // in body axes
  Mat<double, 3, r> moment = b.moment_by_spin * t.spin_tangent + b.moment_by_spin_rate * t.spin_rate_tangent;
  if (b.eccentric) {
    const Mat<double, 3, r> swing =
        t.rotation * (b.swing_by_spin * t.spin_tangent + b.swing_by_spin_rate * t.spin_rate_tangent);
    for (int j = 0; j < r; ++j) {
      const Vec3<double> turned = t.turn[j] * b.swing;
      const Vec3<double> lever = b.moment_by_acceleration * transposed_times(t.turn[j], motion.acceleration);
      for (int i = 0; i < 3; ++i) {
        add(i, 3 + j, turned[i] + swing(i, j));
        moment(i, j) += lever[i];
      }
    }
    const Mat<double, r, 3> by_acceleration =
        transpose(t.spin_map) * (b.moment_by_acceleration * transpose(t.rotation));
    for (int i = 0; i < r; ++i)
      for (int j = 0; j < 3; ++j) add(3 + i, j, w.a * by_acceleration(i, j));
  }
  const Mat<double, r, r> turning = transpose(t.spin_map) * moment;
  for (int i = 0; i < r; ++i)
    for (int j = 0; j < r; ++j) add(3 + i, 3 + j, turning(i, j));
}

template <class E, class Record>
class RotatingBodyBatch final : public ElementBatch<E, Record> {
  using Base = ElementBatch<E, Record>;
  using Base::entries_, Base::n;
  using typename Base::Entry;
  using Body = typename E::Kernel;
  using Node = typename E::OwnRotation;

 public:
  void add(const void* record, const Placement& placement, const Ports& ports) override {
    Base::add(record, placement, ports);
    masses_.push_back(Body::mass_properties(entries_.back().parameters));
    round_.push_back(masses_.back().round());
  }
  void refresh(int entry, const void* record) override {
    Base::refresh(entry, record);
    masses_[static_cast<std::size_t>(entry)] = Body::mass_properties(entries_[entry].parameters);
    round_[static_cast<std::size_t>(entry)] = masses_[static_cast<std::size_t>(entry)].round();
  }
  bool reads_totals() const override { return false; }
  void residual(const Evaluation& evaluation, Ports& ports, double*) const override {
    each_group(0, entries_.size(), [&]<int L>(const Group<L>& group) {
      if (!evaluation.inertia && std::ranges::all_of(group.each([&](std::size_t i) { return round_[i]; }),
                                                     [](char round) { return round != 0; }))
        return;
      const auto motion = [&](std::size_t i) -> const NodeMotion& { return ports.node_motions[entries_[i].node]; };
      const auto first = [&](std::size_t i) { return evaluation.a + entries_[i].dofs[0]; };
      const auto b = gathered<MassProperties>(group.each([&](std::size_t i) { return &masses_[i]; }));
      const auto spin =
          gathered<6>(group.each([&](std::size_t i) { return motion(i).spin.x.data(); }));  // and its rate
      Mat3<Numbers<L>> rotation;  // used only by this class
      if (b.eccentric())
        rotation = {gathered<9>(group.each([&](std::size_t i) { return motion(i).rotation.x.data(); })).x};
      Vec3<Numbers<L>> acceleration{};
      if (evaluation.inertia) acceleration = segment<3>(gathered<4>(group.each(first)), 0);
      const auto w =
          Body::inertia(b, SpinMotion<Numbers<L>>{acceleration, rotation, segment<3>(spin, 0), segment<3>(spin, 3)});
      const auto loads =
          group.each([&](std::size_t i) { return ports.node_loads[entries_[i].node].own_moment.x.data(); });
      add_numbers(joined(-w.moment, -w.force), loads, group.count);
    });
  }
  void tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports, double* values) const override {
    const int* slot = this->slots.data();
    in_wide_registers([&] {
      for (const Entry& e : entries_) {
        const NodeMotion& m = ports.node_motions[e.node];
        const Vec3<double> acceleration =
            evaluation.inertia ? load<double, 3>(evaluation.a + e.dofs[0]) : Vec3<double>{};
        add_inertia_tangent<Body, Node>(e.parameters, {acceleration, m.rotation, m.spin, m.spin_rate},
                                        ports.template rotation<n - 3>(e.node), weights, slot, values);
        slot += n * n;
      }
    });
  }
  // Valid for any state: the nodes need not have been evaluated.
  void mass(const Evaluation& evaluation, Ports&, double* values) const override {
    constexpr Weights weights{.q = 0, .v = 0, .a = 1, .y = 0, .y_t = 0};
    const int* slot = this->slots.data();
    for (const Entry& e : entries_) {
      const auto x = gather<n>(evaluation, e.dofs.data());
      add_inertia_tangent<Body, Node>(e.parameters, Node::template spin_motion<double>(x),
                                      Node::rotation_tangent(x, weights), weights, slot, values);
      slot += n * n;
    }
  }
  // Diagonal if rates are spins about principal axes of inertia through the center of mass.
  bool add_diagonal_masses(const Evaluation&, double* diagonal) const override {
    if constexpr (!LieKernel<Node>) return entries_.empty();
    for (std::size_t k = 0; k < entries_.size(); ++k) {
      const MassProperties<double>& b = masses_[k];
      if (b.eccentric() || !is_zero(segment<3>(b.tensor, 3))) return false;
      for (int i = 0; i < 3; ++i) {
        diagonal[entries_[k].dofs[i]] += b.mass;
        diagonal[entries_[k].dofs[3 + i]] += b.tensor[i];
      }
    }
    return true;
  }

 private:
  std::vector<MassProperties<double>> masses_;
  std::vector<char> round_;  // their spin takes no moment
};

}  // namespace dalembert
