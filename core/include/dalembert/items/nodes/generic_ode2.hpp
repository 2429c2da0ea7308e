// NodeGenericODE2, specs/nodes/generic_ode2.toml: coordinates whose meaning the body on them gives.
#pragma once

#include <string_view>

namespace dalembert {

struct NodeGenericODE2 {
  static constexpr std::string_view item = "NodeGenericODE2";
};

}  // namespace dalembert
