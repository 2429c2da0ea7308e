#include "dalembert/trees/tree_functions.hpp"

#include <algorithm>
#include <array>

#include "dalembert/math/aligned_vector.hpp"
#include "dalembert/math/wide_registers.hpp"
#include "dalembert/trees/articulated_bodies.hpp"
#include "dalembert/trees/tree_tangent.hpp"

namespace dalembert {
namespace {

// A group of states side by side, and the room for its recursions.
template <int N>
struct States {
  using S = Pack<N>;

  explicit States(const Tree& tree)
      : tree(tree), links(tree.links.size()), q(links), v(links), a(links), x(links), places(links), masses(links), motions(links), wrenches(links) {}

  // Lanes beyond the last state repeat it.
  void begin(std::size_t first_state, std::size_t states) {
    first = first_state;
    count = static_cast<int>(std::min<std::size_t>(N, states - first_state));
    for (int lane = 0; lane < N; ++lane) offsets[lane] = (first + static_cast<std::size_t>(std::min(lane, count - 1))) * links;
  }
  DALEMBERT_INLINE void gather(const double* from, AlignedVector<S>& to) const {
    std::array<const double*, N> rows;
    for (int lane = 0; lane < N; ++lane) rows[lane] = from + offsets[lane];
    for (std::size_t i = 0; i < links; ++i) to[i] = S::of_each([&](int lane) { return rows[lane][i]; });
  }
  // Number `at` of the `size` numbers that a result has per state.
  DALEMBERT_INLINE void give(double* to, std::size_t size, std::size_t at, const S& value) const {
    for (int lane = 0; lane < count; ++lane) to[(first + static_cast<std::size_t>(lane)) * size + at] = value[lane];
  }
  DALEMBERT_INLINE void give(double* to, std::size_t size, std::size_t at, const Vec3<S>& value) const {
    for (std::size_t k = 0; k < 3; ++k) give(to, size, at + k, value.x[k]);
  }

  DALEMBERT_INLINE void place(const double* from) {
    gather(from, q);
    trees::place_links<S>(tree, q.data(), places);
  }
  DALEMBERT_INLINE void move(const double* rates, const double* accelerations, const Vec3<double>& gravity) {
    gather(rates, v);
    if (accelerations != nullptr) gather(accelerations, a);
    trees::move_links<S>(tree, places, v.data(), accelerations == nullptr ? nullptr : a.data(), Vec3<S>{} - gravity, motions);
  }
  DALEMBERT_INLINE void find_origins() {
    origins.resize(links);
    trees::find_origins<S>(tree, places, origins);
  }
  DALEMBERT_INLINE void place_masses() { trees::place_masses<S>(tree, places, masses); }
  DALEMBERT_INLINE void sum_inertia_forces() {
    place_masses();
    for (std::size_t i = 0; i < links; ++i) wrenches[i] = trees::inertia_force(tree.links[i], masses[i], motions[i]);
    trees::sum_to_base<S>(tree, places, wrenches, [&](std::size_t i, const S& force) { x[i] = force; });
  }

