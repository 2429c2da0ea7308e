// ObjectConnectorCoordinateVector, specs/constraints/coordinate_vector.toml: one equation per row of its matrices.
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <vector>

#include "dalembert/batches/user_vector.hpp"
#include "dalembert/constraints/coordinate_vector_parameters.hpp"
#include "dalembert/contracts/many_ports.hpp"

namespace dalembert {

struct ObjectConnectorCoordinateVector : AllMarkersAct, NoHistory {
  using Parameters = ObjectConnectorCoordinateVectorParameters;

  static int algebraic_equations(const Parameters& p, std::span<const int>) {
    return std::max(
        {p.scalingMarker0.rows, p.scalingMarker1.rows, p.quadraticTermMarker0.rows, p.quadraticTermMarker1.rows});
  }
  static bool is_multiplier(const Parameters&, int) { return true; }
  static bool forces_follow_motion(const Parameters& p) {
    if (p.constraintUserFunction) return p.jacobianUserFunction && p.jacobianUserFunction.callback->has_derivatives();
    return !(p.quadraticTermMarker0.values.empty() && p.quadraticTermMarker1.values.empty());
  }

  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    if (p.constraintUserFunction) return evaluate_functions(p, c, x);
    const bool own = p.velocityLevel;
    for (int k = 0; k < static_cast<int>(x.equations.size()); ++k)
      for (const Side& side : sides(p)) {
        const Coordinates<S> at(x, side.marker);
        const std::span<S> forces = x.forces(side.marker);
        for (int i = 0; i < at.n; ++i) {
          const S slope = side.slope(k, i, at.q[i]);
          x.equations[k] += !x.rate_level || own ? side.value(k, i, own ? at.v[i] : at.q[i]) : slope * at.v[i];
          forces[i] -= slope * x.unknowns[k];
        }
      }
    if ((!x.rate_level || own) && !p.offset.empty())
      for (std::size_t k = 0; k < x.equations.size(); ++k) x.equations[k] -= p.offset[k];
  }

  static bool output(const Parameters&, const Context&, const Exchange<double>& x, OutputVariableType variable,
                     std::vector<double>& values) {
    const Coordinates<double> m0(x, 0), m1(x, 1);
    const auto difference = [&](const double* from, const double* to) {
      values.assign(static_cast<std::size_t>(std::max(m0.n, m1.n)), 0.0);
      for (int i = 0; i < m1.n; ++i) values[i] += to[i];
      for (int i = 0; i < m0.n; ++i) values[i] -= from[i];
      return true;
    };
    switch (variable) {
      case OutputVariableType::Displacement: return difference(m0.q, m1.q);
      case OutputVariableType::Velocity: return difference(m0.v, m1.v);
      case OutputVariableType::Force: values.assign(x.unknowns.begin(), x.unknowns.end()); return true;
      default: return false;
    }
  }

  static void check(const Parameters& p, const Connections& on) {
    const int m = algebraic_equations(p, {});
    if (m == 0)
      refuse(ErrorKind::value,
             {on.item(), "scalingMarker0", "all matrices are empty", "", "a matrix with one row per equation", ""});
    if (p.constraintUserFunction) {
      if (!p.jacobianUserFunction)
        refuse(ErrorKind::value, {on.item(), "jacobianUserFunction", "it is missing", "",
                                  "a function that gives the derivatives of constraintUserFunction", ""});
      return;
    }
    check_matrix(p.scalingMarker0, "scalingMarker0", m, 0, on);
    check_matrix(p.scalingMarker1, "scalingMarker1", m, 1, on);
    check_matrix(p.quadraticTermMarker0, "quadraticTermMarker0", m, 0, on);
    check_matrix(p.quadraticTermMarker1, "quadraticTermMarker1", m, 1, on);
    if (!p.offset.empty() && static_cast<int>(p.offset.size()) != m)
      on.refuse("offset", "a vector of length " + std::to_string(p.offset.size()),
                "a vector of length " + std::to_string(m) + ", one value per equation, or none");
  }

 private:
  using Matrix = DynamicMatrix<double>;

  // Data of one marker: n coordinates and their rates.
  template <class S>
  struct Coordinates {
    int n;
    const S *q, *v;
    Coordinates(const Exchange<S>& x, int marker) : n(x.selected(marker)), q(x.values(marker).data()), v(q + n) {}
  };

  // The part of one marker: sign * (X q + Y q^2).
  struct Side {
    int marker;
    const Matrix &linear, &quadratic;
    double sign;

    double x(int k, int i) const { return linear.values.empty() ? 0.0 : linear(k, i); }
    double y(int k, int i) const { return quadratic.values.empty() ? 0.0 : quadratic(k, i); }
    template <class S>
    S value(int k, int i, const S& q) const {
      return sign * (x(k, i) + y(k, i) * q) * q;
    }
    template <class S>
    S slope(int k, int i, const S& q) const {
      return sign * (x(k, i) + 2 * y(k, i) * q);
    }
  };
  static std::array<Side, 2> sides(const Parameters& p) {
    return {Side{0, p.scalingMarker0, p.quadraticTermMarker0, -1},
            Side{1, p.scalingMarker1, p.quadraticTermMarker1, 1}};
  }

