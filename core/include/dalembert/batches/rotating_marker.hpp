// Markers on rotating nodes and bodies on them: the node finds its motion and its rotation's derivatives once, and takes the
// sum of all forces.
#pragma once

#include "dalembert/batches/frame_marker.hpp"
#include "dalembert/contracts/element.hpp"
#include "dalembert/math/wide_registers.hpp"

namespace dalembert {

// Derivatives of the frame at a point, `local` in own axes.
// Rows: position, velocity and, of 18 Values, the rotation row by row and the angular velocity, all in global axes.
// Writes what can differ from zero of a matrix row by row.
template <int Values, RotatingNode Node>
void write_frame_tangent(const RotationTangent<Node::size - 3>& t, const Vec3<double>& local, const Weights& w, double* d) {
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
  using typename Base::Entry, typename Base::Shape;
  using Base::entries_;
  using Node = typename E::OwnRotation;
  static constexpr int turns = Node::size - 3;

 public:
  void visit(BlockVisitor& visitor, const Ports& ports) const override {
    if (apart()) Base::visit(visitor, ports);
  }
  void evaluate(const Evaluation& evaluation, Ports& ports) const override {
    if (apart()) return Base::evaluate(evaluation, ports);
    if constexpr (Shape::values > 0)
      in_wide_registers([&] {
        for (const Entry& e : entries_) {
          const NodeMotion& m = ports.node_motions[static_cast<std::size_t>(e.node)];
          auto& frame = *reinterpret_cast<typename Shape::template Frame<double>*>(ports.values.data() + e.port.value);
          frame.position = load<double, 3>(evaluation.q + e.dofs[0]);
          frame.velocity = load<double, 3>(evaluation.v + e.dofs[0]);
          if (!is_zero(e.local)) {
            frame.position += m.rotation * e.local;
            frame.velocity += m.rotation * cross(m.spin, e.local);
          }
          if constexpr (Shape::forces == 6) {
            frame.rotation = m.rotation;
            frame.angular_velocity = m.angular_velocity;
          }
        }
      });
  }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    if (apart()) return Base::evaluate_tangent(evaluation, weights, ports);
    in_wide_registers([&] {
      for (const Entry& e : entries_) {
        const RotationTangent<turns>& rotation = ports.template rotation<turns>(e.node);
        const Vec3<double>& point = Shape::point(this->parameters(e), e.local);
        if constexpr (Shape::values > 0)
          write_frame_tangent<Shape::values, Node>(rotation, point, weights, ports.derivative(e.marker));
        write_force_map<Shape::forces, Node>(rotation, point, Shape::scale(this->parameters(e)), ports.jacobian(e.marker));
      }
    });
  }
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override {
    if (apart()) return Base::pull_back(evaluation, ports, r);
    in_wide_registers([&] {
      for (const Entry& e : entries_) {
        const double* f = ports.forces.data() + e.port.force;
        const Vec3<double>& point = Shape::point(this->parameters(e), e.local);
        const Vec3<double> force = Shape::scale(this->parameters(e)) * load<double, 3>(f);
        Vec3<double> moment{};
        if constexpr (Shape::forces == 6) moment = load<double, 3>(f + 3);
        ports.add_load(e.node, point, force, moment);
      }
    });
  }
  // Forces at the node itself do not turn with it.
  bool constant_pull_back(bool of_moments) const override {
    if (apart()) return Base::constant_pull_back(of_moments);
    const auto at_node = [this](const Entry& e) { return is_zero(Shape::point(this->parameters(e), e.local)); };
    return (Shape::forces == 3 || !of_moments) && std::ranges::all_of(entries_, at_node);
  }
  void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports, double* values) const override {
    if (apart()) Base::geometric(evaluation, weights, ports, values);
  }

 private:
  // Markers inside of others keep to themselves.
  bool apart() const { return entries_.empty() || entries_.front().node < 0; }
};

}  // namespace dalembert
