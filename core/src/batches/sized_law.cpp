#include "dalembert/batches/sized_law.hpp"

#include <algorithm>
#include <string>

#include "dalembert/batches/user_vector.hpp"

namespace dalembert {
namespace {

const double* vector_of(const Evaluation& e, StateVector which) {
  switch (which) {
    case StateVector::displacement: return e.u;
    case StateVector::velocity: return e.v;
    case StateVector::acceleration: return e.a;
    case StateVector::first_order: return e.y;
  }
  return nullptr;
}
double weight_of(const Weights& w, StateVector which) {
  switch (which) {
    case StateVector::displacement: return w.q;
    case StateVector::velocity: return w.v;
    case StateVector::acceleration: return w.a;
    case StateVector::first_order: return w.y;
  }
  return 0;
}

void pick(const double* from, std::span<const int> places, std::vector<double>& to) {
  to.clear();
  for (const int i : places) to.push_back(from[i]);
}

}  // namespace

void LawOfBody::place(int order, const Placement& placement, int begin) {
  item_ = placement.item;
  order_ = order;
  begin_ = static_cast<std::size_t>(begin);
  dofs_ = rows_ = order == 2 ? placement.dofs : placement.ode1;
  if (order == 1)
    for (int& row : rows_) row += placement.ode1_offset;
}

void LawOfBody::read(const SizedLaw& law, bool with_residual) {
  force_ = law.force;
  mass_ = law.mass;
  jacobian_ = law.jacobian;
  force_vector_ = law.force_vector == nullptr ? std::vector<double>() : *law.force_vector;
  full_ = with_residual || law.has_user_function();
  forceless_ = !force_ && force_vector_.empty();
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    terms_[i].times = law.matrices[i].times;
    law.matrices[i].make(terms_[i].matrix);
    full_ = full_ || (!terms_[i].matrix.empty() && !terms_[i].matrix.sparse());
    forceless_ = forceless_ && (terms_[i].times == StateVector::acceleration || terms_[i].matrix.empty());
  }
}

bool LawOfBody::take_force(const SizedLaw& law) {
  if (law.force_vector == nullptr || law.force_vector->size() != force_vector_.size()) return false;
  std::ranges::copy(*law.force_vector, force_vector_.begin());
  return true;
}

bool LawOfBody::same_places(const LawOfBody& other) const {
  const auto alike = [](const Term& a, const Term& b) { return a.matrix.same_places(b.matrix); };
  return full_ == other.full_ && std::ranges::equal(terms_, other.terms_, alike);
}

void LawOfBody::Work::make_room(const LawOfBody& law) {
  const std::size_t n = law.dofs_.size();
  if (!law.force_ && !law.mass_ && !law.jacobian_) return;
  q.reserve(n);
  v.reserve(n);
  force.resize(std::max(force.size(), n));
  if (law.mass_ || law.jacobian_) matrix.resize(std::max(matrix.size(), n * n));
}

void LawOfBody::visit(BlockVisitor& visitor) const {
  if (full_) visitor.block(rows_, rows_);
  for (const Term& term : terms_) term.matrix.visit(visitor, own_rows());
}

void LawOfBody::take_arguments(const UserFunction& f, const Evaluation& evaluation, Work& work) const {
  pick(order_ == 1 ? evaluation.y : f.callback->takes_total_coordinates() ? evaluation.q : evaluation.u, dofs_, work.q);
  if (order_ == 2) pick(evaluation.v, dofs_, work.v);
}
void LawOfBody::repeat(const UserFunction& f, double time, const Work& work, std::span<double> result,
                       bool known) const {
  const std::array all{as_argument(work.q), as_argument(work.v)};
  const std::span arguments = std::span(all).first(static_cast<std::size_t>(order_));
  known ? f.callback->recall(time, item_, arguments, result) : f.callback->call(time, item_, arguments, result);
}
void LawOfBody::call(const UserFunction& f, const Evaluation& evaluation, Work& work, std::span<double> result) const {
  take_arguments(f, evaluation, work);
  repeat(f, evaluation.time, work, result, evaluation.same_state);
}

// Equations of second order have forces on the other side.
void LawOfBody::add_forces(const Evaluation& evaluation, Work& work, double* r) const {
  if (forceless_) return;
  const double sign = order_ == 2 ? -1 : 1;
  for (const Term& term : terms_)
    if (term.times != StateVector::acceleration)
      term.matrix.add_product(vector_of(evaluation, term.times), own_dofs(), r, own_rows());
  for (std::size_t i = 0; i < force_vector_.size(); ++i) r[own_rows()[i]] += sign * force_vector_[i];
  if (!force_) return;
  const std::span<double> force = std::span(work.force).first(dofs_.size());
  call(force_, evaluation, work, force);
  for (std::size_t i = 0; i < force.size(); ++i) r[rows_[i]] += sign * force[i];
}

