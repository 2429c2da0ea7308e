// Markers with numbers that are computed from all coordinates of their body, such as points of a cable or the
// coordinates themselves. A kernel defines the numbers (`values`: selected ones, their rates, and further constant
// data for connectors) and the generalised forces of forces on the selected numbers. Derivatives follow.
#pragma once

#include <concepts>
#include <span>
#include <vector>

#include "dalembert/frames.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/reflection/item_type.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

template <class K>
concept MappedMarkerKernel =
    requires(const typename K::Parameters& p, const typename K::Constants& k, const ItemType& body, const void* record,
             std::span<const double> reference, const double* numbers, double* results, const Placement& on,
             const ItemLabel& item) {
      { K::check_body(p, on, item) } -> std::same_as<void>;
      { K::prepare(p, body, record, reference) } -> std::same_as<typename K::Constants>;  // of the body of the marker
      { K::values(p, k) } -> std::same_as<int>;  // how many numbers there are
      { K::forces(p, k) } -> std::same_as<int>;  // how many of them are selected: they have forces
      { K::constant_pull_back(p) } -> std::same_as<bool>;  // independent of the coordinates
      // arguments: coordinates and their rates
      { K::template map<double>(p, k, numbers, numbers, results) } -> std::same_as<void>;
      // arguments: coordinates and forces; adds to the result
      { K::template pull_back<double>(p, k, numbers, numbers, results) } -> std::same_as<void>;
      // position of the symbol of the marker, from q, v and a
      { K::origin(k, numbers, numbers, numbers) } -> std::same_as<Motion<double>>;
    };

}  // namespace dalembert
