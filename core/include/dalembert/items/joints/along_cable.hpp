// Common part of joints on a chain of cable elements, one of which acts at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "dalembert/contracts/many_ports.hpp"
#include "dalembert/math/cubic_hermite.hpp"

namespace dalembert {

template <class P>
struct AlongCable : SwitchesAndSettles {
  enum Marker { body = 0, cable = 1 };  // index among the acting markers
  enum Data { current_element = 0, start_of_step = 1 };
  static constexpr double round_off = 1e-12;  // tolerance of positions, relative to an element

  // The body, its initial cable (the data coordinate has the current one), and all cables.
  static ActingMarkers acting(const P&, int markers) {
    ActingMarkers acting{{0}, {}};
    for (int i = 2; i < markers; ++i) acting.alternatives.push_back(i);
    return acting;
  }
  static int alternative(const P& p, const Context& c) { return element_of(p, c.data); }

  static int elements(const P& p) { return static_cast<int>(p.slidingMarkerNumbers.size()); }
  static int element_of(const P& p, const double* data) {
    return std::clamp(static_cast<int>(std::lround(data[current_element])), 0, elements(p) - 1);
  }
  // The place along all elements at which the current one begins, and where the body was at the start of the step, from there.
  static double offset(const P& p, const double* data) {
    return p.slidingMarkerOffsets[static_cast<std::size_t>(element_of(p, data))];
  }
  static double start(const P& p, const Context& c) { return c.data[start_of_step] - offset(p, c.data); }
  template <class S>
  static double length(const Exchange<S>& x) {
    return value_of(x.values(cable).back());
  }

  // Another element takes over at its end, but for the ends of all.
  static int switch_count(const P&) { return 1; }
  static void find_switch(const P& p, const Exchange<double>& x, double place, const double* data, Switches& switches) {
    const int element = element_of(p, data);
    const double before = element > 0 ? place - offset(p, data) : length(x);
    const double behind = element + 1 < elements(p) ? offset(p, data) + length(x) - place : length(x);
    switches.passes("element", std::min(before, behind), round_off * length(x));
  }
  // How far the body has left the cable.
  static PostNewton leave(const P& p, const Exchange<double>& x, double place, const double* data) {
    const int element = element_of(p, data);
    PostNewton verdict;
    if (element == 0) verdict.error = std::max(verdict.error, offset(p, data) - place);
    if (element + 1 == elements(p)) verdict.error = std::max(verdict.error, place - offset(p, data) - length(x));
    return verdict;
  }

  // How far the body has left its element is the error of the step; it goes on in the next one, if there is one.
  struct Passage {
    PostNewton verdict;
    bool at_end = false;
  };
  static Passage go_on(const P& p, const Exchange<double>& x, double place, double* data) {
    const double before = offset(p, data) - place, behind = -before - length(x);
    const int next = element_of(p, data) + (behind > 0) - (before > 0), last = elements(p) - 1;
    Passage passage{.verdict = {}, .at_end = next < 0 || next > last};
    passage.verdict.error = std::max({before, behind, 0.0});
    data[current_element] = std::clamp(next, 0, last);
    return passage;
  }
  // The way within a step, into data.
  static PostNewton take_over(const P& p, const Exchange<double>& x, const History& h, double& way) {
    double& place = h.data[start_of_step];
    place += std::exchange(way, 0.0);
    const double begin = offset(p, h.data);
    const Passage passage = go_on(p, x, place, h.data);
    if (passage.at_end) place = std::clamp(place, begin, begin + length(x));
    return passage.verdict;
  }

  static void check_cables(const P& p, const Connections& on, const char* marker) {
    if (elements(p) == 0)
      on.refuse("slidingMarkerNumbers", "an empty list", "the markers of the cable elements, in their order");
    for (int i = 1; i < on.markers(); ++i)
      on.require(on.type(i).name == marker, i, i == 1 ? "markerNumbers" : "slidingMarkerNumbers",
                 std::string("a ") + marker);
    if (static_cast<int>(p.slidingMarkerOffsets.size()) != elements(p))
      on.refuse("slidingMarkerOffsets", std::to_string(p.slidingMarkerOffsets.size()) + " offsets",
                std::to_string(elements(p)) + ", one for each of slidingMarkerNumbers");
  }
};

}  // namespace dalembert
