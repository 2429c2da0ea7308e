// Accelerations from joint forces by a mass matrix and its factors, for trees of few links. The operations depend
// less on each other than those of articulated bodies (trees/articulated_bodies.hpp), which need the quotient of the
// previous link. The matrix is computed by composite bodies; its factors L^T D L, from the leaves on, keep the zeros
// between branches (Featherstone 2008, sections 6.2 and 6.5). A row belongs to a joint: its force, then one entry for
// each joint; entries of joints on the path to the base are used.
#pragma once

#include <utility>

#include "dalembert/math/aligned_vector.hpp"
#include "dalembert/trees/tree_tangent.hpp"

namespace dalembert {

// Articulated bodies are faster for more links.
constexpr int few_links = 16;
// The rows of so few joints stay in registers.
constexpr std::size_t joints_in_registers = 7;

// Work space and constants of one tree.
struct JointMasses {
  AlignedVector<CompositeMass<Spread>> bodies;
  // forces and moments for unit accelerations of joints, about a common point
  AlignedVector<LinkWrench<Spread>> answers;
  // data of links, and of the composite body of each joint, with number i + 1, at this point
  AlignedVector<Vec3<Spread>> origins, turns, shifts;
  AlignedVector<std::array<Pack<4>, 6>> columns;  // the same of four joints: x, y, z of shifts, then of turns
  AlignedVector<double> rows, shares;
  AlignedVector<double> ways;  // by rows: 1 for used entries, otherwise 0; for few joints with branches
  std::size_t width = 0;  // length of a row
  int first_turn = -1;                // the first link that turns; -1: none
  std::vector<int> before, first;  // joints on the path to the base, base first; start of those of each link

