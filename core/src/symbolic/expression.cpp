#include "dalembert/symbolic/expression.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <unordered_set>

#include "dalembert/math/piecewise_cubic.hpp"

namespace dalembert::symbolic {
namespace {

constexpr std::array of_one{
    NamedOp{Op::absolute, "abs"},      NamedOp{Op::sign, "sign"},   NamedOp{Op::logical_not, "Not"},
    NamedOp{Op::round, "round"},       NamedOp{Op::ceil, "ceil"},   NamedOp{Op::floor, "floor"},
    NamedOp{Op::exp, "exp"},           NamedOp{Op::sqrt, "sqrt"},   NamedOp{Op::log, "log"},
    NamedOp{Op::sin, "sin"},           NamedOp{Op::cos, "cos"},     NamedOp{Op::tan, "tan"},
    NamedOp{Op::asin, "asin"},         NamedOp{Op::acos, "acos"},   NamedOp{Op::atan, "atan"},
    NamedOp{Op::sinh, "sinh"},         NamedOp{Op::cosh, "cosh"},   NamedOp{Op::tanh, "tanh"},
    NamedOp{Op::asinh, "asinh"},       NamedOp{Op::acosh, "acosh"}, NamedOp{Op::atanh, "atanh"},
    NamedOp{Op::is_finite, "isfinite"}};
constexpr std::array of_two{NamedOp{Op::power, "pow"}, NamedOp{Op::atan2, "atan2"}, NamedOp{Op::modulo, "mod"},
                            NamedOp{Op::minimum, "min"}, NamedOp{Op::maximum, "max"}};
constexpr std::array infix{NamedOp{Op::add, "+"},
                           NamedOp{Op::subtract, "-"},
                           NamedOp{Op::divide, "/"},
                           NamedOp{Op::scale, "*"},
                           NamedOp{Op::dot, "*"},
                           NamedOp{Op::matrix_vector, "*"},
                           NamedOp{Op::vector_matrix, "*"},
                           NamedOp{Op::matrix_matrix, "*"},
                           NamedOp{Op::less, "<"},
                           NamedOp{Op::less_equal, "<="},
                           NamedOp{Op::greater, ">"},
                           NamedOp{Op::greater_equal, ">="},
                           NamedOp{Op::equal, "=="},
                           NamedOp{Op::not_equal, "!="},
                           NamedOp{Op::floored_modulo, "%"},
                           NamedOp{Op::floored_quotient, "//"}};

// Names in stored expressions of what is written in another form in texts.
constexpr std::array others{NamedOp{Op::negate, "negate"}, NamedOp{Op::norm, "norm"},
                            NamedOp{Op::multiply_components, "multiply_components"}, NamedOp{Op::select, "select"},
                            NamedOp{Op::table, "table"}};

std::string_view name_in(std::span<const NamedOp> names, Op op) {
  const auto found = std::ranges::find(names, op, &NamedOp::op);
  return found == names.end() ? std::string_view() : found->name;
}

std::string describe(Shape shape) {
  if (shape.is_scalar()) return "a scalar";
  if (!shape.is_matrix()) return "a vector of length " + std::to_string(shape.rows);
  return "a matrix of " + std::to_string(shape.rows) + " x " + std::to_string(shape.columns);
}

[[noreturn]] void refuse_shapes(std::string_view what, Shape a, Shape b) {
  throw std::invalid_argument("symbolic: " + std::string(what) + " is not defined for " + describe(a) + " and " +
                              describe(b));
}

Node make(Op op, Shape shape, std::vector<Node> operands, int index = 0) {
  return std::make_shared<Expression>(Expression{op, shape, std::move(operands), {}, {}, index});
}

std::string number(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

template <class Entry>
std::string bracketed(Shape shape, const Entry& entry) {
  if (shape.is_scalar()) return entry(0);
  std::string result = "[";
  const int columns = shape.is_matrix() ? shape.columns : shape.size();
  for (int i = 0; i < shape.size(); ++i) {
    if (i > 0) result += ",";
    if (shape.is_matrix() && i % columns == 0) result += "[";
    result += entry(i);
    if (shape.is_matrix() && (i + 1) % columns == 0) result += "]";
  }
  return result + "]";
}

std::string place(const Expression& e) {
  const Shape& shape = e.operands[0]->shape;
  if (!shape.is_matrix()) return "[" + std::to_string(e.index) + "]";
  return "[" + std::to_string(e.index / shape.columns) + "," + std::to_string(e.index % shape.columns) + "]";
}

}  // namespace

std::span<const NamedOp> functions_of_one() { return of_one; }
std::span<const NamedOp> functions_of_two() { return of_two; }

std::vector<Node> in_order(const Node& root) {
  std::vector<Node> order, open{root};
  std::unordered_set<const Expression*> done;
  while (!open.empty()) {
    const Node e = open.back();
    const std::size_t before = open.size();
    if (!done.contains(e.get()))
      for (const Node& operand : e->operands)
        if (!done.contains(operand.get())) open.push_back(operand);
    if (open.size() > before) continue;
    open.pop_back();
    if (done.insert(e.get()).second) order.push_back(e);
  }
  return order;
}

const Expression* open_variable(const Node& root) {
  for (const Node& e : in_order(root))
    if (e->is_open) return e.get();
  return nullptr;
}

bool is_leaf(const Expression& expression) { return expression.op == Op::constant || expression.op == Op::variable; }

Node constant(double value) { return std::make_shared<Expression>(Expression{Op::constant, {}, {}, {value}, {}, 0}); }

Node variable(Shape shape, std::vector<double> values, std::string name) {
  return std::make_shared<Expression>(Expression{Op::variable, shape, {}, std::move(values), std::move(name), 0});
}

Node apply(Op op, const Node& a) {
  switch (op) {
    case Op::negate: return make(op, a->shape, {a});
    case Op::norm:
      if (a->shape.is_scalar() || a->shape.is_matrix())
        throw std::invalid_argument("symbolic: NormL2 is defined for vectors");
      return make(op, {}, {a});
    default: break;
  }
  if (!a->shape.is_scalar())
    throw std::invalid_argument("symbolic: " + std::string(name_in(of_one, op)) + " is defined for scalars, not for " +
                                describe(a->shape));
  return make(op, {}, {a});
}

Node apply(Op op, const Node& a, const Node& b) {
  switch (op) {
    case Op::add:
    case Op::subtract:
    case Op::multiply_components:
      if (a->shape != b->shape)
        refuse_shapes(op == Op::multiply_components ? "MultComponents" : name_in(infix, op), a->shape, b->shape);
      return make(op, a->shape, {a, b});
    case Op::equal:
    case Op::not_equal:
      if (a->shape != b->shape) refuse_shapes(name_in(infix, op), a->shape, b->shape);
      return make(op, {}, {a, b});
    default: break;
  }
  if (!a->shape.is_scalar() || !b->shape.is_scalar()) {
    const std::string_view name = name_in(of_two, op);
    refuse_shapes(name.empty() ? name_in(infix, op) : name, a->shape, b->shape);
  }
  return make(op, {}, {a, b});
}

Node product(const Node& a, const Node& b) {
  const Shape &s = a->shape, &t = b->shape;
  if (s.is_scalar()) return make(Op::scale, t, {a, b});
  if (t.is_scalar()) return make(Op::scale, s, {b, a});
  if (s.is_matrix() && t.is_matrix() && s.columns == t.rows)
    return make(Op::matrix_matrix, {s.rows, t.columns}, {a, b});
  if (s.is_matrix() && !t.is_matrix() && s.columns == t.rows) return make(Op::matrix_vector, {s.rows, 0}, {a, b});
  if (!s.is_matrix() && t.is_matrix() && s.rows == t.rows) return make(Op::vector_matrix, {t.columns, 0}, {a, b});
  if (!s.is_matrix() && s == t) return make(Op::dot, {}, {a, b});
  refuse_shapes("*", s, t);
}

Node select(const Node& condition, const Node& a, const Node& b) {
  if (!condition->shape.is_scalar() || a->shape != b->shape) refuse_shapes("IfThenElse", a->shape, b->shape);
  return make(Op::select, a->shape, {condition, a, b});
}

Node element(const Node& a, int index) { return make(Op::element, {}, {a}, index); }

// All components of one vector in their order are the vector.
Node gather(Shape shape, std::vector<Node> scalars) {
  const Node whole = scalars[0]->op == Op::element ? scalars[0]->operands[0] : nullptr;
  int place = 0;
  const bool is_whole = whole && whole->shape == shape && std::ranges::all_of(scalars, [&](const Node& scalar) {
                          return scalar->op == Op::element && scalar->operands[0] == whole && scalar->index == place++;
                        });
  return is_whole ? whole : make(Op::gather, shape, std::move(scalars));
}

Node replace(const Node& a, int index, const Node& scalar) { return make(Op::replace, a->shape, {a, scalar}, index); }

Node table(const Node& x, const Node& numbers) {
  if (!x->shape.is_scalar() || !is_leaf(*numbers) || !numbers->shape.is_vector())
    refuse_shapes("table", x->shape, numbers->shape);
  PiecewiseCubic::check(numbers->values);
  return make(Op::table, {}, {x, numbers});
}

std::string_view name_of(Op op) {
  if (op >= Op::scale && op <= Op::matrix_matrix && op != Op::norm) return "*";
  for (const auto names : {std::span<const NamedOp>(of_one), std::span<const NamedOp>(of_two),
                           std::span<const NamedOp>(infix), std::span<const NamedOp>(others)})
    if (const auto name = name_in(names, op); !name.empty()) return name;
  return "";
}

Node apply(std::string_view name, std::span<const Node> operands) {
  const auto named = [&](std::span<const NamedOp> names) { return std::ranges::find(names, name, &NamedOp::name); };
  if (operands.size() == 1) {
    if (const auto found = named(of_one); found != std::span<const NamedOp>(of_one).end())
      return apply(found->op, operands[0]);
    if (name == "negate") return apply(Op::negate, operands[0]);
    if (name == "norm") return apply(Op::norm, operands[0]);
  } else if (operands.size() == 2) {
    if (name == "*") return product(operands[0], operands[1]);
    if (name == "table") return table(operands[0], operands[1]);
    if (name == "multiply_components") return apply(Op::multiply_components, operands[0], operands[1]);
    if (const auto found = named(of_two); found != std::span<const NamedOp>(of_two).end())
      return apply(found->op, operands[0], operands[1]);
    if (const auto found = named(infix); found != std::span<const NamedOp>(infix).end())
      return apply(found->op, operands[0], operands[1]);
  } else if (operands.size() == 3 && name == "select") {
    return select(operands[0], operands[1], operands[2]);
  }
  throw std::invalid_argument("symbolic: there is no operation '" + std::string(name) + "' of " +
                              std::to_string(operands.size()) + " operands");
}

std::string text(const Expression& e) {
  if (!e.name.empty()) return e.name;
  const auto operand = [&](std::size_t i) { return text(*e.operands[i]); };
  if (is_leaf(e)) return bracketed(e.shape, [&](int i) { return number(e.values[static_cast<std::size_t>(i)]); });
  switch (e.op) {
    case Op::negate: return "(-" + operand(0) + ")";
    case Op::norm: return "NormL2(" + operand(0) + ")";
    case Op::multiply_components: return operand(0) + ".MultComponents(" + operand(1) + ")";
    case Op::select: return "IfThenElse(" + operand(0) + "," + operand(1) + "," + operand(2) + ")";
    case Op::element: return operand(0) + place(e);
    case Op::table: return "table(" + operand(0) + ")";
    case Op::replace: return operand(0) + "{" + place(e) + "=" + operand(1) + "}";
    case Op::gather: return bracketed(e.shape, [&](int i) { return operand(static_cast<std::size_t>(i)); });
    default: break;
  }
  if (const auto sign = name_in(infix, e.op); !sign.empty())
    return "(" + operand(0) + " " + std::string(sign) + " " + operand(1) + ")";
  if (const auto name = name_in(of_one, e.op); !name.empty()) return std::string(name) + "(" + operand(0) + ")";
  return std::string(name_in(of_two, e.op)) + "(" + operand(0) + "," + operand(1) + ")";
}

}  // namespace dalembert::symbolic
