// Markers on bodies of run-time size: each has a place in the frame of its body (contracts/frame_place.hpp), and a
// port. Types differ in the seat, which computes the place.
#pragma once

#include <array>

#include "dalembert/batches/mesh_place.hpp"
#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/contracts/sized_body.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

// Arguments for making a seat.
struct Seating {
  std::vector<const ItemType*> node_types;  // node types of the body
  MeshMeanReader read_mean = nullptr;  // used by markers on mesh nodes
};

// A point of the frame itself.
template <class B, class OwnerRecord>
struct LocalSeat {
  FramePlace place;
  void sit(const void* local, const Placement&, const Seating& made_for) { refresh(local, -1, made_for); }
  void refresh(const void* local, int, const Seating&) { place.rest = *static_cast<const Vec3<double>*>(local); }
  void refresh_owner(const void*, int) {}
};

// The body as a whole.
template <class B, class OwnerRecord>
struct MassSeat {
  FramePlace place;
  void sit(const void*, const Placement& on, const Seating&) { refresh_owner(on.owner, on.item); }
  void refresh(const void*, int, const Seating&) {}
  void refresh_owner(const void* owner, int) {
    place = B::whole_mass(static_cast<const OwnerRecord*>(owner)->parameters);
  }
};

// The weighted mean of mesh nodes.
template <class B, class OwnerRecord>
struct MeshSeat {
  FramePlace place;

  void sit(const void* record, const Placement& on, const Seating& made_for) {
    mean_ = made_for.read_mean(record);
    if constexpr (B::mesh == Mesh::nodes) nodes_ = mesh_of_nodes(mean_.nodes, on, made_for.node_types);
    coordinates_ = static_cast<int>(on.dofs.size());
    refresh_owner(on.owner, on.item);
  }
  void refresh(const void* record, int marker, const Seating& made_for) {
    mean_ = made_for.read_mean(record);
    place = mean_place(nodes_, mean_, marker);
  }
  void refresh_owner(const void* owner, int marker) {
    if constexpr (places_mesh<B>) take_mesh(static_cast<const OwnerRecord*>(owner)->parameters);
    place = mean_place(nodes_, mean_, marker);
  }

 private:
  void take_mesh(const typename B::Parameters& p) {
    nodes_ = {{}, {}, coordinates_};
    for (const int number : mean_.nodes) {
      const auto node = static_cast<int>(nodes_.rest.size());
      nodes_.rest.push_back(B::rest(p, number));
      B::each_shape(p, number,
                    [&](int i, const Vec3<double>& by) { nodes_.shapes.push_back({node, frame_size<B> + i, by}); });
    }
  }

  MeshMean mean_;
  MeshNodes nodes_;
  int coordinates_ = 0;
};

template <class B, class OwnerRecord, class Port, template <class, class> class SeatOf>
class SizedMarkerBatch final : public MarkerBatch {
  using Frame = typename B::Frame;

 public:
  SizedMarkerBatch(std::span<const ItemType* const> nodes, MeshMeanReader read)
      : made_for_{{nodes.begin(), nodes.end()}, read} {}

  int value_count(const void*, const Placement&) const override { return Port::values; }
  int force_count(const void*, const Placement&) const override { return Port::forces; }
  void add(const void* record, const Placement& placement, const Ports&) override {
    Entry& e = entries_.emplace_back();
    e.marker = placement.item;
    e.dofs = placement.dofs;
    e.seat.sit(record, placement, made_for_);
    vectors_.make_room(placement.dofs.size());
    forces_.resize(std::max(forces_.size(), placement.dofs.size()));
    moving_forces_.resize(forces_.size());
  }
  void refresh(int entry, const void* record) override {
    entries_[entry].seat.refresh(record, entries_[entry].marker, made_for_);
  }
  void refresh_owner(int entry, const void* record) override {
    entries_[entry].seat.refresh_owner(record, entries_[entry].marker);
  }
  void refresh_resting(int entry, const void* record, const Placement& placement) override {
    entries_[entry].seat.sit(record, placement, made_for_);
  }
  void visit(BlockVisitor& visitor, const Ports&) const override {
    if constexpr (!is_constant)
      for (const Entry& e : entries_) visitor.block(e.dofs, e.dofs);
  }

