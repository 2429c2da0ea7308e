// ObjectConnectorCoordinateVector, specs/constraints/coordinate_vector.toml: one equation per row of its matrices.
#include <algorithm>
#include <array>

#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/batches/user_vector.hpp"
#include "dalembert/constraints/coordinate_vector_parameters.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {
namespace {

using Parameters = ObjectConnectorCoordinateVectorParameters;
using Matrix = DynamicMatrix<double>;

const Parameters& parameters(const void* record) {
  return static_cast<const ObjectConnectorCoordinateVectorRecord*>(record)->parameters;
}
int equations(const Parameters& p) {
  return std::max(
      {p.scalingMarker0.rows, p.scalingMarker1.rows, p.quadraticTermMarker0.rows, p.quadraticTermMarker1.rows});
}

// The part of one marker: sign * (X q + Y q^2), q and its rates v.
struct Side {
  const Matrix& linear;
  const Matrix& quadratic;
  double sign;
  const double* q;
  const double* v;
  int n;

  Side(const Parameters& p, const Ports& ports, int marker, bool first)
      : linear(first ? p.scalingMarker0 : p.scalingMarker1),
        quadratic(first ? p.quadraticTermMarker0 : p.quadraticTermMarker1),
        sign(first ? -1 : 1),
        q(ports.frame(marker)),
        v(q + ports.ports[marker].values / 2),
        n(ports.ports[marker].values / 2) {}

  double x(int k, int i) const { return linear.values.empty() ? 0.0 : linear(k, i); }
  double y(int k, int i) const { return quadratic.values.empty() ? 0.0 : quadratic(k, i); }
  double of(int k, const double* values) const {
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += (x(k, i) + y(k, i) * values[i]) * values[i];
    return sign * sum;
  }
  double slope(int k, int i, const double* values) const { return sign * (x(k, i) + 2 * y(k, i) * values[i]); }
};

class CoordinateVectorBatch final : public Term {
 public:
  void add(const void* record, const Placement& placement, const Ports&) override {
    Entry e{parameters(record), {placement.markers[0], placement.markers[1]}, {}, placement.item, placement.first_ae};
    for (int k = 0; k < equations(e.parameters); ++k) e.rows.push_back(placement.ae_offset + placement.first_ae + k);
    entries_.push_back(std::move(e));
  }
  void refresh(int entry, const void* record) override {
    Entry& e = entries_[entry];
    const Parameters& p = parameters(record);
    if (equations(p) != static_cast<int>(e.rows.size()) || quadratic(p) != quadratic(e.parameters))
      refuse(ErrorKind::state,
             {"object " + std::to_string(e.item) + " (ObjectConnectorCoordinateVector)", "",
              "its matrices have changed their sizes since the system was assembled", "", "", "Use mbs.ModifyObject(...), then mbs.Assemble()"});
    e.parameters = p;
  }
  void visit(BlockVisitor& visitor, const Ports& ports) const override {
    for (const Entry& e : entries_) {
      const auto dofs = all_dofs<2>(ports, e.markers);
      visitor.block(e.rows, dofs);
      visitor.mirror(e.rows, dofs);
      for (const int row : e.rows) visitor.entry(row, row);
      if (quadratic(e.parameters))
        for (const int marker : e.markers) visitor.block(ports.marker_dofs(marker), ports.marker_dofs(marker));
    }
  }

  void residual(const Evaluation& evaluation, Ports& ports, double* r) const override {
    for (const Entry& e : entries_) {
      const double* lambda = evaluation.lambda + e.first_ae;
      const int m = static_cast<int>(e.rows.size());
      if (!e.parameters.activeConnector) {
        for (int k = 0; k < m; ++k) r[e.rows[k]] += lambda[k];
        continue;
      }
      const std::vector<double> gaps = e.gaps(evaluation, ports), gradient = e.gradient(evaluation, ports);
      for (int k = 0; k < m; ++k) r[e.rows[k]] += gaps[k];
      const double* row = gradient.data();
      for (int k = 0; k < m; ++k)
        for (const int marker : e.markers) {
          double* force = ports.force(marker);
          for (int i = 0; i < ports.ports[marker].values / 2; ++i) force[i] -= *row++ * lambda[k];
        }
    }
  }