  const Tree& tree;
  std::size_t links, first = 0;
  int count = 0;
  std::array<std::size_t, N> offsets{};  // of the states, in lists of joints
  AlignedVector<S> q, v, a, x;
  AlignedVector<LinkPlace<S>> places;
  AlignedVector<LinkMass<S>> masses;
  AlignedVector<LinkMotion<S>> motions;
  AlignedVector<LinkWrench<S>> wrenches;
  // Room that some functions need: made when it is asked for first.
  AlignedVector<ArticulatedBody<S>> articulated;
  AlignedVector<CompositeBody<S>> bodies;
  AlignedVector<JointIncrement<S>> increments;
  AlignedVector<Vec3<S>> origins;
};

// f(group) for all states, as many at once as registers hold.
template <class F>
void each_group(const Tree& tree, std::size_t states, const F& f) {
  const auto in_groups = [&]<int N>() {
    States<N> group(tree);
    for (std::size_t first = 0; first < states; first += N) {
      group.begin(first, states);
      f(group);
    }
  };
  states > 4 ? in_lanes(in_groups) : in_lanes<4>(in_groups);  // few states fill no wider registers
}

}  // namespace

void TreeFunctions::inverse_dynamics(std::size_t states, const double* q, const double* v, const double* a, double* forces) const {
  each_group(tree_, states, [&](auto& group) {
    group.place(q);
    group.move(v, a, gravity_);
    group.sum_inertia_forces();
    for (std::size_t i = 0; i < group.links; ++i) group.give(forces, group.links, i, group.x[i]);
  });
}

int TreeFunctions::forward_dynamics(std::size_t states, const double* q, const double* v, const double* forces, double* a) const {
  int loose = -1;
  each_group(tree_, states, [&]<int N>(States<N>& group) {
    using S = Pack<N>;
    group.articulated.resize(group.links);
    group.place(q);
    group.move(v, nullptr, gravity_);
    group.sum_inertia_forces();
    group.gather(forces, group.a);
    for (std::size_t i = 0; i < group.links; ++i) group.x[i] = group.a[i] - group.x[i];
    loose = std::max(loose, trees::accelerate<S>(tree_, group.places, group.masses, group.articulated, group.wrenches, group.x.data()));
    for (std::size_t i = 0; i < group.links; ++i) group.give(a, group.links, i, group.x[i]);
  });
  return loose;
}

void TreeFunctions::mass_matrix(std::size_t states, const double* q, double* matrices) const {
  const std::size_t n = tree_.links.size();
  std::fill_n(matrices, states * n * n, 0.0);
  each_group(tree_, states, [&]<int N>(States<N>& group) {
    using S = Pack<N>;
    group.bodies.resize(n);
    group.place(q);
    group.place_masses();
    trees::compose<S>(tree_, group.places, group.masses, group.bodies);
    trees::mass_matrix<S>(tree_, group.places, group.bodies, [&](int k, int j, const S& m) {
      const auto row = static_cast<std::size_t>(k), column = static_cast<std::size_t>(j);
      group.give(matrices, n * n, row * n + column, m);
      group.give(matrices, n * n, column * n + row, m);
    });
  });
}

void TreeFunctions::derivatives(std::size_t states, const double* q, const double* v, const double* a, double* by_q, double* by_v) const {
  const std::size_t n = tree_.links.size();
  for (double* matrices : {by_q, by_v}) std::fill_n(matrices, states * n * n, 0.0);
  each_group(tree_, states, [&]<int N>(States<N>& group) {
    using S = Pack<N>;
    group.bodies.resize(n);
    group.increments.resize(n);
    group.place(q);
    group.move(v, a, gravity_);
    group.sum_inertia_forces();
    trees::compose<S>(tree_, group.places, group.masses, group.motions, group.bodies);
    const auto find = [&](const Weights& w, double* matrices) {
      for (std::size_t i = 0; i < n; ++i) group.increments[i] = trees::increment_of(tree_.links[i], group.places[i].axis, group.motions[i], w);
      trees::tangent<S>(tree_, group.places, group.bodies, group.wrenches, group.increments, w, [&](int k, int j, const S& row, const S& column) {
        const auto behind = static_cast<std::size_t>(k), before = static_cast<std::size_t>(j);
        group.give(matrices, n * n, before * n + behind, column);
        group.give(matrices, n * n, behind * n + before, row);
      });
    };
    find({.q = 1, .v = 0, .a = 0}, by_q);
    find({.q = 0, .v = 1, .a = 0}, by_v);
  });
}

void TreeFunctions::frames(std::size_t states, const double* q, double* rotations, double* origins) const {
  const std::size_t n = tree_.links.size();
  each_group(tree_, states, [&]<int N>(States<N>& group) {
    group.place(q);
    group.find_origins();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < 9; ++k) group.give(rotations, 9 * n, 9 * i + k, group.places[i].rotation.x[k]);
      group.give(origins, 3 * n, 3 * i, group.origins[i]);
    }
  });
}

void TreeFunctions::jacobian(std::size_t states, const double* q, int link, const Vec3<double>& local, double* matrices) const {
  const std::size_t n = tree_.links.size();
  std::fill_n(matrices, states * 6 * n, 0.0);
  each_group(tree_, states, [&]<int N>(States<N>& group) {
    using S = Pack<N>;
    group.place(q);
    Vec3<S> arm = group.places[static_cast<std::size_t>(link)].rotation * local;  // from the origin of link i to the point
    for (int joint = link; joint >= 0; joint = tree_.links[static_cast<std::size_t>(joint)].parent) {
      const auto i = static_cast<std::size_t>(joint);
      const Vec3<S>& axis = group.places[i].axis;
      const bool slides = tree_.links[i].slides;
      const Vec3<S> velocity = slides ? axis : cross(axis, arm);
      for (std::size_t row = 0; row < 3; ++row) {
        group.give(matrices, 6 * n, row * n + i, velocity.x[row]);
        if (!slides) group.give(matrices, 6 * n, (3 + row) * n + i, axis.x[row]);
      }
      arm += group.places[i].arm;
    }
  });
}

namespace {

// The sum of mass times position.
template <int N>
DALEMBERT_INLINE inline Vec3<Pack<N>> first_moment(States<N>& group) {
  group.find_origins();
  Vec3<Pack<N>> sum{};
  for (std::size_t i = 0; i < group.links; ++i)
    sum += group.tree.links[i].mass * group.origins[i] + group.places[i].rotation * group.tree.links[i].moment;
  return sum;
}

}  // namespace

void TreeFunctions::centre_of_mass(std::size_t states, const double* q, double* points) const {
  double mass = 0;
  for (const TreeLink& link : tree_.links) mass += link.mass;
  each_group(tree_, states, [&](auto& group) {
    group.place(q);
    group.give(points, 3, 0, (1 / mass) * first_moment(group));
  });
}

void TreeFunctions::energies(std::size_t states, const double* q, const double* v, double* kinetic, double* potential) const {
  each_group(tree_, states, [&]<int N>(States<N>& group) {
    using S = Pack<N>;
    group.place(q);
    if (potential != nullptr) group.give(potential, 1, 0, -dot(gravity_, first_moment(group)));
    if (kinetic == nullptr) return;
    group.move(v, nullptr, {});
    S sum(0.0);
    for (std::size_t i = 0; i < group.links; ++i) {
      const TreeLink& link = tree_.links[i];
      const LinkMotion<S>& m = group.motions[i];
      const Mat3<S>& rotation = group.places[i].rotation;
      const Vec3<S> w = transposed_times(rotation, m.spin);
      sum += 0.5 * (link.mass * dot(m.velocity, m.velocity) + dot(w, link.inertia * w)) + dot(m.velocity, cross(m.spin, rotation * link.moment));
    }
    group.give(kinetic, 1, 0, sum);
  });
}

}  // namespace dalembert
