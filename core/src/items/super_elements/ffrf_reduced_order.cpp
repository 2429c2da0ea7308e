// ObjectFFRFreducedOrder: what its parameters have to be, and the constants that follow from them.
#include "dalembert/items/super_elements/ffrf_reduced_order.hpp"

#include <algorithm>
#include <cmath>

#include "dalembert/model/value_checks.hpp"

namespace dalembert {
namespace {

using Parameters = ObjectFFRFreducedOrderParameters;
using Matrix = DynamicMatrix<double>;

bool is_empty(const Matrix& m) { return m.rows * m.columns == 0; }

// Three components of a x b, from entries of -a~ b~ = (a . b) I - b a^T, with the sign that integrals of the kind -a x b have.
Vec3<double> crossed(const Matrix& m, int row, int column) {
  const auto skew_part = [&](int i, int j) { return m(row + i, column + j) - m(row + j, column + i); };
  return {skew_part(2, 1), skew_part(0, 2), skew_part(1, 0)};
}

// mXRefTildePsi of mXRefTildePsiTilde, mPsiTildePsi of mPsiTildePsiTilde: the blocks of three rows and columns, mode by mode.
Matrix crossed(const Matrix& of) {
  Matrix made{of.rows, of.columns / 3, std::vector<double>(of.values.size() / 3)};
  for (int i = 0; i < made.rows; i += 3)
    for (int j = 0; j < made.columns; ++j) {
      const Vec3<double> c = crossed(of, i, 3 * j);
      for (int axis = 0; axis < 3; ++axis) made(i + axis, j) = c[axis];
    }
  return made;
}
// mPhitTPsiTilde of mPhitTPsi.
Matrix tilde(const Matrix& of) {
  Matrix made{3, 3 * of.columns, std::vector<double>(static_cast<std::size_t>(9 * of.columns))};
  for (int mode = 0; mode < of.columns; ++mode) {
    const Mat3<double> s = skew(Vec3<double>{of(0, mode), of(1, mode), of(2, mode)});
    for (int i = 0; i < 9; ++i) made(i / 3, 3 * mode + i % 3) = s.x[static_cast<std::size_t>(i)];
  }
  return made;
}

class Checked {
 public:
  Checked(const ItemLabel& item, int modes) : item_(item), modes_(modes) {}

  void size(const char* name, const Matrix& m, int rows, int columns) const {
    if (m.rows == rows && m.columns == columns) return;
    const auto of = [](int r, int c) { return "a matrix of " + std::to_string(r) + " x " + std::to_string(c); };
    refuse(ErrorKind::value, {item_, name, "", of(m.rows, m.columns), of(rows, columns) + ", for " + std::to_string(modes_) + " modes",
                              "The class ObjectFFRFreducedOrderInterface of dalembert.FEM computes it from mesh and modes"});
  }
  // What is given twice must agree.
  void follows(const char* name, const Matrix& given, const Matrix& made, const char* from) const {
    if (is_empty(given)) return;
    size(name, given, made.rows, made.columns);
    double largest = 0, error = 0;
    for (std::size_t i = 0; i < made.values.size(); ++i) {
      largest = std::max(largest, std::abs(made.values[i]));
      error = std::max(error, std::abs(given.values[i] - made.values[i]));
    }
    if (error > 1e-6 * largest + 1e-12)
      refuse(ErrorKind::value, {item_, name, std::string("it does not belong to ") + from + ": they differ by " + std::to_string(error), "",
                                "integrals of the same mesh and modes, with a mass matrix that is the same in all directions",
                                "Leave it empty: it follows from " + std::string(from)});
  }

