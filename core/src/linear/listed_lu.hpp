// Executes the list of an elimination: for one matrix, S = double, or for several at once, S = Pack.
#pragma once

#include "dalembert/math/pack.hpp"
#include "elimination_list.hpp"

namespace dalembert {

// Factors in place of the entries, and the reciprocals of the pivots. Returns the largest entry of L.
template <class S>
DALEMBERT_INLINE inline S eliminate_listed(const EliminationList& list, S* a, S* inverse) {
  S largest = 0;
  const EliminationList::Update* update = list.updates.data();
  S* lower = a + list.size;
  for (int k = 0; k < list.size; ++k) {
    const S reciprocal = inverse[k] = 1 / a[k];
    for (const S* end = a + list.lower_ends[k]; lower != end; ++lower) {
      *lower *= reciprocal;
      largest = larger(magnitude(*lower), largest);
    }
    for (const auto* end = list.updates.data() + list.update_ends[k]; update != end; ++update)
      a[update->target] -= a[update->factor] * a[update->of];
  }
  return largest;
}

// w := U^-1 L^-1 w
template <class S>
DALEMBERT_INLINE inline void substitute_listed(const EliminationList& list, const S* a, const S* inverse, S* w) {
  for (const auto& u : list.forward) w[u.target] -= a[u.factor] * w[u.of];
  const EliminationList::Update *within = list.within.data(), *before = list.before.data();
  for (const EliminationList::Group& group : list.groups) {
    for (const auto* end = list.within.data() + group.within_end; within != end; ++within) {
      const S scaled = a[within->factor] * inverse[within->of];
      w[within->target] -= scaled * w[within->of];
    }
    for (int i = group.first; i < group.end; ++i) w[i] *= inverse[i];
    for (const auto* end = list.before.data() + group.before_end; before != end; ++before)
      w[before->target] -= a[before->factor] * w[before->of];
  }
}

}  // namespace dalembert
