// Static equilibrium by Newton's method, with loads that increase in steps.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "dalembert/solvers/newton.hpp"

namespace dalembert {

// A point of the path at which the stiffness matrix is singular.
struct SingularPoint {
  StepCount step;
  double load_factor;
  bool limit;                // the load has an extremum; otherwise a branch begins
  std::vector<double> mode;  // null vector of ODE2 coordinates; its largest entry is 1
};

class StaticSolver : public NewtonSolver {
 public:
  StaticSolver();
  ~StaticSolver() override;

  bool is_static() const override { return true; }
  std::string name() const override { return "nonlinear static solver"; }
  double load_factor() const override;

  void read_settings() override;
  void pre_initialize() override;
  void initial_conditions() override;
  void update_current_time() override;
  void increase_step_size() override;
  double compute_residual() override;
  void compute_update(bool initial) override;
  void compute_jacobian() override;
  bool discontinuous_iteration() override;
  void look_back() override;
  // Singular points of the last solution, with staticSolver.arcLength.
  const std::vector<SingularPoint>& singular_points() const { return singular_points_; }
  double geometric_factor() const { return geometric_factor_; }  // ratio of successive loads, with loadStepGeometric

 protected:
  bool writes_each_step() const override;

 private:
  double metric_scale() override;
  double stabilizer() const;
  void compute_mass_matrix();
  void turn_multipliers();
  // Adds an increment of all unknowns to the state.
  void move(std::span<const double> step);
  void set_quasi_time(double time);
  void compute_jacobian(double load_dependencies);
  void look_for_motion();
  // Returns coordinates of zero-energy modes (free_motion.cpp); `last` is the matrix of the present factors.
  std::vector<int> free_coordinates(std::span<const double> last);
  std::vector<int> free_of_resistance() const;
  // Modes with negative stiffness, for the present matrix (static_stability.cpp).
  struct Instability {
    int directions = 0;
    std::vector<double> direction;  // one of them, in ODE2 coordinates; empty if there is none
  };
  Instability find_instability();
  void look_for_instability();

  // ---- arc-length continuation (arc_length.cpp) --------------------------------------------------------------------
  struct Path;
  struct PathTangent {
    std::vector<double> direction;  // all unknowns; the ODE2 part has norm 1
    double rate = 0;                // rate of quasi-time per length
    double load = 0;                // norm of the residual per quasi-time
  };
  struct Crossing {
    bool found = false;
    double before = 0, after = 0;  // eigenvalues
    std::vector<double> mode;
  };
  void begin_path();
  void begin_path_step();
  void predict_on_path();
  void correct_on_path();
  bool find_first_tangent();
  PathTangent path_tangent();
  std::vector<double> residual_by_quasi_time();
  std::span<const double> displacements(std::span<const double> unknowns) const;
  bool solve_step_again();
  bool end_path_at(double time);
  void prepare_next_step(const Crossing& crossing, double length);
  bool factorize_at_end();
  void find_modes();
  Crossing find_crossing() const;
  bool go_to_singular_point(const Crossing& crossing);
  void pass_singular_point(const Crossing& crossing);
  void leave_bifurcation(std::span<const double> mode);
  void orient(PathTangent& tangent) const;
  double next_length() const;

  StaticSolverSettings options_;
  double geometric_factor_ = 1;
  std::vector<double> mass_;
  std::unique_ptr<Path> path_;  // null: load steps
  std::vector<SingularPoint> singular_points_;
};

}  // namespace dalembert
