// ObjectGenericODE2, specs/super_elements/generic_ode2.toml: as many coordinates as its nodes have.
#include <algorithm>
#include <array>

#include "dalembert/batches/mesh_marker.hpp"
#include "dalembert/batches/square_matrix.hpp"
#include "dalembert/batches/user_vector.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/super_elements/generic_ode2_parameters.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {
namespace {

using Parameters = ObjectGenericODE2Parameters;

const Parameters& parameters(const void* record) {
  return static_cast<const ObjectGenericODE2Record*>(record)->parameters;
}

class GenericODE2Batch final : public Term {
 public:
  void add(const void* record, const Placement& placement, const Ports&) override {
    Entry e;
    e.dofs = placement.dofs;
    e.item = placement.item;
    e.read(parameters(record));
    entries_.push_back(std::move(e));
  }
  void refresh(int entry, const void* record) override {
    Entry& e = entries_[entry];
    Entry renewed = e;
    renewed.read(parameters(record));
    if (renewed.full != e.full || !renewed.mass.same_places(e.mass) || !renewed.stiffness.same_places(e.stiffness) ||
        !renewed.damping.same_places(e.damping))
      refuse(ErrorKind::state, {"object " + std::to_string(e.item) + " (ObjectGenericODE2)", "",
                                "its matrices have entries at other places than when the system was assembled", "", "",
                                "Use mbs.ModifyObject(...), then mbs.Assemble()"});
    e = std::move(renewed);
  }
  // A full block for dense matrices and user functions, then the places of the sparse matrices.
  void visit(BlockVisitor& visitor, const Ports&) const override {
    for (const Entry& e : entries_) {
      if (e.full) visitor.block(e.dofs, e.dofs);
      for (const SquareMatrix* m : {&e.stiffness, &e.damping, &e.mass}) m->visit(visitor, e.dofs);
    }
  }

  void residual(const Evaluation& evaluation, Ports&, double* r) const override {
    for (const Entry& e : entries_) {
      e.add_forces(evaluation, r);
      if (!evaluation.inertia) continue;
      if (e.parameters.massMatrixUserFunction) {
        const UserCall user(e, evaluation);
        SquareMatrix({e.n(), e.n(), true, user.mass_matrix(), {}}).add_product(evaluation.a, e.dofs, r);
      } else {
        e.mass.add_product(evaluation.a, e.dofs, r);
      }
    }
  }
  // A mass matrix of a user function is held fixed: its derivatives are not asked for.
  void tangent(const Evaluation& evaluation, const Weights& w, Ports&, double* values) const override {
    SlotCursor slot(slots.data(), values);
    for (const Entry& e : entries_) {
      if (e.full) {
        std::vector<double> block(e.dofs.size() * e.dofs.size(), 0.0);
        for (const auto& [matrix, factor] : e.weighted(w)) matrix->add(factor, std::span(block));
        if (e.has_user_function()) UserCall(e, evaluation).add_derivatives(w, block);
        for (const double entry : block) slot.add(entry);
      }
      for (const auto& [matrix, factor] : e.weighted(w)) matrix->add(factor, slot);
    }
  }
  void mass(const Evaluation& evaluation, Ports& ports, double* values) const override {
    tangent(evaluation, {.q = 0, .v = 0, .a = 1, .y = 0, .y_t = 0}, ports, values);
  }
  bool has_mass() const override { return true; }
  bool constant_mass() const override {
    return std::ranges::none_of(entries_,
                                [](const Entry& e) { return static_cast<bool>(e.parameters.massMatrixUserFunction); });
  }

  bool output(int entry, OutputVariableType variable, const Vec3<double>&, const Evaluation& evaluation, const Ports&,
              std::vector<double>& values) const override {
    if (variable != OutputVariableType::Force) return false;
    const Entry& e = entries_[entry];
    const auto highest = std::ranges::max_element(e.dofs);
    std::vector<double> r(highest == e.dofs.end() ? 0 : static_cast<std::size_t>(*highest) + 1, 0.0);
    e.add_forces(evaluation, r.data());
    values.clear();
    for (const int i : e.dofs) values.push_back(r[i]);
    return true;
  }

 private:
  struct Entry {
    Parameters parameters;
    SquareMatrix mass, stiffness, damping;
    std::vector<int> dofs;
    int item = -1;
    bool full = false;  // needs all n x n places of the tangent

    void read(const Parameters& p) {
      parameters = p;
      stiffness = SquareMatrix(p.stiffnessMatrix);
      damping = SquareMatrix(p.dampingMatrix);
      mass = p.massMatrixUserFunction ? SquareMatrix() : SquareMatrix(p.massMatrix);
      parameters.massMatrix = parameters.stiffnessMatrix = parameters.dampingMatrix = {};
      full = has_user_function();
      for (const SquareMatrix* m : {&stiffness, &damping, &mass}) full = full || (!m->empty() && !m->sparse());
    }
    bool has_user_function() const {
      return parameters.forceUserFunction || parameters.massMatrixUserFunction || parameters.jacobianUserFunction;
    }
    int n() const { return static_cast<int>(dofs.size()); }
    std::array<std::pair<const SquareMatrix*, double>, 3> weighted(const Weights& w) const {
      return {{{&stiffness, w.q}, {&damping, w.v}, {&mass, w.a}}};
    }

