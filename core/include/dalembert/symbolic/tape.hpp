// An expression as a flat list of instructions over one array of numbers.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "dalembert/symbolic/expression.hpp"

namespace dalembert::symbolic {

// Operands and result are places in the array; the second operand of a table is its number in `tables_`.
struct Instruction {
  Op op;
  int result, a, b, c;
  int n;        // components, or rows of the left operand
  int m, k;  // products with matrices: the common dimension, and columns of the right operand
};

class Tape {
 public:
  // `inputs` are variables whose values come with each evaluation. Other variables give the value they have at that time.
  explicit Tape(const Node& root, std::span<const Node> inputs = {});

  // One pointer per input, to the numbers of its shape. May be called from several threads.
  void evaluate(std::span<const double* const> inputs, std::span<double> results) const;
  std::vector<double> evaluate() const;  // evaluates a tape without inputs
  // Results and their derivatives with respect to some numbers of the inputs, which are counted through from the input
  // `first`. `slopes` has the derivatives of all results one after the other.
  void linearize(std::span<const double* const> inputs, std::size_t first, std::span<const int> numbers,
                 std::span<double> results, std::span<double> slopes) const;
  // The derivative of a scalar result with respect to a scalar variable that is no input.
  double derivative(const Expression& variable) const;

  // Variables that are no inputs, in the order in which they occur.
  std::vector<Node> variables() const;
  // A copy in which another variable takes the place of one that is no input.
  Tape replaced(const Expression& variable, const Node& by) const;

  Shape shape() const { return shape_; }
  std::span<const Shape> input_shapes() const { return input_shapes_; }
  std::size_t length() const { return instructions_.size(); }

 private:
  struct Live {
    Node variable;
    int place;
  };
  struct Constant {
    int place;
    double value;
  };
  class Recorder;

  // All numbers in the memory of this thread, without the results of instructions.
  template <class S>
  S* loaded(std::span<const double* const> inputs) const;
  template <int N>
  void sweep(std::span<const double* const> inputs, std::span<const int> places, std::span<double> results,
             std::span<double> slopes) const;

  std::vector<Instruction> instructions_;
  std::vector<Constant> constants_;
  std::vector<Live> live_;
  std::vector<Node> tables_;  // numbers of tables, to which instructions refer
  std::vector<Shape> input_shapes_;
  std::vector<int> input_places_;
  Shape shape_;
  int size_ = 0, result_ = 0;
};

std::vector<double> evaluate(const Node& node);

}  // namespace dalembert::symbolic
