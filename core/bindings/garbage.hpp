// A MainSystem whose user functions refer to it is a cycle; the garbage collector of Python finds it.
#pragma once

#include <Python.h>

namespace dalembert {

void collect_main_systems(PyHeapTypeObject* type);

}  // namespace dalembert
