// The equations of an assembled system at any state, for tests and for authors of integrators: dalembert._core.testing.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "console.hpp"
#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/solvers/open_constraints.hpp"
#include "dalembert/solvers/constraint_rank.hpp"
#include "main_system.hpp"
#include "module.hpp"
#include "solver_data.hpp"
#include "system_derivatives.hpp"

namespace dalembert {
namespace {

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Member = std::vector<double> State::*;

// A copy of the state and of all other arguments of the equations. The configurations of the system do not change.
struct EvaluationState {
  State state;
  Conditions conditions;
};

py::array_t<double> array(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

std::vector<double> numbers(const Array& values, std::size_t size, const char* name) {
  if (values.ndim() != 1 || static_cast<std::size_t>(values.size()) != size)
    refuse(ErrorKind::value, {.item = "testing.State",
                              .parameter = name,
                              .received = std::to_string(values.size()) + " numbers",
                              .expected = std::to_string(size) + " numbers, as the assembled system has"});
  return {values.data(), values.data() + values.size()};
}

System& checked(MainSystem& main, const EvaluationState& s, const char* method) {
  require_idle(main, std::string("testing.") + method + "(...)");
  System& system = main.assembled(method);
  const Sizes& n = system.sizes();
  const auto fits = [](const std::vector<double>& v, int size) { return v.size() == static_cast<std::size_t>(size); };
  const State& x = s.state;
  if (!(fits(x.q, n.ode2) && fits(x.v, n.ode2) && fits(x.a, n.ode2) && fits(x.y, n.ode1) && fits(x.y_t, n.ode1) &&
        fits(x.lambda, n.ae) && fits(x.data, n.data)))
    refuse(ErrorKind::value, {.item = std::string("testing.") + method,
                              .parameter = "state",
                              .received = "a state of another system or of an earlier Assemble()",
                              .expected = "testing.State(mbs)"});
  return system;
}

// Values in pattern order as a square array.
py::array_t<double> square(const Pattern& pattern, const std::vector<double>& values, int size) {
  py::array_t<double> matrix({size, size});
  auto to = matrix.mutable_unchecked<2>();
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      to(i, j) = pattern.is_dense() ? values[static_cast<std::size_t>(pattern.slot(i, j))] : 0.0;
  if (pattern.is_dense()) return matrix;
  for (int j = 0; j < size; ++j)
    for (int k = pattern.column_start()[j]; k < pattern.column_start()[j + 1]; ++k)
      if (pattern.row_index()[k] < size) to(pattern.row_index()[k], j) = values[static_cast<std::size_t>(k)];
  return matrix;
}

template <class Evaluate>
py::array_t<double> matrix(System& system, bool dense, int size, Evaluate&& evaluate) {
  const Pattern& pattern = system.pattern(dense);
  std::vector<double> values(static_cast<std::size_t>(pattern.values()));
  evaluate(pattern, values);
  return square(pattern, values, size);
}

py::array_t<int> array(const std::vector<int>& values) {
  return py::array_t<int>(static_cast<py::ssize_t>(values.size()), values.data());
}

// Entries of the sparse matrix as (rows, columns, values).
template <class Evaluate>
py::tuple entries(System& system, Evaluate&& evaluate) {
  const Pattern& pattern = system.pattern(false);
  std::vector<double> values(static_cast<std::size_t>(pattern.values())), stored;
  evaluate(pattern, values);
  std::vector<int> rows, columns;
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (values[slot] == 0) return;
    rows.push_back(row);
    columns.push_back(column);
    stored.push_back(values[slot]);
  });
  return py::make_tuple(array(rows), array(columns), array(stored));
}

void register_state(py::module_& module) {
  py::class_<EvaluationState> cls(
      module, "State",
      "A copy of the current state of mbs, and of all other arguments of the equations. ODE2 "
      "coordinates count from the reference configuration. Arrays are copied in and out.");
  cls.def(py::init([](MainSystem& main) {
            return EvaluationState{main.assembled("testing.State").state(ConfigurationType::Current), {}};
          }),
          py::arg("mbs"));
  cls.def("copy", [](const EvaluationState& s) { return s; }, "An independent copy.");
  const auto vector = [&cls](const char* name, Member member, const char* doc) {
    cls.def_property(
        name, [member](const EvaluationState& s) { return array(s.state.*member); },
        [member, name](EvaluationState& s, const Array& values) {
          s.state.*member = numbers(values, (s.state.*member).size(), name);
        },
        doc);
  };
  vector("q", &State::q, "ODE2 displacements");
  vector("v", &State::v, "ODE2 velocities");
  vector("a", &State::a, "ODE2 accelerations");
  vector("y", &State::y, "ODE1 coordinates");
  vector("y_t", &State::y_t, "rates of ODE1 coordinates");
  vector("lam", &State::lambda, "Lagrange multipliers");
  vector("data", &State::data, "data coordinates");
  cls.def_property(
      "t", [](const EvaluationState& s) { return s.state.time; },
      [](EvaluationState& s, double t) { s.state.time = t; }, "time");
  cls.def_property(
      "load_factor", [](const EvaluationState& s) { return s.conditions.load_factor; },
      [](EvaluationState& s, double x) { s.conditions.load_factor = x; }, "factor of loads in static solutions");
  cls.def_property(
      "step_size", [](const EvaluationState& s) { return s.conditions.step_size; },
      [](EvaluationState& s, double x) { s.conditions.step_size = x; }, "step size that friction and contact see");
  cls.def_property(
      "rate_level", [](const EvaluationState& s) { return s.conditions.rate_level; },
      [](EvaluationState& s, bool x) { s.conditions.rate_level = x; }, "constraints as rates of their gaps (index 2)");
  cls.def_property(
      "inertia", [](const EvaluationState& s) { return s.conditions.inertia; },
      [](EvaluationState& s, bool x) { s.conditions.inertia = x; }, "False: static, without accelerations");
}

void register_vectors(py::module_& module) {
  const auto vector = [&module](const char* name, auto size, auto evaluate, const char* doc) {
    module.def(
        name,
        [name, size, evaluate](MainSystem& main, const EvaluationState& s) {
          System& system = checked(main, s, name);
          std::vector<double> values(static_cast<std::size_t>(size(system.sizes())));
          (system.*evaluate)(s.state, s.conditions, values);
          return array(values);
        },
        py::arg("mbs"), py::arg("state"), doc);
  };
  vector(
      "residual", [](const Sizes& n) { return n.total(); }, &System::residual,
      "Residual of [ODE2, ODE1, AE]: M a + f + G^T lam = 0; rates - y_t = 0; gaps (or their rates) = 0.");
  vector("forces", [](const Sizes& n) { return n.ode2; }, &System::forces, "Q of M a = Q, without constraint forces.");
  vector("rates", [](const Sizes& n) { return n.ode1; }, &System::rates, "Right-hand side of the ODE1 equations.");
  vector("gaps", [](const Sizes& n) { return n.ae; }, &System::gaps, "Algebraic equations alone.");
  module.def(
      "switch_over",
      [](MainSystem& main, EvaluationState& s) { checked(main, s, "switch_over").switch_over(s.state, s.conditions); },
      py::arg("mbs"), py::arg("state"),
      "Set the data coordinates of items with events, such as contacts, to those of the state.");
}

// The equations of one object alone: mbs.ComputeItem.
void register_object_equations(py::module_& module) {
  const auto of = [](MainSystem& main, int object, const char* method) {
    require_idle(main, std::string("testing.") + method + "(...)");
    System& system = main.assembled(method);
    return ObjectEquations(main.model, system, object);
  };
  const auto matrix_of = [](const std::vector<double>& values, int columns) {
    const py::ssize_t rows = columns == 0 ? 0 : static_cast<py::ssize_t>(values.size()) / columns;
    return new_array({rows, columns}, values.data());
  };
  module.def(
      "object_residual",
      [of](MainSystem& main, int object) {
        ObjectEquations equations = of(main, object, "object_residual");
        const std::vector<double> r = equations.residual();
        const auto split = r.begin() + equations.coordinates();
        return py::make_tuple(array(std::vector<double>(r.begin(), split)), array(std::vector<double>(split, r.end())));
      },
      py::arg("mbs"), py::arg("object"),
      "f of the ODE2 coordinates of an object alone, without accelerations, loads and multipliers, and its algebraic "
      "equations, in the current state.");
  module.def(
      "object_tangent",
      [of, matrix_of](MainSystem& main, int object, double cq, double cv) {
        ObjectEquations equations = of(main, object, "object_tangent");
        return matrix_of(equations.tangent(cq, cv), equations.coordinates());
      },
      py::arg("mbs"), py::arg("object"), py::kw_only(), py::arg("cq") = 1.0, py::arg("cv") = 0.0,
      "cq times the derivative of both by the coordinates of the object, and cv times that by their rates; see "
      "`tangent`.");
  module.def(
      "object_mass_matrix",
      [of, matrix_of](MainSystem& main, int object) {
        ObjectEquations equations = of(main, object, "object_mass_matrix");
        return matrix_of(equations.mass_matrix(), equations.coordinates());
      },
      py::arg("mbs"), py::arg("object"), "The mass matrix of an object alone.");
}

void register_matrices(py::module_& module) {
  module.def(
      "tangent",
      [](MainSystem& main, const EvaluationState& s, double cq, double cv, double ca, double cy, double cy_t,
         bool dense) {
        System& system = checked(main, s, "tangent");
        const Weights weights{.q = cq, .v = cv, .a = ca, .y = cy, .y_t = cy_t};
        return matrix(system, dense, system.sizes().total(), [&](const Pattern& pattern, std::vector<double>& values) {
          system.tangent(s.state, s.conditions, weights, pattern, values);
        });
      },
      py::arg("mbs"), py::arg("state"), py::kw_only(), py::arg("cq") = 1.0, py::arg("cv") = 0.0, py::arg("ca") = 0.0,
      py::arg("cy") = 1.0, py::arg("cy_t") = 0.0, py::arg("dense") = true,
      "cq dr/dq + cv dr/dv + ca dr/da in the ODE2 columns, cy dr/dy + cy_t dr/dy_t in the ODE1 columns, dr/dlam in the "
      "AE "
      "columns. Rows of constraints are divided by cq (by cv if cq is 0). Rotations of Lie-group nodes are varied by "
      "increments. dense: which storage is used inside; the result is a full square array in either case.");
  module.def(
      "mass_matrix",
      [](MainSystem& main, const EvaluationState& s, bool dense) {
        System& system = checked(main, s, "mass_matrix");
        return matrix(system, dense, system.sizes().ode2, [&](const Pattern& pattern, std::vector<double>& values) {
          system.mass_matrix(s.state, pattern, values);
        });
      },
      py::arg("mbs"), py::arg("state"), py::kw_only(), py::arg("dense") = true, "M(q) of the ODE2 coordinates.");
  module.def(
      "tangent_entries",
      [](MainSystem& main, const EvaluationState& s, double cq, double cv) {
        System& system = checked(main, s, "tangent_entries");
        return entries(system, [&](const Pattern& pattern, std::vector<double>& values) {
          system.tangent(s.state, s.conditions, {.q = cq, .v = cv, .a = 0, .y = 1, .y_t = 0}, pattern, values);
        });
      },
      py::arg("mbs"), py::arg("state"), py::kw_only(), py::arg("cq") = 1.0, py::arg("cv") = 0.0,
      "The entries of `tangent` that are not zero: (rows, columns, values).");
  module.def(
      "mass_entries",
      [](MainSystem& main, const EvaluationState& s) {
        System& system = checked(main, s, "mass_entries");
        return entries(system, [&](const Pattern& pattern, std::vector<double>& values) {
          system.mass_matrix(s.state, pattern, values);
        });
      },
      py::arg("mbs"), py::arg("state"), "The entries of `mass_matrix` that are not zero: (rows, columns, values).");
  module.def(
      "constant_mass_matrix",
      [](MainSystem& main) { return main.assembled("constant_mass_matrix").constant_mass_matrix(); }, py::arg("mbs"),
      "True if M does not depend on the coordinates.");
}

void register_constraints(py::module_& module) {
  module.def(
      "constraint_rates",
      [](MainSystem& main, const EvaluationState& s) {
        const ConstraintRates now = constraint_rates(checked(main, s, "constraint_rates"), s.state, s.conditions);
        std::vector<int> of_velocities(now.of_velocities.begin(), now.of_velocities.end());
        return py::make_tuple(array(now.rates), array(now.speeds), array(of_velocities));
      },
      py::arg("mbs"), py::arg("state"),
      "Of all constraint equations: the rates of their gaps, the sums of the magnitudes of the velocities that meet in "
      "them, and 1 for "
      "those that constrain velocities.");
  module.def(
      "open_constraints",
      [](MainSystem& main, const EvaluationState& s, double position, double velocity, bool rates) {
        System& system = checked(main, s, "open_constraints");
        py::list found;
        for (const OpenConstraint& open : open_constraints(system, s.state, s.conditions, {position, velocity, rates}))
          found.append(py::make_tuple(open.row, open.of_rate, open.gap, open.excess, open.text(system)));
        return found;
      },
      py::arg("mbs"), py::arg("state"), py::arg("position"), py::arg("velocity"), py::arg("rates") = true,
      "Constraints that the state does not fulfil, the worst first: (AE number, whether the rate is meant, gap, gap / "
      "tolerance, text).");
  module.def(
      "redundant_constraints",
      [](MainSystem& main, const EvaluationState& s, double moment_length) {
        System& system = checked(main, s, "redundant_constraints");
        const ConstraintRank found(system, s.state, s.conditions,
                                   constraint_metric(system, s.state, s.conditions, moment_length));
        py::dict result = redundancy_dictionary(found, system);
        result["dependent"] = found.dependent();
        return result;
      },
      py::arg("mbs"), py::arg("state"), py::arg("momentLength") = 0.0,
      "Constraint equations that follow from others, as GetRedundantConstraints of the solvers gives them; dependent: "
      "as many of them as could be "
      "left out.");
  module.def(
      "constraint_metric",
      [](MainSystem& main, const EvaluationState& s) {
        const ConstraintMetric metric = constraint_metric(checked(main, s, "constraint_metric"), s.state, s.conditions);
        return py::make_tuple(array(metric.weights), array(metric.units));
      },
      py::arg("mbs"), py::arg("state"),
      "By constraint equation: what solvers weigh it with where some contradict each other (0: they never do), and "
      "what counts as one in its gap.");
  module.def(
      "extent", [](MainSystem& main) { return main.assembled("extent").extent(); }, py::arg("mbs"),
      "The diagonal of the box around all markers in space, as evaluated last, in m; 1 without such markers.");
}

void register_division(py::module_& module) {
  module.def(
      "divide",
      [](MainSystem& main, int coordinates, int threads) {
        main.assembled("divide");
        require_idle(main, "testing.divide(...)");
        main.system.assemble(main.model, {.coordinates = coordinates, .entries = 0});
        main.system.use_threads(threads);
        return main.system.threads();
      },
      py::arg("mbs"), py::arg("coordinates"), py::arg("threads"),
      "Assemble again, in regions of so many ODE2 coordinates at least, which so many threads share; returns how many "
      "there are.");
}

void register_updates(py::module_& module) {
  module.def(
      "compose",
      [](MainSystem& main, const EvaluationState& s, const Array& increment) {
        System& system = checked(main, s, "compose");
        const std::vector<double> step = numbers(increment, s.state.q.size(), "increment");
        std::vector<double> q = s.state.q;
        for (std::size_t i = 0; i < q.size(); ++i) q[i] += step[i];
        system.compose(s.state.q, step, q);
        return array(q);
      },
      py::arg("mbs"), py::arg("state"), py::arg("increment"),
      "q after an increment: sums, and compositions of rotations for Lie-group nodes (increments in the local frame).");
  module.def(
      "post_newton",
      [](MainSystem& main, EvaluationState& s) {
        const Discontinuity verdict = checked(main, s, "post_newton").post_newton(s.state, s.conditions);
        return py::make_tuple(verdict.error, verdict.recommended_step_size);
      },
      py::arg("mbs"), py::arg("state"),
      "Update the data coordinates of `state`; returns (error, recommended step size or -1).");
  module.def(
      "describe_row", [](MainSystem& main, int row) { return main.assembled("describe_row").describe_row(row); },
      py::arg("mbs"), py::arg("row"), "Which items act on a row of the residual.");
}

void register_system_terms(py::module_& module) {
  module.def(
      "search",
      [](MainSystem& main, const EvaluationState& s) {
        return checked(main, s, "search").search(s.state, s.conditions);
      },
      py::arg("mbs"), py::arg("state"),
      "Let terms that are not items update their contacts in a state; returns whether the sparse pattern has changed.");
  module.def(
      "pattern_revisions", [](MainSystem& main) { return main.assembled("pattern_revisions").pattern_revisions(); },
      py::arg("mbs"), "How often the sparse pattern of the system matrix has been made anew.");
}

}  // namespace

void register_evaluation(py::module_& module) {
  py::module_ testing = module.def_submodule(
      "testing", "Residual and tangent of an assembled system at any state, for tests and authors of integrators.");
  register_state(testing);
  register_vectors(testing);
  register_object_equations(testing);
  register_matrices(testing);
  register_constraints(testing);
  register_updates(testing);
  register_division(testing);
  register_system_terms(testing);
  register_system_derivatives(testing);
}

}  // namespace dalembert
