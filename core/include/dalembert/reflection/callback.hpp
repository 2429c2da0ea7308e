// A function that the user supplies, seen from the core: numbers in, numbers out.
#pragma once

#include <span>
#include <vector>

namespace dalembert {

// One argument: a scalar (rows = columns = 0), a vector (columns = 0) or a matrix, row by row.
struct Argument {
  const double* data = nullptr;
  int rows = 0, columns = 0;
  int size() const { return (rows == 0 ? 1 : rows) * (columns == 0 ? 1 : columns); }
};

class Callback {
 public:
  virtual ~Callback() = default;
  // Whether coordinates among the arguments include reference values.
  virtual bool takes_total_coordinates() const { return false; }
  // `results` has the size of the signature in the spec. Throws the exceptions of the user's function.
  virtual void call(double time, int item, std::span<const Argument> arguments, std::span<double> results) const = 0;
  // Variant for a system whose state has not changed since the last call: it may return the previous result if the
  // arguments are equal.
  virtual void recall(double time, int item, std::span<const Argument> arguments, std::span<double> results) const {
    call(time, item, arguments, results);
  }
  // The results of `call`, and their derivatives with respect to some numbers of the arguments, which are counted
  // through: `slopes` has the results' derivatives one after the other. Derivatives that do not exist are not finite. Only for
  // functions that have derivatives.
  virtual void linearize(double /*time*/, int /*item*/, std::span<const Argument> /*arguments*/,
                         std::span<const int> /*numbers*/, std::span<double> /*results*/,
                         std::span<double> /*slopes*/) const {}
  // Variant of `call` for a result of any length.
  virtual std::vector<double> call_any(double time, int item, std::span<const Argument> arguments) const = 0;
  // Whether `linearize` is defined.
  virtual bool has_derivatives() const { return false; }
};

}  // namespace dalembert
