// Markers that pass on numbers made of all coordinates of their body, such as points of a cable or the coordinates themselves.
//
// A kernel states the numbers (`values`: as many selected ones, their rates, and whatever else a connector has to know, which is
// constant) and the generalised forces that forces on the selected numbers make. Derivatives follow.
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
    requires(const typename K::Parameters& p, const typename K::Constants& k, const ItemType& body, const void* record, std::span<const double> reference, const double* numbers,
             double* results, const Placement& on, const ItemLabel& item) {
      { K::check_body(p, on, item) } -> std::same_as<void>;
      { K::prepare(p, body, record, reference) } -> std::same_as<typename K::Constants>;  // of the body that the marker sits on
      { K::values(p, k) } -> std::same_as<int>;                                // how many numbers there are
      { K::forces(p, k) } -> std::same_as<int>;                                // how many of them are selected: they have forces
      { K::constant_pull_back(p) } -> std::same_as<bool>;                      // whatever the coordinates are
      { K::template map<double>(p, k, numbers, numbers, results) } -> std::same_as<void>;       // of coordinates and their rates
      { K::template pull_back<double>(p, k, numbers, numbers, results) } -> std::same_as<void>;  // of coordinates and forces; is added
      { K::origin(k, numbers, numbers, numbers) } -> std::same_as<Motion<double>>;  // where the marker is shown: of q, v and a
    };

}  // namespace dalembert