    // K q + D q_t - f, with displacements q.
    void add_forces(const Evaluation& evaluation, double* r) const {
      stiffness.add_product(evaluation.u, dofs, r);
      damping.add_product(evaluation.v, dofs, r);
      if (!parameters.forceVector.empty())
        for (std::size_t i = 0; i < dofs.size(); ++i) r[dofs[i]] -= parameters.forceVector[i];
      if (!parameters.forceUserFunction) return;
      std::vector<double> force(dofs.size());
      UserCall(*this, evaluation).force(force);
      for (std::size_t i = 0; i < dofs.size(); ++i) r[dofs[i]] -= force[i];
    }
  };

  // The user functions of one entry at one state.
  class UserCall {
   public:
    UserCall(const Entry& e, const Evaluation& evaluation) : e_(e), time_(evaluation.time) {
      for (const int i : e.dofs) {
        q_.push_back(evaluation.u[i]);
        v_.push_back(evaluation.v[i]);
      }
    }
    void force(std::span<double> f) const {
      const std::array arguments{as_argument(q_), as_argument(v_)};
      e_.parameters.forceUserFunction.callback->call(time_, e_.item, arguments, f);
    }
    std::vector<double> mass_matrix() const {
      std::vector<double> m(q_.size() * q_.size());
      const std::array arguments{as_argument(q_), as_argument(v_)};
      e_.parameters.massMatrixUserFunction.callback->call(time_, e_.item, arguments, m);
      return m;
    }
    void add_derivatives(const Weights& w, std::vector<double>& block) {
      const bool forces = w.q != 0 || w.v != 0;
      if (forces && e_.parameters.jacobianUserFunction) {
        std::vector<double> jacobian(block.size());
        const std::array arguments{as_argument(q_), as_argument(v_), Argument{&w.q}, Argument{&w.v}};
        e_.parameters.jacobianUserFunction.callback->call(time_, e_.item, arguments, jacobian);
        for (std::size_t i = 0; i < block.size(); ++i) block[i] += jacobian[i];
      } else if (forces && e_.parameters.forceUserFunction) {
        const auto evaluate = [&](std::span<double> f) { force(f); };
        add_differences(q_, -w.q, block, evaluate);
        add_differences(v_, -w.v, block, evaluate);
      }
      if (w.a != 0 && e_.parameters.massMatrixUserFunction) {
        const std::vector<double> m = mass_matrix();
        for (std::size_t i = 0; i < block.size(); ++i) block[i] += w.a * m[i];
      }
    }

   private:
    const Entry& e_;
    double time_;
    std::vector<double> q_, v_;
  };

  std::vector<Entry> entries_;
};

struct GenericODE2Physics final : ObjectPhysics {
  std::unique_ptr<Term> make_batch(std::span<const ItemType* const>) const override {
    return std::make_unique<GenericODE2Batch>();
  }
  int mesh_nodes(const void*, const Placement& on) const override { return static_cast<int>(on.nodes.size()); }
  std::vector<int> mesh_coordinates(const void*, const Placement& on, std::span<const int> nodes) const override {
    return node_coordinates(on, nodes);
  }
  std::unique_ptr<MarkerBatch> make_mesh_marker(FrameShape shape,
                                                std::span<const ItemType* const> nodes) const override {
    switch (shape) {
      case FrameShape::point: return make_mesh_position_marker(nodes);
      case FrameShape::rigid: return make_mesh_rigid_marker(nodes);
      default: return nullptr;
    }
  }
  void check(const void* record, const Placement& placement, const Ports&, const ItemLabel& item) const override {
    const Parameters& p = parameters(record);
    const int n = static_cast<int>(placement.dofs.size());
    const auto expected = [&](const std::string& what) {
      return what + ", for the " + std::to_string(n) + " coordinates of the object's nodes, or none";
    };
    const std::string size = std::to_string(n) + " x " + std::to_string(n);
    const std::pair<const char*, const MatrixContainer*> matrices[] = {
        {"massMatrix", &p.massMatrix}, {"stiffnessMatrix", &p.stiffnessMatrix}, {"dampingMatrix", &p.dampingMatrix}};
    for (const auto& [name, m] : matrices)
      if (!m->empty() && (m->rows != n || m->columns != n))
        refuse(ErrorKind::value,
               {item, name, "", "a matrix of " + std::to_string(m->rows) + " x " + std::to_string(m->columns),
                expected("a matrix of " + size), ""});
    if (!p.forceVector.empty() && p.forceVector.size() != placement.dofs.size())
      refuse(ErrorKind::value, {item, "forceVector", "", "a vector of length " + std::to_string(p.forceVector.size()),
                                expected("a vector of length " + std::to_string(n)), ""});
  }
};

}  // namespace

const Physics& object_generic_ode2_physics() {
  static const GenericODE2Physics physics;
  return physics;
}

}  // namespace dalembert
