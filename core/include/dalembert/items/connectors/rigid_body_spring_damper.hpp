// ObjectConnectorRigidBodySpringDamper, specs/connectors/rigid_body_spring_damper.toml
#pragma once

#include "dalembert/connectors/rigid_body_spring_damper_parameters.hpp"
#include "dalembert/contracts/joint_frames.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/contracts/user_function.hpp"

namespace dalembert {

struct ObjectConnectorRigidBodySpringDamper : HasPairHistory, NoSwitches, AlwaysNeedsData, NoConnectorForms {
  using Parameters = ObjectConnectorRigidBodySpringDamperParameters;
  using Port = RigidPort;
  static constexpr int data_coordinates = any_data_coordinates;  // data coordinates of its user function

  // Force and moment in the joint frame; the intrinsic formulation measures them in the middle between the markers.
  template <class S>
  static std::array<Wrench<S>, 2> forces(const Parameters& p, const Context& c, const RigidFrame<S>& m0,
                                         const RigidFrame<S>& m1) {
    const Relative<S> r(p, m0, m1);
    const Vec<S, 6> local = tension(p, c, r);
    const Vec3<S> force = r.A_0c * segment<3>(local, 0), moment = r.A_0c * segment<3>(local, 3);
    Vec3<S> lever{};
    if (p.intrinsicFormulation) lever = cross(r.A_0c * (0.5 * r.displacement), force);
    return {Wrench<S>{force, moment + lever}, Wrench<S>{-force, lever - moment}};
  }

  // The user function returns an error, a recommended step size and new data coordinates.
  static PostNewton update(const Parameters& p, const Context& c, const RigidFrame<double>& m0,
                           const RigidFrame<double>& m1, const double*, double* data) {
    if (!p.postNewtonStepUserFunction) return {};
    const Relative<double> r(p, m0, m1);
    CallArguments<double, arguments_size> arguments;
    add_arguments(p, r, arguments);
    std::array<Argument, 10> all;
    all[0] = {data, c.data_count, 0};
    arguments.describe(std::span(all).subspan(1));
    std::vector<double> results(static_cast<std::size_t>(c.data_count) + 2);
    p.postNewtonStepUserFunction.callback->call(c.time, c.item, all, results);
    std::copy(results.begin() + 2, results.end(), data);
    return {results[0], results[1]};
  }

  static bool output(const Parameters& p, const Context& c, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                     OutputVariableType variable, std::vector<double>& values) {
    const Relative<double> r(p, m0, m1);
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    const auto local = [&] { return p.activeConnector ? tension(p, c, r) : Vec<double, 6>{}; };
    switch (variable) {
      case OutputVariableType::Displacement: vector(m1.position - m0.position); return true;
      case OutputVariableType::DisplacementLocal: vector(r.displacement); return true;
      case OutputVariableType::VelocityLocal: vector(r.velocity); return true;
      case OutputVariableType::Rotation: vector(r.rotation); return true;
      case OutputVariableType::AngularVelocityLocal: vector(r.angular_velocity); return true;
      case OutputVariableType::ForceLocal: vector(segment<3>(local(), 0)); return true;
      case OutputVariableType::TorqueLocal: vector(segment<3>(local(), 3)); return true;
      case OutputVariableType::PotentialEnergy: {
        const Vec<double, 6> stretch = joined(r.displacement, r.rotation) - p.offset;
        values = {p.activeConnector ? 0.5 * dot(stretch, p.stiffness * stretch) : 0.0};
        return !p.springForceTorqueUserFunction;
      }
      default: return false;
    }
  }

 private:
  static constexpr int arguments_size = 12 + 72 + 18 + 6;

  // Relative motion of the joint frames i and j, in the axes of a frame c: i, or half way to j.
  template <class S>
  struct Relative {
    Mat3<S> A_0c;
    Vec3<S> displacement, rotation, velocity, angular_velocity;

    Relative(const Parameters& p, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
      const JointAxes<S> axes(p, m0, m1);
      A_0c = axes.A_0i;
      displacement = transposed_times(A_0c, m1.position - m0.position);
      const Mat3<S> A_ij = transpose(axes.A_0i) * axes.A_0j;
      if (p.intrinsicFormulation) {
        // Logarithm of the relative rigid body motion; the joint frame is half way along it.
        rotation = rotation_vector_of(A_ij);
        displacement = rotation_vector_rate(-rotation, displacement);
        A_0c = axes.A_0i * rotation_vector_rotation(0.5 * rotation);
      } else {
        rotation = tait_bryan_angles(A_ij);
      }
      velocity = transposed_times(A_0c, m1.velocity - m0.velocity);
      angular_velocity = transposed_times(A_0c, m1.angular_velocity - m0.angular_velocity);
    }
  };

  template <class S>
  static Vec<S, 6> joined(const Vec3<S>& a, const Vec3<S>& b) {
    return {a[0], a[1], a[2], b[0], b[1], b[2]};
  }

  template <class S>
  static void add_arguments(const Parameters& p, const Relative<S>& r, CallArguments<S, arguments_size>& arguments) {
    arguments.vector(r.displacement).vector(r.rotation).vector(r.velocity).vector(r.angular_velocity);
    arguments.matrix(p.stiffness)
        .matrix(p.damping)
        .matrix(p.rotationMarker0)
        .matrix(p.rotationMarker1)
        .vector(p.offset);
  }

  template <class S>
  static Vec<S, 6> tension(const Parameters& p, const Context& c, const Relative<S>& r) {
    if (p.springForceTorqueUserFunction) {
      CallArguments<S, arguments_size> arguments;
      add_arguments(p, r, arguments);
      return evaluate<6>(p.springForceTorqueUserFunction, c, arguments);
    }
    return p.stiffness * (joined(r.displacement, r.rotation) - p.offset) +
           p.damping * joined(r.velocity, r.angular_velocity);
  }
};

}  // namespace dalembert
