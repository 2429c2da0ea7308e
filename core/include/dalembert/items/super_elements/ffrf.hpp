// ObjectFFRF, specs/super_elements/ffrf.toml: a body frame F, in whose axes all nodes of a mesh move.
//
// Let w and w_t be the spin of F and its rate, and a the acceleration of its origin, all in the axes of F. Mesh node i, at y_i = x_i + q_i,
// accelerates by
//
//      a + w_t x y + w x (w x y) + 2 w x q_t + q_tt .
//
// Times the mass matrix of the mesh, which turns nothing, these are the inertia forces on the nodes; their sum and their moments act on F.
// A. Zwoelfer, J. Gerstmayr, Multibody System Dynamics 49 (2020).
#pragma once

#include "dalembert/contracts/sized_body.hpp"
#include "dalembert/super_elements/ffrf_parameters.hpp"

namespace dalembert {

// The mass matrix row by row, and derived data.
struct MeshInertia {
  struct Entry {
    int column;
    double mass;
  };
  int coordinates = 0;
  std::vector<std::size_t> begins = {};  // starts of the rows among the entries, and the end
  std::vector<Entry> entries = {};
  std::vector<Mat3<double>> whole = {};  // by node: its forces of an acceleration of all
  std::vector<double> rest = {};  // reference positions of the nodes
  std::vector<double> force = {};  // on frame and nodes, in global axes
};

struct ObjectFFRF {
  using Parameters = ObjectFFRFParameters;
  using Constants = MeshInertia;
  static constexpr std::string_view item = "ObjectFFRF";
  static constexpr int order = 2;
  static constexpr std::string_view coordinates = "coordinates of the mesh nodes";
  static constexpr Mesh mesh = Mesh::nodes_in_frame;
  static constexpr bool computes_parameters = true;

  static bool takes(std::string_view node, int position) { return position == 0 || node == "NodePoint"; }
  static SizedLaw law(const Parameters& p);
  static void check(const Parameters& p, const Placement& on, const ItemLabel& item);
  // Positions of the mesh nodes, and mass, centre of mass and inertia of the mesh without deformation.
  static void complete(Parameters& p, const Placement& on);
  static MeshInertia prepare(const Parameters& p);

  static int mesh_nodes(const Parameters& p) { return static_cast<int>(p.nodeNumbers.size()) - 1; }
  static Vec3<double> rest(const Parameters& p, int node) {
    return load<double, 3>(p.referencePositions.data() + 3 * node);
  }
  template <class Shape>
  static void each_shape(const Parameters&, int node, const Shape& shape) {
    for (int axis = 0; axis < 3; ++axis)
      shape(3 * node + axis, vector_of<3>([&](int i) { return i == axis ? 1.0 : 0.0; }));
  }
  static bool mesh_outputs(const Parameters&, const SizedCoordinates<double>&, int, int, OutputVariableType,
                           std::vector<double>&) {
    return false;
  }

  template <class Node>
  struct On;
};

// Coordinates of the node that is its frame.
template <class Node>
struct ObjectFFRF::On : ObjectFFRF {
  using Frame = Node;

  static FramePlace whole_mass(const Parameters& p) {
    const auto mesh = p.referencePositions.size(), n = Node::size + mesh;
    FramePlace place{.scale = p.physicsMass,
                     .rest = p.physicsMass * p.physicsCenterOfMass,
                     .translation = std::vector<double>(3 * n)};
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < mesh; ++i)
        place.translation[axis * n + Node::size + i] = p.PHItTM(static_cast<int>(axis), static_cast<int>(i));
    return place;
  }

  template <class S>
  static void residual(const MeshInertia& k, const SizedCoordinates<S>& x, std::span<S> r) {
    std::ranges::fill(r, S(0));
    if (k.coordinates == 0) return;
    const auto at_node = x.template of_first<Node>();
    const SpinMotion<S> frame = spin_motion<Node, S>(at_node);
    const Mat3<S>& A_0F = frame.rotation;
    const Vec3<S>&w = frame.spin, &w_t = frame.spin_rate, a = transposed_times(A_0F, frame.acceleration);
    Vec3<S> sum{}, moment{};
    for (int i = 0; i < k.coordinates; i += 3) {
      const auto [position, velocity, acceleration] = weighted(k, x, i);
      const Vec3<S> force = k.whole[static_cast<std::size_t>(i / 3)] * a + cross(w_t, position) +
                            cross(w, cross(w, position)) + 2.0 * cross(w, velocity) + acceleration;
      const Vec3<S> y = vector_of<3>(
          [&](int axis) { return S(k.rest[static_cast<std::size_t>(i + axis)] + x.u[Node::size + i + axis]); });
      sum += force;
      moment += cross(y, force);
      for (int axis = 0; axis < 3; ++axis) r[static_cast<std::size_t>(Node::size + i + axis)] = force[axis];
    }
    const auto whole = pull_back_spin_wrench<Node, S>(at_node, A_0F * sum, moment);
    for (int i = 0; i < Node::size; ++i) r[static_cast<std::size_t>(i)] = whole[i];
    subtract_force(k, A_0F, r);
  }

 private:
  // Rows i to i + 2 of the mass matrix times positions, velocities and accelerations of the mesh in the frame.
  template <class S>
  struct Weighted {
    Vec3<S> position, velocity, acceleration;
  };
  template <class S>
  static Weighted<S> weighted(const MeshInertia& k, const SizedCoordinates<S>& x, int i) {
    Weighted<S> sum{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto row = static_cast<std::size_t>(i + axis);
      for (std::size_t e = k.begins[row]; e < k.begins[row + 1]; ++e) {
        const auto [column, mass] = k.entries[e];
        sum.position[axis] += mass * (k.rest[static_cast<std::size_t>(column)] + x.u[Node::size + column]);
        sum.velocity[axis] += mass * x.v[Node::size + column];
        sum.acceleration[axis] += mass * x.a[Node::size + column];
      }
    }
    return sum;
  }
  // Forces on the nodes are transformed to the frame.
  template <class S>
  static void subtract_force(const MeshInertia& k, const Mat3<S>& A_0F, std::span<S> r) {
    if (k.force.empty()) return;
    for (std::size_t i = 0; i < Node::size; ++i) r[i] -= k.force[i];
    for (std::size_t i = Node::size; i < k.force.size(); i += 3) {
      const Vec3<S> f_F = transposed_times(A_0F, load<double, 3>(k.force.data() + i));
      for (int axis = 0; axis < 3; ++axis) r[i + static_cast<std::size_t>(axis)] -= f_F[axis];
    }
  }
};

}  // namespace dalembert