  // Second derivatives of a user function are left out: its Jacobian is held fixed.
  void tangent(const Evaluation& evaluation, const Weights& w, Ports& ports, double* values) const override {
    SlotCursor slot(slots.data(), values);
    for (const Entry& e : entries_) {
      const bool active = e.parameters.activeConnector;
      const int m = static_cast<int>(e.rows.size()), columns = Columns<2>(ports, e.markers).total;
      if (active) {
        const std::vector<double> gradient = e.gradient(evaluation, ports);
        const auto [by_q, by_v] = e.partials(evaluation, ports, gradient);
        add_gap_rows(e, by_q, by_v, 1 / (w.q != 0 ? w.q : w.v), ports, slot);
        add_multiplier_columns(e, gradient, ports, slot);
      } else {
        slot.skip(2 * m * columns);
      }
      for (int k = 0; k < m; ++k) slot.add(active ? 0.0 : 1.0);
      if (quadratic(e.parameters)) add_curvature(e, active ? evaluation.lambda + e.first_ae : nullptr, ports, slot);
    }
  }

  bool output(int entry, OutputVariableType variable, const Vec3<double>&, const Evaluation& evaluation,
              const Ports& ports, std::vector<double>& values) const override {
    const Entry& e = entries_[entry];
    const Side m0(e.parameters, ports, e.markers[0], true), m1(e.parameters, ports, e.markers[1], false);
    const double* lambda = evaluation.lambda + e.first_ae;
    const auto difference = [&](const double* from, int n0, const double* to, int n1) {
      values.assign(static_cast<std::size_t>(std::max(n0, n1)), 0.0);
      for (int i = 0; i < n1; ++i) values[i] += to[i];
      for (int i = 0; i < n0; ++i) values[i] -= from[i];
    };
    switch (variable) {
      case OutputVariableType::Displacement: difference(m0.q, m0.n, m1.q, m1.n); return true;
      case OutputVariableType::Velocity: difference(m0.v, m0.n, m1.v, m1.n); return true;
      case OutputVariableType::Force: values.assign(lambda, lambda + e.rows.size()); return true;
      case OutputVariableType::ConstraintEquation:
        values = e.parameters.activeConnector ? e.gaps(evaluation, ports)
                                              : std::vector<double>(lambda, lambda + e.rows.size());
        return true;
      default: return false;
    }
  }

 private:
  struct Entry {
    Parameters parameters;
    std::array<int, 2> markers{};
    std::vector<int> rows;  // in the system vector
    int item = -1, first_ae = -1;

    std::array<Side, 2> sides(const Ports& ports) const {
      return {Side(parameters, ports, markers[0], true), Side(parameters, ports, markers[1], false)};
    }
    bool rate_level(const Evaluation& evaluation) const { return parameters.velocityLevel || evaluation.rate_level; }

    // q, v of both markers and the level, as arguments of a user function.
    void call(const UserFunction& f, const Evaluation& evaluation, const Ports& ports, bool level,
              std::span<double> results) const {
      std::vector<double> q, v;
      for (const Side& s : sides(ports)) {
        q.insert(q.end(), s.q, s.q + s.n);
        v.insert(v.end(), s.v, s.v + s.n);
      }
      const double flag = level ? 1 : 0;
      const std::array arguments{as_argument(q), as_argument(v), Argument{&flag}};
      f.callback->call(evaluation.time, item, arguments, results);
    }

    std::vector<double> gaps(const Evaluation& evaluation, const Ports& ports) const {
      std::vector<double> c(rows.size(), 0.0);
      const Parameters& p = parameters;
      if (p.constraintUserFunction) {
        call(p.constraintUserFunction, evaluation, ports, rate_level(evaluation), c);
        return c;
      }
      const bool rate = rate_level(evaluation), own = p.velocityLevel;
      for (int k = 0; k < static_cast<int>(c.size()); ++k) {
        for (const Side& s : sides(ports)) {
          if (!rate || own) {
            c[k] += s.of(k, own ? s.v : s.q);
          } else {
            for (int i = 0; i < s.n; ++i) c[k] += s.slope(k, i, s.q) * s.v[i];
          }
        }
        if ((!rate || own) && !p.offset.empty()) c[k] -= p.offset[k];
      }
      return c;
    }

