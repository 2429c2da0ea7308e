#include "solver_wrapper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "interpreter_lock.hpp"

namespace dalembert {

Array dense_matrix(const char* method, const Pattern& pattern, std::span<const double> values, int size) {
  if (const double entries = static_cast<double>(size) * size; entries > std::numeric_limits<int>::max()) {
    refuse(ErrorKind::value,
           {.item = std::string("solver.") + method + "()",
            .problem = "an array of shape (" + std::to_string(size) + ", " + std::to_string(size) +
                       ") is too large: it would take " + std::to_string(std::lround(8e-9 * entries)) + " GB"});
  }
  Array matrix({size, size});
  auto m = matrix.mutable_unchecked<2>();
  std::fill_n(matrix.mutable_data(), matrix.size(), 0.0);
  if (values.empty()) return matrix;
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (row < size && column < size) m(row, column) = values[slot];
  });
  return matrix;
}

Array vector_array(std::span<const double> values) {
  return new_array({static_cast<py::ssize_t>(values.size())}, values.data());
}

namespace {

[[noreturn]] void refuse_shape(const char* method, const std::string& received, const std::string& expected) {
  refuse(ErrorKind::value,
         {.item = std::string("solver.") + method + "(...)", .received = received, .expected = expected});
}

}  // namespace

void read_matrix(const char* method, const Array& matrix, const Pattern& pattern, std::span<double> values, int size) {
  const std::string expected = "a matrix of shape (" + std::to_string(size) + ", " + std::to_string(size) + ")";
  if (matrix.ndim() != 2 || matrix.shape(0) != size || matrix.shape(1) != size) {
    refuse_shape(method,
                 "an array with " + std::to_string(matrix.ndim()) + " dimensions and " + std::to_string(matrix.size()) +
                     " entries",
                 expected);
  }
  const auto m = matrix.unchecked<2>();
  std::vector<double> stored(values.size(), 0.0);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      if (m(i, j) == 0) continue;
      if (!pattern.contains(i, j))
        refuse_shape(method, "an entry in row " + std::to_string(i) + ", column " + std::to_string(j),
                     "entries of coordinates that items of the model couple; set "
                     "simulationSettings.linearSolverType=EigenDense for others");
      stored[static_cast<std::size_t>(pattern.slot(i, j))] = m(i, j);
    }
  }
  std::copy(stored.begin(), stored.end(), values.begin());
}

void read_vector(const char* method, const Array& vector, std::span<double> values) {
  if (vector.ndim() != 1 || vector.size() != static_cast<py::ssize_t>(values.size())) {
    refuse_shape(method, std::to_string(vector.size()) + " numbers",
                 "a vector of length " + std::to_string(values.size()));
  }
  std::copy_n(vector.data(), values.size(), values.begin());
}

MainPointer SolverWrapper::main() const {
  if (auto main = main_.lock()) return main;
  throw ModelError(ErrorKind::state,
                   "the system that this solver worked on does not exist any more, or there was none");
}

void SolverWrapper::attach(const MainPointer& new_main, const py::object& object, const char* method, bool renew) {
  const bool other = new_main != main_.lock();
  System& system = new_main->assembled(method);
  auto used = settings;
  if (!object.is_none() && !object.is(settings_object)) {
    used = simulation_settings_of(object);
    settings_object = object;
  }
  if (!used) used = std::make_shared<SimulationSettings>();
  if (renew || other || !environment_) environment_ = make_environment(new_main);
  main_ = new_main;
  settings = std::move(used);
  if (newton_settings_) {
    const auto copy = simulation_settings_of(newton_settings_);
    solver().newton_settings = copy->timeIntegration.newton;
  }
  solver().attach(system, *settings, *environment_);
}

void SolverWrapper::refuse_uninitialized(const char* method, const std::string& problem) {
  refuse(ErrorKind::state, {.item = std::string("solver.") + method + "(...)",
                            .problem = problem,
                            .advice = "Call solver.InitializeSolver(mbs, simulationSettings) first."});
}

void SolverWrapper::require_initialized(const char* method, const MainPointer& new_main) const {
  if (!initialized_) refuse_uninitialized(method, "the solver is not initialized");
  if (new_main != main_.lock()) refuse_uninitialized(method, "the solver is initialized for another system");
  if (version_ != new_main->system.version())
    refuse_uninitialized(method, "the system was assembled again after the solver was initialized");
}

