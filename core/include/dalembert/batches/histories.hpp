// Work of connector batches between Newton's method and the next step: histories and switching of items.
#pragma once

#include "dalembert/contracts/switches.hpp"

namespace dalembert {

// `with(entry, call)` calls `call` with the kernel arguments of an entry that follow its parameters.
template <class K>
struct Histories {
  static PostNewton update(const auto& entries, const auto& with) {
    PostNewton result;
    if constexpr (K::has_history)
      each_active(entries, with, [&](const auto& p, const auto&... given) { result.add(K::update(p, given...)); });
    return result;
  }
  static PostNewton settle(const auto& entries, const auto& with) {
    PostNewton result;
    if constexpr (K::settles)
      each_active(entries, with, [&](const auto& p, const auto&... given) { result.add(K::settle(p, given...)); });
    return result;
  }
  static void switch_over(const auto& entries, const auto& with) {
    if constexpr (!K::has_switches)
      return;
    else if constexpr (K::switches_by_update)
      update(entries, with);
    else
      each_active(entries, with, [](const auto& p, const auto&... given) { K::switch_over(p, given...); });
  }
  static void find_switches(const auto& entries, const auto& with, Switches& switches) {
    if constexpr (K::has_switches)
      for (const auto& e : entries) {
        switches.of(e.item);
        if (is_active(e.parameters))
          with(e, [&](const auto&... given) { K::find_switches(e.parameters, given..., switches); });
        else
          switches.none(K::switch_count(e.parameters));
      }
  }

 private:
  static void each_active(const auto& entries, const auto& with, const auto& f) {
    for (const auto& e : entries)
      if (is_active(e.parameters)) with(e, [&](const auto&... given) { f(e.parameters, given...); });
  }
};

}  // namespace dalembert
