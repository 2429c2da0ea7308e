// Residual, matrices K, D, M and the factors of a step matrix at any state; values of sensors with their gradients.
//
//   K = dr/d[q, y, lambda]    D = dr/dv    M = dr/da        (derivatives with respect to rotations of Lie-group nodes are
//                                                            those along increments in the body frame)
//   J = ck K B + cv D + ca M                               (B: 3 x 3 blocks at the rotations of Lie-group nodes, otherwise 1)
//
// At the level of accelerations, constraint equations are second derivatives of gaps (first derivatives of those of
// velocities) along the motion, and M contains their rows.
//
// States are arrays [q, v, a, y, y_t, lambda, data]. Several vectors are rows of an array.
#include "system_derivatives.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "dalembert/linear/linear_solver.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/solvers/constrained_motion.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/system/switches.hpp"
#include "main_system.hpp"

namespace dalembert {
namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Rows = py::array_t<double>;

constexpr int most_dense_unknowns = 32;  // as solvers choose

class SystemDerivatives {
 public:
  SystemDerivatives(std::shared_ptr<MainSystem> main, bool rate_level, bool inertia) : main_(std::move(main)) {
    System& system = main_->assembled("SystemDerivatives");
    version_ = system.version();
    n_ = system.sizes();
    state_ = system.state(ConfigurationType::Initial);
    state_.a.resize(static_cast<std::size_t>(n_.ode2));
    state_.y_t.resize(static_cast<std::size_t>(n_.ode1));
    state_.lambda.resize(static_cast<std::size_t>(n_.ae));
    state_.sign = MultiplierSign::motion;
    conditions_.rate_level = rate_level;
    conditions_.inertia = inertia;
    system.complete_pattern();
    pattern_ = &system.pattern(n_.total() <= most_dense_unknowns);
    const auto values = static_cast<std::size_t>(pattern_->values());
    for (auto* matrix : {&k_, &d_, &m_, &j_}) matrix->assign(values, 0.0);
    residual_.assign(static_cast<std::size_t>(n_.total()), 0.0);
  }
  SystemDerivatives(const SystemDerivatives&) = delete;
  SystemDerivatives& operator=(const SystemDerivatives&) = delete;

  Rows residual(const Array& z, double time, double step_size) {
    System& system = take(z, time, step_size);
    Rows r(static_cast<py::ssize_t>(residual_.size()));
    evaluate(system, {r.mutable_data(), residual_.size()});
    return r;
  }

  // The weighted sum of the residuals of several systems with equal unknowns.
  static Rows residual_sum(const std::vector<SystemDerivatives*>& systems, const std::vector<double>& weights,
                           const std::vector<Array>& states, double time, double step_size) {
    if (systems.empty() || weights.size() != systems.size() || states.size() != systems.size())
      refuse(ErrorKind::value, {.item = "testing.residual_sum",
                                .parameter = "systems",
                                .received = std::to_string(systems.size()) + " systems",
                                .expected = "as many as weights and states"});
    const std::size_t total = systems.front()->residual_.size();
    Rows sum(static_cast<py::ssize_t>(total));
    double* to = sum.mutable_data();
    std::fill_n(to, total, 0.0);
    for (std::size_t k = 0; k < systems.size(); ++k) {
      SystemDerivatives& one = *systems[k];
      System& system = one.take(states[k], time, step_size);
      one.evaluate(system, one.residual_);
      if (one.residual_.size() != total)
        refuse(ErrorKind::value,
               {.item = "testing.residual_sum", .parameter = "systems", .expected = "systems of equal size"});
      for (std::size_t i = 0; i < total; ++i) to[i] += weights[k] * one.residual_[i];
    }
    return sum;
  }

  // Residuals at states in rows: sums over all states of weights times residuals, entry by entry. weights: states x outputs x
  // equations; the result: outputs x equations. One system at a time stays in the caches.
  Rows weighted_residuals(const Array& states, const Array& times, double step_size, const Array& weights) {
    const py::ssize_t count = check_states(states, times);
    const auto total = static_cast<py::ssize_t>(residual_.size());
    if (weights.ndim() != 3 || weights.shape(0) != count || weights.shape(2) != total)
      refuse(ErrorKind::value, {.item = "testing.SystemDerivatives",
                                .parameter = "weights",
                                .received = std::to_string(weights.size()) + " numbers",
                                .expected = "states x outputs x equations"});
    const py::ssize_t outputs = weights.shape(1);
    Rows result({outputs, total});
    double* const sums = result.mutable_data();
    std::fill_n(sums, outputs * total, 0.0);
    for (py::ssize_t k = 0; k < count; ++k) {
      evaluate(take_from(states.data(k, 0), times.data()[k], step_size), residual_);
      for (py::ssize_t o = 0; o < outputs; ++o) {
        const double* w = weights.data(k, o, 0);
        for (py::ssize_t i = 0; i < total; ++i) sums[o * total + i] += w[i] * residual_[static_cast<std::size_t>(i)];
      }
    }
    return result;
  }

