#include "dalembert/system/ports.hpp"

namespace dalembert {

void Ports::append(int value_count, int force_count, std::span<const int> coordinate_dofs, int translations) {
  PortLayout p;
  p.values = value_count;
  p.first_value = static_cast<int>(values.size());
  p.forces = force_count;
  p.first_force = static_cast<int>(forces.size());
  p.n = static_cast<int>(coordinate_dofs.size());
  p.first_dof = static_cast<int>(dofs.size());
  p.first_derivative = static_cast<int>(derivatives.size());
  p.first_jacobian = ports.empty() ? 0 : ports.back().first_jacobian + ports.back().forces * ports.back().n;
  p.translations = translations;
  ports.push_back(p);
  values.resize(values.size() + static_cast<std::size_t>(p.values));
  forces.resize(forces.size() + static_cast<std::size_t>(p.forces));
  derivatives.resize(derivatives.size() + static_cast<std::size_t>(p.values) * p.n);
  jacobians.resize(static_cast<std::size_t>(p.first_jacobian + p.forces * p.n + margin));
  dofs.insert(dofs.end(), coordinate_dofs.begin(), coordinate_dofs.end());
}

void Ports::clear() { *this = Ports(); }

}  // namespace dalembert