void SolverWrapper::require_initialized(const char* method) const {
  const MainPointer known = main_.lock();
  if (!known)
    refuse_uninitialized(
        method, initialized_ ? "the solver's system does not exist any more" : "the solver is not initialized");
  require_own_thread(method);
  require_initialized(method, known);
}

void SolverWrapper::require_own_thread(const char* method) const {
  if (const MainPointer known = main_.lock())
    dalembert::require_own_thread(*known, [&] { return std::string("solver.") + method + "(...)"; });
}

bool SolverWrapper::initialize_for(const MainPointer& new_main, const py::object& object) {
  const Work here(new_main, *this, "InitializeSolver", Work::Extent::whole);
  run(new_main, object, "InitializeSolver", [this] { return solver().initialize(); });
  return initialized_;
}

bool SolverWrapper::solve_for(const MainPointer& new_main, const py::object& object) {
  const Work here(new_main, *this, "SolveSystem", Work::Extent::whole);
  const struct Release {
    SolverWrapper& self;
    MainSystem& main;
    ~Release() {
      self.solver().forget_environment();
      self.environment_.reset();
      main.show_current();  // also shown after a failure
    }
  } release_functions{*this, *new_main};
  const bool success = run(new_main, object, "SolveSystem", [this] { return solver().solve_system(); });
  if (settings->cleanUpMemory) {
    solver().free_memory();
    initialized_ = false;
  }
  return success;
}

// Runs a call that starts with the initialization. User functions may call parts of the solver as soon as it starts.
template <class F>
bool SolverWrapper::run(const MainPointer& new_main, const py::object& object, const char* method, F&& f) {
  initialized_ = false;
  attach(new_main, object, method, true);
  new_main->stop_requested = false;
  version_ = new_main->system.version();
  mass_.clear();
  new_main->system.state(ConfigurationType::Visualization);  // there before other threads ask for it
  const struct Mark {
    SolverWrapper& self;
    ~Mark() { self.initialized_ = self.solver().output.initializationSuccessful; }
  } mark{*this};
  initialized_ = true;
  bool success = false;
  {
    const WithoutInterpreter free;
    success = f();
  }
  update_newton_view();
  return success;
}

py::object SolverWrapper::newton_view() {
  if (!newton_settings_) {
    newton_settings_ = py::module_::import("dalembert._core").attr("SimulationSettings")();
    update_newton_view();
  }
  return newton_settings_.attr("timeIntegration").attr("newton");
}

void SolverWrapper::set_newton(const py::object& newton) {
  require_own_thread("newton");
  newton_view();
  newton_settings_.attr("timeIntegration").attr("newton") = newton;
  solver().newton_settings = simulation_settings_of(newton_settings_)->timeIntegration.newton;
}

void SolverWrapper::update_newton_view() {
  if (newton_settings_) simulation_settings_of(newton_settings_)->timeIntegration.newton = solver().newton_settings;
}

const Pattern& SolverWrapper::pattern() {
  if (NewtonSolver* newton = newton_solver()) return newton->pattern();
  return main()->system.pattern(is_dense(solver().linear_type()));
}

std::span<double> SolverWrapper::residual() {
  if (NewtonSolver* newton = newton_solver()) return newton->residual();
  own_residual_.resize(static_cast<std::size_t>(solver().sizes().total()));
  return own_residual_;
}

Array SolverWrapper::residual_array() {
  require_initialized("GetSystemResidual");
  return vector_array(residual());
}

void SolverWrapper::set_residual(const Array& vector) {
  require_initialized("SetSystemResidual");
  read_vector("SetSystemResidual", vector, residual());
}

void SolverWrapper::store_mass_matrix(double factor) {
  mass_.assign(static_cast<std::size_t>(pattern().values()), 0.0);
  main()->system.mass_matrix(main()->system.state(ConfigurationType::Current), pattern(), mass_);
  for (double& x : mass_) x *= factor;
}

Array SolverWrapper::mass_matrix() const {
  require_initialized("GetSystemMassMatrix");
  auto& self = const_cast<SolverWrapper&>(*this);
  if (mass_.empty()) self.store_mass_matrix(1);
  return dense_matrix("GetSystemMassMatrix", self.pattern(), mass_, solver().sizes().ode2);
}

