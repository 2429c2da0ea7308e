// Derivatives of tabulated joint equations by the coordinates of both markers, in closed form.
#pragma once

#include <algorithm>
#include <array>

#include "dalembert/contracts/joint_equations.hpp"
#include "dalembert/system/ports.hpp"

namespace dalembert {

class JointTangent {
 public:
  static constexpr int most = 7;  // coordinates per marker; beyond, the general sweep is as good

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
    const bool has_force = e.kind != JointEquation::Kind::product, has_moment = e.kind != JointEquation::Kind::displacement;
    for (int i = 0; i < 2; ++i, to += n_[0]) {
      std::fill(to, to + n_[i], 0.0);
      if (has_force) add_pulled_back(i, 0, unit[i].force, to);
      if (has_moment) add_pulled_back(i, 3, unit[i].moment, to);
    }
  }
  // Adds the derivative of J^T reaction, J held fixed, to values[slots[row * (n0 + n1) + column]].
  void add_forces(const int* slots, double* values) const {
    const int total = n_[0] + n_[1];
    for (int i = 0; i < 2; ++i) {
      const double sign = i == 0 ? 1 : -1;
      for (int j = 0; j < n_[i]; ++j, slots += total) {
        Row row{};
        for (int k = 0; k < 3; ++k) {
          const double weight = jacobian_[i][(3 + k) * n_[i] + j];
          add(sign * weight, moment_[k], row);
          if (!turns_) continue;
          if (i == 0) add(-weight, lever_[k], row);
          add(-sign * jacobian_[i][k * n_[i] + j], force_[k], row);
        }
        for (int c = 0; c < total; ++c) values[slots[c]] += row[c];
      }
    }
  }

 private:
  using Row = std::array<double, 2 * most + 2>;  // columns of both markers, and as many as fill the registers

  static void add(double weight, const Row& row, Row& to) {
    for (std::size_t c = 0; c < row.size(); ++c) to[c] += weight * row[c];
  }
  static void put(const Vec3<double>& v, std::array<Row, 3>& to, int c) {
    for (int k = 0; k < 3; ++k) to[k][c] += v[k];
  }

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
  void add_pulled_back(int i, int first, const Vec3<double>& f, double* to) const {
    for (int k = 0; k < 3; ++k) {
      const double* jacobian = jacobian_[i] + (first + k) * n_[i];
      for (int j = 0; j < n_[i]; ++j) to[j] += jacobian[j] * f[k];
    }
  }
  void add_product(const JointEquation& e, double multiplier, double* to) {
    const Vec3<double> a = frames_[0].rotation * e.first, b = frames_[1].rotation * e.second;
    for (int c = 0; c < n_[0]; ++c) {
      const Vec3<double> d = turned(0, e.first, c);
      to[c] = dot(d, b);
      put(multiplier * cross(d, b), moment_, c);
    }
    for (int c = 0; c < n_[1]; ++c) {
      const Vec3<double> d = turned(1, e.second, c);
      to[n_[0] + c] = dot(a, d);
      put(multiplier * cross(a, d), moment_, n_[0] + c);
    }
  }
  void add_turning_axis(const JointEquation& e, const Vec3<double>& axis, double multiplier, double* to) {
    turns_ = true;
    for (int c = 0; c < n_[0]; ++c) {
      const Vec3<double> d = turned(0, e.first, c);
      to[c] += dot(d, span_);
      put(multiplier * d, force_, c);
      put(multiplier * (cross(span_, d) - cross(moved(0, c), axis)), lever_, c);
    }
    for (int c = 0; c < n_[1]; ++c) put(multiplier * cross(moved(1, c), axis), lever_, n_[0] + c);
  }

  std::array<RigidFrame<double>, 2> frames_;
  Vec3<double> span_;
  std::array<int, 2> n_{};
  std::array<const double*, 2> derivative_{}, jacobian_{};
  // How the reaction varies: the moment on the first frame (its opposite acts on the second), and, of displacements along
  // axes that turn, the force on the second frame (its opposite acts on the first) and the moment on the first alone.
  std::array<Row, 3> moment_{}, force_{}, lever_{};
  bool turns_ = false;
};

}  // namespace dalembert
