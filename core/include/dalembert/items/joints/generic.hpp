// ObjectJointGeneric, specs/joints/generic.toml
#pragma once

#include "dalembert/contracts/joint_equations.hpp"
#include "dalembert/contracts/joint_frames.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/contracts/user_function.hpp"
#include "dalembert/contracts/variation.hpp"
#include "dalembert/joints/generic_parameters.hpp"

namespace dalembert {

struct ObjectJointGeneric : Holonomic, VaryingDirections {
  using Parameters = ObjectJointGenericParameters;
  using Port = RigidPort;
  static constexpr ConstraintForms closed_forms{.reaction = true, .table = true};
  static constexpr int equations = 6;
  static constexpr int offsets = 6;  // prescribed motion: a displacement and Tait-Bryan angles in the first joint frame

  static bool constrains(const Parameters& p, int k) { return p.constrainedAxes[static_cast<std::size_t>(k)] != 0; }
  static Vec<double, 6> offset(const Parameters& p, const Context& c) { return prescribed(p.offsetUserFunction, p, c); }
  static Vec<double, 6> offset_rate(const Parameters& p, const Context& c) {
    return prescribed(p.offsetUserFunction_t, p, c);
  }

  // Displacements along the constrained axes, and products of axes that have to be normal to each other; or, as alternative,
  // the rotation vector between the frames, which vanishes only where they agree.
  template <class S>
  static Vec<S, 6> gap(const Parameters& p, const Context&, const RigidFrame<S>& m0, const RigidFrame<S>& m1,
                       const Vec<S, 6>& offset) {
    const Axes<S> axes(p, m0, m1, offset);
    const Vec3<S> span = m1.position - m0.position;
    const Vec3<S> along = all_translations(p) ? span : transposed_times(axes.A_0i, span);
    Vec<S, 6> g;
    for (int i = 0; i < 3; ++i) g[i] = along[i] - offset[i];
    if (p.alternativeConstraints && locked(p) == 3) {
      // Signs as in the products of axes, which these equations approach where the frames agree.
      const Vec3<S> turn = rotation_vector_of(transpose(axes.A_0i) * axes.A_0j);
      g[3] = turn[0], g[4] = -turn[1], g[5] = -turn[2];
      return g;
    }
    for_each_product(p, [&](int row, int a, int b) { g[row] = dot(column(axes.A_0i, a), column(axes.A_0j, b)); });
    return g;
  }

  template <class S>
  static std::array<Wrench<S>, 2> reaction(const Parameters& p, const Context& c, const RigidFrame<S>& m0,
                                           const RigidFrame<S>& m1, const Vec<double, 6>& lambda) {
    if (p.alternativeConstraints && locked(p) == 3) return virtual_work<ObjectJointGeneric, S>(p, c, m0, m1, lambda);
    const Vec<double, 6> now = offset(p, c);
    Vec<S, 6> o;
    for (int i = 0; i < 6; ++i) o[i] = S(now[i]);
    const Axes<S> axes(p, m0, m1, o);
    Vec3<S> f{S(lambda[0]), S(lambda[1]), S(lambda[2])};
    Vec3<S> lever{};  // the axes of the first frame turn under the displacement
    if (!all_translations(p)) {
      f = axes.A_0i * f;
      lever = cross(m1.position - m0.position, f);
    }
    std::array<Wrench<S>, 2> forces{Wrench<S>{.force = -f, .moment = -lever}, Wrench<S>{.force = f}};
    for_each_product(p, [&](int row, int a, int b) {
      add_moment_of_product(column(axes.A_0i, a), column(axes.A_0j, b), lambda[row], forces);
    });
    return forces;
  }

  // The same as a table, where nothing is prescribed.
  static bool tabulated(const Parameters& p) {
    return !p.offsetUserFunction && !(p.alternativeConstraints && locked(p) == 3);
  }
  static std::array<JointEquation, 6> table(const Parameters& p) {
    using enum JointEquation::Kind;
    std::array<JointEquation, 6> rows{};
    for (int i = 0; i < 3; ++i)
      rows[i] = all_translations(p) ? JointEquation{displacement, column(identity(), i)}
                                    : JointEquation{along, column(p.rotationMarker0, i)};
    for_each_product(p, [&](int row, int a, int b) {
      rows[row] = {product, column(p.rotationMarker0, a), column(p.rotationMarker1, b)};
    });
    return rows;
  }

  static bool output(const Parameters& p, const Context&, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                     const Vec<double, 6>& lambda, OutputVariableType variable, std::vector<double>& values) {
    if (variable == OutputVariableType::ForceLocal) {
      Vec3<double> force = segment<3>(lambda, 0);
      if (all_translations(p)) force = transposed_times(JointAxes<double>(p, m0, m1).A_0i, force);
      values.assign(force.x.begin(), force.x.end());
      return true;
    }
    if (variable == OutputVariableType::TorqueLocal) {
      values = {lambda[3], lambda[4], lambda[5]};
      return true;
    }
    return joint_motion_output(p, m0, m1, variable, values);
  }

 private:
  // Joint axes; the prescribed rotation turns those of the first frame.
  template <class S>
  struct Axes : JointAxes<S> {
    Axes(const Parameters& p, const RigidFrame<S>& m0, const RigidFrame<S>& m1, const Vec<S, 6>& offset)
        : JointAxes<S>(p, m0, m1) {
      if (p.offsetUserFunction) this->A_0i = this->A_0i * tait_bryan_rotation(segment<3>(offset, 3));
    }
  };

  static bool all_translations(const Parameters& p) { return constrains(p, 0) && constrains(p, 1) && constrains(p, 2); }
  static int locked(const Parameters& p) { return constrains(p, 3) + constrains(p, 4) + constrains(p, 5); }

  static Vec<double, 6> prescribed(const UserFunction& f, const Parameters& p, const Context& c) {
    if (!f) return {};
    CallArguments<double, 6> arguments;
    arguments.vector(p.offsetUserFunctionParameters);
    return evaluate<6>(f, c, arguments);
  }

  // Pairs of orthogonal axes: axis a of the first frame, axis b of the second, and the number of the equation.
  template <class F>
  static void for_each_product(const Parameters& p, F&& f) {
    constexpr int x = 0, y = 1, z = 2;
    if (locked(p) == 3) {
      f(3, z, y);
      f(4, z, x);
      f(5, x, y);
      return;
    }
    for (int axis = 0; axis < 3; ++axis) {
      const int low = axis == 0 ? 1 : 0, high = axis == 2 ? 1 : 2;  // the two other axes, in order
      if (locked(p) == 2 && !constrains(p, 3 + axis)) {
        f(3 + low, axis, low);
        f(3 + high, axis, high);
      } else if (locked(p) == 1 && constrains(p, 3 + axis)) {
        f(3 + axis, low, high);
      }
    }
  }
};

}  // namespace dalembert