 private:
  const ItemLabel& item_;
  int modes_;
};

int modes_of(const Parameters& p) { return p.mPhitTPsi.columns; }

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
    refuse(ErrorKind::value, {item, "nodeNumbers", "", std::to_string(on.nodes.size()) + " nodes",
                              "two: the rigid body node of the frame, and a NodeGenericODE2 with the modal coordinates", ""});
  const int modes = on.node_sizes[1], mesh = static_cast<int>(p.referencePositions.size());
  for (int i = on.node_sizes[0]; i < static_cast<int>(on.reference.size()); ++i)
    if (on.reference[static_cast<std::size_t>(i)] != 0)
      refuse(ErrorKind::value, {item, "nodeNumbers", "the node of the modal coordinates has reference coordinates that are not zero", "",
                                "a reference configuration without deformation", "Use initialCoordinates of the node"});
  const Checked checked(item, modes);
  if (mesh % 3 != 0)
    refuse(ErrorKind::value, {item, "referencePositions", "", std::to_string(mesh) + " numbers", "three for each mesh node", ""});
  if (mesh > 0 || !is_empty(p.modeBasis)) checked.size("modeBasis", p.modeBasis, mesh, modes);
  const bool has_output = p.outputVariableTypeModeBasis != OutputVariableType::_None;
  if (has_output && p.outputVariableTypeModeBasis != OutputVariableType::StressLocal &&
      p.outputVariableTypeModeBasis != OutputVariableType::StrainLocal)
    refuse(ErrorKind::value, {item, "outputVariableTypeModeBasis", "another variable", "", "StressLocal, StrainLocal or _None", ""});
  if (has_output || !is_empty(p.outputVariableModeBasis))
    checked.size("outputVariableModeBasis", p.outputVariableModeBasis, has_output ? mesh / 3 : 0, has_output ? 6 * modes : 0);
  if (!p.computeFFRFterms) return;
  check_inertia(p.physicsMass, p.physicsInertia, p.physicsCenterOfMass, item);
  checked.size("mPhitTPsi", p.mPhitTPsi, 3, modes);
  checked.size("mXRefTildePsiTilde", p.mXRefTildePsiTilde, 3, 3 * modes);
  checked.size("mPsiTildePsiTilde", p.mPsiTildePsiTilde, 3 * modes, 3 * modes);
  checked.follows("mPhitTPsiTilde", p.mPhitTPsiTilde, tilde(p.mPhitTPsi), "mPhitTPsi");
  checked.follows("mXRefTildePsi", p.mXRefTildePsi, crossed(p.mXRefTildePsiTilde), "mXRefTildePsiTilde");
  checked.follows("mPsiTildePsi", p.mPsiTildePsi, crossed(p.mPsiTildePsiTilde), "mPsiTildePsiTilde");
}

void ObjectFFRFreducedOrder::complete(Parameters& p) {
  p.physicsCenterOfMassTilde = skew(p.physicsCenterOfMass);
  p.objectIsInitialized = true;
  if (!p.computeFFRFterms) return;
  if (is_empty(p.mPhitTPsiTilde)) p.mPhitTPsiTilde = tilde(p.mPhitTPsi);
  if (is_empty(p.mXRefTildePsi)) p.mXRefTildePsi = crossed(p.mXRefTildePsiTilde);
  if (is_empty(p.mPsiTildePsi)) p.mPsiTildePsi = crossed(p.mPsiTildePsiTilde);
}

ModalInertia ObjectFFRFreducedOrder::prepare(const Parameters& p) {
  ModalInertia k;
  k.acts = p.computeFFRFterms;
  if (!k.acts) return k;
  const int modes = k.modes = modes_of(p);
  k.mass = p.physicsMass;
  k.moment = p.physicsMass * p.physicsCenterOfMass;
  k.inertia = p.physicsInertia;
  k.moments = p.mPhitTPsi.values;
  for (int j = 0; j < modes; ++j) {
    k.arms.push_back(vector_of<3>([&](int i) { return p.mXRefTildePsi(i, j); }));
    k.inertias.push_back(matrix_of<3, 3>([&](int row, int column) { return p.mXRefTildePsiTilde(row, 3 * j + column); }));
    for (int i = 0; i < 3; ++i)
      for (int other = 0; other < modes; ++other) k.crossed.push_back(p.mPsiTildePsi(3 * other + i, j));
    for (int entry = 0; entry < 9; ++entry)
      for (int other = 0; other < modes; ++other)
        k.products.push_back(p.mPsiTildePsiTilde(3 * other + entry / 3, 3 * j + entry % 3));
  }
  return k;
}

bool ObjectFFRFreducedOrder::mesh_output(const Parameters& p, const SizedCoordinates<double>& x, int node, OutputVariableType variable,
                                         std::vector<double>& values) {
  if (variable != p.outputVariableTypeModeBasis || variable == OutputVariableType::_None) return false;
  constexpr int components = 6;
  const int modes = p.outputVariableModeBasis.columns / components;
  values.assign(components, 0.0);
  for (int mode = 0; mode < modes; ++mode)
    for (int i = 0; i < components; ++i)
      values[static_cast<std::size_t>(i)] += p.outputVariableModeBasis(node, components * mode + i) * x.u[x.count - modes + mode];
  return true;
}

}  // namespace dalembert