  void make(const Tree& tree) {
    const auto links = static_cast<std::size_t>(tree.count());
    width = (links + 4) / 4 * 4;
    bodies.resize(links);
    answers.resize(links);
    origins.resize(links);
    turns.assign(width, {});
    shifts.assign(width, {});
    columns.resize(width / 4);
    rows.assign((width - 1) * width, 0.0);
    shares.assign((width - 1) * width, 0.0);
    ways.clear();
    first_turn = -1;
    before.clear();
    first.assign(1, 0);
    for (int i = 0; i < tree.count(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (first_turn < 0 && !tree.links[at].slides) first_turn = i;
      if (const int parent = tree.links[at].parent; parent >= 0) {
        const std::vector<int> way(before.begin() + first[static_cast<std::size_t>(parent)],
                                   before.begin() + first[static_cast<std::size_t>(parent) + 1]);
        before.insert(before.end(), way.begin(), way.end());
        before.push_back(parent);
      }
      first.push_back(static_cast<int>(before.size()));
    }
    if (width <= joints_in_registers + 1 && static_cast<int>(before.size()) < tree.count() * (tree.count() - 1) / 2)
      mark_ways(tree.count());
  }

 private:
  void mark_ways(int links) {
    ways.assign(rows.size(), 0.0);
    for (int i = 0; i < links; ++i) {
      double* way = ways.data() + static_cast<std::size_t>(i) * width;
      way[0] = way[i + 1] = 1;
      for (int at = first[static_cast<std::size_t>(i)]; at < first[static_cast<std::size_t>(i) + 1]; ++at)
        way[before[static_cast<std::size_t>(at)] + 1] = 1;
    }
  }
};

namespace trees {

// The point is the origin of the first link that turns: it stays with a tree that slides far away.
DALEMBERT_INLINE inline void find_answers(const Tree& tree, std::span<const LinkPlace<Spread>> places,
                                          JointMasses& room) {
  Vec3<Spread> base{};
  for (int i = room.first_turn; i >= 0; i = tree.links[static_cast<std::size_t>(i)].parent)
    base -= places[static_cast<std::size_t>(i)].arm;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink& link = tree.links[i];
    const Vec3<Spread>& axis = places[i].axis;
    const Vec3<Spread> origin =
        (link.parent < 0 ? base : room.origins[static_cast<std::size_t>(link.parent)]) + places[i].arm;
    room.origins[i] = origin;
    room.answers[i] = shifted(inertia_along(link, axis, room.bodies[i]), origin);
    room.turns[i + 1] = link.slides ? Vec3<Spread>{} : axis;
    room.shifts[i + 1] = link.slides ? axis : cross(origin, axis);
  }
}

DALEMBERT_INLINE inline void find_rows(JointMasses& room, std::size_t links, const double* x) {
  for (std::size_t g = 0; g < room.columns.size(); ++g) {
    const auto four = [g](const AlignedVector<Vec3<Spread>>& all) {
      return transposed<4>({all[4 * g].x, all[4 * g + 1].x, all[4 * g + 2].x, all[4 * g + 3].x});
    };
    const std::array<Pack<4>, 4> shifts = four(room.shifts), turns = four(room.turns);
    room.columns[g] = {shifts[0], shifts[1], shifts[2], turns[0], turns[1], turns[2]};
  }
  for (std::size_t k = 0; k < links; ++k) {
    const Pack<4>::Register &f = room.answers[k].force.x.x, &m = room.answers[k].moment.x.x;
    double* row = room.rows.data() + k * room.width;
    for (std::size_t g = 0; 4 * g <= k + 1; ++g) {
      const std::array<Pack<4>, 6>& c = room.columns[g];
      Pack<4> entries = (f[0] * c[0] + f[1] * c[1] + f[2] * c[2]) + (m[0] * c[3] + m[1] * c[4] + m[2] * c[5]);
      if (!room.ways.empty()) entries = entries * Pack<4>::load(room.ways.data() + k * room.width + 4 * g);
      if (g == 0) entries.x[0] = x[k];
      entries.store(row + 4 * g);
    }
  }
}

// Rows become factors, and forces of joints shares of accelerations. Returns the first joint from the leaves on that nothing resists, or -1.
DALEMBERT_INLINE inline int factorize(JointMasses& room, std::size_t links, double* x) {
  int loose = -1;
  for (std::size_t k = links; k-- > 0;) {
    const double *row = room.rows.data() + k * room.width, pivot = row[k + 1];
    double* shares = room.shares.data() + k * room.width;
    if (loose < 0 && !(pivot > 0)) loose = static_cast<int>(k);
    const double inverse = 1 / pivot;
    x[k] = row[0] * inverse;
    for (int at = room.first[k + 1]; at-- > room.first[k];) {
      const auto i = static_cast<std::size_t>(room.before[static_cast<std::size_t>(at)]);
      const double share = shares[i + 1] = row[i + 1] * inverse;
      double* other = room.rows.data() + i * room.width;
      for (std::size_t c = 0; c <= i + 1; c += 4)
        (Pack<4>::load(other + c) - share * Pack<4>::load(row + c)).store(other + c);
    }
  }
  return loose;
}

// Calls f.operator()<i>() for all i below `count`, in this order.
template <std::size_t count, class F>
DALEMBERT_INLINE inline void each_constant(const F& f) {
  [&]<std::size_t... i>(std::index_sequence<i...>)
      DALEMBERT_INLINE { (f.template operator()<i>(), ...); }(std::make_index_sequence<count>());
}

// The same of rows that registers hold, `groups` of four entries each. Entries of joints that are not on the way to the base are zero.
template <std::size_t groups>
DALEMBERT_INLINE inline int factorize_in_registers(JointMasses& room, std::size_t links, double* x) {
  constexpr std::size_t joints = 4 * groups - 1, width = 4 * groups;
  std::array<std::array<Pack<4>, groups>, joints> rows;
  each_constant<joints>([&]<std::size_t k>() DALEMBERT_INLINE {
    each_constant<groups>([&]<std::size_t g>()
                              DALEMBERT_INLINE { rows[k][g] = Pack<4>::load(room.rows.data() + k * width + 4 * g); });
  });
  int loose = -1;
  each_constant<joints>([&]<std::size_t above>() DALEMBERT_INLINE {
    constexpr std::size_t k = joints - 1 - above, own = k + 1;
    if (k >= links) return;
    const double pivot = rows[k][own / 4][own % 4];
    if (loose < 0 && !(pivot > 0)) [[unlikely]]
      loose = static_cast<int>(k);
    const double inverse = 1 / pivot;
    std::array<Pack<4>, groups> shares;
    each_constant<groups>([&]<std::size_t g>() DALEMBERT_INLINE {
      shares[g] = inverse * rows[k][g];
      shares[g].store(room.shares.data() + k * width + 4 * g);
    });
    x[k] = shares[0][0];
    each_constant<k>([&]<std::size_t i>() DALEMBERT_INLINE {
      constexpr int lane = (i + 1) % 4;
      const Pack<4> share = spreads::shuffled<lane, lane, lane, lane>(shares[(i + 1) / 4]);
      each_constant<(i + 1) / 4 + 1>([&]<std::size_t g>()
                                         DALEMBERT_INLINE { rows[i][g] = rows[i][g] - share * rows[k][g]; });
    });
  });
  return loose;
}

// See the function of the same name for articulated bodies.
DALEMBERT_INLINE inline int accelerate(const Tree& tree, std::span<const LinkPlace<Spread>> places,
                                       std::span<const LinkMass<Spread>> masses, JointMasses& room, double* x) {
  const std::size_t links = tree.links.size();
  compose<Spread>(tree, places, masses, room.bodies);
  find_answers(tree, places, room);
  find_rows(room, links, x);
  const int loose = room.width == 4   ? factorize_in_registers<1>(room, links, x)
                    : room.width == 8 ? factorize_in_registers<2>(room, links, x)
                                      : factorize(room, links, x);
  for (std::size_t k = 0; k < links; ++k) {
    const double* shares = room.shares.data() + k * room.width + 1;
    double own = x[k];
    for (int at = room.first[k]; at < room.first[k + 1]; ++at) {
      const auto i = static_cast<std::size_t>(room.before[static_cast<std::size_t>(at)]);
      own -= shares[i] * x[i];
    }
    x[k] = own;
  }
  return loose;
}

}  // namespace trees
}  // namespace dalembert
