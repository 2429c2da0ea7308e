// ObjectFFRFreducedOrder: checks of its parameters, and derived constants.
#include "dalembert/items/super_elements/ffrf_reduced_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dalembert/batches/sized_law.hpp"
#include "dalembert/model/value_checks.hpp"

namespace dalembert {
namespace {

using Matrix = DynamicMatrix<double>;

Matrix zeros(int rows, int columns) {
  return {rows, columns, std::vector<double>(static_cast<std::size_t>(rows * columns))};
}

// -int a x b of the blocks -int a~ b~ = int (a . b) I - b a^T: mXRefTildePsi of mXRefTildePsiTilde, mPsiTildePsi of mPsiTildePsiTilde.
Matrix crossed(const Matrix& of) {
  Matrix made = zeros(of.rows, of.columns / 3);
  for (int row = 0; row < made.rows; ++row)
    for (int j = 0; j < made.columns; ++j) {
      const int block = row - row % 3, next = (row + 1) % 3, last = (row + 2) % 3;
      made(row, j) = of(block + last, 3 * j + next) - of(block + next, 3 * j + last);
    }
  return made;
}
// mPhitTPsiTilde of mPhitTPsi.
Matrix tilde(const Matrix& of) {
  Matrix made = zeros(3, 3 * of.columns);
  for (int j = 0; j < of.columns; ++j) {
    const Mat3<double> s = skew(Vec3<double>{of(0, j), of(1, j), of(2, j)});
    for (int i = 0; i < 9; ++i) made(i / 3, 3 * j + i % 3) = s(i / 3, i % 3);
  }
  return made;
}

constexpr const char* interface_class =
    "The class ObjectFFRFreducedOrderInterface of dalembert.FEM computes it from mesh and modes";

// Given parameters must agree with the values that follow from other parameters.
void check_agreement(const char* name, const Matrix& given, const Matrix& made, const std::string& from,
                     const ItemLabel& item) {
  if (given.values.empty()) return;
  check_size(name, given, made.rows, made.columns, item, interface_class);
  double largest = 0, error = 0;
  for (std::size_t i = 0; i < made.values.size(); ++i) {
    largest = std::max(largest, std::abs(made.values[i]));
    error = std::max(error, std::abs(given.values[i] - made.values[i]));
  }
  if (error > 1e-6 * largest + 1e-12)
    refuse(ErrorKind::value,
           {item, name, "it does not belong to " + from, "entries that differ by " + std::to_string(error),
            "integrals of the same mesh and modes, with masses that are the same in all directions", "Leave it empty"});
}

}  // namespace

// A body whose user functions do it all has nothing else.
SizedLaw ObjectFFRFreducedOrder::law(const Parameters& p) {
  SizedLaw law{.force = p.forceUserFunction, .mass = p.massMatrixUserFunction};
  if (p.computeFFRFterms)
    law.matrices = {ConstantMatrix("stiffnessMatrixReduced", StateVector::displacement, p.stiffnessMatrixReduced),
                    ConstantMatrix("dampingMatrixReduced", StateVector::velocity, p.dampingMatrixReduced),
                    ConstantMatrix("massMatrixReduced", StateVector::acceleration, p.massMatrixReduced)};
  return law;
}

void ObjectFFRFreducedOrder::check(const Parameters& p, const Placement& on, const ItemLabel& item) {
  if (on.nodes.size() != 2)
    refuse(ErrorKind::value,
           {item, "nodeNumbers", "", std::to_string(on.nodes.size()) + " nodes",
            "two: the rigid body node of the frame, and a NodeGenericODE2 with the modal coordinates", ""});
  const int modes = on.node_sizes[1], mesh = static_cast<int>(p.referencePositions.size());
  for (int i = on.node_sizes[0]; i < static_cast<int>(on.reference.size()); ++i)
    if (on.reference[static_cast<std::size_t>(i)] != 0)
      refuse(ErrorKind::value,
             {item, "nodeNumbers", "the node of the modal coordinates has reference coordinates that are not zero", "",
              "a reference configuration without deformation", "Use initialCoordinates of the node"});
  if (mesh % 3 != 0)
    refuse(ErrorKind::value,
           {item, "referencePositions", "", std::to_string(mesh) + " numbers", "three for each mesh node", ""});
  if (mesh > 0 || !p.modeBasis.values.empty())
    check_size("modeBasis", p.modeBasis, mesh, modes, item, "One column per mode");
  const OutputVariableType variable = p.outputVariableTypeModeBasis;
  if (variable != OutputVariableType::_None && variable != OutputVariableType::StressLocal &&
      variable != OutputVariableType::StrainLocal)
    refuse(ErrorKind::value, {item, "outputVariableTypeModeBasis", "it is another variable", "",
                              "StressLocal, StrainLocal or _None", ""});
  if (variable != OutputVariableType::_None)
    check_size("outputVariableModeBasis", p.outputVariableModeBasis, mesh / 3, 6 * modes, item, "Six columns per mode");
  if (p.computeFFRFterms || !p.mPhitTPsi.values.empty())
    check_size("mPhitTPsi", p.mPhitTPsi, 3, modes, item, interface_class);
  if (!p.computeFFRFterms) return;
  check_inertia(p.physicsMass, p.physicsInertia, p.physicsCenterOfMass, item);
  check_size("mXRefTildePsiTilde", p.mXRefTildePsiTilde, 3, 3 * modes, item, interface_class);
  check_size("mPsiTildePsiTilde", p.mPsiTildePsiTilde, 3 * modes, 3 * modes, item, interface_class);
  check_agreement("mPhitTPsiTilde", p.mPhitTPsiTilde, tilde(p.mPhitTPsi), "mPhitTPsi", item);
  check_agreement("mXRefTildePsi", p.mXRefTildePsi, crossed(p.mXRefTildePsiTilde), "mXRefTildePsiTilde", item);
  check_agreement("mPsiTildePsi", p.mPsiTildePsi, crossed(p.mPsiTildePsiTilde), "mPsiTildePsiTilde", item);
}

void ObjectFFRFreducedOrder::complete(Parameters& p, const Placement&) {
  p.physicsCenterOfMassTilde = skew(p.physicsCenterOfMass);
  p.objectIsInitialized = true;
  if (!p.computeFFRFterms) return;
  if (p.mPhitTPsiTilde.values.empty()) p.mPhitTPsiTilde = tilde(p.mPhitTPsi);
  if (p.mXRefTildePsi.values.empty()) p.mXRefTildePsi = crossed(p.mXRefTildePsiTilde);
  if (p.mPsiTildePsi.values.empty()) p.mPsiTildePsi = crossed(p.mPsiTildePsiTilde);
}

ModalInertia ObjectFFRFreducedOrder::prepare(const Parameters& p) {
  ModalInertia k;
  k.acts = p.computeFFRFterms;
  if (!k.acts) return k;
  const int modes = k.modes = p.mPhitTPsi.columns;
  k.mass = p.physicsMass;
  k.moment = p.physicsMass * p.physicsCenterOfMass;
  k.inertia = p.physicsInertia;
  for (int j = 0; j < modes; ++j) {
    k.moments.push_back(vector_of<3>([&](int i) { return p.mPhitTPsi(i, j); }));
    k.arms.push_back(vector_of<3>([&](int i) { return p.mXRefTildePsi(i, j); }));
    k.inertias.push_back(
        matrix_of<3, 3>([&](int row, int column) { return p.mXRefTildePsiTilde(row, 3 * j + column); }));
    for (int i = 0; i < 3 * modes; ++i) k.crossed.push_back(p.mPsiTildePsi(3 * (i % modes) + i / modes, j));
    for (int entry = 0; entry < 9; ++entry)
      for (int i = 0; i < modes; ++i) k.products.push_back(p.mPsiTildePsiTilde(3 * i + entry / 3, 3 * j + entry % 3));
  }
  return k;
}

bool ObjectFFRFreducedOrder::mesh_outputs(const Parameters& p, const SizedCoordinates<double>& x, int first, int count,
                                          OutputVariableType variable, std::vector<double>& values) {
  if (variable != p.outputVariableTypeModeBasis || variable == OutputVariableType::_None) return false;
  constexpr std::size_t components = 6;
  const std::size_t columns = static_cast<std::size_t>(p.outputVariableModeBasis.columns), modes = columns / components;
  const double* const zeta = x.u.values + x.count - modes;
  const double* row = p.outputVariableModeBasis.values.data() + static_cast<std::size_t>(first) * columns;
  values.resize(components * static_cast<std::size_t>(count));
  for (double* to = values.data(); to != values.data() + values.size(); to += components, row += columns) {
    std::array<double, components> sums{};
    for (std::size_t mode = 0; mode < modes; ++mode)
      for (std::size_t i = 0; i < components; ++i) sums[i] += row[components * mode + i] * zeta[mode];
    std::ranges::copy(sums, to);
  }
  return true;
}

}  // namespace dalembert