  // Residuals at states in rows.
  Rows residuals(const Array& states, const Array& times, double step_size) {
    const py::ssize_t count = check_states(states, times);
    const auto total = static_cast<py::ssize_t>(residual_.size());
    Rows result({count, total});
    for (py::ssize_t k = 0; k < count; ++k)
      evaluate(take_from(states.data(k, 0), times.data()[k], step_size), {result.mutable_data(k, 0), residual_.size()});
    return result;
  }

  // Gaps of constraints at a level other than that of the equations.
  Rows gaps(const Array& z, double time, bool rate_level) {
    System& system = take(z, time, conditions_.step_size);
    Conditions conditions = conditions_;
    conditions.rate_level = rate_level;
    Rows g(n_.ae);
    system.gaps(state_, conditions, {g.mutable_data(), static_cast<std::size_t>(n_.ae)});
    return g;
  }

  // Switches of items at a state: (value, whether forces have a kink only, noise, object or -1, what).
  py::list switches(const Array& z, double time, double step_size) {
    System& system = take(z, time, step_size);
    std::vector<Switch> found;
    system.find_switches(state_, conditions_, found);
    py::list result;
    for (const Switch& at : found) result.append(py::make_tuple(at.value, at.kink, at.noise, at.item, at.what));
    return result;
  }

  // Data coordinates after a step that ends at a state, whose data are those of the step.
  Rows switch_over(const Array& z, double time, double step_size) {
    System& system = take(z, time, step_size);
    system.switch_over(state_, conditions_);
    return array(state_.data);
  }

  // D is found with K, because closed forms of some items need both: K + step D, minus K.
  void linearize(const Array& z, double time, double step_size, std::optional<bool> rate_level) {
    System& system = take(z, time, step_size);
    Conditions conditions = conditions_;
    if (rate_level) conditions.rate_level = *rate_level;
    system.tangent(state_, conditions, {.q = 1, .v = 0, .a = 0, .y = 1, .y_t = 0}, *pattern_, k_);
    if (!conditions.inertia) return;  // D and M stay zero
    const double weight = step_size > 0 ? 1 / step_size : 1;
    system.tangent(state_, conditions, {.q = 1, .v = weight, .a = 0, .y = 1, .y_t = 0}, *pattern_, d_);
    for (std::size_t i = 0; i < d_.size(); ++i) d_[i] = (d_[i] - k_[i]) / weight;
    system.mass_matrix(state_, *pattern_, m_);
    if (acceleration_level_ && !rate_level && n_.ae > 0) linearize_gap_accelerations(system);
  }

  // Factors of each part of the matrix: K, D and M in the equations of motion (and K, D in those of first order); K and D
  // in constraints; K in the columns of first-order coordinates, and minus dr/dydot there.
  // Returns -1, or the unknown without a pivot. `scale` multiplies ODE2 equations and divides multipliers, for the
  // selection of pivots only.
  int factorize(const std::array<double, 7>& factors, const std::optional<Array>& blocks, double scale,
                bool transposed) {
    const auto& [ck, cv, ca, gk, gv, cy, cy_t] = factors;
    const int n = n_.ode2, first_ae = n_.first_ae();
    const auto value_at = [&, ck = ck, cv = cv, ca = ca, gk = gk, gv = gv, cy = cy, cy_t = cy_t](int row, int column,
                                                                                                 std::size_t slot) {
      if (column >= first_ae) return k_[slot];
      if (column >= n) return cy * k_[slot] - (row == column ? cy_t : 0.0);
      if (row >= first_ae) return gk * k_[slot] + gv * d_[slot] + ca * m_[slot];
      return ck * k_[slot] + cv * d_[slot] + (row < n ? ca * m_[slot] : 0.0);
    };
    const auto scale_of = [n, first_ae, scale](int row, int column) {
      return (row < n ? scale : 1.0) * (column >= first_ae ? 1 / scale : 1.0);
    };
    for_each_entry(*pattern_, [&](int row, int column, std::size_t slot) {
      j_[slot] = scale_of(row, column) * value_at(row, column, slot);
    });
    if (blocks) add_blocks(*blocks, ck * scale, gk);
    scale_ = scale;
    transposed_ = transposed;
    if (transposed) transpose();
    if (!factors_) {
      const auto type = pattern_->is_dense() ? LinearSolverType::EXUdense : LinearSolverType::EigenSparse;
      factors_ = make_linear_solver(*pattern_, type, {.unsettled_matrices = 8});
    }
    return factors_->factorize(j_);
  }

