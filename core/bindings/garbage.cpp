// References of a MainSystem for the garbage collector: functions and dictionaries may refer to the system.
#include "garbage.hpp"

#include "dalembert/model/member.hpp"
#include "main_system.hpp"
#include "python_callback.hpp"

namespace dalembert {
namespace {

template <class F>
void each_function(const Model& model, F&& f) {
  for (int k = 0; k < item_kinds; ++k) {
    const ItemKind kind = static_cast<ItemKind>(k);
    for (int i = 0; i < model.count(kind); ++i) {
      const Item& item = model.item(kind, i);
      for (const Row& row : item.type->rows)
        if (row.storage == Storage::user_function) f(*static_cast<const UserFunction*>(member(item.record.get(), row)));
    }
  }
}

MainSystem* system_of(PyObject* self) {
  return py::detail::is_holder_constructed(self) ? py::cast<MainSystem*>(py::handle(self)) : nullptr;
}

// If other owners share the system, such as a container, the collector cannot see them; then nothing is traversed.
int traverse(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  MainSystem* main = system_of(self);
  if (main == nullptr || main->weak_from_this().use_count() != 1) return 0;
  Py_VISIT(main->variables.ptr());
  Py_VISIT(main->sys.ptr());
  for (const auto& [name, function] : main->user_functions) Py_VISIT(function.ptr());
  int stop = 0;
  each_function(main->model, [&](const UserFunction& function) {
    PyObject* owned = owned_function(function);
    if (owned != nullptr && stop == 0) stop = visit(owned, arg);
  });
  return stop;
}

int clear(PyObject* self) {
  if (MainSystem* main = system_of(self)) {
    main->user_functions.clear();
    main->variables = py::dict();
    main->sys = py::dict();
    each_function(main->model, drop_function);
  }
  return 0;
}

}  // namespace

void collect_main_systems(PyHeapTypeObject* type) {
  type->ht_type.tp_flags |= Py_TPFLAGS_HAVE_GC;
  type->ht_type.tp_traverse = traverse;
  type->ht_type.tp_clear = clear;
}

}  // namespace dalembert