    // Rows by coordinates of both markers: directions of the reaction.
    std::vector<double> gradient(const Evaluation& evaluation, const Ports& ports) const {
      const auto both = sides(ports);
      std::vector<double> g(rows.size() * static_cast<std::size_t>(both[0].n + both[1].n), 0.0);
      if (parameters.jacobianUserFunction && parameters.constraintUserFunction) {
        user_gradient(evaluation, ports, both, g);
        return g;
      }
      double* to = g.data();
      for (int k = 0; k < static_cast<int>(rows.size()); ++k)
        for (const Side& s : both)
          for (int i = 0; i < s.n; ++i) *to++ = s.slope(k, i, s.q);
      return g;
    }

    // The user function has no columns for the single coordinate of a marker on ground.
    void user_gradient(const Evaluation& evaluation, const Ports& ports, const std::array<Side, 2>& both,
                       std::vector<double>& g) const {
      std::array<bool, 2> moves{};
      std::size_t columns = 0;
      for (int i = 0; i < 2; ++i) {
        moves[i] = ports.ports[markers[i]].n > 0;
        columns += moves[i] ? static_cast<std::size_t>(both[i].n) : 0;
      }
      std::vector<double> given(rows.size() * columns);
      call(parameters.jacobianUserFunction, evaluation, ports, parameters.velocityLevel, given);
      auto from = given.begin();
      auto to = g.begin();
      for (std::size_t k = 0; k < rows.size(); ++k)
        for (int i = 0; i < 2; ++i) {
          if (moves[i]) {
            std::copy_n(from, both[i].n, to);
            from += both[i].n;
          }
          to += both[i].n;
        }
    }

    // Derivatives of the gaps by the coordinates and by the velocity coordinates.
    std::pair<std::vector<double>, std::vector<double>> partials(const Evaluation& evaluation, const Ports& ports,
                                                                 const std::vector<double>& gradient) const {
      std::vector<double> zero(gradient.size(), 0.0);
      if (!rate_level(evaluation)) return {gradient, zero};
      if (parameters.constraintUserFunction) return {zero, gradient};
      std::vector<double> by_q = zero, by_v = gradient;
      std::size_t at = 0;
      for (int k = 0; k < static_cast<int>(rows.size()); ++k)
        for (const Side& s : sides(ports))
          for (int i = 0; i < s.n; ++i, ++at) {
            if (parameters.velocityLevel) {
              by_v[at] = s.slope(k, i, s.v);
            } else {
              by_q[at] = 2 * s.sign * s.y(k, i) * s.v[i];
            }
          }
      return {by_q, by_v};
    }
  };

  static bool quadratic(const Parameters& p) {
    return !p.constraintUserFunction &&
           (!p.quadraticTermMarker0.values.empty() || !p.quadraticTermMarker1.values.empty());
  }

