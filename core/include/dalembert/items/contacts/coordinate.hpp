// ObjectContactCoordinate, specs/contacts/coordinate.toml
#pragma once

#include <cmath>
#include <string>

#include "dalembert/contacts/coordinate_parameters.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/laws/impact.hpp"

namespace dalembert {

struct ObjectContactCoordinate : HasPairHistory, SwitchesByUpdate, AlwaysNeedsData, NoConnectorForms {
  using Parameters = ObjectContactCoordinateParameters;
  using Port = ScalarPort;
  // The gap of the last update; with an impact model also the speed at which contact began.
  static constexpr int data_coordinates = any_data_coordinates;
  static int data_of(const Parameters& p) { return p.impactModel == 0 ? 1 : 2; }

  static void check(const Parameters& p, const ItemLabel& item) {
    if (p.impactModel > 2)
      refuse(ErrorKind::value, {item, "impactModel", "", std::to_string(p.impactModel), "0, 1 or 2", ""});
  }

  // The normal force of an impact law that acts while the gap of the last update is not positive.
  template <class S>
  static std::array<ScalarForce<S>, 2> forces(const Parameters& p, const Context& c, const ScalarFrame<S>& m0,
                                              const ScalarFrame<S>& m1) {
    if (c.data[0] > 0) return {};
    const ImpactLaw law(p, p.impactModel == 0 ? 0.0 : c.data[1]);
    const S f = law.normal_force<S>(-gap(p, m0, m1), m0.rate - m1.rate);
    return {ScalarForce<S>{-f}, ScalarForce<S>{f}};
  }

  // Contact that opens or closes within a step is an error; the recommended step ends when that happens.
  static PostNewton update(const Parameters& p, const Context&, const ScalarFrame<double>& m0,
                           const ScalarFrame<double>& m1, const double* start, double* data) {
    PostNewton verdict;
    const double rate = m1.rate - m0.rate;
    data[0] = gap(p, m0, m1);
    if (p.impactModel != 0) data[1] = start[0] > 0 && !(data[0] > 0) ? -rate : start[1];
    if ((data[0] > 0) == (start[0] > 0)) return verdict;
    verdict.error = std::abs(data[0] * p.contactStiffness);
    if (rate != 0) verdict.recommended_step_size = std::abs(start[0] / rate);
    return verdict;
  }

  static int switch_count(const Parameters&) { return 1; }
  static void find_switches(const Parameters& p, const Context& c, const ScalarFrame<double>& m0,
                            const ScalarFrame<double>& m1, Switches& switches) {
    const bool touches = !(c.data[0] > 0);
    switches.holds("contact", touches, touches ? -gap(p, m0, m1) : gap(p, m0, m1));
  }

  static bool output(const Parameters& p, const Context&, const ScalarFrame<double>& m0, const ScalarFrame<double>& m1,
                     OutputVariableType variable, std::vector<double>& values) {
    if (variable != OutputVariableType::Distance) return false;
    values = {gap(p, m0, m1)};
    return true;
  }

 private:
  template <class S>
  static S gap(const Parameters& p, const ScalarFrame<S>& m0, const ScalarFrame<S>& m1) {
    return m1.value - m0.value - p.offset;
  }
};

}  // namespace dalembert
