// ObjectContactSphereTorus, specs/contacts/sphere_torus.toml
#pragma once

#include <string>

#include "dalembert/contacts/sphere_torus_parameters.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/laws/touch.hpp"
#include "dalembert/model/errors.hpp"

namespace dalembert {

struct ObjectContactSphereTorus : HasPairHistory, SwitchesByUpdate, AlwaysNeedsData, NoConnectorForms {
  using Parameters = ObjectContactSphereTorusParameters;
  using Port = RigidPort;
  static constexpr int data_coordinates = TouchData::count;

  template <class S>
  static std::array<Wrench<S>, 2> forces(const Parameters& p, const Context& c, const RigidFrame<S>& m0,
                                         const RigidFrame<S>& m1) {
    if (!(c.data[TouchData::gap] < 0)) return {};
    const InTube<S> touch(p, c, m0, m1);
    const Vec3<S> force = force_on_sphere(p, c.data, touch);
    return {Wrench<S>{force, cross(touch.arm0, force)}, Wrench<S>{-force, -cross(touch.arm1, force)}};
  }

  // Sticking and sliding change from one step to the next.
  static PostNewton update(const Parameters& p, const Context& c, const RigidFrame<double>& m0,
                           const RigidFrame<double>& m1, const double* start, double* data) {
    return update_touch(p, InTube<double>(p, c, m0, m1), start, data);
  }
  static int switch_count(const Parameters&) { return touch_switches; }
  static void find_switches(const Parameters& p, const Context& c, const RigidFrame<double>& m0,
                            const RigidFrame<double>& m1, Switches& switches) {
    const InTube<double> touch(p, c, m0, m1);
    find_touch_switches(p, touch, c.data,
                        ImpactLaw(p, c.data[TouchData::impact]).pull_margin(-touch.gap, touch.penetration_rate),
                        switches);
  }

  static bool output(const Parameters& p, const Context& c, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                     OutputVariableType variable, std::vector<double>& values) {
    const InTube<double> touch(p, c, m0, m1);
    const Vec3<double> span = m1.position - m0.position;
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    switch (variable) {
      case OutputVariableType::Displacement: vector(span); return true;
      case OutputVariableType::Velocity: vector(touch.velocity); return true;
      case OutputVariableType::Director1: vector(direction(span)); return true;
      case OutputVariableType::Director2: vector(touch.radial); return true;
      case OutputVariableType::Director3: vector(touch.normal); return true;
      default: break;
    }
    const bool acts = p.activeConnector && c.data[TouchData::gap] < 0;
    return touch_output(touch, m0.position, acts ? force_on_sphere(p, c.data, touch) : Vec3<double>{}, variable,
                        values);
  }

 private:
  // The normal leads from the centre line of the torus to the sphere.
  template <class S>
  struct InTube : Touch<S> {
    Vec3<S> radial;  // from the center of the torus to its center line

    InTube(const Parameters& p, const Context& c, const RigidFrame<S>& sphere, const RigidFrame<S>& torus) {
      const Vec3<S> axis = torus.rotation * p.torusAxis, span = sphere.position - torus.position;
      radial = direction(span - dot(axis, span) * axis);
      if (value_of(dot(radial, radial)) == 0)
        refuse(ErrorKind::value,
               {"object " + std::to_string(c.item) + " (ObjectContactSphereTorus)", "markerNumbers",
                "the centre of the sphere lies on the axis of the torus at time " + std::to_string(c.time), "", "",
                "The sphere has to be inside the tube of the torus"});
      const Vec3<S> line = p.torusMajorRadius * radial, offset = span - line;
      this->normal = direction(offset);
      this->gap = p.torusMinorRadius - p.radiusSphere - dot(this->normal, offset);
      this->arm0 = (p.radiusSphere + 0.5 * this->gap) * this->normal;
      this->arm1 = line + (p.torusMinorRadius - 0.5 * this->gap) * this->normal;
      this->move(sphere, torus);
    }
  };

  template <class S>
  static Vec3<S> force_on_sphere(const Parameters& p, const double* data, const Touch<S>& touch) {
    return force_on_first(p, data, touch,
                          ImpactLaw(p, data[TouchData::impact]).normal_force(-touch.gap, touch.penetration_rate));
  }
};

}  // namespace dalembert