  Rows solve(const Array& right) {
    Rows result = rows_like(right, n_.total(), n_.total());
    const auto total = static_cast<std::size_t>(n_.total()), n = static_cast<std::size_t>(n_.ode2),
               first_ae = static_cast<std::size_t>(n_.first_ae());
    const double before = transposed_ ? 1 : scale_, of_multipliers = transposed_ ? 1 / scale_ : 1;
    for (py::ssize_t k = 0; k < right.shape(0); ++k) {
      const double* from = right.data() + static_cast<std::size_t>(k) * total;
      double* x = result.mutable_data() + static_cast<std::size_t>(k) * total;
      std::copy_n(from, total, x);
      for (std::size_t i = 0; i < n; ++i) x[i] *= before;
      for (std::size_t i = first_ae; i < total; ++i) x[i] *= of_multipliers;
      factors_->solve({x, total});
      for (std::size_t i = 0; i < n; ++i) x[i] *= transposed_ ? scale_ : 1;
      for (std::size_t i = first_ae; i < total; ++i) x[i] *= transposed_ ? 1 : 1 / scale_;
    }
    return result;
  }

  // K x, of all unknowns, or D v, of velocities, for each row; or the products with the transposed matrices.
  Rows product(char matrix, const Array& x, bool transposed) {
    const std::vector<double>& values = matrix == 'K' ? k_ : matrix == 'D' ? d_ : m_;
    const int columns = matrix == 'K' ? n_.total() : n_.ode2,
              rows = matrix == 'M' && !acceleration_level_ ? n_.ode2 : n_.total();
    const int length = transposed ? rows : columns, result_length = transposed ? columns : rows;
    Rows result = rows_like(x, length, result_length);
    const auto count = static_cast<std::size_t>(x.shape(0));
    // Entry by entry, for all rows at once.
    std::vector<double> from(count * static_cast<std::size_t>(length)),
        to(count * static_cast<std::size_t>(result_length), 0.0);
    const auto turn = [count](const double* rows_of, double* columns_of, std::size_t size) {
      for (std::size_t k = 0; k < count; ++k)
        for (std::size_t i = 0; i < size; ++i) columns_of[i * count + k] = rows_of[k * size + i];
    };
    turn(x.data(), from.data(), static_cast<std::size_t>(length));
    for_each_entry(*pattern_, [&](int row, int column, std::size_t slot) {
      const double value = values[slot];
      if (value == 0 || column >= columns || row >= rows) return;
      const double* __restrict in = from.data() + static_cast<std::size_t>(transposed ? row : column) * count;
      double* __restrict out = to.data() + static_cast<std::size_t>(transposed ? column : row) * count;
      for (std::size_t k = 0; k < count; ++k) out[k] += value * in[k];
    });
    double* found = result.mutable_data();
    for (std::size_t i = 0; i < static_cast<std::size_t>(result_length); ++i)
      for (std::size_t k = 0; k < count; ++k)
        found[k * static_cast<std::size_t>(result_length) + i] = to[i * count + k];
    return result;
  }

