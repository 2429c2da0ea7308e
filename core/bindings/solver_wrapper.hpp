// The Python class of a solver: with the system and the settings of the current call, and with access to its
// matrices.
#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dalembert/solvers/newton.hpp"
#include "main_system.hpp"
#include "settings.hpp"
#include "solver_environment.hpp"

namespace dalembert {

using Array = py::array_t<double>;
using MainPointer = std::shared_ptr<MainSystem>;

// Refused if it is too large for `method` to give.
Array dense_matrix(const char* method, const Pattern& pattern, std::span<const double> values, int size);
Array vector_array(std::span<const double> values);
// Refused if the shape differs, or if an entry lies outside the pattern.
void read_matrix(const char* method, const Array& matrix, const Pattern& pattern, std::span<double> values, int size);
void read_vector(const char* method, const Array& vector, std::span<double> values);

// What MainSolver... classes need besides the solver itself.
class SolverWrapper {
 public:
  virtual ~SolverWrapper() = default;
  virtual Solver& solver() = 0;
  virtual NewtonSolver* newton_solver() { return nullptr; }
  const Solver& solver() const { return const_cast<SolverWrapper*>(this)->solver(); }

  // f() with an initialized solver at work on the system; refused if one of both is in use.
  template <class F>
  auto during(const MainPointer& main, const py::object& settings, const char* method, Work::Extent extent, F&& f) {
    const Work here(main, *this, method, extent);
    require_initialized(method, main);
    attach(main, settings, method, false);
    return f();
  }
  // Variant for methods without settings: uses those of the last call.
  template <class F>
  auto during(const MainPointer& main, const char* method, F&& f) {
    return during(main, settings_object ? settings_object : py::object(py::none()), method, Work::Extent::part, f);
  }
  // Throws if the data refers to a system that has been assembled again, or deleted.
  void require_initialized(const char* method) const;
  void require_own_thread(const char* method) const;

  bool solve_for(const MainPointer& main, const py::object& settings);
  bool initialize_for(const MainPointer& main, const py::object& settings);

  // A copy of the settings that the solver obeys, which writes through at the next call.
  py::object newton_view();
  void set_newton(const py::object& newton);
  void update_newton_view();

  // ---- matrices ----------------------------------------------------------------------------------------------------
  void store_mass_matrix(double factor);
  void compute_ode2_jacobian(double q, double v, double y, int loads);
  void add_ode1_jacobian(double q, double v, double y);
  void add_ae_jacobian(double q, double v, double y, bool rate_level);
  void compute_forces();
  void compute_rates();
  void compute_gaps(bool rate_level);
  Array mass_matrix() const;
  Array jacobian();
  Array residual_array();
  void set_mass_matrix(const Array& matrix);
  void set_jacobian(const Array& matrix);
  void set_residual(const Array& vector);
  std::span<double> residual();
  const Pattern& pattern();

  MainPointer main() const;  // system of the last call; throws if it has been deleted
  std::shared_ptr<SimulationSettings> settings;
  py::object settings_object;
  const Work* work = nullptr;  // the innermost call that is running

 private:
  // Called before every method that uses a system. Hooks are made anew if `renew` is set or the system differs.
  void attach(const MainPointer& main, const py::object& settings, const char* method, bool renew);
  void require_initialized(const char* method, const MainPointer& main) const;
  template <class F>
  bool run(const MainPointer& main, const py::object& settings, const char* method, F&& f);
  [[noreturn]] static void refuse_uninitialized(const char* method, const std::string& problem);
  std::weak_ptr<MainSystem> main_;  // systems keep their solvers in mbs.sys
  // The part of a tangent that `wanted(row, column)` selects is added to the Jacobian, times `factor`.
  template <class Wanted>
  void add_part(const Weights& weights, const Conditions& conditions, double factor, Wanted&& wanted);
  State quiet_state();

  std::optional<SolverEnvironment> environment_;  // empty after SolveSystem: functions are not kept longer than needed
  bool initialized_ = false;
  std::uint64_t version_ = 0;  // version of the system at the initialization
  std::vector<double> mass_, own_residual_, part_;
  py::object newton_settings_;  // settings of which one branch holds the copy
};

template <class Core>
class WrappedSolver : public SolverWrapper, public Core, public std::enable_shared_from_this<WrappedSolver<Core>> {
 public:
  Solver& solver() override { return *this; }
  NewtonSolver* newton_solver() override {
    if constexpr (std::is_base_of_v<NewtonSolver, Core>) {
      return this;
    } else {
      return nullptr;
    }
  }
};

}  // namespace dalembert
