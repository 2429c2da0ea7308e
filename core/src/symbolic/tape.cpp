#include "dalembert/symbolic/tape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "dalembert/math/dual.hpp"
#include "dalembert/math/piecewise_cubic.hpp"

namespace dalembert::symbolic {
namespace {

double value_of_one(Op op, double x) {
  switch (op) {
    case Op::absolute: return std::abs(x);
    case Op::sign: return x > 0 ? 1 : x < 0 ? -1 : 0;
    case Op::logical_not: return x == 0 ? 1 : 0;
    case Op::round: return std::nearbyint(x);  // halves to even numbers, as in Python
    case Op::ceil: return std::ceil(x);
    case Op::floor: return std::floor(x);
    case Op::exp: return std::exp(x);
    case Op::sqrt: return std::sqrt(x);
    case Op::log: return std::log(x);
    case Op::sin: return std::sin(x);
    case Op::cos: return std::cos(x);
    case Op::tan: return std::tan(x);
    case Op::asin: return std::asin(x);
    case Op::acos: return std::acos(x);
    case Op::atan: return std::atan(x);
    case Op::sinh: return std::sinh(x);
    case Op::cosh: return std::cosh(x);
    case Op::tanh: return std::tanh(x);
    case Op::asinh: return std::asinh(x);
    case Op::acosh: return std::acosh(x);
    case Op::atanh: return std::atanh(x);
    default: return std::isfinite(x) ? 1 : 0;  // Op::is_finite
  }
}

// The slope of the function above at x, where its value is y; steps count as flat.
double slope_of_one(Op op, double x, double y) {
  switch (op) {
    case Op::absolute: return x < 0 ? -1 : 1;
    case Op::exp: return y;
    case Op::sqrt: return 0.5 / y;
    case Op::log: return 1 / x;
    case Op::sin: return std::cos(x);
    case Op::cos: return -std::sin(x);
    case Op::tan: return 1 + y * y;
    case Op::asin: return 1 / std::sqrt(1 - x * x);
    case Op::acos: return -1 / std::sqrt(1 - x * x);
    case Op::atan: return 1 / (1 + x * x);
    case Op::sinh: return std::cosh(x);
    case Op::cosh: return std::sinh(x);
    case Op::tanh: return 1 - y * y;
    case Op::asinh: return 1 / std::sqrt(x * x + 1);
    case Op::acosh: return 1 / std::sqrt(x * x - 1);
    case Op::atanh: return 1 / (1 - x * x);
    default: return 0;
  }
}

// A zero rate gives a zero derivative, even if the slope is infinite, as that of a square root at zero.
double times(double slope, double rate) { return rate == 0 ? 0.0 : slope * rate; }

template <int N>
Dual<N> value_of_one(Op op, const Dual<N>& x) {
  Dual<N> r(value_of_one(op, x.value));
  const double slope = slope_of_one(op, x.value, r.value);
  for (int i = 0; i < N; ++i) r.d[i] = times(slope, x.d[i]);
  return r;
}

template <int N>
bool moves(const Dual<N>& x) {
  return std::ranges::any_of(x.d, [](double rate) { return rate != 0; });
}

double power(double x, double y) { return std::pow(x, y); }
template <int N>
Dual<N> power(const Dual<N>& x, const Dual<N>& y) {
  Dual<N> r(std::pow(x.value, y.value));
  if (moves(x)) {
    const double slope = y.value * std::pow(x.value, y.value - 1);
    for (int i = 0; i < N; ++i) r.d[i] += times(slope, x.d[i]);
  }
  if (moves(y)) {
    const double slope = r.value == 0 ? 0.0 : std::log(x.value) * r.value;
    for (int i = 0; i < N; ++i) r.d[i] += times(slope, y.d[i]);
  }
  return r;
}

double modulo(double x, double y) { return std::fmod(x, y); }
template <int N>
Dual<N> modulo(const Dual<N>& x, const Dual<N>& y) {
  Dual<N> r(std::fmod(x.value, y.value));
  const double quotient = std::trunc(x.value / y.value);
  for (int i = 0; i < N; ++i) r.d[i] = x.d[i] - quotient * y.d[i];
  return r;
}

// The remainder has the sign of the divisor.
double floored_modulo(double x, double y) {
  const double r = std::fmod(x, y);
  return r != 0 && (r < 0) != (y < 0) ? r + y : r;
}
double floored_quotient(double x, double y) { return std::round((x - floored_modulo(x, y)) / y); }
template <int N>
Dual<N> floored_modulo(const Dual<N>& x, const Dual<N>& y) {
  Dual<N> r(floored_modulo(x.value, y.value));
  const double quotient = floored_quotient(x.value, y.value);
  for (int i = 0; i < N; ++i) r.d[i] = x.d[i] - quotient * y.d[i];
  return r;
}
template <int N>
Dual<N> floored_quotient(const Dual<N>& x, const Dual<N>& y) {
  return Dual<N>(floored_quotient(x.value, y.value));
}

template <class S>
S value_of_two(Op op, const S& x, const S& y) {
  using std::atan2;
  const double u = value_of(x), v = value_of(y);
  switch (op) {
    case Op::divide: return x / y;
    case Op::power: return power(x, y);
    case Op::atan2: return atan2(x, y);
    case Op::modulo: return modulo(x, y);
    case Op::floored_modulo: return floored_modulo(x, y);
    case Op::floored_quotient: return floored_quotient(x, y);
    case Op::minimum: return u < v ? x : y;
    case Op::maximum: return u > v ? x : y;
    case Op::less: return S(u < v ? 1.0 : 0.0);
    case Op::less_equal: return S(u <= v ? 1.0 : 0.0);
    case Op::greater: return S(u > v ? 1.0 : 0.0);
    default: return S(u >= v ? 1.0 : 0.0);  // Op::greater_equal
  }
}

// left (rows x inner) times right (inner x columns).
template <class S>
void multiply(const S* left, const S* right, S* out, int rows, int inner, int columns) {
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      S sum(0.0);
      for (int l = 0; l < inner; ++l) sum = sum + left[i * inner + l] * right[l * columns + j];
      out[i * columns + j] = sum;
    }
}

template <class S>
bool all_equal(const S* a, const S* b, int n) {
  return std::equal(a, a + n, b, [](const S& x, const S& y) { return value_of(x) == value_of(y); });
}

template <class S>
S norm(const S* a, int n) {
  using std::sqrt;
  S sum(0.0);
  for (int i = 0; i < n; ++i) sum = sum + a[i] * a[i];
  return value_of(sum) == 0 ? S(0.0) : sqrt(sum);
}

double value_in_table(const PiecewiseCubic& table, double x) { return table.at(x).value; }
template <int N>
Dual<N> value_in_table(const PiecewiseCubic& table, const Dual<N>& x) {
  const auto [value, slope] = table.at(x.value);
  Dual<N> r(value);
  for (int i = 0; i < N; ++i) r.d[i] = times(slope, x.d[i]);
  return r;
}

template <class S>
void run(std::span<const Instruction> instructions, std::span<const Node> tables, S* x) {
  for (const Instruction& at : instructions) {
    S* out = x + at.result;
    const S *a = x + at.a, *b = x + at.b, *c = x + at.c;
    switch (at.op) {
      case Op::add:
        for (int i = 0; i < at.n; ++i) out[i] = a[i] + b[i];
        break;
      case Op::subtract:
        for (int i = 0; i < at.n; ++i) out[i] = a[i] - b[i];
        break;
      case Op::negate:
        for (int i = 0; i < at.n; ++i) out[i] = -a[i];
        break;
      case Op::scale:
        for (int i = 0; i < at.n; ++i) out[i] = *a * b[i];
        break;
      case Op::multiply_components:
        for (int i = 0; i < at.n; ++i) out[i] = a[i] * b[i];
        break;
      case Op::select: std::copy_n(value_of(*a) != 0 ? b : c, at.n, out); break;
      case Op::gather: std::copy_n(a, at.n, out); break;
      case Op::equal: *out = S(all_equal(a, b, at.n) ? 1.0 : 0.0); break;
      case Op::not_equal: *out = S(all_equal(a, b, at.n) ? 0.0 : 1.0); break;
      case Op::norm: *out = norm(a, at.n); break;
      case Op::table: *out = value_in_table(PiecewiseCubic(tables[static_cast<std::size_t>(at.b)]->values), *a); break;
      case Op::dot:
      case Op::matrix_vector:
      case Op::vector_matrix:
      case Op::matrix_matrix: multiply(a, b, out, at.n, at.m, at.k); break;
      default:
        *out =
            at.op >= Op::divide && at.op <= Op::greater_equal ? value_of_two(at.op, *a, *b) : value_of_one(at.op, *a);
    }
  }
}

}  // namespace