void LawOfBody::add_inertia(const Evaluation& evaluation, Work& work, double* r) const {
  for (const Term& term : terms_)
    if (term.times == StateVector::acceleration) term.matrix.add_product(evaluation.a, own_dofs(), r, own_rows());
  if (!mass_) return;
  const std::size_t n = dofs_.size();
  const std::span<double> mass = std::span(work.matrix).first(n * n);
  call(mass_, evaluation, work, mass);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) r[rows_[i]] += mass[i * n + j] * evaluation.a[dofs_[j]];
}

// A mass matrix of a user function is held fixed: its derivatives are not asked for.
void LawOfBody::add_tangent(const Evaluation& evaluation, const Weights& w, Work& work, std::span<double> block) const {
  const std::size_t n = dofs_.size();
  for (const Term& term : terms_) term.matrix.add(weight_of(w, term.times), block, n);
  const bool moves = order_ == 1 ? w.y != 0 : w.q != 0 || w.v != 0;
  if (moves && jacobian_) {
    take_arguments(jacobian_, evaluation, work);
    const std::array arguments{as_argument(work.q), as_argument(work.v), Argument{&w.q}, Argument{&w.v}};
    jacobian_.callback->call(evaluation.time, item_, arguments, std::span(work.matrix).first(n * n));
    for (std::size_t i = 0; i < n * n; ++i) block[i] += work.matrix[i];
  } else if (moves && force_) {
    const std::span<double> force = std::span(work.force).first(n);
    call(force_, evaluation, work, force);
    std::vector<double> values(n);
    const auto evaluate = [&](std::span<double> f) { repeat(force_, evaluation.time, work, f); };
    const auto derivative_from = [&](int first) {
      return [&, first](int number, std::span<double> slopes) -> bool {
        const std::array all{as_argument(work.q), as_argument(work.v)};
        if (!force_.callback->has_derivatives()) return false;
        const int moving = first + number;
        force_.callback->linearize(evaluation.time, item_, std::span(all).first(static_cast<std::size_t>(order_)),
                                   std::span(&moving, 1), values, slopes);
        return std::ranges::all_of(slopes, [](double x) { return std::isfinite(x); });
      };
    };
    add_derivatives(work.q, order_ == 2 ? -w.q : w.y, force, block, evaluate, derivative_from(0));
    if (order_ == 2) add_derivatives(work.v, -w.v, force, block, evaluate, derivative_from(static_cast<int>(n)));
  }
  if (w.a == 0 || !mass_) return;
  call(mass_, evaluation, work, std::span(work.matrix).first(n * n));
  for (std::size_t i = 0; i < n * n; ++i) block[i] += w.a * work.matrix[i];
}

void LawOfBody::add_sparse(const Weights& w, SlotCursor& slot) const {
  for (const Term& term : terms_) term.matrix.add(weight_of(w, term.times), slot);
}

namespace {

std::string matrix_of(int rows, int columns) {
  return "a matrix of " + std::to_string(rows) + " x " + std::to_string(columns);
}

}  // namespace

void check_sizes(const SizedLaw& law, int coordinates, std::string_view called, const ItemLabel& item) {
  const auto for_nodes = [&] {
    return ", for the " + std::to_string(coordinates) + " " + std::string(called) + ", or none";
  };
  for (const ConstantMatrix& m : law.matrices)
    if (!m.empty() && (m.rows != coordinates || m.columns != coordinates))
      refuse(ErrorKind::value, {item, m.parameter, "", matrix_of(m.rows, m.columns),
                                matrix_of(coordinates, coordinates) + for_nodes(), ""});
  if (law.force_vector != nullptr && !law.force_vector->empty() &&
      law.force_vector->size() != static_cast<std::size_t>(coordinates))
    refuse(ErrorKind::value,
           {item, law.force_parameter, "", "a vector of length " + std::to_string(law.force_vector->size()),
            "a vector of length " + std::to_string(coordinates) + for_nodes(), ""});
}

void check_size(const char* parameter, const DynamicMatrix<double>& m, int rows, int columns, const ItemLabel& item,
                const char* advice) {
  if (m.rows != rows || m.columns != columns)
    refuse(ErrorKind::value, {item, parameter, "", matrix_of(m.rows, m.columns), matrix_of(rows, columns), advice});
}

}  // namespace dalembert
