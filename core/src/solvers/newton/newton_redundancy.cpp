// Newton's method with constraints that follow from others, contradict each other a little, or are about to become dependent.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "constraints/constraint_states.hpp"
#include "dalembert/solvers/newton.hpp"

namespace dalembert {

namespace {

constexpr double silent_misfit = RedundantConstraints::silent_misfit;
// Logarithm of the square of a step size, beyond which weights are those of other matrices.
constexpr double other_step = 4.6;
constexpr double harmless_multiple = 0.01;  // of eps may be left open, in units of gaps, by multipliers from which no force comes
constexpr double torn_apart = 0.1;  // gaps relative to the size of the model, or in radians
// Before anything is known of the matrix: large enough that round-off hardly shows, and if that is too large, `try_harder` takes less.
constexpr double first_eps = RedundantConstraints::regular_eps;
// Of equations that are left out. Many in one part have combinations that take longer to find than what regularized factors take more.
constexpr int most_left_out = 32, fewest_steps_held = 10, most_inclusions = 8;

// Joints that are far apart hide what is redundant, until their gaps are closed.
bool hides_some(const RedundantConstraints& found, const Conditions& conditions) {
  return !conditions.rate_level && !(found.counting() < RedundantConstraints::largest_eps);
}

}  // namespace

bool NewtonSolver::treats_redundancy() const {
  return dalembert::treats_redundancy(sizes_, settings().redundantConstraints, settings().linearSolverSettings.ignoreSingularJacobian);
}

bool NewtonSolver::measure_redundancy() {
  measured_for_ = row_scale();
  return redundant_.measure(system(), *pattern_, jacobian_, settings().redundantConstraints.momentLength, rate_factor());
}

void NewtonSolver::allow_for_gaps() { redundant_.allow_for(gaps_of_positions(system(), current(), conditions_)); }

void NewtonSolver::forget_redundancy() {
  redundant_ = RedundantConstraints();
  plain_.reset();
  misfit_.clear();
  confirmed_ = false;
  left_out_ = {};
  times_included_ = 0;
  looks_at_next_ = treats_redundancy();
  treatment_ = looks_at_next_ ? Treatment::unknown : Treatment::none;
}

void NewtonSolver::examine_constraints_anew() {
  if (!treats_redundancy()) return;
  const bool treated = redundant_.in_use();
  told_multipliers();
  forget_redundancy();
  if (treated) take_pattern();
}

// At the start of a solution, and after events.
void NewtonSolver::constraints_are_known(RedundantConstraints found) {
  if (treatment_ != Treatment::none && treatment_ != Treatment::unknown) return;
  if (found.in_use() && (treatment_ == Treatment::none || found.count() == 0 || !found.consistent())) return;
  if (!found.in_use() && hides_some(found, conditions_)) return;
  looks_at_next_ = false;
  treatment_ = found.in_use() ? Treatment::announced : Treatment::none;
  if (treatment_ == Treatment::none) return;
  redundant_ = std::move(found);
  confirmed_ = redundant_.lasts();
  linear_ = treating_solver();
}

// Where all equations fit, those that follow from others are fulfilled with these.
bool NewtonSolver::may_leave_out() const {
  return confirmed_ && redundant_.consistent() && !redundant_.allows_for_gaps() && redundant_.most_of_a_part() <= most_left_out &&
         !(largest_misfit_ > silent_misfit) && !conditions_.rate_level && !has_replaced_parts() && times_included_ < most_inclusions;
}

[[gnu::noinline]] void NewtonSolver::leave_out(const std::vector<DependentEquations>& parts) {
  treatment_ = Treatment::lasting;
  left_out_ = LeftOutEquations(parts, redundant_.weights(), sizes_.first_ae());
  left_out_.hold(current().lambda);
  steps_to_hold_ = 1;
  linear_ = treating_solver();
  conv.jacobianUpdateRequested = true;
  announce_redundancy();
}

[[gnu::noinline]] void NewtonSolver::follow_left_out() {
  std::vector<double> smallest = current().lambda;
  if (!left_out_.make_smallest(*pattern_, jacobian_, *linear_, smallest)) return include_again();
  steps_to_hold_ = std::max(fewest_steps_held, left_out_.solutions());
  left_out_.hold(smallest);
  const std::vector<DependentEquations> better = left_out_.better();
  const bool are_looked_at = !multipliers_may_wait() && idle_ == Idle::at_factors;
  if (better.empty() && !are_looked_at) return;
  std::ranges::copy(smallest, current().lambda.begin());  // in place: users have views of these numbers
  idle_ = Idle::none;
  if (!better.empty()) leave_out(better);
}

// Where they do not fit, or the rest of the equations is not enough any more.
[[gnu::noinline]] void NewtonSolver::include_again() {
  ++times_included_;
  left_out_ = {};
  confirmed_ = false;
  treatment_ = Treatment::announced;
  linear_ = treating_solver();
  if (idle_ == Idle::at_factors) idle_ = Idle::at_state;
  conv.jacobianUpdateRequested = true;
}

// Combinations are those of all matrices with these constraints, weights are not. False: there are other constraints now.
[[gnu::noinline]] bool NewtonSolver::weigh_again() {
  const RedundantConstraints found = std::exchange(redundant_, {});
  if (measure_redundancy() && redundant_.take_over(found)) {
    redundant_.use(found.eps());
    return true;
  }
  forget_redundancy();
  linear_ = make_linear_solver(*pattern_, linear_type(), newton_options());
  return false;
}

void NewtonSolver::begin_announced_treatment() {
  if (!weigh_again()) return;
  treatment_ = Treatment::lasting;
  treated_since_ = it.currentStepIndex;
  redundant_.use(std::max(redundant_.eps_for(0, conditions_.rate_level), first_eps));
  announce_redundancy();
}

void NewtonSolver::regularize() {
  if (treatment_ == Treatment::announced) begin_announced_treatment();
  if (!left_out_.empty()) return redundant_.count_rates(rate_factor());
  if (treatment_ == Treatment::lasting && !(std::abs(std::log(row_scale() / measured_for_)) < other_step)) weigh_again();
  if (redundant_.in_use()) redundant_.regularize(*pattern_, jacobian_, rate_factor());
}

std::unique_ptr<LinearSolver> NewtonSolver::treating_solver() const {
  const LinearSolverOptions options = newton_options();
  return make_linear_solver(*pattern_, linear_type(), left_out_.empty() ? redundant_.options(options) : left_out_.options(options));
}

// Of which less than eps is left. Which they are does not depend on what resists: stiffness may resist some motions alone, and much more than others,
// where masses resist all. False: the matrix is singular for other reasons as well.
bool NewtonSolver::find_combinations(double eps, LinearSolver& factors) {
  if (!is_static()) return redundant_.find(*pattern_, jacobian_, eps, factors);
  const bool counts = eps == redundant_.counting();
  const double moment_length = settings().redundantConstraints.momentLength;
  return redundant_.take_over(dalembert::redundant_constraints(system(), current(), conditions_, moment_length, counts ? 0 : eps)) &&
         redundant_.find_rest(*pattern_, jacobian_, factors);
}

// With the factors; none: see above.
std::unique_ptr<LinearSolver> NewtonSolver::find_redundancy() {
  auto factors = make_linear_solver(*pattern_, linear_type(), redundant_.options_to_find(newton_options()));
  if (!find_combinations(redundant_.counting(), *factors)) factors.reset();
  return factors;
}

// Before the first prediction of a solution: constraints follow from others where they are fulfilled, and not quite beside that. The factors of
// regular systems do not notice. Static solvers begin where they are, with a matrix that tells all.
[[gnu::noinline]] void NewtonSolver::look_for_redundancy_at_start() {
  treatment_ = Treatment::none;
  begun_at_trial_ = false;
  looks_at_next_ = is_static() && !settings().staticSolver.arcLength.active;
  if (looks_at_next_) return;
  system().reactions_are_known({});
  compute_residual();
  compute_jacobian();
  if (RedundantConstraints::evidently_none(system(), *pattern_, jacobian_)) return;
  if (!measure_redundancy()) return;
  const auto plain = make_linear_solver(*pattern_, linear_type(), newton_options());
  const bool regular = plain->factorize(jacobian_) == LinearSolver::success;
  allow_for_gaps();
  looks_at_next_ = hides_some(redundant_, conditions_);
  if (regular && !redundant_.suspected(*plain)) return;
  const auto factors = find_redundancy();
  if (factors && redundant_.count() > 0) begin_treatment(*factors);
}

// At the first matrix of a step that cannot be factorized, and at the next one after a singular position; later ones are those of `try_harder`.
[[gnu::noinline]] void NewtonSolver::look_for_redundancy() {
  begun_at_trial_ = !std::exchange(looks_at_next_, false);
  if (treatment_ == Treatment::unknown) treatment_ = Treatment::none;
  if (!treats_redundancy() || redundant_.in_use() || (begun_at_trial_ && it.newtonSteps > 1)) return;
  system().reactions_are_known({});
  if (!conv.linearSolverFailed && RedundantConstraints::evidently_none(system(), *pattern_, jacobian_)) return;
  if (!measure_redundancy()) return;
  allow_for_gaps();
  looks_at_next_ = hides_some(redundant_, conditions_) && !conv.linearSolverFailed;
  if (!conv.linearSolverFailed && !is_static() && !redundant_.suspected(*linear_)) return;
  const auto factors = find_redundancy();
  if (factors && (redundant_.count() > 0 || conv.linearSolverFailed)) begin_treatment(*factors);
}

// Where fewer equations follow from others a little further on.
bool NewtonSolver::is_in_singular_position() {
  if (is_static()) return false;
  ConstrainedMotion motion;
  prepare(motion);
  Conditions conditions = conditions_;
  conditions.rate_level = false;
  return motion.factorize(system(), start_of_step(), conditions) == LinearSolver::success && motion.in_singular_position();
}

void NewtonSolver::begin_treatment(LinearSolver& factors) {
  looks_at_next_ = false;
  system().reactions_are_known(redundant_.equations());
  treatment_ = redundant_.count() > 0 && !is_in_singular_position() ? Treatment::lasting : Treatment::passing;
  double eps = RedundantConstraints::passing_eps;
  if (treatment_ == Treatment::lasting) {
    const auto gaps = std::span<const double>(residual_).subspan(static_cast<std::size_t>(sizes_.first_ae()));
    eps = redundant_.eps_for_gaps(gaps, conditions_.rate_level, [&](double nearly) { find_combinations(nearly, factors); });
    announce_redundancy();
  } else {
    passing_singular_position();
    plain_ = std::move(linear_);
    measure_redundancy();  // no combination lasts
  }
  treated_since_ = it.currentStepIndex;
  redundant_.use(eps);
  confirmed_ = is_static() && treatment_ == Treatment::lasting;
  if (is_static() && may_leave_out()) leave_out(redundant_.dependent());
  else linear_ = treating_solver();
  factorize_anew();
}

// A step that fails in spite of its treatment is repeated without: weights are those of its size.
[[gnu::noinline]] void NewtonSolver::drop_treatment() {
  treatment_ = Treatment::none;
  left_out_ = {};
  redundant_.use(0);
  plain_.reset();
  system().reactions_are_known({});
  linear_ = make_linear_solver(*pattern_, linear_type(), newton_options());
  conv.jacobianUpdateRequested = true;
}

// In the next step, unless the last factors of the first one have told already (`settle_multipliers`): redundancy may have been that of a
// singular position only, and what was to be passed may have come to stay.
[[gnu::noinline]] void NewtonSolver::look_again_at_redundancy() {
  if (treatment_ == Treatment::passing) return end_treatment();
  if (confirmed_) {
    if (left_out_.empty() && may_leave_out()) leave_out(redundant_.dependent());
    return;
  }
  confirmed_ = true;
  if (largest_misfit_ > silent_misfit) return;
  compute_residual();
  compute_jacobian();
  conv.jacobianUpdateRequested = true;
  allow_for_gaps();
  if (!find_combinations(redundant_.counting(), *linear_) && !find_redundancy()) return;
  const bool gone = redundant_.count() == 0;
  system().reactions_are_known(redundant_.equations());
  redundant_.use(gone ? 0 : redundant_.eps_for(0, conditions_.rate_level));
  if (!gone) return;
  treatment_ = Treatment::none;
  linear_ = make_linear_solver(*pattern_, linear_type(), newton_options());
}

void NewtonSolver::factorize_anew() {
  if (redundant_.in_use() && left_out_.empty()) redundant_.regularize(*pattern_, jacobian_, rate_factor());
  conv.linearSolverCausingRow = linear_->factorize(jacobian_);
  conv.linearSolverFailed = conv.linearSolverCausingRow != LinearSolver::success;
}

// The next matrix is looked at again.
void NewtonSolver::end_treatment() {
  treatment_ = Treatment::none;
  redundant_ = RedundantConstraints();
  linear_ = std::move(plain_);
  looks_at_next_ = true;
  conv.jacobianUpdateRequested = true;
}

// Once per call of newton, where constraints may be to blame that it has not converged. True: again from the start of the step.
[[gnu::noinline]] bool NewtonSolver::try_harder() {
  if (!left_out_.empty()) {
    include_again();
    reset_to_start_of_step();
    return true;
  }
  const bool has_been_looked_at = conv.linearSolverFailed && it.newtonSteps <= 1;
  if (tried_harder_ || sizes_.ae == 0 || it.newtonSteps == 0 || has_been_looked_at) return false;
  tried_harder_ = true;
  if (!redundant_.in_use()) return treat_from_start_of_step();
  if (conv.linearSolverFailed) return false;
  const bool fits = misfit_.empty() || redundant_.largest(misfit_) <= silent_misfit;
  redundant_.use(fits ? RedundantConstraints::passing_eps : std::max(redundant_.eps(), RedundantConstraints::largest_eps));
  conv.jacobianUpdateRequested = true;
  reset_to_start_of_step();
  return true;
}

// What Newton's method has tried may be far from any state of the system, where everything looks redundant: joints are as far apart as the
// model is large, and nothing is to be learned.
bool NewtonSolver::treat_from_start_of_step() {
  if (!treats_redundancy() || !measure_redundancy()) return false;
  const auto gaps = std::span<const double>(residual_).subspan(static_cast<std::size_t>(sizes_.first_ae()));
  if (!(redundant_.largest(gaps) < torn_apart) || (!conv.linearSolverFailed && !redundant_.suspected(*linear_))) return false;
  const std::vector<double> tried = residual_;
  reset_to_start_of_step();
  compute_residual();
  compute_jacobian();
  const auto factors = measure_redundancy() ? find_redundancy() : nullptr;
  if (!factors) {
    residual_ = tried;
    return false;
  }
  begun_at_trial_ = true;
  begin_treatment(*factors);
  conv.jacobianUpdateRequested = true;
  return true;
}

// What the increment would leave open shows in its multipliers. The part that no motion closes would make them larger in each
// iteration; it is kept as misfit, which residuals do without. A matrix that has to serve many steps turns round-off into more. Beside a singular
// position, motions close all gaps. So they do where a step is predicted, to second order: that is no misfit, and where it is small, multipliers of
// the size that it gives them do no harm.
[[gnu::noinline]] void NewtonSolver::take_off_misfit() {
  if (treatment_ == Treatment::passing || !left_out_.empty()) return;
  const bool first = std::exchange(predicted_, false);
  // Rates count by what they change within a step, which is less than positions are rounded by.
  const double round_off = RedundantConstraints::round_off_of_gaps / (conditions_.rate_level ? std::max(1.0, rate_factor()) : 1);
  const double harmless = first ? std::max(round_off, harmless_multiple * redundant_.eps()) : round_off;
  const auto multipliers = std::span<double>(increment_).subspan(static_cast<std::size_t>(sizes_.first_ae()));
  const bool open = !full_newton_ || redundant_.leaves_open(multipliers, harmless);
  if (!open) return;
  if (first) return redundant_.take_off_idle_solution(*linear_, increment_);
  misfit_.resize(multipliers.size());
  redundant_.take_off_idle_solution(*linear_, increment_, misfit_, conditions_.rate_level ? RedundantConstraints::many_times : 1);
}

// Where the first correction has met the tolerance.
bool NewtonSolver::leaves_misfit() const {
  constexpr double silent = RedundantConstraints::silent_misfit;
  if (!misfit_.empty() || treatment_ == Treatment::passing) return false;
  const auto gaps = std::span<const double>(residual_).subspan(static_cast<std::size_t>(sizes_.first_ae()));
  return redundant_.largest(gaps) > silent && redundant_.largest(redundant_.misfit(gaps)) > silent;
}

double NewtonSolver::residual_without_misfit() {
  const auto gaps = std::span<double>(residual_).subspan(static_cast<std::size_t>(sizes_.first_ae()));
  for (std::size_t k = 0; k < gaps.size(); ++k) gaps[k] -= misfit_[k];
  return norm_of(unscaled_residual());
}

// Multipliers start from zero in each step: what is idle of them is taken off where somebody looks, by the forces of this state where those of the
// factors are others. This changes no motion.
const std::vector<double>* NewtonSolver::told_multipliers() {
  Idle idle = std::exchange(idle_, Idle::none);
  if (idle == Idle::at_factors && !left_out_.empty()) {
    if (!left_out_.make_smallest(*pattern_, jacobian_, *linear_, current().lambda)) idle = Idle::at_state;
  } else if (idle == Idle::at_factors) {
    redundant_.take_off_idle_part(*linear_, current().lambda);
  }
  if (idle == Idle::at_state) {
    if (!forces_) prepare(*(forces_ = std::make_unique<ConstrainedMotion>()));
    RedundantConstraints known = redundant_;
    if (!known.in_use()) known.use(first_eps);
    forces_->take_off_idle_part(known, system(), current(), conditions_, current().lambda);
  }
  return nullptr;
}

// Iterates may have been further off the constraints: what a motion closes of the gaps that are left now is no misfit. True: Newton's method goes on.
[[gnu::noinline]] bool NewtonSolver::renews_misfit() {
  constexpr double same = 0.1;
  if (!conv.newtonConverged || misfit_.empty() || conditions_.rate_level) return false;
  const double before = redundant_.largest(misfit_);
  if (!(before > silent_misfit)) return false;
  const auto rest = std::span<double>(residual_).subspan(static_cast<std::size_t>(sizes_.first_ae()));
  std::vector<double> gaps(misfit_), change(misfit_);
  for (std::size_t k = 0; k < gaps.size(); ++k) gaps[k] += rest[k];
  const std::vector<double> open = redundant_.left_open(*linear_, gaps);
  for (std::size_t k = 0; k < gaps.size(); ++k) change[k] -= open[k];
  if (!(redundant_.largest(change) > same * before)) return false;
  for (std::size_t k = 0; k < gaps.size(); ++k) rest[k] += change[k];
  misfit_ = open;
  conv.newtonConverged = false;
  return true;
}

// Velocities of joints that are apart contradict each other, also where motions would close all of their gaps.
[[gnu::noinline]] bool NewtonSolver::joints_fit() {
  constexpr double curvature = 0.1;  // of gaps that one linear step leaves open
  if (!conditions_.rate_level) return false;
  const std::vector<double> gaps = gaps_of_positions(system(), current(), conditions_);
  const double open = redundant_.largest_left_open(*linear_, gaps);
  return !(open > std::max(settings().redundantConstraints.largestMisfit, curvature * redundant_.largest_apart(gaps)));
}

// After Newton's method has converged. False: constraints contradict each other too much.
[[gnu::noinline]] bool NewtonSolver::settle_multipliers() {
  if (!left_out_.empty()) {
    idle_ = full_newton_ && !is_static() ? Idle::at_factors : Idle::at_state;
    if (--steps_to_hold_ <= 0 && !is_static()) follow_left_out();
    if (!multipliers_may_wait()) told_multipliers();
    return true;
  }
  const double misfit = misfit_.empty() ? 0 : redundant_.largest(misfit_);
  if (misfit > settings().redundantConstraints.largestMisfit && !joints_fit()) {
    conv.newtonConverged = false;
    conv.stopNewton = contradiction_ = true;
    return false;
  }
  contradiction_ = false;
  // What eps leaves open of weak constraints is no contradiction.
  const auto contradicts = [&] { return redundant_.largest(redundant_.misfit(misfit_)) > silent_misfit; };
  if (misfit > silent_misfit && !conditions_.rate_level && contradicts()) warn_of_contradiction(misfit_);
  largest_misfit_ = std::max(largest_misfit_, misfit);
  const double eps = redundant_.eps_for(misfit, conditions_.rate_level);
  const bool other_eps = treatment_ == Treatment::lasting && eps != redundant_.eps();
  // Factors of an earlier state have its forces, rows of rates are not those of forces, as velocities turn them, and stiffness hardly resists some motions.
  idle_ = full_newton_ && !conditions_.rate_level && !is_static() ? Idle::at_factors : Idle::at_state;
  // Ends of steps by velocities bring parameters of rotation back to unit length: what is idle is that of their state.
  const bool at_once = !multipliers_may_wait() && !conditions_.rate_level;
  if (at_once || treatment_ != Treatment::lasting || other_eps) told_multipliers();
  if (!confirmed_ && treatment_ == Treatment::lasting && !(largest_misfit_ > silent_misfit)) confirmed_ = redundant_.confirm(*pattern_, jacobian_, *linear_);
  if (other_eps) {
    redundant_.use(eps);
    conv.jacobianUpdateRequested = true;
  }
  return true;
}

[[gnu::noinline]] void NewtonSolver::announce_redundancy() {
  if (std::exchange(announced_, true) || !verbose(1)) return;
  std::string text = "  " + std::to_string(redundant_.count()) + " of " + std::to_string(redundant_.rows().size()) +
                     " constraint equations follow from others; where reactions are not unique, the smallest are taken:\n";
  for (const auto& item : redundant_.items(system()))
    text += "    " + item.item + ": " + std::to_string(item.removable) + " of " + std::to_string(item.equations) + " could be left out\n";
  say(1, text);
}

}  // namespace dalembert
