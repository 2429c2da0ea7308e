// Lists of item numbers as attributes of items: a change of the list is a change of the item.
#pragma once

#include <pybind11/pybind11.h>

namespace dalembert {

// A list with the same entries, which assigns itself to owner.name when it is changed. New reference.
PyObject* make_index_list(PyObject* list, PyObject* owner, PyObject* name);

}  // namespace dalembert