  void evaluate(const Evaluation& evaluation, Ports& ports) const override {
    if constexpr (Port::values > 0)
      for (const Entry& e : entries_) {
        vectors_.gather(evaluation, e.dofs);
        const auto frame = frame_of(e.seat.place.template motion<Frame>(vectors_.values()));
        std::copy_n(reinterpret_cast<const double*>(&frame), Port::values, ports.frame(e.marker));
      }
  }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    for (const Entry& e : entries_) {
      const std::size_t n = e.dofs.size();
      vectors_.gather(evaluation, e.dofs);
      if constexpr (Port::values > 0)
        each_sweep(n, [&](int first, int count) {
          const auto frame =
              frame_of(e.seat.place.template motion<Frame>(vectors_.template seeded<SweepDual>(weights, first)));
          const auto* from = reinterpret_cast<const SweepDual*>(&frame);
          double* to = ports.derivative(e.marker) + first;
          for (int i = 0; i < Port::values; ++i, to += n) std::copy_n(from[i].d.begin(), count, to);
        });
      for (std::size_t i = 0; i < Port::forces; ++i) {
        std::array<double, 6> unit{};
        unit[i] = 1;
        pull_back(e, vectors_.values(), unit.data(), std::span(ports.jacobian(e.marker) + i * n, n));
      }
    }
  }
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override {
    for (const Entry& e : entries_) {
      vectors_.gather(evaluation, e.dofs);
      pull_back(e, vectors_.values(), ports.force(e.marker), std::span(forces_).first(e.dofs.size()));
      for (std::size_t i = 0; i < e.dofs.size(); ++i) r[e.dofs[i]] -= forces_[i];
    }
  }
  bool constant_pull_back(bool) const override { return is_constant; }
  bool geometric_follows_tangent() const override { return false; }
  void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports,
                 double* values) const override {
    if constexpr (is_constant) return;
    const int* slot = slots.data();
    for (const Entry& e : entries_) {
      const std::size_t n = e.dofs.size();
      vectors_.gather(evaluation, e.dofs);
      each_sweep(n, [&](int first, int count) {
        pull_back(e, vectors_.template seeded<SweepDual>(weights, first), ports.force(e.marker),
                  std::span(moving_forces_).first(n));
        for (std::size_t i = 0; i < n; ++i)
          for (int j = 0; j < count; ++j)
            values[slot[i * n + static_cast<std::size_t>(first + j)]] -= moving_forces_[i].d[j];
      });
      slot += n * n;
    }
  }
  bool motion(int entry, const Evaluation& evaluation, Motion<double>& m) const override {
    if constexpr (Port::values == 0) return false;
    const Entry& e = entries_[entry];
    GatheredVectors vectors;  // an output may be asked for in the middle of an evaluation
    vectors.make_room(e.dofs.size());
    vectors.gather(evaluation, e.dofs);
    m = e.seat.place.template motion<Frame>(vectors.values());
    return true;
  }

 private:
  // Neither a frame nor a rotation turns forces.
  static constexpr bool is_constant = !is_framed<B> && Port::forces == PointPort::forces;

  struct Entry {
    SeatOf<B, OwnerRecord> seat;
    int marker = -1;
    std::vector<int> dofs;
  };

  template <class S>
  static typename Port::template Frame<S> frame_of(const Motion<S>& m) {
    if constexpr (Port::values == RigidPort::values)
      return {m.position, m.velocity, m.rotation, m.angular_velocity};
    else
      return {m.position, m.velocity};
  }
  template <class S>
  static void pull_back(const Entry& e, const SizedCoordinates<S>& x, const double* force, std::span<S> q) {
    Vec3<double> moment{};
    if constexpr (Port::forces == RigidPort::forces) moment = load<double, 3>(force + 3);
    e.seat.place.template pull_back<Frame>(x, load<double, 3>(force), moment, q);
  }

  Seating made_for_;
  std::vector<Entry> entries_;
  mutable GatheredVectors vectors_;  // work space
  mutable std::vector<double> forces_;
  mutable std::vector<SweepDual> moving_forces_;
};

}  // namespace dalembert
