// The parameters of an element out of the records of its body and, where it rests, of its node.
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

template <class E, class Record>
void renew_parameters(typename E::Parameters& to, const void* record) {
  const auto& from = static_cast<const Record*>(record)->parameters;
  if constexpr (requires { typename E::RestingNode; }) {
    to.body = from;
  } else if constexpr (ReadsReference<typename E::Parameters>) {
    static_cast<std::remove_cvref_t<decltype(from)>&>(to) = from;
  } else {
    to = from;
  }
}

template <class E, class Record>
void take_parameters(typename E::Parameters& to, const void* record, const Placement& placement) {
  renew_parameters<E, Record>(to, record);
  if constexpr (requires { typename E::RestingNode; })
    to.node = static_cast<const typename E::RestingNode::Record*>(placement.node_records[0])->parameters;
  if constexpr (ReadsReference<typename E::Parameters>)
    to.reference = load<double, E::size>(placement.reference.data());
}

}  // namespace dalembert