  // One step backwards, with factors of the transposed matrix. coefficients: h, c_v, c_a, c_b, then those of a and b in the
  // predictions of q, v and b. ends: derivatives of outputs (rows) with respect to q, v, a, b, y, y_t and lambda at the end.
  // turns: derivatives of rotations at the end with respect to increments, rotations, predicted increments and velocities.
  // Returns the derivatives with respect to the start, without those by lambda, which are zero, and the solutions w.
  py::tuple step_back(const std::array<double, 10>& coefficients, const std::array<Array, 7>& ends,
                      const std::optional<std::array<Array, 4>>& turns) {
    const auto [h, c_v, c_a, c_b, p_a, p_b, r_a, r_b, m_a, m_b] = coefficients;
    const auto& [q_end, v_end, a_end, b_end, y_end, y_t_end, lambda_end] = ends;
    const py::ssize_t rows = q_end.shape(0);
    const int n = n_.ode2, n1 = n_.ode1, first_ae = n_.first_ae();
    for (int part = 0; part < 7; ++part) {
      const Array& end = ends[static_cast<std::size_t>(part)];
      rows_like(end, part < 4 ? n : part < 6 ? n1 : n_.ae, 0);
      if (end.shape(0) != rows)
        refuse(ErrorKind::value,
               {.item = "testing.SystemDerivatives", .parameter = "ends", .expected = "parts with equal rows"});
    }
    Rows right({rows, static_cast<py::ssize_t>(n_.total())});
    for (py::ssize_t o = 0; o < rows; ++o) {
      double* x = mutable_row(right, o);
      std::copy_n(row(q_end, o), n, x);
      if (turns) transform_rotations((*turns)[0], row(q_end, o), x, false);
      const double *v = row(v_end, o), *a = row(a_end, o), *b = row(b_end, o);
      for (int i = 0; i < n; ++i) x[i] += c_v * v[i] + c_a * (a[i] + c_b * b[i]);
      for (int i = 0; i < n1; ++i) x[n + i] = row(y_end, o)[i] + 2 / h * row(y_t_end, o)[i];
      for (int k = 0; k < n_.ae; ++k) x[first_ae + k] = row(lambda_end, o)[k];
    }
    const Rows w = solve(right);
    const Rows by_k = product('K', w, true), by_d = product('D', w, true);
    const auto made = [rows](int size) { return Rows({rows, static_cast<py::ssize_t>(size)}); };
    Rows q_start = made(n), v_start = made(n), a_start = made(n), b_start = made(n), y_start = made(n1),
         y_t_start = made(n1);
    std::vector<double> of_end(static_cast<std::size_t>(n)), increment(of_end.size());
    for (py::ssize_t o = 0; o < rows; ++o) {
      double *q = mutable_row(q_start, o), *v = mutable_row(v_start, o), *a = mutable_row(a_start, o),
             *b = mutable_row(b_start, o);
      const double *kw = row(by_k, o), *dw = row(by_d, o), *q0 = row(q_end, o), *v0 = row(v_end, o),
                   *b0 = row(b_end, o);
      for (int i = 0; i < n; ++i) {
        q[i] = increment[static_cast<std::size_t>(i)] = of_end[static_cast<std::size_t>(i)] = q0[i] - kw[i];
        v[i] = v0[i] - dw[i];
      }
      if (turns) {
        transform_rotations((*turns)[1], of_end.data(), q, false);
        transform_rotations((*turns)[2], of_end.data(), increment.data(), false);
        transform_rotations((*turns)[3], of_end.data(), v, true);
      }
      for (int i = 0; i < n; ++i) {
        const double dq = increment[static_cast<std::size_t>(i)];
        a[i] = p_a * dq + r_a * v[i] + m_a * b0[i];
        b[i] = p_b * dq + r_b * v[i] + m_b * b0[i];
        v[i] += h * dq;
      }
      for (int i = 0; i < n1; ++i) {
        const double y = row(y_end, o)[i] - kw[n + i];
        mutable_row(y_start, o)[i] = y;
        mutable_row(y_t_start, o)[i] = 0.5 * h * y;
      }
    }
    return py::make_tuple(q_start, v_start, a_start, b_start, y_start, y_t_start, w);
  }

  Rows compose(const Array& q, const Array& increment) {
    check(q, n_.ode2, "q");
    check(increment, n_.ode2, "increment");
    std::vector<double> result(q.data(), q.data() + q.size());
    move(current(), {q.data(), static_cast<std::size_t>(q.size())},
         {increment.data(), static_cast<std::size_t>(increment.size())}, result);
    return Rows(static_cast<py::ssize_t>(result.size()), result.data());
  }

  Rows sensor(int number, const Array& z, double time) {
    take(z, time, conditions_.step_size);
    return array(measured(number));
  }

