// Assignment of the call arguments of an item class: NodePoint(...), VNodePoint(...).
#pragma once

#include <string>
#include <vector>

#include "item_classes.hpp"

namespace dalembert {

// A record to write to. Items and V classes differ only in this.
struct CallTarget {
  const ItemClass& item_class;
  void* record;
  bool visualization;  // a V class

  const std::vector<ItemClass::Argument>& arguments() const;
  std::string where() const;  // for errors
  void assign(std::size_t position, PyObject* value) const;
};

// Positional values, followed by those that the tuple `keywords` names (may be null).
void assign_arguments(const CallTarget& target, PyObject* const* values, std::size_t positional, PyObject* keywords);
// Assigns the arguments that __init__ receives.
void assign_init_arguments(const CallTarget& target, PyObject* args, PyObject* kwargs);

}  // namespace dalembert
