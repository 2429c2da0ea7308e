#include "dalembert/system/ports.hpp"

#include <algorithm>

#include "dalembert/system/room_of_forces.hpp"

namespace dalembert {

void Ports::append(int value_count, int force_count, std::span<const int> coordinate_dofs, int translations) {
  PortLayout p;
  p.values = value_count;
  p.first_value = static_cast<int>(values.size());
  p.forces = force_count;
  p.first_force = static_cast<int>(forces.size());
  p.n = static_cast<int>(coordinate_dofs.size());
  p.first_dof = static_cast<int>(dofs.size());
  p.first_derivative = derivative_count_;
  p.first_jacobian = jacobian_count_;
  derivative_count_ += p.values * p.n;
  jacobian_count_ += p.forces * p.n;
  p.translations = translations;
  ports.push_back(p);
  values.resize(values.size() + static_cast<std::size_t>(p.values));
  forces.resize(forces.size() + static_cast<std::size_t>(room_of_forces(p.forces)));
  dofs.insert(dofs.end(), coordinate_dofs.begin(), coordinate_dofs.end());
}

void Ports::add_rotating_node() {
  node_motions.emplace_back();
  node_loads.emplace_back();
  point_forces.emplace_back();
  const std::size_t size = rotations_.size() + rotation_size;
  if (size > rotations_.capacity()) rotations_.reserve(node_motions.capacity() * rotation_size);
  rotations_.resize(size);
}

void Ports::clear_forces() {
  std::fill(forces.begin(), forces.end(), 0.0);
  std::fill(node_loads.begin(), node_loads.end(), NodeLoad{});
}

}  // namespace dalembert