// Gives every expression of the graph its place, operands first, without recursion.
class Tape::Recorder {
 public:
  explicit Recorder(Tape& tape) : tape_(tape) {}

  int reserve(const Expression& e) {
    const int place = tape_.size_;
    tape_.size_ += e.shape.size();
    places_.emplace(&e, place);
    return place;
  }

  int record(const Node& root) {
    std::vector<Node> open{root};
    while (!open.empty()) {
      const Node e = open.back();
      if (places_.contains(e.get())) {
        open.pop_back();
        continue;
      }
      const std::size_t before = open.size();
      for (const Node& operand : e->op == Op::table ? std::span(e->operands).first(1) : std::span(e->operands))
        if (!places_.contains(operand.get())) open.push_back(operand);
      if (open.size() > before) continue;
      open.pop_back();
      emit(e);
    }
    return places_.at(root.get());
  }

 private:
  int place_of(const Expression& e, std::size_t operand) const {
    return operand < e.operands.size() ? places_.at(e.operands[operand].get()) : 0;
  }

  void copy(int from, int to, int n) { tape_.instructions_.push_back({Op::gather, to, from, 0, 0, n, 0, 0}); }

  void emit(const Node& node) {
    const Expression& e = *node;
    if (e.op == Op::element) {
      places_.emplace(&e, place_of(e, 0) + e.index);
      return;
    }
    const int place = reserve(e), n = e.shape.size();
    switch (e.op) {
      case Op::constant: tape_.constants_.push_back({place, e.values[0]}); return;
      case Op::variable: tape_.live_.push_back({node, place}); return;
      case Op::gather:
        for (int i = 0; i < n; ++i) copy(place_of(e, static_cast<std::size_t>(i)), place + i, 1);
        return;
      case Op::replace:
        copy(place_of(e, 0), place, n);
        copy(place_of(e, 1), place + e.index, 1);
        return;
      default: break;
    }
    if (e.op == Op::table) {
      tape_.instructions_.push_back({e.op, place, place_of(e, 0), static_cast<int>(tape_.tables_.size()), 0, n, 0, 0});
      tape_.tables_.push_back(e.operands[1]);
      return;
    }
    Instruction at{e.op, place, place_of(e, 0), place_of(e, 1), place_of(e, 2), n, 0, 0};
    const Shape left = e.operands[0]->shape;
    switch (e.op) {
      case Op::equal:
      case Op::not_equal:
      case Op::norm: at.n = left.size(); break;
      case Op::dot: at.n = 1, at.m = left.rows, at.k = 1; break;
      case Op::matrix_vector: at.n = left.rows, at.m = left.columns, at.k = 1; break;
      case Op::vector_matrix: at.n = 1, at.m = left.rows, at.k = n; break;
      case Op::matrix_matrix: at.n = left.rows, at.m = left.columns, at.k = e.shape.columns; break;
      default: break;
    }
    tape_.instructions_.push_back(at);
  }

