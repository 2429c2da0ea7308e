// A map of elements that stand on frames (contracts/strain_points.hpp): N nodes with position and rotation, each seen from one of
// them, the base. Rigid motion cancels there, so that any interpolation of what is left is objective.
//
//   d_i = A_b0 (r_i - r_b),  phi_i = log(A_b0 A_0i)  of each other node i, seen from the base b
//
// M. A. Crisfield, G. Jelenic, Objectivity of strain measures in the geometrically exact three-dimensional beam theory and its
// finite-element implementation, Proc. R. Soc. Lond. A 455 (1999). Rotations between nodes of an element stay below half a turn.
#pragma once

#include <algorithm>

#include "dalembert/contracts/strain_points.hpp"
#include "dalembert/math/relative_rotation.hpp"

namespace dalembert {

// Position, and rotation from own to global axes.
template <class S>
struct Pose {
  Vec3<S> position;
  Mat3<S> rotation;
};

template <class NodeType, int Nodes>
struct RelativeFrames {
  using Node = NodeType;
  static constexpr int nodes = Nodes, others = Nodes - 1, node_size = Node::size;
  static constexpr int dimension = 3, vectors = 2 * others, rows = dimension * vectors, size = Nodes * node_size;
  static constexpr int base = others / 2;  // the first of two, the middle of three
  static constexpr int other(int i) { return i < base ? i : i + 1; }
  static constexpr bool linear = false;
  // Increments of coordinates on the group are spins in own axes: derivatives by these have closed forms.
  static constexpr bool derives = LieKernel<Node>;
  static constexpr auto lie_rotations = [] {
    std::array<int, derives ? Nodes : 0> first{};
    if constexpr (derives)
      for (int n = 0; n < Nodes; ++n) first[n] = n * node_size + Node::traits.lie_rotation;
    return first;
  }();

  template <class S>
  using State = Coordinates<S, size>;
  template <class S>
  using Local = Vectors<S, 3, vectors>;

  // Euler parameters may have drifted from unit length: only their direction defines the rotation.
  static constexpr int unit_from = [] {
    if constexpr (Node::traits.unit_from >= 0) return Node::traits.unit_from;
    return node_size;
  }();
  template <class S>
  static S unit_scale(const State<S>& x, int n) {
    if constexpr (unit_from < node_size)
      return 1.0 / norm(segment<node_size - unit_from>(x.q, n * node_size + unit_from));
    return S(1);
  }
  template <class S>
  static Coordinates<S, node_size> of_node(const State<S>& x, int n) {
    const S scale = unit_scale(x, n);
    const auto part = [&](const Vec<S, size>& all) {
      auto own = segment<node_size>(all, n * node_size);
      for (int i = unit_from; i < node_size; ++i) own[i] = scale * own[i];
      return own;
    };
    return {part(x.q), part(x.v), part(x.a)};
  }
  template <class S>
  static Pose<S> pose(const State<S>& x, int n) {
    const auto at = of_node(x, n);
    return {segment<3>(at.q, 0), node_rotation<Node, S>(at)};
  }

  template <class K, class S>
  static Local<S> local(const K&, const State<S>& x) {
    std::array<Pose<S>, Nodes> all;
    for (int n = 0; n < Nodes; ++n) all[n] = pose(x, n);
    return seen_from_base(all);
  }
  template <class S>
  static Local<S> seen_from_base(const std::array<Pose<S>, Nodes>& all) {
    const Mat3<S> A_b0 = transpose(all[base].rotation);
    Local<S> y;
    for (int i = 0; i < others; ++i) {
      y[2 * i] = A_b0 * (all[other(i)].position - all[base].position);
      y[2 * i + 1] = rotation_vector_of(A_b0 * all[other(i)].rotation);
    }
    return y;
  }
  template <class K, class S>
  static Local<S> local_rate(const K& k, const State<S>& x) {
    const auto y = local(k, x);
    const auto velocity = [&x](int n) { return segment<3>(x.v, n * node_size); };
    const auto spin = [&x](int n) { return spin_motion<Node, S>(of_node(x, n)).spin; };
    const Mat3<S> A_b0 = transpose(pose(x, base).rotation);
    Local<S> rate;
    for (int i = 0; i < others; ++i) {
      rate[2 * i] = A_b0 * (velocity(other(i)) - velocity(base)) + cross(y[2 * i], spin(base));
      rate[2 * i + 1] =
          inverse_tangent_map(y[2 * i + 1], spin(other(i))) - inverse_tangent_map(-y[2 * i + 1], spin(base));
    }
    return rate;
  }

