// Error texts for the data node of an item with history.
#pragma once

#include <string>

namespace dalembert {

inline std::string data_node_of(int count) {
  return "a NodeGenericData with numberOfDataCoordinates = " + std::to_string(count);
}

}  // namespace dalembert
