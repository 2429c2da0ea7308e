// Markers that pass on the frame of an element at a local point, or take a load on its whole mass.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "dalembert/batches/element_parameters.hpp"
#include "dalembert/math/few_numbers.hpp"
#include "dalembert/system/physics.hpp"
#include "dalembert/system/room_of_forces.hpp"

namespace dalembert {

// How a frame shape reads a motion, and the generalised force of its conjugate. On a rotating element this is `scale`
// times a force at `point`, and a moment.
template <class E>
struct PointShape {
  template <class S>
  using Frame = PointFrame<S>;
  static constexpr int values = 6, forces = 3;
  static const Vec3<double>& point(const typename E::Parameters&, const Vec3<double>& local) { return local; }
  static double scale(const typename E::Parameters&) { return 1; }
  template <class S>
  static Frame<S> frame(const Motion<S>& m) {
    return {m.position, m.velocity};
  }
  template <class S>
  static auto pull_back(const typename E::Parameters& p, const Coordinates<S, E::size>& x, const Vec3<double>& local,
                        const auto* f) {
    return E::template pull_back<S>(p, x, local, Vec3<S>{S(f[0]), S(f[1]), S(f[2])}, Vec3<S>{});
  }
};

template <class E>
struct RigidShape : PointShape<E> {
  template <class S>
  using Frame = RigidFrame<S>;
  static constexpr int values = 18, forces = 6;
  template <class S>
  static Frame<S> frame(const Motion<S>& m) {
    return {m.position, m.velocity, m.rotation, m.angular_velocity};
  }
  template <class S>
  static auto pull_back(const typename E::Parameters& p, const Coordinates<S, E::size>& x, const Vec3<double>& local,
                        const auto* f) {
    return E::template pull_back<S>(p, x, local, Vec3<S>{S(f[0]), S(f[1]), S(f[2])},
                                    Vec3<S>{S(f[3]), S(f[4]), S(f[5])});
  }
};

template <class E>
struct MassShape {
  template <class S>
  using Frame = MassFrame<S>;
  static constexpr int values = 0, forces = 3;
  static decltype(auto) point(const typename E::Parameters& p, const Vec3<double>&) { return E::Kernel::centre(p); }
  static double scale(const typename E::Parameters& p) { return E::Kernel::mass(p); }
  // The mass matrix that multiplies accelerations also weights the load.
  static constexpr bool constant_jacobian = E::traits.constant_mass;
  template <class S>
  static auto pull_back(const typename E::Parameters& p, const Coordinates<S, E::size>& x, const Vec3<double>&,
                        const auto* g) {
    return E::template mass_load<S>(p, x, Vec3<S>{S(g[0]), S(g[1]), S(g[2])});
  }
};

template <class E>
inline constexpr bool is_at_node = false;
template <class Node>
inline constexpr bool is_at_node<AtNode<Node>> = true;

template <class E, class OwnerRecord, template <class> class ShapeOf>
class FrameMarkerBatch : public MarkerBatch {
 public:
  using Shape = ShapeOf<E>;
  static constexpr int n = E::size;

  int value_count(const void*, const Placement&) const override { return Shape::values; }
  int force_count(const void*, const Placement&) const override { return Shape::forces; }
  int translations() const override { return E::traits.translations; }

  void reserve(int entries) override { entries_.reserve(static_cast<std::size_t>(entries)); }
  // The record of a frame marker is only its local position; the body's record comes with the placement.
  void add(const void* local, const Placement& placement, const Ports& ports) override {
    Entry e;
    e.local = *static_cast<const Vec3<double>*>(local);
    e.owner = owner_of(placement);
    e.marker = placement.item;
    e.node = placement.rotating_node;
    e.port = ports.offsets(placement.item);
    for (int i = 0; i < n; ++i) e.dofs[i] = placement.dofs[i];
    if constexpr (passes_on) add_to_runs(e);
    entries_.push_back(std::move(e));
  }
  void refresh(int entry, const void* local) override {
    entries_[entry].local = *static_cast<const Vec3<double>*>(local);
  }
  void refresh_owner(int entry, const void* record) override {
    if constexpr (owner_has_parameters) renew_parameters<E, OwnerRecord>(owners_[entries_[entry].owner], record);
  }
  void refresh_resting(int entry, const void*, const Placement& placement) override {
    if constexpr (owner_has_parameters)
      take_parameters<E, OwnerRecord>(owners_[entries_[entry].owner], placement.owner, placement);
  }
  void visit(BlockVisitor& visitor, const Ports&) const override {
    if constexpr (has_geometric)
      for (const Entry& e : entries_) visitor.block(e.dofs, e.dofs);
  }

