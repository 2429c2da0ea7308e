// ObjectContactCoordinate, specs/contacts/coordinate.toml
#pragma once

#include <cmath>

#include "dalembert/contacts/coordinate_parameters.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/frames.hpp"

namespace dalembert {

struct ObjectContactCoordinate : HasPairHistory, SwitchesByUpdate, AlwaysNeedsData, NoPairOutputs, NoConnectorForms {
  using Parameters = ObjectContactCoordinateParameters;
  using Port = ScalarPort;
  static constexpr int data_coordinates = 1;

  // A spring and damper that acts while the gap of the last update is not positive.
  template <class S>
  static std::array<ScalarForce<S>, 2> forces(const Parameters& p, const Context& c, const ScalarFrame<S>& m0,
                                              const ScalarFrame<S>& m1) {
    if (c.data[0] > 0) return {};
    const S f = p.contactStiffness * gap(p, m0, m1) + p.contactDamping * (m1.rate - m0.rate);
    return {ScalarForce<S>{f}, ScalarForce<S>{-f}};
  }

  // Contact that opens or closes within a step is an error; the recommended step ends when that happens.
  static PostNewton update(const Parameters& p, const Context&, const ScalarFrame<double>& m0, const ScalarFrame<double>& m1,
                           const double* start, double* data) {
    PostNewton verdict;
    data[0] = gap(p, m0, m1);
    if ((data[0] > 0) == (start[0] > 0)) return verdict;
    verdict.error = std::abs(data[0] * p.contactStiffness);
    const double rate = m1.rate - m0.rate;
    if (rate != 0) verdict.recommended_step_size = std::abs(start[0] / rate);
    return verdict;
  }

  static int switch_count(const Parameters&) { return 1; }
  static void find_switches(const Parameters& p, const Context& c, const ScalarFrame<double>& m0, const ScalarFrame<double>& m1, Switches& switches) {
    const bool touches = !(c.data[0] > 0);
    switches.holds("contact", touches, touches ? -gap(p, m0, m1) : gap(p, m0, m1));
  }

 private:
  template <class S>
  static S gap(const Parameters& p, const ScalarFrame<S>& m0, const ScalarFrame<S>& m1) {
    return m1.value - m0.value - p.offset;
  }
};

}  // namespace dalembert
