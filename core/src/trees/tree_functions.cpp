#include "dalembert/trees/tree_functions.hpp"

#include <algorithm>
#include <array>

#include "dalembert/math/aligned_vector.hpp"
#include "dalembert/math/wide_registers.hpp"
#include "dalembert/trees/tree_tangent.hpp"

namespace dalembert {
namespace {

// A group of states side by side, and the room for its recursions.
template <int N>
struct States {
  using S = Pack<N>;

  explicit States(const Tree& tree)
      : tree(tree),
        links(tree.links.size()),
        q(links),
        v(links),
        a(links),
        x(links),
        places(links),
        masses(links),
        motions(links),
        wrenches(links) {}

  // Lanes beyond the last state repeat it.
  void begin(std::size_t first_state, std::size_t states) {
    first = first_state;
    count = static_cast<int>(std::min<std::size_t>(N, states - first_state));
    for (int lane = 0; lane < N; ++lane)
      offsets[lane] = (first + static_cast<std::size_t>(std::min(lane, count - 1))) * links;
  }
  DALEMBERT_INLINE void gather(const double* from, AlignedVector<S>& to) const {
    std::array<const double*, N> rows;
    for (int lane = 0; lane < N; ++lane) rows[lane] = from + offsets[lane];
    if (links < 4)
      for (std::size_t i = 0; i < links; ++i) to[i] = S::of_each([&](int lane) { return rows[lane][i]; });
    each_four([&](std::size_t i) DALEMBERT_INLINE {
      const auto four = columns_of<N>([&](int lane) DALEMBERT_INLINE { return Pack<4>::load(rows[lane] + i); });
      for (std::size_t k = 0; k < 4; ++k) to[i + k] = four[k];
    });
  }
  // A result with one number per joint.
  DALEMBERT_INLINE void give(double* to, const AlignedVector<S>& from) const {
    if (links < 4)
      for (std::size_t i = 0; i < links; ++i) give(to, links, i, from[i]);
    each_four([&](std::size_t i) DALEMBERT_INLINE {
      double* rows = to + first * links + i;
      each_row<N>({from[i], from[i + 1], from[i + 2], from[i + 3]}, count,
                  [&](int lane, const Pack<4>& row)
                      DALEMBERT_INLINE { row.store(rows + static_cast<std::size_t>(lane) * links); });
    });
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
    trees::move_links<S>(tree, places, v.data(), accelerations == nullptr ? nullptr : a.data(), Vec3<S>{} - gravity,
                         motions);
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

  // f(i) for joints i to i + 3, for all joints: the last four may overlap with the previous ones. Not called for
  // fewer than four.
  template <class F>
  DALEMBERT_INLINE void each_four(const F& f) const {
    for (std::size_t i = 0; i + 4 <= links; i += 4) f(i);
    if (links > 4 && links % 4 != 0) f(links - 4);
  }

  const Tree& tree;
  std::size_t links, first = 0;
  int count = 0;
  std::array<std::size_t, N> offsets{};  // offsets of the states in lists of joints
  AlignedVector<S> q, v, a, x;
  AlignedVector<LinkPlace<S>> places;
  AlignedVector<LinkMass<S>> masses;
  AlignedVector<LinkMotion<S>> motions;
  AlignedVector<LinkWrench<S>> wrenches;
  // Room that some functions need: made when it is asked for first.
  AlignedVector<S> sines, cosines, rows;
  AlignedVector<LaneStation<S>> stations;
  AlignedVector<LaneFork<S>> forks;
  AlignedVector<CompositeBody<S>> bodies;
  AlignedVector<JointIncrement<S>> increments;
  AlignedVector<Vec3<S>> origins;
};

// f(group) for all states, four at once, or eight if registers hold as many and `most` allows it, which saves a
// quarter of the time of accelerations. A few states do not fill wider registers.
template <int most = 4, class F>
void each_group(const Tree& tree, std::size_t states, const F& f) {
  const auto in_groups = [&]<int N>() {
    States<N> group(tree);
    for (std::size_t first = 0; first < states; first += N) {
      group.begin(first, states);
      f(group);
    }
  };
  if constexpr (most == 8)
    if (states > 4 && numbers_in_register() == 8)
      return run_in_widest_registers([&] { in_groups.template operator()<8>(); });
  in_wide_registers([&] { in_groups.template operator()<4>(); });
}

// Orientation in a frame whose first axis is that of its joint.
Mat3<double> axis_first(const TreeLink& link) {
  Mat3<double> turn{};
  for (int j = 0; j < 3; ++j) turn((link.axis + j) % 3, j) = 1;
  return turn;
}

}  // namespace

std::vector<LaneLink> lane_links(const Tree& tree) {
  std::vector<LaneLink> lanes(tree.links.size());
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const TreeLink& link = tree.links[i];
    LaneLink& lane = lanes[i];
    const Mat3<double> own = axis_first(link),
                       carrier = link.parent < 0 ? identity<double>()
                                                 : axis_first(tree.links[static_cast<std::size_t>(link.parent)]),
                       orientation = transpose(carrier) * link.orientation * own,
                       inertia = transpose(own) * link.inertia * own;
    const double half = 0.5 * (inertia(0, 0) + inertia(1, 1) + inertia(2, 2));
    lane = {.parent = link.parent,
            .depth = link.parent < 0 ? 0 : lanes[static_cast<std::size_t>(link.parent)].depth + 1,
            .slides = link.slides,
            .follows = i > 0 && link.parent + 1 == static_cast<int>(i),
            .axis = column(orientation, 0),
            .second = column(orientation, 1),
            .third = column(orientation, 2),
            .offset = transposed_times(carrier, link.offset),
            .mass = link.mass,
            .mass_behind = link.mass,
            .moment = transposed_times(own, link.moment),
            .second_moment = {half - inertia(0, 0), -inertia(0, 1), -inertia(0, 2), half - inertia(1, 1),
                              -inertia(1, 2), half - inertia(2, 2)}};
    if (link.parent >= 0 && !lane.follows) lanes[static_cast<std::size_t>(link.parent)].forks = true;
  }
  for (std::size_t i = lanes.size(); i-- > 0;)
    if (lanes[i].parent >= 0) lanes[static_cast<std::size_t>(lanes[i].parent)].mass_behind += lanes[i].mass_behind;
  return lanes;
}

void TreeFunctions::inverse_dynamics(std::size_t states, const double* q, const double* v, const double* a,
                                     double* forces) const {
  each_group(tree_, states, [&](auto& group) {
    group.place(q);
    group.move(v, a, gravity_);
    group.sum_inertia_forces();
    group.give(forces, group.x);
  });
}

int TreeFunctions::forward_dynamics(std::size_t states, const double* q, const double* v, const double* forces,
                                    double* a) const {
  int loose = -1;
  each_group<8>(tree_, states, [&]<int N>(States<N>& group) {
    using S = Pack<N>;
    group.sines.resize(group.links);
    group.cosines.resize(group.links);
    group.stations.resize(group.links);
    group.forks.resize(group.links);
    group.gather(q, group.q);
    group.gather(v, group.v);
    group.gather(forces, group.x);
    each_sine_cosine(group.q.data(), group.links, [&](std::size_t i, const S& sine, const S& cosine) DALEMBERT_INLINE {
      group.sines[i] = sine;
      group.cosines[i] = cosine;
    });
    trees::go_outward<S>(lanes_, group.q.data(), group.sines.data(), group.cosines.data(), group.v.data(),
                         Vec3<S>{} - gravity_, group.stations, group.forks);
    if (tree_.count() > few_links_in_lanes) {
      trees::go_inward<S>(lanes_, group.x.data(), group.stations, group.forks);
      trees::go_outward_again<S>(lanes_, group.x.data(), group.stations, group.forks);
    } else {
      group.rows.resize(group.links * group.links);
      trees::compose<S>(lanes_, group.stations, group.forks, group.x.data(), group.rows.data());
      trees::eliminate<S>(lanes_, group.stations, group.x.data(), group.rows.data());
    }
    loose = std::max(loose, trees::loose_joint<N>(group.stations));
    group.give(a, group.x);
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

void TreeFunctions::derivatives(std::size_t states, const double* q, const double* v, const double* a, double* by_q,
                                double* by_v) const {
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
      for (std::size_t i = 0; i < n; ++i)
        group.increments[i] = trees::increment_of(tree_.links[i], group.places[i].axis, group.motions[i], w);
      trees::tangent<S>(tree_, group.places, group.bodies, group.wrenches, group.increments, w,
                        [&](int k, int j, const S& row, const S& column) {
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

void TreeFunctions::jacobian(std::size_t states, const double* q, int link, const Vec3<double>& local,
                             double* matrices) const {
  const std::size_t n = tree_.links.size();
  std::fill_n(matrices, states * 6 * n, 0.0);
  each_group(tree_, states, [&]<int N>(States<N>& group) {
    using S = Pack<N>;
    group.place(q);
    // from the origin of link i to the point
    Vec3<S> arm = group.places[static_cast<std::size_t>(link)].rotation * local;
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

void TreeFunctions::energies(std::size_t states, const double* q, const double* v, double* kinetic,
                             double* potential) const {
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
      sum += 0.5 * (link.mass * dot(m.velocity, m.velocity) + dot(w, link.inertia * w)) +
             dot(m.velocity, cross(m.spin, rotation * link.moment));
    }
    group.give(kinetic, 1, 0, sum);
  });
}

}  // namespace dalembert