  NodeFrame node_frame(int entry) const override {
    if constexpr (passes_on && n == 3) return {entries_[static_cast<std::size_t>(entry)].dofs[0], -1};
    return {};
  }
  void evaluate(const Evaluation& evaluation, Ports& ports) const override { find_frames(evaluation, ports); }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    differentiate(evaluation, weights, ports);
  }
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override {
    subtract_forces(evaluation, ports, r);
  }
  bool traceable() const override { return only_translates; }
  void trace(const TracedCall& call) const override {
    if constexpr (only_translates) {
      switch (call.function) {
        case TracedCall::Function::evaluate: return find_frames(call.evaluation, call.ports);
        case TracedCall::Function::evaluate_tangent: return differentiate(call.evaluation, call.weights, call.ports);
        case TracedCall::Function::pull_back: return subtract_forces(call.evaluation, call.ports, call.sums);
        default: return;
      }
    }
  }
  bool constant_pull_back(bool) const override { return n > 0 && !has_geometric; }
  bool geometric_follows_tangent() const override { return false; }
  void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports,
                 double* values) const override {
    if constexpr (has_geometric) {
      SlotCursor slot(slots.data(), values);
      for (const Entry& e : entries_) {
        const auto x = gather<n>(evaluation, e.dofs.data());
        const double* force = ports.force(e.marker);
        Mat<double, n, n> changes;
        for (int first = 0; first < n; first += directions) {
          const auto q = Shape::template pull_back<Dual<directions>>(
              parameters(e), seeded_from<E, directions>(first, x, weights), e.local, force);
          for (int i = 0; i < n; ++i) std::copy_n(q[i].d.begin(), std::min(directions, n - first), &changes(i, first));
        }
        for (const double change : changes.x) slot.add(-change);
      }
    }
  }
  bool motion(int entry, const Evaluation& evaluation, Motion<double>& m) const override {
    if constexpr (Shape::values > 0) {
      const Entry& e = entries_[entry];
      m = E::template motion<double>(parameters(e), gather<n>(evaluation, e.dofs.data()), e.local);
      return true;
    }
    return false;
  }

 protected:
  struct Entry {
    Vec3<double> local;
    std::size_t owner = 0;
    int marker = -1;
    int node = -1;  // among the rotating nodes of the ports
    PortOffsets port;
    std::array<int, n> dofs{};
  };
  std::vector<Entry> entries_;

  static constexpr bool owner_has_parameters = !std::is_empty_v<typename E::Parameters>;
  const typename E::Parameters& parameters(const Entry& e) const {
    if constexpr (owner_has_parameters)
      return owners_[e.owner];
    else
      return no_parameters;
  }

 private:
  template <class S>
  void find_frames(const EvaluationOf<S>& evaluation, PortsOf<S>& ports) const {
    if constexpr (passes_on)
      for (const Run& run : runs_) {
        const S *q = evaluation.q + run.dof, *v = evaluation.v + run.dof;
        S* to = ports.values.data() + run.value;
        for (int k = 0; k < run.count; ++k, q += n, v += n, to += Shape::values) {
          keep_loop();
          const Vec<S, n> at = load<S, n>(q), rate = load<S, n>(v);
          for (int i = 0; i < n; ++i) to[i] = at[i], to[n + i] = rate[i];
        }
      }
    else if constexpr (Shape::values > 0)
      for (const Entry& e : entries_) {
        const auto x = gather<n>(evaluation, e.dofs.data());
        auto* frame = reinterpret_cast<typename Shape::template Frame<S>*>(ports.values.data() + e.port.value);
        *frame = Shape::frame(E::template motion<S>(parameters(e), x, e.local));
      }
  }
  template <class S>
  void differentiate(const EvaluationOf<S>& evaluation, const Weights& weights, PortsOf<S>& ports) const {
    if constexpr (n > 0)
      for (const Entry& e : entries_) {
        if constexpr (translates)
          translate(e, weights, ports);
        else
          sweep(e, gather<n>(evaluation, e.dofs.data()), weights, ports);
      }
  }
  template <class S>
  void subtract_forces(const EvaluationOf<S>& evaluation, const PortsOf<S>& ports, S* r) const {
    if constexpr (passes_on)
      for (const Run& run : runs_) {
        const S* force = ports.forces.data() + run.force;
        S* to = r + run.dof;
        for (int k = 0; k < run.count; ++k, to += n, force += room_of_forces(n)) {
          keep_loop();
          const Vec<S, n> changed = load<S, n>(to) - load<S, n>(force);
          for (int i = 0; i < n; ++i) to[i] = changed[i];
        }
      }
    else if constexpr (n > 0)
      for (const Entry& e : entries_) {
        const auto x = gather<n>(evaluation, e.dofs.data());
        const auto q = Shape::template pull_back<S>(parameters(e), x, e.local, ports.forces.data() + e.port.force);
        for (int i = 0; i < n; ++i) r[e.dofs[i]] -= q[i];
      }
  }

  static constexpr std::conditional_t<owner_has_parameters, int, typename E::Parameters> no_parameters{};

  // Markers on one body mostly follow each other: they share its parameters.
  std::size_t owner_of(const Placement& placement) {
    if constexpr (owner_has_parameters) {
      const bool is_last = !owners_.empty() && placement.owner_number >= 0 && placement.owner_number == last_owner_;
      last_owner_ = placement.owner_number;
      if (!is_last) take_parameters<E, OwnerRecord>(owners_.emplace_back(), placement.owner, placement);
      return owners_.size() - 1;
    }
    return 0;
  }
  // All coordinates are components of the position.
  static constexpr bool only_translates = n > 0 && E::traits.translations == n;
  // They are the frame themselves, and its forces theirs. Markers whose numbers all lie side by side are a run: large systems are as fast as
  // memory is, and this is all they read of their markers.
  static constexpr bool passes_on = is_at_node<E> && only_translates && n == Shape::forces && 2 * n == Shape::values;
  struct Run {
    int dof, value, force, count;
  };
  void add_to_runs(const Entry& e) {
    const Run* last = runs_.empty() ? nullptr : &runs_.back();
    const auto follows = [&](int first, int size, int next) { return first + size * last->count == next; };
    const bool goes_on = last != nullptr && follows(last->dof, n, e.dofs[0]) &&
                         follows(last->value, Shape::values, e.port.value) &&
                         follows(last->force, room_of_forces(n), e.port.force);
    goes_on ? void(++runs_.back().count) : runs_.push_back({e.dofs[0], e.port.value, e.port.force, 1});
  }
  static constexpr bool has_geometric = [] {
    if constexpr (requires { requires Shape::constant_jacobian; } || E::traits.constant_jacobian || only_translates)
      return false;
    else
      return n > 0;
  }();
  // The position is the first coordinates: derivatives are those of the identity.
  static constexpr bool translates = E::traits.translations > 0 &&
                                     (only_translates || (E::traits.constant_jacobian && !E::traits.oriented)) &&
                                     Shape::values == PointShape<E>::values;
  template <class S>
  static void translate(const Entry& e, const Weights& weights, PortsOf<S>& ports) {
    S *derivative = ports.derivative(e.marker), *jacobian = ports.jacobian(e.marker);
    std::fill_n(derivative, Shape::values * n, S(0.0));
    std::fill_n(jacobian, Shape::forces * n, S(0.0));
    for (int i = 0; i < E::traits.translations; ++i) {
      derivative[i * n + i] = weights.q;
      derivative[(3 + i) * n + i] = weights.v;
      jacobian[i * n + i] = 1;
    }
  }
  // How many directions are swept at once: all of a node or two, so that elements of many coordinates do not take minutes to compile.
  static constexpr int sweeps = (n + 7) / 8, directions = sweeps == 0 ? 0 : (n + sweeps - 1) / sweeps;
  template <class S>
  void sweep(const Entry& e, const Coordinates<S, n>& x, const Weights& weights, PortsOf<S>& ports) const {
    if constexpr (Shape::values > 0) {
      for (int first = 0; first < n; first += directions) {
        const auto frame = Shape::frame(E::template motion<Dual<directions>>(
            parameters(e), seeded_from<E, directions>(first, x, weights), e.local));
        const auto* from = reinterpret_cast<const Dual<directions>*>(&frame);
        double* to = ports.derivative(e.marker) + first;
        for (int i = 0; i < Shape::values; ++i)
          std::copy_n(from[i].d.begin(), std::min(directions, n - first), to + i * n);
      }
    }
    S* jacobian = ports.jacobian(e.marker);
    for (int i = 0; i < Shape::forces; ++i) {
      std::array<S, Shape::forces> unit{};
      unit[i] = 1;
      const auto q = Shape::template pull_back<S>(parameters(e), x, e.local, unit.data());
      jacobian = std::copy(q.x.begin(), q.x.end(), jacobian);
    }
  }

  std::vector<Run> runs_;  // runs of entries that pass forces on
  std::vector<typename E::Parameters> owners_;
  int last_owner_ = -1;  // its number
};

}  // namespace dalembert
