// Where markers leave their frames and connectors their forces: flat arrays, one stretch per marker.
#pragma once

#include <span>
#include <vector>

#include "dalembert/contracts/rotating_node.hpp"

namespace dalembert {

// One marker's stretch. Frames are `values` scalars; `n` coordinates move it.
struct PortLayout {
  int values = 0, first_value = 0;        // frame
  int forces = 0, first_force = 0;        // conjugate of the frame
  int n = 0, first_dof = 0;               // global ODE2 coordinates
  int first_derivative = 0;               // values x n: frame along the weights of the tangent
  int first_jacobian = 0;                 // forces x n: generalised force = J^T force
  int translations = 0;                   // the first coordinates, if each moves the frame along one axis and nothing else
};

// What a batch keeps of a port to reach it without the layout.
struct PortOffsets {
  int value = 0, force = 0;
};

class Ports {
 public:
  std::vector<PortLayout> ports;                // by marker number
  std::vector<double> values, forces;
  std::vector<double> derivatives, jacobians;   // empty before `differentiate`
  // By rotating node, for the bodies and markers on it.
  std::vector<NodeMotion> node_motions;
  std::vector<NodeLoad> node_loads;
  std::vector<int> dofs;

  // Append a marker's stretch; `n` dofs follow with the call.
  void append(int value_count, int force_count, std::span<const int> coordinate_dofs, int translations = 0);
  // Make room for derivatives and Jacobians: evaluations without a tangent do without.
  void differentiate();
  // Rows of a matrix may be read up to so many entries beyond its end.
  static constexpr int margin = 4;

  PortOffsets offsets(int marker) const { return {ports[marker].first_value, ports[marker].first_force}; }
  const double* frame(int marker) const { return values.data() + ports[marker].first_value; }
  double* frame(int marker) { return values.data() + ports[marker].first_value; }
  const double* force(int marker) const { return forces.data() + ports[marker].first_force; }
  double* force(int marker) { return forces.data() + ports[marker].first_force; }
  double* derivative(int marker) { return derivatives.data() + ports[marker].first_derivative; }
  const double* derivative(int marker) const { return derivatives.data() + ports[marker].first_derivative; }
  double* jacobian(int marker) { return jacobians.data() + ports[marker].first_jacobian; }
  const double* jacobian(int marker) const { return jacobians.data() + ports[marker].first_jacobian; }
  void add_rotating_node();
  void clear_forces();
  // The derivatives of a node's rotation by its R rotation coordinates.
  template <int R>
  RotationTangent<R>& rotation(int node) {
    static_assert(sizeof(RotationTangent<R>) <= rotation_size * sizeof(double));
    return *reinterpret_cast<RotationTangent<R>*>(rotations_.data() + static_cast<std::size_t>(node) * rotation_size);
  }
  std::span<const int> marker_dofs(int marker) const {
    return {dofs.data() + ports[marker].first_dof, static_cast<std::size_t>(ports[marker].n)};
  }

 private:
  int derivative_count_ = 0, jacobian_count_ = 0;
  static constexpr std::size_t rotation_size = sizeof(RotationTangent<4>) / sizeof(double);
  std::vector<double> rotations_;
};

}  // namespace dalembert
