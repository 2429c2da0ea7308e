// One item with everything it depends on, as a separate system: outputs before the whole model is assembled.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "dalembert/model/model.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

struct Excerpt {
  struct Source {
    ItemKind kind;
    int number;
    std::shared_ptr<const void> record;
  };

  std::unique_ptr<System> system;
  int number = -1;  // number of the item in it
  std::vector<Source> sources;  // copied items; the requested item comes first
};

Excerpt excerpt(const Model& model, ItemKind kind, int number);

// The equations of one object alone, in the current state of the system that it belongs to. Rows are its ODE2 coordinates,
// then its algebraic equations; multipliers and accelerations are zero, loads do not act.
class ObjectEquations {
 public:
  ObjectEquations(const Model& model, System& whole, int object);

  int coordinates() const { return static_cast<int>(with_.rows.size()) - equations_; }
  int rows() const { return static_cast<int>(with_.rows.size()); }
  std::vector<double> residual();
  // cq dr/dq + cv dr/dv, row by row. Rows of algebraic equations are divided by cq, or by cv if cq is 0.
  std::vector<double> tangent(double cq, double cv);
  std::vector<double> mass_matrix();

 private:
  // The object with all items that it depends on, and these items alone.
  struct Part {
    std::unique_ptr<System> system;
    std::vector<int> rows;  // in the residual of the system
  };
  template <class Evaluate>
  std::vector<double> matrix(Evaluate&& evaluate);

  Part with_, without_;
  int equations_ = 0;
};

// Keeps the last ones: while a model is built, the same items are asked again and again.
class Excerpts {
 public:
  std::shared_ptr<const Excerpt> of(const Model& model, ItemKind kind, int number);

 private:
  std::array<std::shared_ptr<const Excerpt>, 4> kept_;
  std::size_t next_ = 0;
};

}  // namespace dalembert
