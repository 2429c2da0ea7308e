// ObjectConnectorPlasticSpring, specs/connectors/plastic_spring.toml
#pragma once

#include <algorithm>

#include "dalembert/connectors/plastic_spring_parameters.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"

namespace dalembert {

struct ObjectConnectorPlasticSpring : HasPairHistory, NoSwitches, AlwaysNeedsData, NoConnectorForms {
  using Parameters = ObjectConnectorPlasticSpringParameters;
  using Port = PointPort;
  static constexpr int data_coordinates = 1;

  // Force in the spring, positive for tension, with the plastic elongation of the last step.
  template <class S>
  static S tension(const Parameters& p, const S& length, double plastic) {
    const S elastic = p.stiffness * (length - p.referenceLength - plastic);
    if (value_of(elastic) > p.yieldForce) return S(p.yieldForce);
    if (value_of(elastic) < -p.yieldForce) return S(-p.yieldForce);
    return elastic;
  }

  // Forces on both markers.
  template <class S>
  static std::array<Force<S>, 2> forces(const Parameters& p, const Context& c, const PointFrame<S>& m0,
                                        const PointFrame<S>& m1) {
    const Vec3<S> span = m1.position - m0.position;
    const S length = norm(span);
    if (value_of(length) == 0) return {};
    const Vec3<S> f = (tension(p, length, c.data[0]) / length) * span;
    return {Force<S>{f}, Force<S>{-f}};
  }

  // The plastic elongation at the end of the step. The force is the same with the new value: no further iteration is needed.
  static PostNewton update(const Parameters& p, const Context&, const PointFrame<double>& m0,
                           const PointFrame<double>& m1, const double* start, double* data) {
    const double length = norm(m1.position - m0.position), limit = p.yieldForce / p.stiffness;
    const double elongation = length - p.referenceLength;
    data[0] = std::clamp(start[0], elongation - limit, elongation + limit);
    return {};
  }

  static bool output(const Parameters& p, const Context& c, const PointFrame<double>& m0, const PointFrame<double>& m1,
                     OutputVariableType variable, std::vector<double>& values) {
    switch (variable) {
      case OutputVariableType::Distance: values = {norm(m1.position - m0.position)}; return true;
      case OutputVariableType::Force: {
        const Vec3<double> f = p.activeConnector ? forces<double>(p, c, m0, m1)[0].force : Vec3<double>{};
        values.assign(f.x.begin(), f.x.end());
        return true;
      }
      default: return false;
    }
  }
};

}  // namespace dalembert