  // Per node: force in global axes, moment in own axes.
  template <class S>
  using Wrenches = std::array<SpinWrench<S>, Nodes>;
  template <class S>
  static Wrenches<S> wrenches(const Mat3<S>& A_0b, const Local<S>& y, const Local<S>& g) {
    Wrenches<S> w{};
    for (int i = 0; i < others; ++i) {
      const Vec3<S> force = A_0b * g[2 * i], &phi = y[2 * i + 1], &m = g[2 * i + 1];
      w[other(i)].force += force;
      w[base].force -= force;
      w[other(i)].moment += inverse_tangent_map(-phi, m);
      w[base].moment += cross(g[2 * i], y[2 * i]) - inverse_tangent_map(phi, m);
    }
    return w;
  }
  template <class S>
  static Vec<S, size> pull_back(const State<S>& x, const Wrenches<S>& w) {
    Vec<S, size> r;
    for (int n = 0; n < Nodes; ++n) {
      const auto of = pull_back_spin_wrench<Node, S>(of_node(x, n), w[n].force, w[n].moment);
      const S scale = unit_scale(x, n);
      for (int i = 0; i < node_size; ++i) r[n * node_size + i] = i < unit_from ? of[i] : S(scale * of[i]);
    }
    return r;
  }
  template <class K, class S>
  static Vec<S, size> pull_back(const K& k, const State<S>& x, const Local<S>& g) {
    return pull_back(x, wrenches(pose(x, base).rotation, local(k, x), g));
  }

  // J'mJ and the derivative with fixed local forces: those in global axes rotate with the base, moments change with d
  // and phi; rates of the local vectors, and damping, rotate with the coordinates.
  template <class K, class T>
  static Mat<T, size, size> tangent(const K& k, const State<T>& x, const Local<T>& g, const Mat<T, rows, rows>& m,
                                    const Mat<T, rows, rows>& damping, const Weights& w)
    requires derives
  {
    const Local<T> y = local(k, x);
    const Mat3<T> A_0b = pose(x, base).rotation;
    const Mat<T, rows, size> j = jacobian(A_0b, y);
    Mat<T, rows, size> change = m * j;
    if (w.q != 0 && std::ranges::any_of(damping.x, [](const T& d) { return d != 0; })) {
      const auto rate = local_rate(k, seeded<RelativeFrames>(x, Weights{.q = w.q, .v = 0, .a = 0}));
      change = change +
               damping * matrix_of<rows, size>([&](int row, int column) { return rate[row / 3][row % 3].d[column]; });
    }
    Mat<T, size, size> r = transpose(j) * change;
    for (int i = 0; i < others; ++i) {
      const Mat3<T> turn = w.q * skew(g[2 * i]), turned = A_0b * turn;
      add_block(r, node_size * other(i), node_size * base + 3, -1.0 * turned);
      add_block(r, node_size * base, node_size * base + 3, turned);
      const auto by_d = rows_of_vector(j, 2 * i), by_phi = rows_of_vector(j, 2 * i + 1);
      add_block(r, node_size * base + 3, 0, turn * by_d);
      add_block(r, node_size * base + 3, 0, -1.0 * (moment_slope(y[2 * i + 1], g[2 * i + 1], w.q) * by_phi));
      add_block(r, node_size * other(i) + 3, 0, moment_slope(-y[2 * i + 1], g[2 * i + 1], -w.q) * by_phi);
    }
    return r;
  }

 private:
  // Derivatives of the local vectors by positions and own spins.
  template <class T>
  static Mat<T, rows, size> jacobian(const Mat3<T>& A_0b, const Local<T>& y) {
    Mat<T, rows, size> j{};
    const Mat3<T> A_b0 = transpose(A_0b);
    for (int i = 0; i < others; ++i) {
      const Vec3<T>& phi = y[2 * i + 1];
      const Mat3<T> by_spin = matrix_of<3, 3>([&](int row, int column) {
        return inverse_tangent_map(phi, Vec3<T>{T(column == 0), T(column == 1), T(column == 2)})[row];
      });
      add_block(j, 6 * i, node_size * other(i), A_b0);
      add_block(j, 6 * i, node_size * base, -1.0 * A_b0);
      add_block(j, 6 * i, node_size * base + 3, skew(y[2 * i]));
      add_block(j, 6 * i + 3, node_size * other(i) + 3, by_spin);
      add_block(j, 6 * i + 3, node_size * base + 3, -1.0 * transpose(by_spin));
    }
    return j;
  }
  // The derivative of T(v)^-1 moment by v.
  template <class T>
  static Mat3<T> moment_slope(const Vec3<T>& v, const Vec3<T>& moment, double weight) {
    Vec3<Dual<3, T>> moving, held;
    for (int i = 0; i < 3; ++i) {
      moving[i] = Dual<3, T>::seed(v[i], i, weight);
      held[i] = Dual<3, T>(moment[i]);
    }
    const auto turned = inverse_tangent_map(moving, held);
    return matrix_of<3, 3>([&](int i, int j) { return turned[i].d[j]; });
  }
  template <class T>
  static Mat<T, 3, size> rows_of_vector(const Mat<T, rows, size>& j, int vector) {
    return matrix_of<3, size>([&](int row, int column) { return j(3 * vector + row, column); });
  }
  template <class M, class T, int R, int C>
  static void add_block(M& to, int row, int column, const Mat<T, R, C>& block) {
    for (int i = 0; i < R; ++i)
      for (int j = 0; j < C; ++j) to(row + i, column + j) += block(i, j);
  }
};

}  // namespace dalembert
