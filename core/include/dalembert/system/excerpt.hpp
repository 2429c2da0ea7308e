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

// Keeps the last ones: while a model is built, the same items are asked again and again.
class Excerpts {
 public:
  std::shared_ptr<const Excerpt> of(const Model& model, ItemKind kind, int number);

 private:
  std::array<std::shared_ptr<const Excerpt>, 4> kept_;
  std::size_t next_ = 0;
};

}  // namespace dalembert
