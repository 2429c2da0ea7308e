// MainSolverStatic, MainSolverImplicitSecondOrder, MainSolverDiagonallyImplicit and MainSolverExplicit: whole solutions, and each part of them alone.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>

#include "dalembert/model/errors.hpp"
#include "dalembert/output/restart_file.hpp"
#include "dalembert/solvers/diagonally_implicit.hpp"
#include "dalembert/solvers/explicit.hpp"
#include "dalembert/solvers/second_order.hpp"
#include "dalembert/solvers/static.hpp"
#include "interpreter_lock.hpp"
#include "module.hpp"
#include "python_callback.hpp"
#include "solver_data.hpp"
#include "solver_wrapper.hpp"

namespace dalembert {

namespace {

using StaticWrapper = WrappedSolver<StaticSolver>;
using ExplicitWrapper = WrappedSolver<ExplicitSolver>;
using DiagonallyImplicitWrapper = WrappedSolver<DiagonallyImplicitSolver>;

// Parts of an implicit step that the user has replaced by Python functions f(mainSolver, mainSystem, simulationSettings).
class ImplicitWrapper final : public WrappedSolver<SecondOrderSolver> {
 public:
  using Base = SecondOrderSolver;

  void update_current_time() override {
    replaced("UpdateCurrentTime", [this] { Base::update_current_time(); });
  }
  void initialize_step() override {
    replaced("InitializeStep", [this] { Base::initialize_step(); });
  }
  void finish_step(bool write) override {
    replaced("FinishStep", [&] { Base::finish_step(write); });
  }
  bool discontinuous_iteration() override {
    return replaced("DiscontinuousIteration", [this] { return Base::discontinuous_iteration(); });
  }
  bool newton() override {
    return replaced("Newton", [this] { return Base::newton(); });
  }
  double compute_residual() override {
    return replaced("ComputeNewtonResidual", [this] { return Base::compute_residual(); });
  }
  void compute_update(bool initial) override {
    replaced("ComputeNewtonUpdate", [&] { Base::compute_update(initial); }, initial);
  }
  void compute_jacobian() override {
    replaced("ComputeNewtonJacobian", [this] { Base::compute_jacobian(); });
  }
  double post_newton() override {
    return replaced("PostNewton", [this] { return Base::post_newton(); });
  }

  void replace(const std::string& part, const py::object& function) {
    functions_.erase(part);
    const bool none = function.is_none() || (PyLong_Check(function.ptr()) && PyObject_IsTrue(function.ptr()) == 0);
    if (!none) functions_[part] = function;
  }

 private:
  // While a function runs, the same part called from it is the built-in one.
  template <class BuiltIn, class... Arguments>
  auto replaced(const char* part, BuiltIn&& built_in, Arguments... arguments) -> decltype(built_in()) {
    if (functions_.empty() || !is_replaced(part)) [[likely]]
      return built_in();
    return call_replacement<decltype(built_in())>(part, arguments...);
  }
  bool has_replaced_parts() const override { return !functions_.empty(); }
  bool is_replaced(const char* part) const { return running_ != part && functions_.find(part) != functions_.end(); }

  template <class Result, class... Arguments>
  [[gnu::noinline]] Result call_replacement(const char* part, Arguments... arguments) {
    const InterpreterLock lock;
    const std::string_view before = std::exchange(running_, part);
    PyObject* raw = nullptr;
    {
      const std::weak_ptr<MainSystem> owner = main();
      const auto words = [](const void* name, int) {
        return "the user function " + std::string(static_cast<const char*>(name)) + " of the solver";
      };
      const RunningFunction known(owner, RunningFunction::Place::between_evaluations, words, part);
      const py::object function = functions_.find(part)->second;  // which may take its place
      const py::tuple all = py::make_tuple(py::cast(shared()), main(), settings_object, arguments...);
      raw = PyObject_Call(function.ptr(), all.ptr(), nullptr);
    }
    running_ = before;
    if (raw == nullptr) throw_python_error("in the user function " + std::string(part) + " of the solver");
    const py::object result = py::reinterpret_steal<py::object>(raw);
    main()->assembled(part);
    if constexpr (!std::is_void_v<Result>) return result.cast<Result>();
  }
  std::shared_ptr<ImplicitWrapper> shared() { return std::static_pointer_cast<ImplicitWrapper>(shared_from_this()); }