  Tape& tape_;
  std::unordered_map<const Expression*, int> places_;
};

Tape::Tape(const Node& root, std::span<const Node> inputs) : shape_(root->shape) {
  Recorder recorder(*this);
  for (const Node& input : inputs) {
    input_places_.push_back(recorder.reserve(*input));
    input_shapes_.push_back(input->shape);
  }
  result_ = recorder.record(root);
}

template <class S>
S* Tape::loaded(std::span<const double* const> inputs) const {
  thread_local std::vector<S> memory;
  if (memory.size() < static_cast<std::size_t>(size_)) memory.resize(static_cast<std::size_t>(size_));
  S* x = memory.data();
  for (std::size_t i = 0; i < input_places_.size(); ++i)
    std::copy_n(inputs[i], input_shapes_[i].size(), x + input_places_[i]);
  for (const Constant& constant : constants_) x[constant.place] = constant.value;
  for (const Live& live : live_) std::ranges::copy(live.variable->values, x + live.place);
  return x;
}

void Tape::evaluate(std::span<const double* const> inputs, std::span<double> results) const {
  double* x = loaded<double>(inputs);
  run<double>(instructions_, tables_, x);
  std::copy_n(x + result_, results.size(), results.begin());
}

std::vector<double> Tape::evaluate() const {
  std::vector<double> results(static_cast<std::size_t>(shape_.size()));
  evaluate({}, results);
  return results;
}

