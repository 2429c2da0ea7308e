// The coordinates of a body whose number of them is known at run time only. Nothing is copied for derivatives: a vector is read
// as doubles, or as duals of which each carries the derivatives by those few coordinates that a sweep is at.
//
//      coordinates   0 1 2 3 4 5 6 7 | 8 9 ...          a sweep of 8 directions begins at `first`; coordinate i has the
//      first sweep   1 1 1 1 1 1 1 1                    weight of its vector (Weights: q, v or a) as derivative by
//      second sweep                  | 1 1 ...          direction i - first, and none by the others
#pragma once

#include <algorithm>
#include <span>

#include "dalembert/contracts/element.hpp"

namespace dalembert {

template <class S>
struct SizedVector {
  static_assert(std::is_same_v<S, double>, "double or Dual<N>");
  const double* values = nullptr;
  double operator[](int i) const { return values[i]; }
  // The sum of factors[k] times coordinate begin + k.
  double combined(std::span<const double> factors, int begin) const {
    double sum = 0;
    for (std::size_t k = 0; k < factors.size(); ++k) sum += factors[k] * values[begin + static_cast<int>(k)];
    return sum;
  }
};
template <int N>
struct SizedVector<Dual<N>> {
  const double* values = nullptr;
  double weight = 0;
  int first = 0;
  Dual<N> operator[](int i) const {
    Dual<N> r(values[i]);
    if (i >= first && i < first + N) r.d[i - first] = weight;
    return r;
  }
  Dual<N> combined(std::span<const double> factors, int begin) const {
    Dual<N> r(SizedVector<double>{values}.combined(factors, begin));
    const int end = begin + static_cast<int>(factors.size());
    for (int i = std::max(first, begin); i < std::min(first + N, end); ++i)
      r.d[i - first] = weight * factors[i - begin];
    return r;
  }
};

template <class S>
struct SizedCoordinates {
  SizedVector<S> q, u, v, a;  // totals, displacements, velocities, accelerations
  int count = 0;

  // Three sums at once: `rows` has three rows of as many factors as there are coordinates from `begin` on.
  static Vec3<S> combined(const SizedVector<S>& x, std::span<const double> rows, int begin) {
    const std::size_t n = rows.size() / 3;
    return {x.combined(rows.first(n), begin), x.combined(rows.subspan(n, n), begin), x.combined(rows.last(n), begin)};
  }
  // Coordinates of a node that has the first coordinates.
  template <class Node>
  Coordinates<S, Node::size> of_first() const {
    Coordinates<S, Node::size> x;
    for (int i = 0; i < Node::size; ++i) {
      x.q[i] = q[i];
      x.v[i] = v[i];
      x.a[i] = a[i];
    }
    if constexpr (LieKernel<Node> && !std::is_same_v<S, double>) compose(x, Node::traits.lie_rotation);
    return x;
  }

 private:
  // Increments of a rotation vector on the group turn into rates of its components.
  template <int N>
  void compose(Coordinates<S, N>& x, int r) const {
    const Vec3<double> rotation{value_of(x.q[r]), value_of(x.q[r + 1]), value_of(x.q[r + 2])};
    for (int j = 0; j < 3; ++j) {
      Vec3<double> axis;
      axis[j] = 1;
      const Vec3<double> rate = rotation_vector_rate(rotation, axis);
      const int direction = r + j - q.first;
      if (direction < 0 || direction >= static_cast<int>(x.q[r].d.size())) continue;
      for (int i = 0; i < 3; ++i) x.q[r + i].d[direction] = q.weight * rate[i];
    }
  }
};

// The vectors of one body or marker, gathered out of those of the system: coordinates side by side. Room is made once.
class GatheredVectors {
 public:
  void make_room(std::size_t coordinates) { numbers_.resize(std::max(numbers_.size(), 4 * coordinates)); }
  void gather(const Evaluation& e, std::span<const int> dofs) {
    count_ = static_cast<int>(dofs.size());
    for (int i = 0; i < count_; ++i) {
      row(0)[i] = e.q[dofs[i]];
      row(1)[i] = e.u[dofs[i]];
      row(2)[i] = e.v[dofs[i]];
      row(3)[i] = e.inertia ? e.a[dofs[i]] : 0.0;
    }
  }
  // A configuration at rest, without deformation.
  void rest_at(std::span<const double> reference) {
    count_ = static_cast<int>(reference.size());
    std::fill_n(numbers_.begin(), 4 * reference.size(), 0.0);
    std::ranges::copy(reference, row(0));
  }
  void stop() { std::fill_n(row(3), count_, 0.0); }  // no accelerations

  SizedCoordinates<double> values() const { return {{row(0)}, {row(1)}, {row(2)}, {row(3)}, count_}; }
  template <class D>
  SizedCoordinates<D> seeded(const Weights& w, int first) const {
    return {{row(0), w.q, first}, {row(1), w.q, first}, {row(2), w.v, first}, {row(3), w.a, first}, count_};
  }
  std::span<double> displacements() { return {row(1), static_cast<std::size_t>(count_)}; }
  std::span<double> velocities() { return {row(2), static_cast<std::size_t>(count_)}; }

 private:
  double* row(int i) { return numbers_.data() + i * count_; }
  const double* row(int i) const { return numbers_.data() + i * count_; }
  std::vector<double> numbers_;
  int count_ = 0;
};

}  // namespace dalembert
