// Markers on rotating nodes and bodies on them: the node finds its motion and its rotation's derivatives once, and takes the
// sum of all forces.
#pragma once

#include "dalembert/batches/frame_marker.hpp"
#include "dalembert/contracts/element.hpp"
#include "dalembert/math/wide_registers.hpp"

namespace dalembert {

// Derivatives of the frame at a point, `local` in body axes. Rows: position, velocity and, if there are 18 Values,
// the rotation row by row and the angular velocity, all in global axes. Writes the nonzero part of a matrix row by
// row.
template <int Values, RotatingNode Node>
void write_frame_tangent(const RotationTangent<Node::size - 3>& t, const Vec3<double>& local, const Weights& w,
                         double* d) {
  constexpr int n = Node::size;
  const auto put = [&](int row, int j, const Vec3<double>& v) {
    for (int i = 0; i < 3; ++i) d[(row + i) * n + 3 + j] = v[i];
  };
  const Vec3<double> swing = cross(t.spin, local);
  for (int i = 0; i < 3; ++i) {
    d[i * n + i] = w.q;
    d[(3 + i) * n + i] = w.v;
  }
  for (int j = 0; j < n - 3; ++j) {
    put(0, j, t.turn[j] * local);
    put(3, j, t.turn[j] * swing + t.rotation * cross(column(t.spin_tangent, j), local));
    if constexpr (Values == 18) {
      for (int i = 0; i < 9; ++i) d[(6 + i) * n + 3 + j] = t.turn[j].x[i];
      put(15, j, column(t.angular_tangent, j));
    }
  }
}
// Rows: generalised force of forces of size `scale` and, of 6 Forces, of unit moments, in global axes; written likewise.
template <int Forces, RotatingNode Node>
void write_force_map(const RotationTangent<Node::size - 3>& t, const Vec3<double>& local, double scale, double* map) {
  constexpr int n = Node::size;
  for (int i = 0; i < 3; ++i) map[i * n + i] = scale;
  for (int j = 0; j < n - 3; ++j) {
    const Vec3<double> speed = t.rotation * cross(column(t.spin_map, j), local);
    for (int i = 0; i < 3; ++i) {
      map[i * n + 3 + j] = scale * speed[i];
      if constexpr (Forces == 6) map[(3 + i) * n + 3 + j] = t.angular_map(i, j);
    }
  }
}

template <class E, class OwnerRecord, template <class> class ShapeOf>
class RotatingMarkerBatch final : public FrameMarkerBatch<E, OwnerRecord, ShapeOf> {
  using Base = FrameMarkerBatch<E, OwnerRecord, ShapeOf>;
  using Base::entries_;
  using typename Base::Entry, typename Base::Shape;
  using Node = typename E::OwnRotation;
  static constexpr int turns = Node::size - 3;