  std::map<std::string, py::object, std::less<>> functions_;
  std::string_view running_;
};

template <class W>
using SolverClass = py::class_<W, std::shared_ptr<W>>;

const py::arg main_argument("mainSystem"), settings_argument("simulationSettings");

// A method of (mainSystem, simulationSettings) that needs an initialized solver. The GIL is released while it works.
template <class W, class F>
void part(SolverClass<W>& c, const char* name, F f, const char* doc, Work::Extent extent = Work::Extent::part) {
  c.def(
      name,
      [name, f, extent](W& w, const MainPointer& main, const py::object& settings) {
        return w.during(main, settings, name, extent, [&] {
          const WithoutInterpreter free;
          return f(w);
        });
      },
      main_argument, settings_argument, doc);
}
// Those that begin or end a solution.
template <class W, class F>
void frame(SolverClass<W>& c, const char* name, F f, const char* doc) {
  part<W>(c, name, f, doc, Work::Extent::whole);
}

template <class W>
void register_solution(SolverClass<W>& c) {
  c.def(
      "InitializeSolver", [](W& w, const MainPointer& m, const py::object& s) { return w.initialize_for(m, s); },
      main_argument, settings_argument, "Open files, set all data and the initial conditions; True if it worked.");
  c.def(
      "SolveSystem", [](W& w, const MainPointer& m, const py::object& s) { return w.solve_for(m, s); }, main_argument,
      settings_argument, "Initialize, solve all steps, finalize; True if it worked.");
  frame<W>(
      c, "SolveSteps",
      [](W& w) {
        const auto success = w.Solver::solve_steps();
        const InterpreterLock lock;
        w.main()->show_current();
        return success;
      },
      "Solve all steps of an initialized solver.");
  frame<W>(c, "FinalizeSolver", [](W& w) { w.Solver::finalize(); }, "Write the last messages and close the files.");
  frame<W>(c, "PreInitializeSolverSpecific", [](W& w) { w.pre_initialize(); }, "First part of InitializeSolver.");
  frame<W>(
      c, "InitializeSolverOutput", [](W& w) { w.initialize_output(); }, "Open files and read the settings of output.");
  frame<W>(c, "InitializeSolverPreChecks", [](W& w) { return w.check_system(); }, "Whether the system can be solved.");
  frame<W>(c, "InitializeSolverData", [](W& w) { w.initialize_data(); }, "Set counters, vectors and matrices back.");
  frame<W>(
      c, "InitializeSolverInitialConditions", [](W& w) { w.initial_conditions(); },
      "Start from the initial values of the system.");
  frame<W>(c, "PostInitializeSolverSpecific", [](W& w) { w.post_initialize(); }, "Last part of InitializeSolver.");
}

template <class W>
void register_step(SolverClass<W>& c) {
  part<W>(c, "UpdateCurrentTime", [](W& w) { w.update_current_time(); }, "Set the time to the end of the step.");
  part<W>(c, "InitializeStep", [](W& w) { w.initialize_step(); }, "Begin a step: time, PreStep user function.");
  part<W>(c, "FinishStep", [](W& w) { w.finish_step(true); }, "End a step: PostStep user function, output.");
  part<W>(
      c, "DiscontinuousIteration", [](W& w) { return w.discontinuous_iteration(); },
      "Newton's method, repeated until discontinuities have settled.");
  part<W>(c, "Newton", [](W& w) { return w.newton(); }, "Newton's method, or one step of an explicit method.");
  part<W>(c, "IncreaseStepSize", [](W& w) { w.increase_step_size(); }, "Make the step size larger.");
  c.def(
      "ReduceStepSize",
      [](W& w, const MainPointer& m, const py::object& s, int) {
        return w.during(m, s, "ReduceStepSize", Work::Extent::part, [&] { return w.reduce_step_size(); });
      },
      main_argument, settings_argument, py::arg("severity"),
      "Make the step size smaller; False if it is the smallest.");
  part<W>(
      c, "HasAutomaticStepSizeControl", [](W& w) { return w.controls_step_size(); },
      "Whether the method chooses its step size by an estimated error.");
  part<W>(
      c, "WriteCoordinatesToFile", [](W& w) { w.write_coordinates(); },
      "Write a row of the solution file, if it is due.");
  part<W>(c, "WriteSolutionFileHeader", [](W& w) { w.write_solution_header(); }, "Write the headers of all files.");
}

template <class W>
void register_information(SolverClass<W>& c) {
  c.def("IsStaticSolver", [](const W& w) { return w.is_static(); }, "Whether it solves static problems.");
  c.def("GetSolverName", [](const W& w) { return w.name(); }, "The name, as files and messages give it.");
  c.def(
      "GetDoubts", [](const W& w) { return w.doubts(); },
      "Why a solution that has finished is not to be trusted, one text each; output.trusted tells whether there are "
      "none.");
  c.def(
      "PrescribeEndsOfSteps", [](W& w, std::vector<double> times) { w.prescribe_ends_of_steps(std::move(times)); },
      py::arg("times"),
      "Lets steps end at these times, the last of which is endTime. Error control has no effect then.");
  c.def("GetErrorString", [](const W& w) { return w.error_string(); }, "Why the solver failed; empty after success.");
  c.def(
      "GetDiagnosis", [](const W& w) { return w.diagnosis().failed() ? w.diagnosis().text() : ""; },
      "Step, time, residuals, equations and items of a failure, and what to try; empty after success.");
  c.def(
      "GetDiagnosisDictionary", [](const W& w) { return diagnosis_dictionary(w.diagnosis()); },
      "The parts of the diagnosis, as the attributes of SolverError have them.");
  c.def(
      "GetSimulationEndTime",
      [](const W& w, const py::object& s) {
        const auto settings = simulation_settings_of(s);
        return w.is_static() ? settings->staticSolver.loadStepDuration : settings->timeIntegration.endTime;
      },
      settings_argument, "End time, or duration of the load steps.");
  c.def(
      "ComputeLoadFactor",
      [](const W& w, const py::object& s) {
        const auto settings = simulation_settings_of(s);
        return w.is_static() ? (w.it.currentTime - w.it.startTime) / settings->staticSolver.loadStepDuration : 1.0;
      },
      settings_argument, "Factor of the loads in a static solver.");
  c.def(
      "IsVerboseCheck", [](const W& w, int level) { return w.verbose(level); }, py::arg("level"),
      "Whether messages of this level are shown or written.");
  c.def(
      "VerboseWrite", [](W& w, int level, const std::string& text) { w.say(level, text); }, py::arg("level"),
      py::arg("str"), "Show and write a message of this level.");
  c.def("GetODE2size", [](const W& w) { return w.sizes().ode2; }, "Number of ODE2 coordinates.");
  c.def("GetODE1size", [](const W& w) { return w.sizes().ode1; }, "Number of ODE1 coordinates.");
  c.def("GetAEsize", [](const W& w) { return w.sizes().ae; }, "Number of algebraic variables.");
  c.def("GetDataSize", [](const W& w) { return w.sizes().data; }, "Number of data coordinates.");
  c.def_readwrite("it", &W::it, "Steps, iterations and step sizes.");
  c.def_readwrite("conv", &W::conv, "Residuals, errors and flags.");
  c.def_readwrite("output", &W::output, "What was written, and how the solver ended.");
  c.def_readwrite("timer", &W::timer, "Computation times.");
}

template <class W>
void register_matrices(SolverClass<W>& c) {
  c.def(
      "ComputeMassMatrix",
      [](W& w, const MainPointer& m, double factor) {
        w.during(m, "ComputeMassMatrix", [&] { w.store_mass_matrix(factor); });
      },
      main_argument, py::arg("scalarFactor") = 1., "Compute the mass matrix, times a factor.");
  c.def("GetSystemMassMatrix", &W::mass_matrix, "The mass matrix computed last.");
  c.def("SetSystemMassMatrix", &W::set_mass_matrix, py::arg("systemMassMatrix"), "Replace the mass matrix.");
  c.def("GetSystemResidual", [](W& w) { return w.residual_array(); }, "The residual of all equations computed last.");
  c.def("SetSystemResidual", &W::set_residual, py::arg("systemResidual"), "Replace the residual.");
  c.def(
      "ComputeODE2RHS", [](W& w, const MainPointer& m) { w.during(m, "ComputeODE2RHS", [&] { w.compute_forces(); }); },
      main_argument, "Compute generalized forces into the ODE2 part of the residual.");
  c.def(
      "ComputeODE1RHS", [](W& w, const MainPointer& m) { w.during(m, "ComputeODE1RHS", [&] { w.compute_rates(); }); },
      main_argument, "Compute right-hand sides into the ODE1 part of the residual.");
}

// Methods of solvers with Newton's method. Only `Base` is called: a replaced part may use the built-in one.
template <class W>
void register_redundancy(SolverClass<W>& c) {
  c.def(
      "GetRedundantConstraints",
      [](W& w) {
        w.require_own_thread("GetRedundantConstraints");
        py::dict found = redundancy_dictionary(w.constraint_rank(), w.system());
        found["misfit"] = w.largest_misfit();
        return found;
      },
      "What the last solution has found of constraint equations that follow from others: their number (count), the "
      "joints that could "
      "lose some (items: object, item, equations, removable), equations whose multipliers are not unique (equations), "
      "the smallest "
      "eigenvalue of the others (weakest), whether that is far enough above round-off to be sure of the number "
      "(certain), and the largest gap that contradictions have left, relative to the size of the model (misfit).");
}

template <class W, class Base>
void register_newton(SolverClass<W>& c) {
  part<W>(
      c, "ComputeNewtonResidual", [](W& w) { return w.compute_residual(); },
      "Compute the residual; returns the number that is compared with the tolerances.");
  part<W>(c, "ComputeNewtonJacobian", [](W& w) { w.compute_jacobian(); }, "Compute the system matrix.");
  c.def(
      "ComputeNewtonUpdate",
      [](W& w, const MainPointer& m, const py::object& s, bool initial) {
        w.during(m, s, "ComputeNewtonUpdate", Work::Extent::part, [&] {
          const WithoutInterpreter free;
          w.compute_update(initial);
        });
      },
      main_argument, settings_argument, py::arg("initial") = true,
      "Move the state by the increment of Newton's method.");
  part<W>(c, "PostNewton", [](W& w) { return w.post_newton(); }, "Update data coordinates; returns the error.");
  c.def(
      "GetNewtonSolution",
      [](W& w) {
        w.require_own_thread("GetNewtonSolution");
        return vector_array(w.increment());
      },
      "The last increment of Newton's method.");
  c.def("GetSystemJacobian", [](W& w) { return w.jacobian(); }, "The system matrix computed last.");
  c.def("SetSystemJacobian", &W::set_jacobian, py::arg("systemJacobian"), "Replace the system matrix.");
  c.def_property(
      "newton", [](W& w) { return w.newton_view(); }, [](W& w, const py::object& n) { w.set_newton(n); },
      "Copy of the settings of Newton's method that the solver obeys.");
  const auto q = py::arg("scalarFactor_ODE2") = 1., v = py::arg("scalarFactor_ODE2_t") = 0.,
             y = py::arg("scalarFactor_ODE1") = 1.;
  c.def(
      "ComputeJacobianODE2RHS",
      [](W& w, const MainPointer& m, double dq, double dv, double dy, int loads) {
        w.during(m, "ComputeJacobianODE2RHS", [&] { w.compute_ode2_jacobian(dq, dv, dy, loads); });
      },
      main_argument, q, v, y, py::arg("computeLoadsJacobian") = 0,
      "Set the system matrix to the derivative of the generalized forces, those of loads only if asked for.");
  c.def(
      "ComputeJacobianODE1RHS",
      [](W& w, const MainPointer& m, double dq, double dv, double dy) {
        w.during(m, "ComputeJacobianODE1RHS", [&] { w.add_ode1_jacobian(dq, dv, dy); });
      },
      main_argument, q, v, y, "Add the derivative of the ODE1 right-hand sides to the system matrix.");
  c.def(
      "ComputeJacobianAE",
      [](W& w, const MainPointer& m, double dq, double dv, double dy, bool rate_level) {
        w.during(m, "ComputeJacobianAE", [&] { w.add_ae_jacobian(dq, dv, dy, rate_level); });
      },
      main_argument, q, v, y, py::arg("velocityLevel") = false,
      "Add the derivatives of the constraints, and their transposed, to the system matrix.");
  c.def(
      "ComputeAlgebraicEquations",
      [](W& w, const MainPointer& m, bool rate_level) {
        w.during(m, "ComputeAlgebraicEquations", [&] { w.compute_gaps(rate_level); });
      },
      main_argument, py::arg("velocityLevel") = false, "Compute the constraints into the AE part of the residual.");
  c.def(
      "CheckInitialized",
      [](W& w, const MainPointer& m) { return w.during(m, "CheckInitialized", [] { return true; }); }, main_argument,
      "True if the solver is initialized for this system; refused otherwise.");
}

template <class W>
void register_common(SolverClass<W>& c) {
  c.def(py::init<>());
  register_solution(c);
  register_step(c);
  register_information(c);
  register_matrices(c);
  c.def("__repr__", [](const W& w) { return "<solver: " + w.name() + ">"; });
}

// The state of the file becomes the initial state; returns the algorithmic accelerations.
std::vector<double> read_restart(MainSystem& main, const std::string& name) {
  RestartData data = read_restart_file(name);
  State& initial = main.assembled("ContinueFromRestartFile").state(ConfigurationType::Initial);
  require_fitting(data, initial, name);
  initial = data.state;  // in place: views stay valid
  return std::move(data.algorithmic_accelerations);
}

void register_implicit(py::module_& module) {
  SolverClass<ImplicitWrapper> c(module, "MainSolverImplicitSecondOrder",
                                 "Generalized alpha, Newmark and trapezoidal rule.");
  register_common(c);
  register_newton<ImplicitWrapper, SecondOrderSolver>(c);
  register_redundancy(c);
  c.def(
      "GetAAlgorithmic",
      [](ImplicitWrapper& w) {
        w.require_own_thread("GetAAlgorithmic");
        return vector_array(w.algorithmic_accelerations());
      },
      "Algorithmic accelerations of the generalized alpha method.");
  c.def(
      "GetStartOfStepStateAAlgorithmic",
      [](ImplicitWrapper& w) {
        w.require_own_thread("GetStartOfStepStateAAlgorithmic");
        return vector_array(w.algorithmic_accelerations_at_start());
      },
      "Algorithmic accelerations at the start of the step.");
  c.def(
      "ContinueFromRestartFile",
      [](ImplicitWrapper& w, const MainPointer& main, const std::string& name) {
        const Work here(main, w, "ContinueFromRestartFile", Work::Extent::whole);
        w.continue_with(read_restart(*main, name));
      },
      main_argument, py::arg("fileName"),
      "Make the state of a restart file the initial state of the system, and continue bit for bit with the next "
      "SolveSystem; timeIntegration.startTime has to be set to the time that systemData.GetTime(Initial) gives.");
  c.def_readwrite("newmarkBeta", &ImplicitWrapper::newmark_beta)
      .def_readwrite("newmarkGamma", &ImplicitWrapper::newmark_gamma)
      .def_readwrite("alphaM", &ImplicitWrapper::alpha_m)
      .def_readwrite("alphaF", &ImplicitWrapper::alpha_f)
      .def_readwrite("spectralRadius", &ImplicitWrapper::spectral_radius)
      .def_property_readonly(
          "factJacAlgorithmic", [](const ImplicitWrapper& w) { return (1 - w.alpha_f) / (1 - w.alpha_m); },
          "Factor of accelerations in algorithmic accelerations, (1 - alphaF) / (1 - alphaM).");
  for (const char* part : {"UpdateCurrentTime", "InitializeStep", "FinishStep", "DiscontinuousIteration", "Newton",
                           "ComputeNewtonResidual", "ComputeNewtonUpdate", "ComputeNewtonJacobian", "PostNewton"}) {
    c.def(("SetUserFunction" + std::string(part)).c_str(),
          [name = std::string(part)](ImplicitWrapper& w, const MainPointer&, const py::object& f) {
            w.require_own_thread(("SetUserFunction" + name).c_str());
            w.replace(name, f);
          },
          main_argument, py::arg("userFunction"), "Replace this part of a step; 0 takes the built-in one again.");
  }
}

// Runge-Kutta methods; the reason says why parts of Newton's method cannot be called.
template <class W>
void register_stages(SolverClass<W>& c, const char* reason) {
  register_common(c);
  register_redundancy(c);
  c.def("GetMethodOrder", [](const W& w) { return w.method_order(); }, "Order of the method.");
  c.def("GetNumberOfStages", [](const W& w) { return w.number_of_stages(); }, "Stages of the method.");
  for (const char* name : {"ComputeNewtonResidual", "ComputeNewtonJacobian", "ComputeNewtonUpdate"}) {
    c.def(name, [name, reason](W&, const py::args&, const py::kwargs&) -> py::object {
      throw ModelError(ErrorKind::planned, std::string("solver.") + name + "(...): " + reason);
    });
  }
}

void register_runge_kutta(py::module_& module) {
  SolverClass<ExplicitWrapper> explicit_solver(module, "MainSolverExplicit",
                                               "Explicit Runge-Kutta methods and velocity Verlet.");
  register_stages(explicit_solver, "explicit solvers have no Newton's method");
  SolverClass<DiagonallyImplicitWrapper> implicit(
      module, "MainSolverDiagonallyImplicit",
      "ESDIRK43: a diagonally implicit Runge-Kutta method for stiff systems, with error control.");
  register_stages(implicit, "this solver has a Newton's method per stage, which is no part by itself");
}

py::list singular_points_of(const StaticWrapper& w) {
  using namespace py::literals;
  w.require_own_thread("GetSingularPoints");
  py::list points;
  for (const SingularPoint& point : w.singular_points())
    points.append(py::dict("step"_a = point.step, "loadFactor"_a = point.load_factor,
                           "type"_a = point.limit ? "limit" : "bifurcation", "mode"_a = vector_array(point.mode)));
  return points;
}

}  // namespace

void register_solvers(py::module_& module) {
  register_solver_data(module);
  SolverClass<StaticWrapper> c(module, "MainSolverStatic", "Static equilibrium under loads that grow in steps.");
  register_common(c);
  register_newton<StaticWrapper, StaticSolver>(c);
  register_redundancy(c);
  c.def_property_readonly(
      "loadStepGeometricFactor", [](const StaticWrapper& w) { return w.geometric_factor(); },
      "Ratio of consecutive loads with loadStepGeometric.");
  c.def("GetSingularPoints", &singular_points_of,
        "Points of the last path of equilibria (staticSolver.arcLength) at which the matrix is singular, one "
        "dictionary each: step, loadFactor, "
        "type ('limit': the load turns; 'bifurcation': a branch begins), and mode, the null vector of ODE2 coordinates "
        "with 1 as its largest entry.");
  register_implicit(module);
  register_runge_kutta(module);
}

}  // namespace dalembert
