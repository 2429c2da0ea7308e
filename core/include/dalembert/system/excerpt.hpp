// One item and all that it stands on, as a system of their own: what an item tells before the whole model is assembled.
#pragma once

#include <memory>

#include "dalembert/model/model.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

struct Excerpt {
  std::unique_ptr<System> system;
  int number = -1;  // of the item in it
};

Excerpt excerpt(const Model& model, ItemKind kind, int number);

}  // namespace dalembert
