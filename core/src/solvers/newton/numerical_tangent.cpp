#include "dalembert/solvers/numerical_tangent.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace dalembert {

namespace {

// An unknown, and by how much it is moved.
struct Move {
  int column;
  double eps;
};

// Residuals on both sides of a state, along columns of the matrix. It is the current state that moves, since user functions
// read that one; it comes back at the end.
class Differences {
 public:
  Differences(System& system, const State& state, const Conditions& conditions, const Weights& weights)
      : system_(system),
        state_(state),
        moved_(system.state(ConfigurationType::Current)),
        saved_(moved_),
        conditions_(conditions),
        weights_(weights),
        increment_(state.q.size(), 0.0),
        up_(static_cast<std::size_t>(system.sizes().total())),
        down_(up_.size()) {
    moved_ = state_;
  }
  ~Differences() { moved_ = saved_; }
  Differences(const Differences&) = delete;
  Differences& operator=(const Differences&) = delete;

  // Moves some unknowns, none of which acts on the rows of another one, to both sides; `rows`: only algebraic ones are needed.
  enum class Rows { all, algebraic };
  void find(std::span<const Move> moves, Rows rows) {
    evaluate(moves, 1, rows, up_);
    evaluate(moves, -1, rows, down_);
  }
  // (r(+eps) - r(-eps)) / (2 eps) in a row of one of them.
  double slope(int row, double eps) const {
    const auto i = static_cast<std::size_t>(row);
    return (up_[i] - down_[i]) / (2 * eps);
  }

 private:
  void evaluate(std::span<const Move> moves, double side, Rows rows, std::vector<double>& r) {
    for (const Move& move : moves) shift(move.column, side * move.eps);
    const bool turns = system_.has_lie_nodes() &&
                       std::ranges::any_of(moves, [&](const Move& move) { return move.column < system_.sizes().ode2; });
    if (turns) system_.compose(state_.q, increment_, moved_.q);
    if (rows == Rows::all)
      system_.residual(moved_, conditions_, r);
    else
      system_.gaps(moved_, conditions_, std::span(r).subspan(static_cast<std::size_t>(system_.sizes().first_ae())));
    if (turns) moved_.q = state_.q;
    for (const Move& move : moves) put_back(move.column);
  }
  void shift(int column, double eps) {
    const Sizes& s = system_.sizes();
    if (column < s.ode2) {
      const auto i = static_cast<std::size_t>(column);
      moved_.q[i] = state_.q[i] + weights_.q * eps;
      moved_.v[i] = state_.v[i] + weights_.v * eps;
      if (!moved_.a.empty()) moved_.a[i] = state_.a[i] + weights_.a * eps;
      increment_[i] = weights_.q * eps;
    } else if (column < s.first_ae()) {
      const auto i = static_cast<std::size_t>(column - s.ode2);
      moved_.y[i] = state_.y[i] + weights_.y * eps;
      moved_.y_t[i] = state_.y_t[i] + weights_.y_t * eps;
    } else {
      const auto i = static_cast<std::size_t>(column - s.first_ae());
      moved_.lambda[i] = state_.lambda[i] + eps;
    }
  }
  void put_back(int column) {
    const Sizes& s = system_.sizes();
    if (column < s.ode2) {
      const auto i = static_cast<std::size_t>(column);
      moved_.q[i] = state_.q[i];
      moved_.v[i] = state_.v[i];
      if (!moved_.a.empty()) moved_.a[i] = state_.a[i];
      increment_[i] = 0;
    } else if (column < s.first_ae()) {
      const auto i = static_cast<std::size_t>(column - s.ode2);
      moved_.y[i] = state_.y[i];
      moved_.y_t[i] = state_.y_t[i];
    } else {
      const auto i = static_cast<std::size_t>(column - s.first_ae());
      moved_.lambda[i] = state_.lambda[i];
    }
  }

  System& system_;
  const State state_;
  State& moved_;
  const State saved_;
  Conditions conditions_;
  Weights weights_;
  std::vector<double> increment_, up_, down_;
};

// Selects the entries that are computed by differences.
class Choice {
 public:
  Choice(System& system, const NewtonNumericalDifferentiationSettings& options)
      : all_(options.doSystemWideDifferentiation),
        algebraic_(options.forAE),
        motion_(options.forODE2 || options.forODE2connectors),
        first_ae_(system.sizes().first_ae()),
        of_items_(all_ && system.calls_user_functions() ? nullptr : &system.pattern(false)) {}

