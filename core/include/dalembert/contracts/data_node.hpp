// What errors expect of the node of an item that remembers something.
#pragma once

#include <string>

namespace dalembert {

inline std::string data_node_of(int count) { return "a NodeGenericData with numberOfDataCoordinates = " + std::to_string(count); }

}  // namespace dalembert
