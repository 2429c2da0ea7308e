// Derivatives of tabulated joint equations by the coordinates of both markers, in closed form.
//
// The coordinates that come first displace a frame along the axes, up to four more turn it (PortLayout): blocks of zeros
// are neither computed nor written.
#pragma once

#include <array>

#include "dalembert/contracts/joint_equations.hpp"
#include "dalembert/system/ports.hpp"

namespace dalembert {

template <class Frame>
class JointTangent {
 public:
  JointTangent(const Ports& ports, const std::array<int, 2>& markers, const std::array<Frame, 2>& frames)
      : frames_(frames), span_(frames[1].position - frames[0].position) {
    for (int i = 0; i < 2; ++i) sides_[i] = Side(ports, markers[i]);
    total_ = sides_[0].n + sides_[1].n;
  }
  static bool fits(const Ports& ports, const std::array<int, 2>& markers) {
    for (const int marker : markers)
      if (ports.ports[marker].n - ports.ports[marker].translations > most_turns) return false;
    return true;
  }
  int total() const { return total_; }

  // Adds one equation: the gap's derivative times `scale` by gap_slots, the generalised force of a unit multiplier by
  // multiplier_slots. The reaction of `multiplier` is varied along the way.
  void add(const JointEquation& e, double multiplier, double scale, const int* gap_slots, const int* multiplier_slots,
           double* values) {
    if (e.kind == JointEquation::Kind::displacement) {
      for (int k = 0; k < 3; ++k)
        if (e.first[k] != 0) add_component(k, e.first[k], scale, gap_slots, multiplier_slots, values);
    } else if constexpr (requires(Frame f) { f.rotation; }) {
      if (e.kind == JointEquation::Kind::product) {
        add_product(e, multiplier, scale, gap_slots, multiplier_slots, values);
      } else {
        const Vec3<double> axis = frames_[0].rotation * e.first;
        for (int k = 0; k < 3; ++k) add_component(k, axis[k], scale, gap_slots, multiplier_slots, values);
        add_turning_axis(e.first, axis, multiplier, scale, gap_slots, multiplier_slots, values);
      }
    }
  }
  // Adds the derivative of J^T reaction, J held fixed, to values[slots[row * total + column]].
  void add_forces(const int* slots, double* values) const {
    if constexpr (requires(Frame f) { f.rotation; }) {
      for (int i = 0; i < 2; ++i) {
        const Side& side = sides_[i];
        const double sign = i == 0 ? 1 : -1;
        const Moving moments = side.jacobian_of_turns(3), forces = turns_ ? side.jacobian_of_turns(0) : Moving{};
        for (int j = 0; j < side.turns(); ++j) {
          const Vec3<double> weight{sign * moments[0][j], sign * moments[1][j], sign * moments[2][j]};
          const int* row = slots + (first_column(i) + side.t + j) * total_;
          for (int l = 0; l < 2; ++l) add_turns(l, 1, dot(weight, moment_[l]), row, values);
          if (!turns_) continue;
          add_turns(0, -1, dot(Vec3<double>{sign * forces[0][j], sign * forces[1][j], sign * forces[2][j]}, force_),
                    row, values);
          if (i == 0) add_lever(weight, row, values);
        }
        if (turns_)
          for (int j = 0; j < side.t; ++j)
            add_turns(0, -sign, force_[j], slots + (first_column(i) + j) * total_, values);
      }
    }
  }

 private:
  static constexpr int most_turns = 4;
  using Turns = Vec<double, most_turns>;  // one value per coordinate that rotates a frame; further values are unused
  using Moving = Vec3<Turns>;  // the derivative of a vector

  struct Side {
    int n = 0, t = 0;  // coordinates, and how many of them translate
    double weight = 0;  // of a translation
    const double* derivative = nullptr;
    const double* jacobian = nullptr;

    Side() = default;
    Side(const Ports& ports, int marker)
        : n(ports.ports[marker].n),
          t(ports.ports[marker].translations),
          derivative(ports.derivative(marker)),
          jacobian(ports.jacobian(marker)) {
      if (t > 0) weight = derivative[0];
    }
    int turns() const { return n - t; }
    Moving moved() const { return rows(derivative, 0); }
    Moving jacobian_of_turns(int row) const { return rows(jacobian, row); }
    // How an axis of the frame turns; the rotation's rows follow position and velocity.
    Moving turned(const Vec3<double>& axis) const {
      Moving d;
      for (int i = 0; i < 3; ++i) d[i] = dot(axis, rows(derivative, 6 + 3 * i));
      return d;
    }