 public:
  void add(const void* local, const Placement& placement, const Ports& ports) override {
    Base::add(local, placement, ports);
    add_to_runs(entries_.size() - 1);
  }
  void refresh(int entry, const void* local) override {
    const Entry& e = entries_[static_cast<std::size_t>(entry)];
    const bool was_at_node = is_at_node_itself(e);
    Base::refresh(entry, local);
    if (is_at_node_itself(e) == was_at_node) return;
    runs_.clear();
    for (std::size_t i = 0; i < entries_.size(); ++i) add_to_runs(i);
  }
  void visit(BlockVisitor& visitor, const Ports& ports) const override {
    if (apart()) Base::visit(visitor, ports);
  }
  NodeFrame node_frame(int entry) const override {
    const Entry& e = entries_[static_cast<std::size_t>(entry)];
    return is_at_node_itself(e) && e.node >= 0 ? NodeFrame{e.dofs[0], e.node} : NodeFrame{};
  }
  void evaluate(const Evaluation& evaluation, Ports& ports) const override {
    if (apart()) return Base::evaluate(evaluation, ports);
    if constexpr (Shape::values > 0) {
      const auto find = [&](const Place& at, const Entry* beside) DALEMBERT_INLINE {
        const NodeMotion& m = ports.node_motions[static_cast<std::size_t>(at.node)];
        auto& frame = *reinterpret_cast<typename Shape::template Frame<double>*>(ports.values.data() + at.value);
        frame.position = load<double, 3>(evaluation.q + at.dof);
        frame.velocity = load<double, 3>(evaluation.v + at.dof);
        if (beside != nullptr) {
          frame.position += m.rotation * beside->local;
          frame.velocity += m.rotation * cross(m.spin, beside->local);
        }
        if constexpr (Shape::forces == 6) {
          frame.rotation = m.rotation;
          frame.angular_velocity = m.angular_velocity;
        }
      };
      in_wide_registers([&] { each_place(find); });
    }
  }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    if (apart()) return Base::evaluate_tangent(evaluation, weights, ports);
    in_wide_registers([&] {
      for (const Entry& e : entries_) {
        const RotationTangent<turns>& rotation = ports.template rotation<turns>(e.node);
        const Vec3<double>& point = Shape::point(this->parameters(e), e.local);
        if constexpr (Shape::values > 0)
          write_frame_tangent<Shape::values, Node>(rotation, point, weights, ports.derivative(e.marker));
        write_force_map<Shape::forces, Node>(rotation, point, Shape::scale(this->parameters(e)),
                                             ports.jacobian(e.marker));
      }
    });
  }
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override {
    if (apart()) return Base::pull_back(evaluation, ports, r);
    const auto leave = [&](const Place& at, const Entry* beside) DALEMBERT_INLINE {
      const double* f = ports.forces.data() + at.force;
      const Vec3<double> force = load<double, 3>(f);
      Vec3<double> moment{};
      if constexpr (Shape::forces == 6) moment = load<double, 3>(f + 3);
      if (beside == nullptr) return ports.node_loads[static_cast<std::size_t>(at.node)].add_at_node(force, moment);
      ports.add_load(at.node, Shape::point(this->parameters(*beside), beside->local),
                     Shape::scale(this->parameters(*beside)) * force, moment);
    };
    in_wide_registers([&] { each_place(leave); });
  }
  // Forces at the node itself do not turn with it.
  bool constant_pull_back(bool of_moments) const override {
    if (apart()) return Base::constant_pull_back(of_moments);
    return (Shape::forces == 3 || !of_moments) &&
           std::ranges::all_of(entries_, [this](const Entry& e) { return at_node(e); });
  }
  bool passes_constantly(int entry, bool of_moments) const override {
    if (apart()) return Base::constant_pull_back(of_moments);
    return (Shape::forces == 3 || !of_moments) && at_node(entries_[static_cast<std::size_t>(entry)]);
  }
  void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports,
                 double* values) const override {
    if (apart()) Base::geometric(evaluation, weights, ports, values);
  }

 private:
  bool at_node(const Entry& e) const { return is_zero(Shape::point(this->parameters(e), e.local)); }

  // A run is a sequence of markers at the node itself with contiguous numbers, which are the only data read. A marker
  // away from the node is a run of its own.
  struct Place {
    int node, dof, value, force;
    bool operator==(const Place&) const = default;
  };
  struct Run {
    Place first;
    std::size_t entry;
    int count;
    bool at_node;
  };
  static bool is_at_node_itself(const Entry& e) { return Shape::values > 0 && is_zero(e.local); }
  static Place place_behind(const Place& p, int count) {
    return {p.node + count, p.dof + count * Node::size, p.value + count * Shape::values,
            p.force + count * room_of_forces(Shape::forces)};
  }
  void add_to_runs(std::size_t number) {
    const Entry& e = entries_[number];
    const Place here{e.node, e.dofs[0], e.port.value, e.port.force};
    const bool at_node = is_at_node_itself(e);
    if (!runs_.empty() && runs_.back().at_node && at_node) {
      Run& last = runs_.back();
      const Place next = place_behind(last.first, last.count);
      if (next == here) return void(++last.count);
    }
    runs_.push_back({here, number, 1, at_node});
  }
  // Calls f(place, entry) for all; entry is null for markers at the node itself.
  template <class F>
  DALEMBERT_INLINE void each_place(const F& f) const {
    for (const Run& run : runs_) {
      if (!run.at_node) {
        f(run.first, &entries_[run.entry]);
        continue;
      }
      Place at = run.first;
      for (int k = 0; k < run.count; ++k, at = place_behind(at, 1)) {
        keep_loop();
        f(at, nullptr);
      }
    }
  }
  std::vector<Run> runs_;

  // Nested markers are separate.
  bool apart() const { return entries_.empty() || entries_.front().node < 0; }
};

}  // namespace dalembert
