// Derivatives of expressions as expressions.
#include <unordered_map>

#include "dalembert/math/piecewise_cubic.hpp"
#include "dalembert/symbolic/expression.hpp"

namespace dalembert::symbolic {
namespace {

Node operator+(const Node& a, const Node& b) { return apply(Op::add, a, b); }
Node operator-(const Node& a, const Node& b) { return apply(Op::subtract, a, b); }
Node operator-(const Node& a) { return apply(Op::negate, a); }
Node operator*(const Node& a, const Node& b) { return product(a, b); }
Node operator/(const Node& a, const Node& b) { return apply(Op::divide, a, b); }
Node plain(double value) { return constant(value); }
Node root_of(const Node& a) { return apply(Op::sqrt, a); }

// Rates of expressions that rest are not stored: null.
class Rates {
 public:
  explicit Rates(const std::unordered_map<const Expression*, Node>& given) : known_(given) {}

  Node of(const Node& e) const {
    const auto found = known_.find(e.get());
    return found == known_.end() ? nullptr : found->second;
  }
  Node or_zero(const Node& e) const {
    const Node rate = of(e);
    return rate ? rate : zero(e->shape);
  }
  void add(const Node& e) {
    if (is_leaf(*e)) return;
    bool moves = false;
    for (const Node& operand : e->operands) moves = moves || of(operand) != nullptr;
    if (!moves) return;
    if (const Node rate = rate_along(e)) known_.emplace(e.get(), rate);
  }
  static Node zero(Shape shape) {
    return shape.is_scalar() ? constant(0)
                             : variable(shape, std::vector<double>(static_cast<std::size_t>(shape.size())), "");
  }

 private:
  // Product rule for every kind of product.
  Node of_product(const Node& a, const Node& b, Node (*times)(const Node&, const Node&)) const {
    const Node da = of(a), db = of(b);
    if (!da) return times(a, db);
    if (!db) return times(da, b);
    return times(da, b) + times(a, db);
  }

  Node slope_of_one(const Node& e) const {
    const Node& a = e->operands[0];
    const Node one = plain(1);
    switch (e->op) {
      case Op::absolute: return select(apply(Op::less, a, plain(0)), plain(-1), one);
      case Op::exp: return e;
      case Op::sqrt: return plain(0.5) / e;
      case Op::log: return one / a;
      case Op::sin: return apply(Op::cos, a);
      case Op::cos: return -apply(Op::sin, a);
      case Op::tan: return one + e * e;
      case Op::asin: return one / root_of(one - a * a);
      case Op::acos: return plain(-1) / root_of(one - a * a);
      case Op::atan: return one / (one + a * a);
      case Op::sinh: return apply(Op::cosh, a);
      case Op::cosh: return apply(Op::sinh, a);
      case Op::tanh: return one - e * e;
      case Op::asinh: return one / root_of(a * a + one);
      case Op::acosh: return one / root_of(a * a - one);
      case Op::atanh: return one / (one - a * a);
      default: return nullptr;  // steps
    }
  }

  Node of_power(const Node& e) const {
    const Node &a = e->operands[0], &b = e->operands[1];
    const Node da = of(a), db = of(b);
    const Node by_base = da ? b * apply(Op::power, a, b - plain(1)) * da : nullptr;
    const Node by_exponent = db ? select(apply(Op::equal, e, plain(0)), plain(0), apply(Op::log, a) * e) * db : nullptr;
    if (by_base && by_exponent) return by_base + by_exponent;
    return by_base ? by_base : by_exponent;
  }

  // a - n b with an integer n, which rests.
  Node of_remainder(const Node& a, const Node& b, const Node& n) const { return or_zero(a) - n * or_zero(b); }

  Node rate_along(const Node& e) const {
    const auto operand = [&](std::size_t i) -> const Node& { return e->operands[i]; };
    const Node& a = operand(0);
    switch (e->op) {
      case Op::negate: return -of(a);
      case Op::add: return of(a) && of(operand(1)) ? of(a) + of(operand(1)) : of(a) ? of(a) : of(operand(1));
      case Op::subtract: return of(a) && of(operand(1)) ? of(a) - of(operand(1)) : of(a) ? of(a) : -of(operand(1));
      case Op::multiply_components:
        return of_product(a, operand(1),
                          [](const Node& x, const Node& y) { return apply(Op::multiply_components, x, y); });
      case Op::scale:
      case Op::dot:
      case Op::matrix_vector:
      case Op::vector_matrix:
      case Op::matrix_matrix: return of_product(a, operand(1), product);
      case Op::divide: return of(operand(1)) ? (or_zero(a) - e * of(operand(1))) / operand(1) : of(a) / operand(1);
      case Op::power: return of_power(e);
      case Op::atan2: {
        const Node& b = operand(1);
        return (b * or_zero(a) - a * or_zero(b)) / (a * a + b * b);
      }
      case Op::modulo: {
        const Node quotient = a / operand(1);
        return of_remainder(
            a, operand(1),
            select(apply(Op::less, quotient, plain(0)), apply(Op::ceil, quotient), apply(Op::floor, quotient)));
      }
      case Op::floored_modulo: return of_remainder(a, operand(1), apply(Op::floored_quotient, a, operand(1)));
      case Op::minimum: return select(apply(Op::less, a, operand(1)), or_zero(a), or_zero(operand(1)));
      case Op::maximum: return select(apply(Op::greater, a, operand(1)), or_zero(a), or_zero(operand(1)));
      case Op::select:
        return of(operand(1)) || of(operand(2)) ? select(a, or_zero(operand(1)), or_zero(operand(2))) : nullptr;
      case Op::norm: return select(apply(Op::equal, e, plain(0)), plain(0), a * of(a) / e);
      case Op::element: return element(of(a), e->index);
      case Op::gather: {
        std::vector<Node> rates;
        for (const Node& scalar : e->operands) rates.push_back(or_zero(scalar));
        return gather(e->shape, std::move(rates));
      }
      case Op::table: {
        std::vector<double> slopes = PiecewiseCubic(operand(1)->values).derivative();
        const Shape size{static_cast<int>(slopes.size()), 0};
        return table(a, variable(size, std::move(slopes), "")) * of(a);
      }
      case Op::replace: return replace(or_zero(a), e->index, or_zero(operand(1)));
      default: break;
    }
    const Node slope = e->operands.size() == 1 ? slope_of_one(e) : nullptr;
    return slope ? slope * of(a) : nullptr;
  }

  std::unordered_map<const Expression*, Node> known_;
};

}  // namespace

Node rate_of(const Node& root, const std::unordered_map<const Expression*, Node>& given) {
  Rates rates(given);
  for (const Node& e : in_order(root)) rates.add(e);
  return rates.or_zero(root);
}

}  // namespace dalembert::symbolic