    Turns row(const double* of, int row) const { return load<double, most_turns>(of + row * n + t); }

   private:
    Moving rows(const double* of, int first) const {
      if (n == t) return {};
      return {row(of, first), row(of, first + 1), row(of, first + 2)};
    }
  };

  int first_column(int side) const { return side == 0 ? 0 : sides_[0].n; }
  void add_turns(int side, double factor, const Turns& x, const int* slots, double* values) const {
    slots += first_column(side) + sides_[side].t;
    for (int c = 0; c < sides_[side].turns(); ++c) values[slots[c]] += factor * x[c];
  }
  // A displacement along global axis k, times a factor.
  void add_component(int k, double factor, double scale, const int* gap_slots, const int* multiplier_slots,
                     double* values) const {
    for (int i = 0; i < 2; ++i) {
      const Side& side = sides_[i];
      const double sign = i == 0 ? -factor : factor;
      if (k < side.t) {
        values[gap_slots[first_column(i) + k]] += sign * scale * side.weight;
        values[multiplier_slots[first_column(i) + k]] += sign;
      }
      if (side.turns() == 0) continue;
      add_turns(i, sign * scale, side.row(side.derivative, k), gap_slots, values);
      add_turns(i, sign, side.row(side.jacobian, k), multiplier_slots, values);
    }
  }
  void add_product(const JointEquation& e, double multiplier, double scale, const int* gap_slots,
                   const int* multiplier_slots, double* values) {
    const Vec3<double> a = frames_[0].rotation * e.first, b = frames_[1].rotation * e.second, moment = cross(a, b);
    const Moving da = sides_[0].turned(e.first), db = sides_[1].turned(e.second);
    add_turns(0, scale, dot(b, da), gap_slots, values);
    add_turns(1, scale, dot(a, db), gap_slots, values);
    add_turns(0, 1, dot(moment, sides_[0].jacobian_of_turns(3)), multiplier_slots, values);
    add_turns(1, -1, dot(moment, sides_[1].jacobian_of_turns(3)), multiplier_slots, values);
    moment_[0] -= multiplier * cross(b, da);
    moment_[1] += multiplier * cross(a, db);
  }
  // Adds the contribution of an axis that rotates with the first frame to a displacement along it.
  void add_turning_axis(const Vec3<double>& local, const Vec3<double>& axis, double multiplier, double scale,
                        const int* gap_slots, const int* multiplier_slots, double* values) {
    turns_ = true;
    const Moving turned = sides_[0].turned(local);
    add_turns(0, scale, dot(span_, turned), gap_slots, values);
    add_turns(0, -1, dot(cross(span_, axis), sides_[0].jacobian_of_turns(3)), multiplier_slots, values);
    force_ += multiplier * turned;
    lever_[0] += multiplier * cross(span_, turned);
    lever_[0] += multiplier * cross(axis, sides_[0].moved());
    lever_[1] -= multiplier * cross(axis, sides_[1].moved());
    axis_ += multiplier * axis;
  }
  // The moment on the first frame of forces that pass through the second point.
  void add_lever(const Vec3<double>& weight, const int* row, double* values) const {
    const Vec3<double> translation = cross(weight, axis_);
    for (int l = 0; l < 2; ++l) {
      const double sign = l == 0 ? -1 : 1;
      for (int c = 0; c < sides_[l].t; ++c)
        values[row[first_column(l) + c]] += sign * sides_[l].weight * translation[c];
      add_turns(l, -1, dot(weight, lever_[l]), row, values);
    }
  }

  const std::array<Frame, 2>& frames_;
  Vec3<double> span_;
  std::array<Side, 2> sides_;
  int total_ = 0;
  // How the reaction varies with the turns of either frame: the moment on the first frame (its opposite acts on the second)
  // and, of displacements along axes that turn, the force on the second frame (its opposite acts on the first) and the
  // moment on the first alone, which translations vary by the force itself.
  std::array<Moving, 2> moment_{}, lever_{};
  Moving force_{};
  Vec3<double> axis_{};
  bool turns_ = false;
};

}  // namespace dalembert