template <int N>
void Tape::sweep(std::span<const double* const> inputs, std::span<const int> places, std::span<double> results,
                 std::span<double> slopes) const {
  Dual<N>* x = loaded<Dual<N>>(inputs);
  for (std::size_t i = 0; i < places.size(); ++i) x[places[i]].d[i] = 1;
  run<Dual<N>>(instructions_, tables_, x);
  for (std::size_t k = 0; k < results.size(); ++k) {
    const Dual<N>& result = x[static_cast<std::size_t>(result_) + k];
    results[k] = result.value;
    for (std::size_t i = 0; i < places.size(); ++i) slopes[i * results.size() + k] = result.d[i];
  }
}

void Tape::linearize(std::span<const double* const> inputs, std::size_t first, std::span<const int> numbers,
                     std::span<double> results, std::span<double> slopes) const {
  constexpr std::size_t few = 2, most = 6;
  std::size_t done = 0;
  do {
    const std::size_t count = std::min(numbers.size() - done, most);
    std::array<int, most> places{};
    // inputs lie side by side
    for (std::size_t i = 0; i < count; ++i) places[i] = input_places_[first] + numbers[done + i];
    const std::span<double> part = slopes.subspan(done * results.size());
    const std::span<const int> moving = std::span(places).first(count);
    count <= few ? sweep<few>(inputs, moving, results, part) : sweep<most>(inputs, moving, results, part);
    done += count;
  } while (done < numbers.size());
}

std::vector<Node> Tape::variables() const {
  std::vector<Node> found;
  for (const Live& live : live_) found.push_back(live.variable);
  return found;
}

Tape Tape::replaced(const Expression& variable, const Node& by) const {
  Tape made = *this;
  for (Live& live : made.live_)
    if (live.variable.get() == &variable) live.variable = by;
  return made;
}

double Tape::derivative(const Expression& variable) const {
  Dual<1>* x = loaded<Dual<1>>({});
  for (const Live& live : live_)
    if (live.variable.get() == &variable) x[live.place].d[0] = 1;
  run<Dual<1>>(instructions_, tables_, x);
  return x[result_].d[0];
}

std::vector<double> evaluate(const Node& node) { return is_leaf(*node) ? node->values : Tape(node).evaluate(); }

}  // namespace dalembert::symbolic
