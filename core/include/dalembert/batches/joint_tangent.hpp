// Derivatives of tabulated joint equations by the coordinates of both markers, in closed form.
#pragma once

#include <array>

#include "dalembert/contracts/joint_equations.hpp"
#include "dalembert/system/ports.hpp"

namespace dalembert {

class JointTangent {
 public:
  static constexpr int most = 7;  // coordinates per marker; beyond, the general sweep is as good
  using Columns = std::array<double, most>;

  JointTangent(const Ports& ports, const std::array<int, 2>& markers, const std::array<RigidFrame<double>, 2>& frames)
      : frames_(frames), span_(frames[1].position - frames[0].position) {
    for (int i = 0; i < 2; ++i) {
      n_[i] = ports.ports[markers[i]].n;
      derivative_[i] = ports.derivative(markers[i]);
      jacobian_[i] = ports.jacobian(markers[i]);
    }
  }
  static bool fits(const Ports& ports, const std::array<int, 2>& markers) {
    return ports.ports[markers[0]].n <= most && ports.ports[markers[1]].n <= most;
  }

  // The gap's derivative: to[0 .. n0 + n1). Along the way, the reaction of `multiplier` is varied as well.
  void add(const JointEquation& e, double multiplier, double* to) {
    using enum JointEquation::Kind;
    if (e.kind == product) return add_product(e, multiplier, to);
    const Vec3<double> axis = e.kind == along ? frames_[0].rotation * e.first : e.first;
    row(0, axis, -1, to);
    row(1, axis, 1, to + n_[0]);
    if (e.kind == along) add_turning_axis(e, axis, multiplier, to);
  }
  // Generalised force of a unit multiplier: to[0 .. n0 + n1).
  void multiplier_column(const JointEquation& e, double* to) const {
    std::array<Wrench<double>, 2> unit{};
    add_joint_reaction(e, frames_[0], frames_[1], 1.0, unit);
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < n_[i]; ++j) *to++ = pulled_back(i, j, unit[i].force, unit[i].moment);
    }
  }
  // Calls add(row, column, value) for the derivative of J^T reaction with J held fixed.
  template <class F>
  void forces(F&& add) const {
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < n_[i]; ++j)
        for (int by = 0; by < 2; ++by)
          for (int c = 0; c < n_[by]; ++c) {
            const Varied& v = varied_[by];
            const Vec3<double> moment = i == 0 ? Vec3<double>(v.moment[c] - v.lever[c]) : Vec3<double>(-v.moment[c]);
            double sum = 0;
            for (int k = 0; k < 3; ++k) sum += jacobian_[i][(3 + k) * n_[i] + j] * moment[k];
            if (has_force_)
              for (int k = 0; k < 3; ++k) sum += (i == 0 ? -1 : 1) * jacobian_[i][k * n_[i] + j] * v.force[c][k];
            add(i == 0 ? j : n_[0] + j, by == 0 ? c : n_[0] + c, sum);
          }
  }

 private:
  // Of the force on the second frame, of the moment on the first (its opposite acts on the second), and of the moment that
  // turns the first frame alone.
  struct Varied {
    std::array<Vec3<double>, most> force{}, moment{}, lever{};
  };

  double position(int marker, int i, int c) const { return derivative_[marker][i * n_[marker] + c]; }
  Vec3<double> moved(int marker, int c) const { return {position(marker, 0, c), position(marker, 1, c), position(marker, 2, c)}; }
  // How an axis of the frame turns with column c; the rotation's rows follow position and velocity.
  Vec3<double> turned(int marker, const Vec3<double>& axis, int c) const {
    const double* d = derivative_[marker] + 6 * n_[marker] + c;
    const int n = n_[marker];
    Vec3<double> r;
    for (int i = 0; i < 3; ++i)
      r[i] = d[3 * i * n] * axis[0] + d[(3 * i + 1) * n] * axis[1] + d[(3 * i + 2) * n] * axis[2];
    return r;
  }
  void row(int marker, const Vec3<double>& axis, double sign, double* to) const {
    for (int c = 0; c < n_[marker]; ++c)
      to[c] = sign * (axis[0] * position(marker, 0, c) + axis[1] * position(marker, 1, c) + axis[2] * position(marker, 2, c));
  }
  double pulled_back(int i, int j, const Vec3<double>& force, const Vec3<double>& moment) const {
    double sum = 0;
    for (int k = 0; k < 3; ++k)
      sum += jacobian_[i][k * n_[i] + j] * force[k] + jacobian_[i][(3 + k) * n_[i] + j] * moment[k];
    return sum;
  }
  void add_product(const JointEquation& e, double multiplier, double* to) {
    const Vec3<double> a = frames_[0].rotation * e.first, b = frames_[1].rotation * e.second;
    for (int c = 0; c < n_[0]; ++c) {
      const Vec3<double> d = turned(0, e.first, c);
      to[c] = dot(d, b);
      varied_[0].moment[c] += multiplier * cross(d, b);
    }
    for (int c = 0; c < n_[1]; ++c) {
      const Vec3<double> d = turned(1, e.second, c);
      to[n_[0] + c] = dot(a, d);
      varied_[1].moment[c] += multiplier * cross(a, d);
    }
  }
  void add_turning_axis(const JointEquation& e, const Vec3<double>& axis, double multiplier, double* to) {
    has_force_ = true;
    for (int c = 0; c < n_[0]; ++c) {
      const Vec3<double> d = turned(0, e.first, c);
      to[c] += dot(d, span_);
      varied_[0].force[c] += multiplier * d;
      varied_[0].lever[c] += multiplier * (cross(span_, d) - cross(moved(0, c), axis));
    }
    for (int c = 0; c < n_[1]; ++c) varied_[1].lever[c] += multiplier * cross(moved(1, c), axis);
  }

  std::array<RigidFrame<double>, 2> frames_;
  Vec3<double> span_;
  std::array<int, 2> n_{};
  std::array<const double*, 2> derivative_{}, jacobian_{};
  std::array<Varied, 2> varied_{};
  bool has_force_ = false;
};

}  // namespace dalembert
