// Ports: arrays with the frames of markers and the forces of connectors. Bodies and connectors do not know each other; between
// them are flat arrays with one range per marker, which is evaluated once for any number of connectors.
//
//                   marker 0              marker 1
//     values        | x  v  R  omega |    | x  v |       the frame, written by MarkerBatch::evaluate, read by connectors
//     forces        | f  m           |    | f    |       its conjugate, summed by connectors; MarkerBatch::pull_back: r -= J^T f
//     derivatives   | 18 x n         |    | 6 x n |      the frame by the n coordinates under the marker, along the weights
//     jacobians     | 6 x n          |    | 3 x n |      J
//
// The tangent of a connector between them is J^T (df/dframe) (dframe): its kernel is differentiated by frames, never by coordinates.
#pragma once

#include <span>
#include <vector>

#include "dalembert/contracts/rotating_node.hpp"
#include "dalembert/math/aligned_vector.hpp"

namespace dalembert {

// Range of one marker. Frames are `values` scalars; `n` coordinates move it.
struct PortLayout {
  int values = 0, first_value = 0;  // frame
  int forces = 0, first_force = 0;  // conjugate of the frame
  int n = 0, first_dof = 0;  // global ODE2 coordinates
  int first_derivative = 0;  // values x n: frame along the weights of the tangent
  int first_jacobian = 0;  // forces x n: generalised force = J^T force
  int translations = 0;  // the first coordinates, if each moves the frame along one axis and nothing else
};

// Offsets by which a batch accesses a port without the layout.
struct PortOffsets {
  int value = 0, force = 0;
};

// Layout of the ports of all markers, independent of the type of data.
class PortTable {
 public:
  std::vector<PortLayout> ports;  // by marker number
  std::vector<int> dofs;

  PortOffsets offsets(int marker) const { return {ports[marker].first_value, ports[marker].first_force}; }
  std::span<const int> marker_dofs(int marker) const {
    return {dofs.data() + ports[marker].first_dof, static_cast<std::size_t>(ports[marker].n)};
  }
  // Rows of a matrix may be read up to so many entries beyond its end.
  static constexpr int margin = 4;

 protected:
  int derivative_count_ = 0, jacobian_count_ = 0;
};

template <class S>
class PortsOf : public PortTable {
 public:
  PortsOf() = default;
  // A copy, whose numbers are constants.
  template <class T>
  explicit PortsOf(const PortsOf<T>& from)
      : PortTable(from), values(from.values.begin(), from.values.end()), forces(from.forces.size()) {}

  AlignedVector<S> values, forces;
  std::vector<S> derivatives, jacobians;  // empty before `differentiate`

  // Make room for derivatives and Jacobians: evaluations without a tangent do without.
  void differentiate() {
    derivatives.resize(static_cast<std::size_t>(derivative_count_));
    jacobians.resize(static_cast<std::size_t>(jacobian_count_ + margin));
  }

  const S* frame(int marker) const { return values.data() + ports[marker].first_value; }
  S* frame(int marker) { return values.data() + ports[marker].first_value; }
  const S* force(int marker) const { return forces.data() + ports[marker].first_force; }
  S* force(int marker) { return forces.data() + ports[marker].first_force; }
  S* derivative(int marker) { return derivatives.data() + ports[marker].first_derivative; }
  const S* derivative(int marker) const { return derivatives.data() + ports[marker].first_derivative; }
  S* jacobian(int marker) { return jacobians.data() + ports[marker].first_jacobian; }
  const S* jacobian(int marker) const { return jacobians.data() + ports[marker].first_jacobian; }
};

class Ports : public PortsOf<double> {
 public:
  // One per rotating node, for its bodies and markers.
  std::vector<NodeMotion> node_motions;
  std::vector<NodeLoad> node_loads;
  std::vector<PointForces> point_forces;  // read if loads require it
  void add_load(int node, const Vec3<double>& point, const Vec3<double>& force, const Vec3<double>& moment) {
    NodeLoad& load = node_loads[static_cast<std::size_t>(node)];
    load.add_at_node(force, moment);
    if (is_zero(point)) return;
    Mat3<double>& sum = point_forces[static_cast<std::size_t>(node)].sum;
    const Mat3<double> more = matrix_of<3, 3>([&](int i, int j) { return point[i] * force[j]; });
    sum = load.beside == 0 ? more : sum + more;
    load.beside = 1;
  }

  // Append a marker's stretch; `n` dofs follow with the call.
  void append(int value_count, int force_count, std::span<const int> coordinate_dofs, int translations = 0);
  void add_rotating_node();
  void clear_forces();
  // The derivatives of a node's rotation by its R rotation coordinates.
  template <int R>
  RotationTangent<R>& rotation(int node) {
    static_assert(sizeof(RotationTangent<R>) <= rotation_size * sizeof(double));
    return *reinterpret_cast<RotationTangent<R>*>(rotations_.data() + static_cast<std::size_t>(node) * rotation_size);
  }

 private:
  static constexpr std::size_t rotation_size = sizeof(RotationTangent<4>) / sizeof(double);
  std::vector<double> rotations_;
};

}  // namespace dalembert