  // Derivatives of the values of a sensor (rows) by entries of z, by central differences of fourth order; rotations of
  // Lie-group nodes vary by increments.
  Rows sensor_gradient(int number, const Array& z, double time, const std::vector<int>& entries,
                       const std::vector<double>& steps) {
    take(z, time, conditions_.step_size);
    const State middle = state_;
    const std::size_t values = measured(number).size();
    Rows result({values, entries.size()});
    for (std::size_t k = 0; k < entries.size(); ++k) {
      std::vector<double> sum(values, 0.0);
      for (const auto& [multiple, weight] : differences) {
        state_ = middle;
        vary(entries[k], multiple * steps[k]);
        const std::vector<double> found = measured(number);
        for (std::size_t i = 0; i < values; ++i) sum[i] += weight / steps[k] * found[i];
      }
      for (std::size_t i = 0; i < values; ++i)
        *result.mutable_data(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) = sum[i];
    }
    state_ = middle;
    return result;
  }

  void set_acceleration_level(bool on) { acceleration_level_ = on; }
  bool acceleration_level() const { return acceleration_level_; }

  // Constraint equations whose gaps user functions prescribe in time.
  std::vector<int> driven(const Array& z, double time, double end_time) {
    System& system = take(z, time, conditions_.step_size);
    const std::vector<char> found = driven_equations(system, state_, conditions_, end_time);
    std::vector<int> result;
    for (std::size_t k = 0; k < found.size(); ++k)
      if (found[k]) result.push_back(static_cast<int>(k));
    return result;
  }

  std::vector<int> rotations() {
    std::vector<int> found;
    for (const System::LieBlock& block : current().lie_blocks()) found.push_back(block.rotation);
    return found;
  }
  std::vector<double> static_signs() {
    const auto signs = current().static_signs();
    return {signs.begin(), signs.end()};
  }
  std::vector<int> sizes() const { return {n_.ode2, n_.ode1, n_.ae, n_.data}; }

 private:
  struct Difference {
    double multiple, weight;
  };
  static constexpr std::array<Difference, 4> differences{
      {{-2, 1.0 / 12}, {-1, -8.0 / 12}, {1, 8.0 / 12}, {2, -1.0 / 12}}};

  void evaluate(System& system, std::span<double> residual) {
    system.residual(state_, conditions_, residual);
    if (!acceleration_level_ || n_.ae == 0) return;
    // Multipliers of inactive constraints, which have no gaps.
    const auto count = static_cast<std::size_t>(n_.ae);
    const std::span<double> sum = residual.subspan(static_cast<std::size_t>(n_.first_ae()), count);
    std::vector<double> part(count);
    system.gaps(state_, of_rates(), sum);
    std::ranges::fill(state_.lambda, 0.0);
    system.gaps(state_, of_rates(), part);
    for (std::size_t k = 0; k < count; ++k) sum[k] -= part[k];
    along_motion([&](double weight) {
      system.gaps(state_, of_rates(), part);
      for (std::size_t k = 0; k < count; ++k) sum[k] += weight * part[k];
    });
  }

  Conditions of_rates() const {
    Conditions conditions = conditions_;
    conditions.rate_level = true;
    return conditions;
  }

  // Calls `add(weight)` at positions q + e v and velocities v + e a, for differences by e of fourth order.
  template <class Add>
  void along_motion(const Add& add) {
    const State middle = state_;
    double speed = 0, size = 1;
    for (const double v : middle.v) speed = std::max(speed, std::abs(v));
    for (const double q : middle.q) size = std::max(size, std::abs(q));
    double rate = speed;  // of velocities, if these change faster
    for (const double a : middle.a) rate = std::max(rate, std::abs(a) * size / std::max(speed, size));
    const double e = relative_step * size / std::max(rate, 1e-10 * size);
    std::vector<double> increment(middle.q.size());
    for (const auto& [multiple, weight] : differences) {
      for (std::size_t i = 0; i < increment.size(); ++i) {
        increment[i] = multiple * e * middle.v[i];
        state_.v[i] = middle.v[i] + multiple * e * middle.a[i];
      }
      move(current(), middle.q, increment, state_.q);
      add(weight / e);
    }
    state_ = middle;
  }