  static void add_gap_rows(const Entry& e, const std::vector<double>& by_q, const std::vector<double>& by_v,
                           double scale, const Ports& ports, SlotCursor& slot) {
    std::size_t at = 0;
    for (std::size_t k = 0; k < e.rows.size(); ++k)
      for (const int marker : e.markers) {
        const int n = ports.ports[marker].n, values = ports.ports[marker].values / 2;
        const double* derivative = ports.derivative(marker);
        for (int j = 0; j < n; ++j) {
          double sum = 0;
          for (int i = 0; i < values; ++i)
            sum += by_q[at + i] * derivative[i * n + j] + by_v[at + i] * derivative[(values + i) * n + j];
          slot.add(scale * sum);
        }
        at += values;
      }
  }
  static void add_multiplier_columns(const Entry& e, const std::vector<double>& gradient, const Ports& ports,
                                     SlotCursor& slot) {
    std::size_t at = 0;
    for (std::size_t k = 0; k < e.rows.size(); ++k)
      for (const int marker : e.markers) {
        const int n = ports.ports[marker].n, values = ports.ports[marker].values / 2;
        const double* jacobian = ports.jacobian(marker);
        for (int j = 0; j < n; ++j) {
          double sum = 0;
          for (int i = 0; i < values; ++i) sum += gradient[at + i] * jacobian[i * n + j];
          slot.add(sum);
        }
        at += values;
      }
  }
  // Multipliers times second derivatives of the quadratic terms.
  static void add_curvature(const Entry& e, const double* lambda, const Ports& ports, SlotCursor& slot) {
    for (const Side& s : e.sides(ports)) {
      const int marker = e.markers[s.sign < 0 ? 0 : 1], n = ports.ports[marker].n;
      if (lambda == nullptr) {
        slot.skip(n * n);
        continue;
      }
      std::vector<double> bend(static_cast<std::size_t>(s.n), 0.0);
      for (int k = 0; k < static_cast<int>(e.rows.size()); ++k)
        for (int i = 0; i < s.n; ++i) bend[i] += 2 * s.sign * s.y(k, i) * lambda[k];
      const double* derivative = ports.derivative(marker);
      const double* jacobian = ports.jacobian(marker);
      for (int r = 0; r < n; ++r)
        for (int c = 0; c < n; ++c) {
          double sum = 0;
          for (int i = 0; i < s.n; ++i) sum += jacobian[i * n + r] * bend[i] * derivative[i * n + c];
          slot.add(sum);
        }
    }
  }

  std::vector<Entry> entries_;
};

struct CoordinateVectorPhysics final : ObjectPhysics {
  std::unique_ptr<Term> make_batch(std::span<const ItemType* const>) const override {
    return std::make_unique<CoordinateVectorBatch>();
  }
  int algebraic_equations(const void* record, std::span<const int>) const override {
    return equations(parameters(record));
  }

  void check(const void* record, const Placement& placement, const Ports& ports,
             const ItemLabel& item) const override {
    const Parameters& p = parameters(record);
    const int m = equations(p);
    if (m == 0)
      refuse(ErrorKind::value,
             {item, "scalingMarker0", "all matrices are empty", "", "a matrix with one row per equation", ""});
    if (p.constraintUserFunction) {
      if (!p.jacobianUserFunction)
        refuse(ErrorKind::value, {item, "jacobianUserFunction", "it is missing", "",
                                  "a function that gives the derivatives of constraintUserFunction", ""});
      return;
    }
    check_matrix(p.scalingMarker0, "scalingMarker0", m, columns(ports, placement, 0), item);
    check_matrix(p.scalingMarker1, "scalingMarker1", m, columns(ports, placement, 1), item);
    check_matrix(p.quadraticTermMarker0, "quadraticTermMarker0", m, columns(ports, placement, 0), item);
    check_matrix(p.quadraticTermMarker1, "quadraticTermMarker1", m, columns(ports, placement, 1), item);
    if (!p.offset.empty() && static_cast<int>(p.offset.size()) != m)
      refuse(ErrorKind::value, {item, "offset", "", "a vector of length " + std::to_string(p.offset.size()),
                                "a vector of length " + std::to_string(m) + ", one value per equation, or none", ""});
  }

 private:
  static int columns(const Ports& ports, const Placement& placement, int side) {
    return ports.ports[placement.markers[side]].values / 2;
  }
  // The matrix of a marker without coordinates is not used.
  static void check_matrix(const Matrix& matrix, const char* name, int m, int n, const ItemLabel& item) {
    if (matrix.values.empty() || n == 0 || (matrix.rows == m && matrix.columns == n)) return;
    refuse(ErrorKind::value,
           {item, name, "", "a matrix of " + std::to_string(matrix.rows) + " x " + std::to_string(matrix.columns),
            "a matrix of " + std::to_string(m) + " x " + std::to_string(n) +
                ", one row per equation and one column per coordinate of the marker, or none",
            ""});
  }
};

}  // namespace

const Physics& object_connector_coordinate_vector_physics() {
  static const CoordinateVectorPhysics physics;
  return physics;
}

}  // namespace dalembert
