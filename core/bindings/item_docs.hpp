// Texts of item classes: signatures, docstrings and repr.
#pragma once

#include <string>

#include "item_classes.hpp"

namespace dalembert {

std::string row_doc(const Row& row);
// Begins with a signature that inspect.signature understands.
std::string class_doc(const ItemClass& item_class, bool visualization);
// NodePoint(name='foot', referenceCoordinates=[1.0, 0.0, 0.0]): what differs from the defaults.
std::string item_repr(const ItemClass& item_class, const void* record, bool visualization);

}  // namespace dalembert
