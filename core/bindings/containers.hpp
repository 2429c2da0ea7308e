// Data that users hand over as objects: lists of vectors and matrices, matrices, sections of beams, materials.
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "dalembert/reflection/beam_section.hpp"
#include "dalembert/reflection/storage.hpp"

namespace dalembert {

namespace py = pybind11;

// Vector3DList, Matrix6DList, ...: a list whose entries all have one size.
template <class Entry>
struct EntryList {
  std::vector<Entry> entries;
};

void register_entry_lists(py::module_& module);       // entry_lists.cpp
void register_matrix_container(py::module_& module);  // matrix_container.cpp
void register_beam_sections(py::module_& module);     // beam_sections.cpp
void register_materials(py::module_& module);         // materials.cpp; needs settings

}  // namespace dalembert
