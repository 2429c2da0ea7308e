#include "item_callback.hpp"

#include "dalembert/model/member.hpp"
#include "item_docs.hpp"
#include "main_system.hpp"

namespace dalembert {

ItemCallback::~ItemCallback() {
  if (Py_IsInitialized() == 0) {
    function_.release();
    return;
  }
  const py::gil_scoped_acquire gil;
  function_ = py::object();
}

std::shared_ptr<const Callback> ItemCallback::bound_to(const ItemType& type, MainSystem& main) const {
  auto bound = copy();
  bound->type_ = &type;
  bound->main_ = main.weak_from_this();
  return bound;
}

const Signature& ItemCallback::signature() const {
  static const Signature none{};
  return row_.signature != nullptr ? *row_.signature : none;
}

std::string ItemCallback::describe(int item) const {
  std::string text = "user function '" + std::string(row_.name) + "'";
  if (type_ == nullptr) return text;
  if (const auto main = main_.lock()) {
    if (!has_this(*main, item)) item = find_this(*main);
    if (item >= 0) return text + " of " + main->model.describe(type_->kind, item);
  }
  return text + " of a " + std::string(type_->name);
}

std::string ItemCallback::expected_call() const { return type_ == nullptr ? "" : call_of(*type_, row_.name); }

bool ItemCallback::has_this(const MainSystem& main, int number) const {
  const Item* item = main.model.find_item(type_->kind, number);
  return item != nullptr && item->type == type_ &&
         static_cast<const UserFunction*>(member(item->record.get(), row_))->callback.get() == this;
}

RunningFunction ItemCallback::running(int item) const {
  const auto words = [](const void* callback, int number) {
    return static_cast<const ItemCallback*>(callback)->describe(number);
  };
  return RunningFunction(main_, RunningFunction::Place::in_evaluation, words, this, item);
}

// Functions of loads are called without their number.
int ItemCallback::find_this(const MainSystem& main) const {
  for (int i = 0; i < main.model.count(type_->kind); ++i)
    if (has_this(main, i)) return i;
  return -1;
}

}  // namespace dalembert
