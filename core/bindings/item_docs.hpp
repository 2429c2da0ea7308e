// Texts of item classes: signatures, docstrings and repr.
#pragma once

#include <string>

#include "item_classes.hpp"

namespace dalembert {

// Whether a unit is shown: false for dimensionless numbers and for numbers with varying units.
inline bool has_unit(const Row& row) { return !row.unit.empty() && row.unit != "1" && row.unit != "various"; }
// Type, check and unit of a parameter; its description has its own line.
std::string row_doc(const ItemType& type, const Row& row);
// Begins with a signature that inspect.signature understands; then summary, parameters and output variables.
std::string class_doc(const ItemClass& item_class, bool visualization);
// Descriptions for Python functions that pass on parameters of an item class: (name, type, check, facts, text) of
// each parameter.
py::list described_parameters(const ItemClass& item_class, bool visualization);
py::list described_outputs(const ItemClass& item_class);
// How a user function is called: "springForceUserFunction(mbs, t, itemNumber, deltaL, ...)"; empty if it is not known.
std::string call_of(const ItemType& type, std::string_view user_function);
// NodePoint(name='foot', referenceCoordinates=[1.0, 0.0, 0.0]): shows only values that differ from the defaults.
std::string item_repr(const ItemClass& item_class, const void* record, bool visualization);

}  // namespace dalembert