  bool everything() const { return all_; }
  // Only algebraic rows are chosen in these columns: in others, all rows may be.
  bool only_algebraic_rows(int column) const { return !all_ && !motion_ && column < first_ae_; }
  // Columns can be moved at the same time if none of them changes a row in which an entry of another one is chosen: A. R. Curtis,
  // M. J. D. Powell, J. K. Reid, On the estimation of sparse Jacobian matrices, IMA J. Appl. Math. 13, 1974. Each column is
  // separate if dependencies are unknown, as those of user functions are.
  std::vector<std::vector<int>> groups(const Sizes& s) const {
    constexpr char changed = 1, chosen = 2;
    std::vector<std::vector<int>> groups;
    std::vector<std::vector<char>> uses;  // of the rows of each group
    for (int column = 0; column < s.total(); ++column) {
      if (!any_in(column)) continue;
      const auto conflicts = [&](int row) { return selects(row, column) ? changed : chosen; };
      std::size_t g = of_items_ == nullptr ? groups.size() : 0;
      for (; g < groups.size(); ++g) {
        if (only_algebraic_rows(column) != only_algebraic_rows(groups[g].front())) continue;
        if (!any_row(column, [&](int row) { return (uses[g][static_cast<std::size_t>(row)] & conflicts(row)) != 0; }))
          break;
      }
      if (g == groups.size()) {
        groups.emplace_back();
        uses.emplace_back(of_items_ == nullptr ? 0 : static_cast<std::size_t>(s.total()), 0);
      }
      groups[g].push_back(column);
      if (of_items_ != nullptr)
        for_each_row(*of_items_, column, [&](int row) {
          uses[g][static_cast<std::size_t>(row)] |= selects(row, column) ? changed | chosen : changed;
        });
    }
    return groups;
  }
  bool operator()(int row, int column) const {
    return of_items_ == nullptr || (selects(row, column) && of_items_->contains(row, column));
  }

 private:
  bool selects(int row, int column) const {
    return all_ || (row < first_ae_ && column < first_ae_ ? motion_ : algebraic_);
  }
  bool any_in(int column) const {
    return of_items_ == nullptr || any_row(column, [&](int row) { return selects(row, column); });
  }
  // From the last row, as algebraic ones are shared by most columns.
  template <class F>
  bool any_row(int column, const F& f) const {
    const auto rows = of_items_->row_index();
    const int begin = of_items_->column_start()[column];
    for (int k = of_items_->column_start()[column + 1]; k-- > begin;)
      if (f(rows[k])) return true;
    return false;
  }

  bool all_, algebraic_, motion_;
  int first_ae_;
  const Pattern* of_items_;  // dependencies declared by items; null: there may be others
};

double size_of_unknown(const Sizes& s, const State& state, const State& reference, bool with_reference, int column) {
  if (column >= s.first_ae()) return state.lambda[static_cast<std::size_t>(column - s.first_ae())];
  if (column >= s.ode2) return state.y[static_cast<std::size_t>(column - s.ode2)];
  const auto i = static_cast<std::size_t>(column);
  return state.q[i] + (with_reference ? reference.q[i] : 0.0);
}

}  // namespace

void numerical_tangent(System& system, const State& state, const Conditions& conditions, const Weights& weights,
                       const NewtonNumericalDifferentiationSettings& options, const Pattern& pattern,
                       std::span<double> values) {
  const Choice chosen(system, options);
  if (chosen.everything())
    std::ranges::fill(values, 0.0);
  else
    system.tangent(state, conditions, weights, pattern, values);
  const Sizes& s = system.sizes();
  const State& reference = system.state(ConfigurationType::Reference);
  // The weights may be scaled by any factor: steps are not.
  const double unit = weights.q != 0 ? weights.q : 1.0;
  Weights direction = weights;
  for (double* weight : {&direction.q, &direction.v, &direction.a}) *weight /= unit;
  Differences differences(system, state, conditions, direction);
  const double constraints = weights.q == 0 && weights.v != 0 ? 1 / weights.v : 1.0;
  std::vector<Move> moves;
  for (const std::vector<int>& group : chosen.groups(s)) {
    moves.clear();
    for (const int column : group) {
      const double size = size_of_unknown(s, state, reference, options.addReferenceCoordinatesToEpsilon, column);
      moves.push_back({column, options.relativeEpsilon * std::max(options.minimumCoordinateSize, std::abs(size))});
    }
    differences.find(moves,
                     chosen.only_algebraic_rows(group.front()) ? Differences::Rows::algebraic : Differences::Rows::all);
    for (const auto& [column, eps] : moves)
      for_each_row(pattern, column, [&, column = column, eps = eps](int row) {
        if (!chosen(row, column)) return;
        const double factor = column < s.ode2 && row < s.first_ae()          ? unit
                              : column < s.first_ae() && row >= s.first_ae() ? constraints
                                                                             : 1.0;
        values[static_cast<std::size_t>(pattern.slot(row, column))] = factor * differences.slope(row, eps);
      });
  }
}

}  // namespace dalembert
