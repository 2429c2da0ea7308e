// ObjectFFRF: checks of its parameters, and derived constants.
#include "dalembert/items/super_elements/ffrf.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "dalembert/batches/sized_law.hpp"

namespace dalembert {
namespace {

using Triplets = std::vector<MatrixContainer::Triplet>;

// Nonzero entries, row by row.
Triplets entries_of(const MatrixContainer& m) {
  if (!m.dense) return SquareMatrix(m).entries();
  Triplets entries;
  for (int row = 0; row < m.rows; ++row)
    for (int column = 0; column < m.columns; ++column)
      if (const double value = m.values[static_cast<std::size_t>(row * m.columns + column)]; value != 0)
        entries.push_back({row, column, value});
  return entries;
}

// A mass matrix that no rotation changes has the same masses in all directions.
void check_directions(const Triplets& entries, const ItemLabel& item) {
  double largest = 0;
  for (const auto& e : entries) largest = std::max(largest, std::abs(e.value));
  for (const auto& e : entries)
    if (e.row % 3 != e.column % 3 && std::abs(e.value) > 1e-6 * largest)
      refuse(ErrorKind::value,
             {item, "massMatrixFF",
              "its entry (" + std::to_string(e.row) + ", " + std::to_string(e.column) + ") couples two directions",
              std::to_string(e.value), "0: a mass matrix of three coordinates per node that no rotation changes", ""});
}

}  // namespace

// A body whose user functions do it all has nothing else.
SizedLaw ObjectFFRF::law(const Parameters& p) {
  SizedLaw law{.force = p.forceUserFunction, .mass = p.massMatrixUserFunction};
  if (p.computeFFRFterms)
    law.matrices = {ConstantMatrix("stiffnessMatrixFF", StateVector::displacement, p.stiffnessMatrixFF),
                    ConstantMatrix("dampingMatrixFF", StateVector::velocity, p.dampingMatrixFF)};
  return law;
}

void ObjectFFRF::check(const Parameters& p, const Placement& on, const ItemLabel& item) {
  const auto nodes = on.nodes.size();
  if (nodes < 2)
    refuse(ErrorKind::value, {item, "nodeNumbers", "", std::to_string(nodes) + " nodes",
                              "the rigid body node of the frame, and those of the mesh", ""});
  const auto size = [&](const char* name, std::size_t received, std::size_t expected) {
    if (received != expected)
      refuse(ErrorKind::value, {item, name, "", std::to_string(received), std::to_string(expected), ""});
  };
  if (!p.forceVector.empty()) size("forceVector", p.forceVector.size(), on.dofs.size());
  if (!p.computeFFRFterms) return;
  size("massMatrixFF (rows)", static_cast<std::size_t>(p.massMatrixFF.rows), 3 * (nodes - 1));
  size("massMatrixFF (columns)", static_cast<std::size_t>(p.massMatrixFF.columns), 3 * (nodes - 1));
  check_directions(entries_of(p.massMatrixFF), item);
}

void ObjectFFRF::complete(Parameters& p, const Placement& on) {
  p.objectIsInitialized = true;
  p.coordinateIndexPerNode.clear();
  int next = 0;
  for (const int size : on.node_sizes) p.coordinateIndexPerNode.push_back(std::exchange(next, next + size));
  p.referencePositions.assign(on.reference.begin() + on.node_sizes[0], on.reference.end());
  const auto n = static_cast<int>(p.referencePositions.size());
  p.PHItTM = {3, n, std::vector<double>(static_cast<std::size_t>(3 * n))};
  p.physicsMass = 0;
  p.physicsCenterOfMass = {};
  p.physicsInertia = {};
  if (!p.computeFFRFterms) return;
  const auto node = [&p](int coordinate) { return load<double, 3>(p.referencePositions.data() + coordinate / 3 * 3); };
  for (const auto& [row, column, mass] : entries_of(p.massMatrixFF)) {
    p.PHItTM(row % 3, column) += mass;
    if (row % 3 != 0 || column % 3 != 0) continue;  // it is the same in the other directions
    const Vec3<double> a = node(row), b = node(column);
    p.physicsMass += mass;
    p.physicsCenterOfMass += mass * b;
    p.physicsInertia = p.physicsInertia + (-mass) * (skew(a) * skew(b));
  }
  if (p.physicsMass != 0) p.physicsCenterOfMass = (1 / p.physicsMass) * p.physicsCenterOfMass;
}

MeshInertia ObjectFFRF::prepare(const Parameters& p) {
  MeshInertia k;
  if (!p.computeFFRFterms) return k;
  k.coordinates = static_cast<int>(p.referencePositions.size());
  k.rest = p.referencePositions;
  k.force = p.forceVector;
  k.whole.resize(p.referencePositions.size() / 3);
  k.begins.assign(p.referencePositions.size() + 1, 0);
  for (const auto& [row, column, mass] : entries_of(p.massMatrixFF)) {
    k.entries.push_back({column, mass});
    ++k.begins[static_cast<std::size_t>(row) + 1];
    k.whole[static_cast<std::size_t>(row / 3)](row % 3, column % 3) += mass;
  }
  for (std::size_t i = 1; i < k.begins.size(); ++i) k.begins[i] += k.begins[i - 1];
  return k;
}

}  // namespace dalembert