void SolverWrapper::set_mass_matrix(const Array& matrix) {
  require_initialized("SetSystemMassMatrix");
  std::vector<double> mass(static_cast<std::size_t>(pattern().values()), 0.0);
  read_matrix("SetSystemMassMatrix", matrix, pattern(), mass, solver().sizes().ode2);
  mass_ = std::move(mass);
}

void SolverWrapper::set_jacobian(const Array& matrix) {
  require_initialized("SetSystemJacobian");
  read_matrix("SetSystemJacobian", matrix, pattern(), newton_solver()->jacobian_values(), solver().sizes().total());
}

Array SolverWrapper::jacobian() {
  require_initialized("GetSystemJacobian");
  NewtonSolver* newton = newton_solver();
  return dense_matrix("GetSystemJacobian", newton->pattern(), newton->jacobian_values(), solver().sizes().total());
}

// The current state without accelerations and multipliers: forces only.
State SolverWrapper::quiet_state() {
  State state = main()->system.state(ConfigurationType::Current);
  state.a.assign(state.q.size(), 0.0);
  std::fill(state.lambda.begin(), state.lambda.end(), 0.0);
  return state;
}

template <class Wanted>
void SolverWrapper::add_part(const Weights& weights, const Conditions& conditions, double factor, Wanted&& wanted) {
  if (factor == 0) return;
  NewtonSolver& newton = *newton_solver();
  part_.resize(newton.jacobian_values().size());
  const State state = quiet_state();
  main()->system.tangent(state, conditions, weights, newton.pattern(), part_);
  const std::span<double> values = newton.jacobian_values();
  for_each_entry(newton.pattern(), [&](int row, int column, std::size_t slot) {
    if (wanted(row, column)) values[slot] += factor * part_[slot];
  });
}

// Right-hand sides stand on the other side of the equations: the sign changes.
void SolverWrapper::compute_ode2_jacobian(double q, double v, double y, int loads) {
  std::ranges::fill(newton_solver()->jacobian_values(), 0.0);
  const Sizes s = solver().sizes();
  add_part({.q = q, .v = v, .a = 0, .y = y, .y_t = 0}, {.loads = loads > 0, .load_dependencies = loads}, -1,
           [s](int row, int column) { return row < s.ode2 && column < s.first_ae(); });
}

void SolverWrapper::add_ode1_jacobian(double q, double v, double y) {
  const Sizes s = solver().sizes();
  if (s.ode1 == 0) return;
  add_part({.q = q, .v = v, .a = 0, .y = y, .y_t = 0}, {}, 1,
           [s](int row, int column) { return row >= s.ode2 && row < s.first_ae() && column < s.first_ae(); });
}

void SolverWrapper::add_ae_jacobian(double q, double v, double y, bool rate_level) {
  const Sizes s = solver().sizes();
  if (s.ae == 0) return;
  add_part({.q = 1, .v = 0, .a = 0, .y = 0, .y_t = 0}, {.rate_level = rate_level}, q,
           [s](int row, int column) { return row >= s.first_ae() && column < s.ode2; });
  add_part({.q = 0, .v = 1, .a = 0, .y = 0, .y_t = 0}, {.rate_level = rate_level}, v,
           [s](int row, int column) { return row >= s.first_ae() && column < s.ode2; });
  add_part({.q = 1, .v = 0, .a = 0, .y = 1, .y_t = 0}, {.rate_level = rate_level}, y,
           [s](int row, int column) { return row >= s.first_ae() && column >= s.ode2 && column < s.first_ae(); });
  add_part({.q = 1, .v = 0, .a = 0, .y = 1, .y_t = 0}, {.rate_level = rate_level}, 1,
           [s](int, int column) { return column >= s.first_ae(); });
}

void SolverWrapper::compute_forces() {
  main()->system.forces(main()->system.state(ConfigurationType::Current), {},
                        residual().first(static_cast<std::size_t>(solver().sizes().ode2)));
}

void SolverWrapper::compute_rates() {
  const Sizes& s = solver().sizes();
  main()->system.rates(main()->system.state(ConfigurationType::Current), {},
                       residual().subspan(static_cast<std::size_t>(s.ode2), static_cast<std::size_t>(s.ode1)));
}

void SolverWrapper::compute_gaps(bool rate_level) {
  main()->system.gaps(main()->system.state(ConfigurationType::Current), {.rate_level = rate_level},
                      residual().subspan(static_cast<std::size_t>(solver().sizes().first_ae())));
}

}  // namespace dalembert
