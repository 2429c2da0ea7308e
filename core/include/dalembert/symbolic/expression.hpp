// Expressions that are recorded: scalars, vectors and matrices as a graph whose leaves are constants and variables.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace dalembert::symbolic {

// A scalar has no rows, a vector no columns; matrices are stored row by row.
struct Shape {
  int rows = 0, columns = 0;
  int size() const { return (is_scalar() ? 1 : rows) * (columns == 0 ? 1 : columns); }
  bool is_scalar() const { return rows == 0 && columns == 0; }
  bool is_vector() const { return rows > 0 && columns == 0; }
  bool is_matrix() const { return columns > 0; }
  bool operator==(const Shape&) const = default;
};

enum class Op : std::uint8_t {
  constant,
  variable,
  // functions of one scalar
  absolute,
  sign,
  logical_not,
  round,
  ceil,
  floor,
  exp,
  sqrt,
  log,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  sinh,
  cosh,
  tanh,
  asinh,
  acosh,
  atanh,
  is_finite,
  // functions of two scalars
  divide,
  power,
  atan2,
  modulo,  // modulo as in C, with the sign of the dividend
  floored_modulo,
  floored_quotient,  // % and // of Python
  minimum,
  maximum,
  less,
  less_equal,
  greater,
  greater_equal,
  // one or two operands of any shape; equal and not_equal give a scalar
  negate,
  add,
  subtract,
  multiply_components,
  equal,
  not_equal,
  select,         // IfThenElse(condition, a, b)
  scale,          // scalar * vector or matrix
  dot,
  norm,      // of vectors
  matrix_vector,
  vector_matrix,
  matrix_matrix,
  element,  // element of a vector or matrix: an address, without computation
  gather,         // scalars side by side
  replace,        // a vector or matrix with one other component
  table,          // PiecewiseCubic of a scalar; the second operand is a leaf with the numbers
};

struct Expression;
using Node = std::shared_ptr<Expression>;

struct Expression {
  Op op;
  Shape shape;
  std::vector<Node> operands;
  std::vector<double> values;  // of leaves
  std::string name;            // of variables; may be empty
  int index = 0;  // index of element and replace: row by row
  bool is_open = false;  // variables whose value is not known while a function is recorded
};

Node constant(double value);
Node variable(Shape shape, std::vector<double> values, std::string name);

// These check the shapes of their operands and throw std::invalid_argument.
Node apply(Op op, const Node& a);
Node apply(Op op, const Node& a, const Node& b);
Node product(const Node& a, const Node& b);  // product of scalars, vectors (dot) and matrices
Node select(const Node& condition, const Node& a, const Node& b);
Node element(const Node& a, int index);
Node gather(Shape shape, std::vector<Node> scalars);
Node replace(const Node& a, int index, const Node& scalar);
Node table(const Node& x, const Node& numbers);

bool is_leaf(const Expression& expression);
// All expressions of the graph, operands first.
std::vector<Node> in_order(const Node& root);
// The first variable of the graph whose value is not known; nullptr: there is none.
const Expression* open_variable(const Node& root);
// The derivative of an expression along given rates of variables, as an expression. Other variables rest.
Node rate_of(const Node& root, const std::unordered_map<const Expression*, Node>& rates);

// Name of an operation in stored expressions. All products have the same name: shapes of operands tell them apart.
std::string_view name_of(Op op);
// Throws std::invalid_argument if there is no operation of this name with so many operands.
Node apply(std::string_view name, std::span<const Node> operands);
// "(a + (3 * sin(t)))"
std::string text(const Expression& expression);

struct NamedOp {
  Op op;
  std::string_view name;
};
std::span<const NamedOp> functions_of_one();
std::span<const NamedOp> functions_of_two();

}  // namespace dalembert::symbolic