  // Writes the rows of the constraints in K, D and M. For gap rates g(q, v), along q' = v and v' = a, these rows are:
  //   dK/de, of rotations of Lie-group nodes less K times (v x), because increments are those at q;  K + dD/de;  D
  void linearize_gap_accelerations(System& system) {
    std::vector<double> by_q(k_.size()), both(k_.size());
    const int first_ae = n_.first_ae();
    const auto of_constraints = [&](auto&& each) {
      for_each_entry(*pattern_, [&](int row, int column, std::size_t slot) {
        if (row >= first_ae && column < n_.ode2) each(slot);
      });
    };
    const auto tangents = [&] {  // `both`: K + D
      system.tangent(state_, of_rates(), {.q = 1, .v = 0, .a = 0, .y = 1, .y_t = 0}, *pattern_, by_q);
      system.tangent(state_, of_rates(), {.q = 1, .v = 1, .a = 0, .y = 1, .y_t = 0}, *pattern_, both);
    };
    tangents();
    of_constraints([&](std::size_t slot) {
      m_[slot] = both[slot] - by_q[slot];
      d_[slot] = by_q[slot];
      k_[slot] = 0.0;
    });
    for (const System::LieBlock& block : system.lie_blocks()) {
      const double* v = state_.v.data() + block.rotation;
      const std::array<std::array<double, 3>, 3> cross{{{0, -v[2], v[1]}, {v[2], 0, -v[0]}, {-v[1], v[0], 0}}};
      for_each_row(*pattern_, block.rotation, [&](int row) {
        if (row < first_ae) return;
        const auto slot = [&](int i) { return static_cast<std::size_t>(pattern_->slot(row, block.rotation + i)); };
        for (int j = 0; j < 3; ++j)
          for (int i = 0; i < 3; ++i)
            k_[slot(j)] -= by_q[slot(i)] * cross[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      });
    }
    along_motion([&](double weight) {
      tangents();
      of_constraints([&](std::size_t slot) {
        k_[slot] += weight * by_q[slot];
        d_[slot] += weight * (both[slot] - by_q[slot]);
      });
    });
  }
  static constexpr double relative_step = 2e-3;

  System& current() {
    System& system = main_->assembled("SystemDerivatives");
    if (system.version() != version_)
      refuse(ErrorKind::state, {.item = "testing.SystemDerivatives",
                                .problem = "the system was assembled again",
                                .advice = "Make a new one."});
    return system;
  }

  static void check(const Array& values, int size, const char* name) {
    if (values.ndim() == 1 && values.size() == size) return;
    refuse(ErrorKind::value, {.item = "testing.SystemDerivatives",
                              .parameter = name,
                              .received = std::to_string(values.size()) + " numbers",
                              .expected = std::to_string(size) + " numbers"});
  }

  int length() const { return 3 * n_.ode2 + 2 * n_.ode1 + n_.ae + n_.data; }

  py::ssize_t check_states(const Array& states, const Array& times) const {
    if (states.ndim() != 2 || states.shape(1) != length() || times.size() != states.shape(0))
      refuse(ErrorKind::value, {.item = "testing.SystemDerivatives",
                                .parameter = "states",
                                .received = std::to_string(states.size()) + " numbers",
                                .expected = "rows of " + std::to_string(length()) + " numbers, and as many times"});
    return states.shape(0);
  }

  System& take(const Array& z, double time, double step_size) {
    check(z, length(), "z");
    return take_from(z.data(), time, step_size);
  }

  System& take_from(const double* from, double time, double step_size) {
    for (auto* part : {&state_.q, &state_.v, &state_.a, &state_.y, &state_.y_t, &state_.lambda, &state_.data}) {
      std::copy_n(from, part->size(), part->begin());
      from += part->size();
    }
    state_.time = time;
    conditions_.step_size = step_size;
    return current();
  }

  static Rows rows_like(const Array& rows, int length, int result_length) {
    if (rows.ndim() != 2 || rows.shape(1) != length)
      refuse(ErrorKind::value, {.item = "testing.SystemDerivatives",
                                .parameter = "rows",
                                .received = std::to_string(rows.size()) + " numbers",
                                .expected = "rows of " + std::to_string(length) + " numbers"});
    return Rows({rows.shape(0), static_cast<py::ssize_t>(result_length)});
  }

  // Rows of arrays that may be empty.
  template <class Numbers>
  static const double* row(const Numbers& rows, py::ssize_t number) {
    return rows.data() + number * rows.shape(1);
  }
  static double* mutable_row(Rows& rows, py::ssize_t number) { return rows.mutable_data() + number * rows.shape(1); }
  static Rows array(const std::vector<double>& values) {
    return Rows(static_cast<py::ssize_t>(values.size()), values.data());
  }

  // Replaces K by K B in the columns of rotations.
  void add_blocks(const Array& blocks, double ck, double gk) {
    const int first_ae = n_.first_ae();
    const double* b = blocks.data();
    for (const System::LieBlock& block : current().lie_blocks()) {
      for_each_row(*pattern_, block.rotation, [&](int row) {
        std::array<std::size_t, 3> slots{};
        for (int j = 0; j < 3; ++j)
          slots[static_cast<std::size_t>(j)] = static_cast<std::size_t>(pattern_->slot(row, block.rotation + j));
        for (int j = 0; j < 3; ++j) {
          double sum = -k_[slots[static_cast<std::size_t>(j)]];
          for (int i = 0; i < 3; ++i) sum += k_[slots[static_cast<std::size_t>(i)]] * b[3 * i + j];
          j_[slots[static_cast<std::size_t>(j)]] += (row < first_ae ? ck : gk) * sum;
        }
      });
      b += 9;
    }
  }

  void transpose() {
    const std::vector<double> values = j_;
    if (pattern_->is_dense()) {
      for_each_entry(*pattern_, [&](int row, int column, std::size_t slot) {
        j_[static_cast<std::size_t>(pattern_->slot(column, row))] = values[slot];
      });
    } else {
      pattern_->for_each_transposed([&](int slot, int transposed) {
        j_[static_cast<std::size_t>(transposed)] = values[static_cast<std::size_t>(slot)];
      });
    }
  }

  // Products of transposed 3 x 3 matrices with the rotations of Lie-group nodes in x; they replace those in y, or are added.
  void transform_rotations(const Array& matrices, const double* x, double* y, bool adds) {
    const auto blocks = current().lie_blocks();
    if (matrices.size() != static_cast<py::ssize_t>(9 * blocks.size()))
      refuse(
          ErrorKind::value,
          {.item = "testing.SystemDerivatives", .parameter = "turns", .expected = "a 3 x 3 matrix for each rotation"});
    const double* m = matrices.data();
    for (const System::LieBlock& block : blocks) {
      const double* from = x + block.rotation;
      for (int j = 0; j < 3; ++j) {
        const double sum = m[j] * from[0] + m[3 + j] * from[1] + m[6 + j] * from[2];
        double& to = y[block.rotation + j];
        to = adds ? to + sum : sum;
      }
      m += 9;
    }
  }

  static void move(const System& system, std::span<const double> from, std::span<const double> increment,
                   std::vector<double>& q) {
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = from[i] + increment[i];
    if (system.has_lie_nodes()) system.compose(from, increment, q);
  }

  void vary(int entry, double by) {
    const auto i = static_cast<std::size_t>(entry);
    if (entry < n_.ode2) {
      std::vector<double> increment(state_.q.size(), 0.0);
      const std::vector<double> from = state_.q;
      increment[i] = by;
      return move(current(), from, increment, state_.q);
    }
    std::size_t first = state_.q.size();
    for (auto* part : {&state_.v, &state_.a, &state_.y, &state_.y_t, &state_.lambda}) {
      if (i < first + part->size()) {
        (*part)[i - first] += by;
        return;
      }
      first += part->size();
    }
  }

  std::vector<double> measured(int sensor) {
    System& system = current();
    system.state(ConfigurationType::Current) = state_;  // in place: vectors keep their addresses
    std::vector<double> values;
    system.sensor_values(sensor, ConfigurationType::Current, values);
    return values;
  }

  std::shared_ptr<MainSystem> main_;
  std::uint64_t version_ = 0;
  Sizes n_;
  State state_;
  Conditions conditions_;
  const Pattern* pattern_ = nullptr;
  std::vector<double> k_, d_, m_, j_, residual_;
  std::unique_ptr<LinearSolver> factors_;
  double scale_ = 1;
  bool transposed_ = false, acceleration_level_ = false;
};

Rows current_state(const std::shared_ptr<MainSystem>& main) {
  const State& state = main->assembled("current_state").state(ConfigurationType::Current);
  const std::array parts{&state.q, &state.v, &state.a, &state.y, &state.y_t, &state.lambda, &state.data};
  std::size_t length = 0;
  for (const auto* part : parts) length += part->size();
  Rows z(static_cast<py::ssize_t>(length));
  double* to = z.mutable_data();
  for (const auto* part : parts) to = std::copy(part->begin(), part->end(), to);
  return z;
}

}  // namespace

void register_system_derivatives(py::module_& testing) {
  using D = SystemDerivatives;
  py::class_<D> c(testing, "SystemDerivatives",
                  "Residual, matrices and sensors of an assembled system at states z = [q, v, a, y, y_t, lam, data]. "
                  "Several vectors "
                  "are rows of an array. rate_level, inertia: see State.");
  c.def(py::init<std::shared_ptr<MainSystem>, bool, bool>(), py::arg("mbs"), py::kw_only(),
        py::arg("rate_level") = false, py::arg("inertia") = true);
  testing.def("current_state", &current_state, py::arg("mbs"), "The current state while a solver runs: z.");
  const auto z = py::arg("z"), time = py::arg("time"), step_size = py::arg("step_size");
  c.def("residual", &D::residual, z, time, step_size, "Residual of [ODE2, ODE1, AE].");
  c.def("residuals", &D::residuals, py::arg("states"), py::arg("times"), step_size, "Residuals at states in rows.");
  c.def("weighted_residuals", &D::weighted_residuals, py::arg("states"), py::arg("times"), step_size,
        py::arg("weights"),
        "Sums over states of weights (states x outputs x equations) times residuals, entry by entry.");
  testing.def("residual_sum", &D::residual_sum, py::arg("systems"), py::arg("weights"), py::arg("states"), time,
              step_size, "Weighted sum of the residuals of SystemDerivatives, each at a state of its own.");
  c.def("gaps", &D::gaps, z, time, py::arg("rate_level"), "Algebraic equations alone, as positions or as rates.");
  c.def("switches", &D::switches, z, time, step_size,
        "Switches of items: (value, whether it is a kink only, noise, object or -1, what). A negative value, or any "
        "change of sign of a kink, is an event.");
  c.def("switch_over", &D::switch_over, z, time, step_size,
        "Data coordinates after a step, given the data of the step.");
  c.def("linearize", &D::linearize, z, time, step_size, py::arg("rate_level") = py::none(),
        "Compute K = dr/d[q, y, lam], D = dr/dv and M = dr/da; rate_level: other than that of the equations.");
  c.def("factorize", &D::factorize, py::arg("factors"), py::arg("blocks") = py::none(), py::arg("scale") = 1.0,
        py::arg("transposed") = false,
        "Factors of a sum of K, D and M, or of its transposed. factors: those of K, D, M in the equations of motion, "
        "of K, D in constraints, of "
        "K and -1 in the columns of first-order coordinates; blocks: 3 x 3 matrices by which K is multiplied from the "
        "right at the rotations of "
        "Lie-group nodes. Returns -1, or the unknown without a pivot.");
  c.def("solve", &D::solve, py::arg("right"), "Solutions for right-hand sides, with the last factors.");
  c.def("product", &D::product, py::arg("matrix"), py::arg("x"), py::arg("transposed") = false,
        "K x, D v or M a for each row, matrix: 'K', 'D' or 'M'; or the products with the transposed matrix.");
  c.def("step_back", &D::step_back, py::arg("coefficients"), py::arg("ends"), py::arg("turns") = py::none(),
        "One step of generalized alpha backwards, with factors of the transposed matrix.");
  c.def("compose", &D::compose, py::arg("q"), py::arg("increment"),
        "q after an increment; rotations of Lie-group nodes are composed.");
  c.def("sensor", &D::sensor, py::arg("number"), z, time, "Values of a sensor. The current state becomes z.");
  c.def("sensor_gradient", &D::sensor_gradient, py::arg("number"), z, time, py::arg("entries"), py::arg("steps"),
        "Derivatives of the values of a sensor by entries of z, by central differences of fourth order with these "
        "steps.");
  c.def("driven", &D::driven, z, time, py::arg("end_time"),
        "Constraint equations whose gaps user functions prescribe in time.");
  c.def_property("acceleration_level", &D::acceleration_level, &D::set_acceleration_level,
                 "Whether constraint equations are those of accelerations: in residuals, and in K, D and M where no "
                 "rate_level is given.");
  c.def_property_readonly("rotations", &D::rotations, "First coordinates of the rotations of Lie-group nodes.");
  c.def_property_readonly(
      "static_signs", &D::static_signs,
      "-1 for multipliers, whose sign is opposite in static solutions; 1 for algebraic coordinates.");
  c.def_property_readonly("sizes", &D::sizes, "Numbers of ODE2, ODE1, algebraic and data coordinates.");
}

}  // namespace dalembert