  // Values and Jacobian of recorded functions have derivatives. Other functions are called with numbers: second
  // derivatives are left out, the Jacobian is held fixed.
  template <class S>
  static void evaluate_functions(const Parameters& p, const Context& c, Exchange<S>& x) {
    const bool rate = x.rate_level || p.velocityLevel;
    if (p.constraintUserFunction.callback->has_derivatives() && p.jacobianUserFunction.callback->has_derivatives()) {
      const std::vector<S> gaps = linearized(p.constraintUserFunction, c, x, rate, x.equations.size());
      const std::vector<S> gradient =
          linearized(p.jacobianUserFunction, c, x, p.velocityLevel, gaps.size() * columns(x));
      auto g = gradient.begin();
      for (std::size_t k = 0; k < gaps.size(); ++k) {
        x.equations[k] = gaps[k];
        for (int marker = 0; marker < 2; ++marker) {
          if (!x.moves(marker)) continue;
          const std::span<S> forces = x.forces(marker);
          for (int i = 0; i < x.selected(marker); ++i) forces[i] -= *g++ * x.unknowns[k];
        }
      }
      return;
    }
    std::vector<double> gaps(x.equations.size());
    // not called for derivatives
    if constexpr (std::is_same_v<S, double>) gaps = call(p.constraintUserFunction, c, x, rate, gaps.size());
    const std::vector<double> gradient = call(p.jacobianUserFunction, c, x, p.velocityLevel, gaps.size() * columns(x));
    auto g = gradient.begin();
    for (std::size_t k = 0; k < gaps.size(); ++k) {
      x.equations[k] = S(gaps[k]);
      for (int marker = 0; marker < 2; ++marker) {
        if (!x.moves(marker)) continue;
        const Coordinates<S> at(x, marker);
        const std::span<S> forces = x.forces(marker);
        for (int i = 0; i < at.n; ++i, ++g) {
          const S& moving = rate ? at.v[i] : at.q[i];
          x.equations[k] += *g * (moving - value_of(moving));
          forces[i] -= *g * x.unknowns[k];
        }
      }
    }
  }
  // The Jacobian has no columns for the single coordinate of a marker on ground.
  template <class S>
  static std::size_t columns(const Exchange<S>& x) {
    std::size_t count = 0;
    for (int marker = 0; marker < 2; ++marker)
      count += x.moves(marker) ? static_cast<std::size_t>(x.selected(marker)) : 0;
    return count;
  }
  // q, v of both markers and the level, as arguments of a user function.
  struct Given {
    std::vector<double> q, v;
    double flag;
    template <class S>
    Given(const Exchange<S>& x, bool level) : flag(level ? 1 : 0) {
      for_coordinates(x, [&](const S& position, const S& velocity) {
        q.push_back(value_of(position));
        v.push_back(value_of(velocity));
      });
    }
    std::array<Argument, 3> arguments() const { return {as_argument(q), as_argument(v), Argument{&flag}}; }
  };
  template <class S, class Use>
  static void for_coordinates(const Exchange<S>& x, const Use& use) {
    for (int marker = 0; marker < 2; ++marker) {
      const Coordinates<S> at(x, marker);
      for (int i = 0; i < at.n; ++i) use(at.q[i], at.v[i]);
    }
  }
  template <class S>
  static std::vector<double> call(const UserFunction& f, const Context& c, const Exchange<S>& x, bool level,
                                  std::size_t size) {
    std::vector<double> results(size);
    const Given given(x, level);
    if (c.same_state)
      f.callback->recall(c.time, c.item, given.arguments(), results);
    else
      f.callback->call(c.time, c.item, given.arguments(), results);
    return results;
  }
  static std::vector<double> linearized(const UserFunction& f, const Context& c, const Exchange<double>& x, bool level,
                                        std::size_t size) {
    return call(f, c, x, level, size);
  }
  template <class S>
  static std::vector<S> linearized(const UserFunction& f, const Context& c, const Exchange<S>& x, bool level,
                                   std::size_t size) {
    const Given given(x, level);
    std::vector<int> numbers(given.q.size() + given.v.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    std::vector<double> values(size), slopes(size * numbers.size());
    f.callback->linearize(c.time, c.item, given.arguments(), numbers, values, slopes);
    std::vector<S> results(values.begin(), values.end());
    std::size_t number = 0;
    const auto add = [&](const S& moving) {
      for (std::size_t k = 0; k < size; ++k) results[k] += slopes[number * size + k] * (moving - value_of(moving));
      ++number;
    };
    for_coordinates(x, [&](const S& position, const S&) { add(position); });
    for_coordinates(x, [&](const S&, const S& velocity) { add(velocity); });
    return results;
  }

  // The matrix of a marker without coordinates is not used.
  static void check_matrix(const Matrix& matrix, const char* name, int m, int marker, const Connections& on) {
    const int n = on.coordinates(marker);
    if (matrix.values.empty() || n == 0 || (matrix.rows == m && matrix.columns == n)) return;
    on.refuse(name, "a matrix of " + std::to_string(matrix.rows) + " x " + std::to_string(matrix.columns),
              "a matrix of " + std::to_string(m) + " x " + std::to_string(n) +
                  ", one row per equation and one column per coordinate of the marker, or none");
  }
};

}  // namespace dalembert
