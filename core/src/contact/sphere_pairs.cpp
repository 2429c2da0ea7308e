#include "dalembert/contact/sphere_pairs.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <type_traits>

#include "dalembert/math/pack.hpp"
#include "dalembert/math/wide_registers.hpp"

namespace dalembert {
namespace {

constexpr std::size_t most_pairings = 1024;  // that are kept

constexpr std::uint32_t numbers = 4;  // numbers per sphere: pairs store offsets

template <int L>
DALEMBERT_INLINE inline std::array<Pack<L>, 4> fours(const double* all, const std::uint32_t* which) {
  return columns_of<L>([&](int lane) DALEMBERT_INLINE { return Pack<4>::load(all + which[lane]); });
}
template <class P>
DALEMBERT_INLINE inline Vec3<P> vector_in(const std::array<P, 4>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

void SpherePairs::take(const ContactSet& set) {
  count_ = set.spheres.size();
  at.resize(count_);
  velocity.resize(count_);
  spin.resize(count_);
  kinds_.resize(count_);
  surfaces_.clear();
  std::map<std::tuple<double, double, int>, int> known;
  for (std::size_t i = 0; i < count_; ++i) {
    at[i].radius = set.spheres[i].radius;
    const ContactSurface& s = set.spheres[i].surface;
    const auto [place, is_new] =
        known.try_emplace({s.stiffness, s.damping, s.material}, static_cast<int>(surfaces_.size()));
    if (is_new) surfaces_.push_back(s);
    kinds_[i] = place->second;
  }
  pairings_.clear();
  with_carriers_.clear();
  if (surfaces_.size() * surfaces_.size() <= most_pairings)
    for (const ContactSurface& a : surfaces_)
      for (const ContactSurface& b : surfaces_) pairings_.push_back(set.pairing(a, b));
  if (surfaces_.size() * set.carriers.size() <= most_pairings)
    for (const ContactSurface& a : surfaces_)
      for (const ContactCarrier& c : set.carriers) with_carriers_.push_back(set.pairing(a, c.surface));
}

void SpherePairs::list(const SphereNeighbours& neighbours, std::span<const int> begins, Workers* workers) {
  begins_.assign(begins.begin(), begins.end());
  const std::size_t chunks = begins.size() - 1;
  const auto each_chunk = [&](const auto& f) {
    share_tasks(workers, static_cast<int>(chunks),
                [&](int c) { f(static_cast<std::size_t>(c), begins[c], begins[c + 1]); });
  };
  first_pair_.assign(1, 0);
  for (std::size_t c = 0; c < chunks; ++c)
    first_pair_.push_back(first_pair_.back() + neighbours.behind(begins[c], begins[c + 1]).size());
  for (LargeVector<std::uint32_t>* all : {&firsts_, &seconds_, &targets_}) all->resize(first_pair_.back());
  first_waiting_.assign(chunks + 1, 0);
  each_chunk([&](std::size_t c, int begin, int end) {
    const auto all = neighbours.behind(begin, end);
    first_waiting_[c + 1] = static_cast<std::size_t>(std::ranges::count_if(all, [end](int j) { return j >= end; }));
  });
  first_waiting_[0] = count_;
  std::partial_sum(first_waiting_.begin(), first_waiting_.end(), first_waiting_.begin());
  force.resize(first_waiting_.back());
  waiting_.resize(first_waiting_.back() - count_);
  each_chunk([&](std::size_t c, int begin, int end) {
    std::size_t p = first_pair_[c], place = first_waiting_[c];
    for (int i = begin; i < end; ++i)
      for (const int j : neighbours.behind(i)) {
        firsts_[p] = numbers * static_cast<std::uint32_t>(i);
        seconds_[p] = targets_[p] = numbers * static_cast<std::uint32_t>(j);
        if (j >= end) {
          targets_[p] = numbers * static_cast<std::uint32_t>(place);
          waiting_[place++ - count_] = j;
        }
        ++p;
      }
  });
  list_collected();
}

// Sorts by the collecting chunks.
void SpherePairs::list_collected() {
  const std::size_t chunks = begins_.size() - 1;
  const auto chunk_of = [&](int sphere) {
    return static_cast<std::size_t>(std::ranges::upper_bound(begins_, sphere) - begins_.begin()) - 1;
  };
  std::vector<std::size_t> next(chunks + 1, 0);
  for (const int sphere : waiting_) ++next[chunk_of(sphere) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  first_collected_ = next;
  collected_.resize(waiting_.size());
  for (std::size_t k = 0; k < waiting_.size(); ++k)
    collected_[next[chunk_of(waiting_[k])]++] = {waiting_[k], static_cast<int>(count_ + k)};
}

ContactPairing SpherePairs::pairing_of(const ContactSet& set, std::uint32_t first, std::uint32_t second) const {
  const auto a = static_cast<std::size_t>(kinds_[first / numbers]),
             b = static_cast<std::size_t>(kinds_[second / numbers]);
  return pairings_.empty() ? set.pairing(surfaces_[a], surfaces_[b]) : pairings_[a * surfaces_.size() + b];
}

// Same as in GeneralContact::force. Inactive pairs add exactly zero: sums never are -0.
template <int L, bool rubs, bool alike>
DALEMBERT_INLINE inline double SpherePairs::compute_pairs(std::size_t begin, std::size_t end, const ContactSet& set) {
  using P = Pack<L>;
  constexpr std::size_t lanes = L;
  const double zone = set.proportional_zone;
  const ContactPairing same = pairing_of(set, 0, 0);
  P least(std::numeric_limits<double>::infinity());
  const double *const places = &at.data()->x, *const velocities = &velocity.data()->x, *const spins = &spin.data()->x;
  double *const forces = &force.data()->x, *const moments = &moment.data()->x;
  const auto some = [&](const std::uint32_t* first, const std::uint32_t* second, const std::uint32_t* target,
                        auto count) DALEMBERT_INLINE {
    const std::array<P, 4> at0 = fours<L>(places, first), at1 = fours<L>(places, second);
    const Vec3<P> span = vector_in(at1) - vector_in(at0);
    const P square = dot(span, span), reach = at0[3] + at1[3];
    const auto overlaps = less(square, reach * reach);
    least = P::chosen(less(square, least), square, least);
    if (P::is_none(overlaps)) return;
    const Vec3<P> approach = vector_in(fours<L>(velocities, second)) - vector_in(fours<L>(velocities, first));
    const P distance = sqrt(one_for_zero(square));
    const Vec3<P> normal = (1.0 / distance) * span;
    const P away = dot(normal, approach);
    ContactPairingOf<P> law{same.stiffness, same.damping, same.friction};
    if constexpr (!alike) {
      std::array<ContactPairing, lanes> laws;
      for (std::size_t lane = 0; lane < lanes; ++lane) laws[lane] = pairing_of(set, first[lane], second[lane]);
      law = side_by_side(laws);
    }
    P normal_force = law.normal_force(distance - reach, away);
    normal_force = P::chosen(overlaps & less(P(), normal_force), normal_force, P());
    if (is_zero(normal_force)) return;
    Vec3<P> on_first = (-normal_force) * normal;
    if constexpr (rubs) {
      const P half = 0.5 * (distance - reach), arm0 = at0[3] + half, arm1 = at1[3] + half;
      const Vec3<P> turn = arm0 * vector_in(fours<L>(spins, first)) + arm1 * vector_in(fours<L>(spins, second));
      const Vec3<P> slip = approach - cross(turn, normal) - away * normal;
      const Vec3<P> friction = law.friction_force(normal_force, slip, zone), torque = cross(normal, friction);
      on_first = on_first + friction;
      const Vec3<P> moment0 = arm0 * torque, moment1 = arm1 * torque;
      const std::array<Pack<4>, lanes> on_second = rows_from<L>({moment1[0], moment1[1], moment1[2], P()});
      each_row<L>({moment0[0], moment0[1], moment0[2], P()}, count,
                  [&](int lane, const Pack<4>& row) DALEMBERT_INLINE {  // pair by pair: sums keep their order
                    row.add_to(moments + first[lane]);
                    on_second[static_cast<std::size_t>(lane)].add_to(moments + target[lane]);
                  });
    }
    each_row<L>({on_first[0], on_first[1], on_first[2], P()}, count,
                [&](int lane, const Pack<4>& row) DALEMBERT_INLINE {
                  row.add_to(forces + first[lane]);
                  row.subtract_from(forces + target[lane]);
                });
  };
  const std::size_t whole = begin + (end - begin) / lanes * lanes;
  for (std::size_t p = begin; p < whole; p += lanes)
    some(&firsts_[p], &seconds_[p], &targets_[p], std::integral_constant<int, L>());
  if (whole < end) {
    std::uint32_t first[lanes], second[lanes], target[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::size_t pair = std::min(whole + lane, end - 1);
      first[lane] = firsts_[pair];
      second[lane] = seconds_[pair];
      target[lane] = targets_[pair];
    }
    some(first, second, target, static_cast<int>(end - whole));
  }
  double nearest = least[0];
  for (int lane = 1; lane < L; ++lane) nearest = std::min(nearest, least[lane]);
  return nearest;
}

double SpherePairs::compute(int chunk, const ContactSet& set, Friction friction) {
  const bool rubs = friction == Friction::of_slip;
  const auto c = static_cast<std::size_t>(chunk);
  const auto clear = [&](LargeVector<Four>& numbers) {
    std::fill(numbers.begin() + begins_[c], numbers.begin() + begins_[c + 1], Four());
    std::fill(numbers.begin() + static_cast<std::ptrdiff_t>(first_waiting_[c]),
              numbers.begin() + static_cast<std::ptrdiff_t>(first_waiting_[c + 1]), Four());
  };
  clear(force);
  if (friction != Friction::none) clear(moment);
  double least = std::numeric_limits<double>::infinity();
  const std::size_t begin = first_pair_[c], end = first_pair_[c + 1];
  if (begin == end) return least;
  const bool alike = surfaces_.size() == 1;
  const auto find = [&, this]<int L, bool with_friction>() DALEMBERT_INLINE {
    least = alike ? compute_pairs<L, with_friction, true>(begin, end, set)
                  : compute_pairs<L, with_friction, false>(begin, end, set);
  };
  if (!rubs) in_registers_of_four([&find] { find.template operator()<4, false>(); });
  // four are faster without friction
  else if (numbers_in_register() == 8)
    run_in_widest_registers([&find] { find.template operator()<8, true>(); });
  else
    in_registers_of_four([&find] { find.template operator()<4, true>(); });
  return least;
}

std::size_t SpherePairs::place_of_second(std::size_t pair) const { return targets_[pair] / numbers; }

void SpherePairs::collect(int chunk, bool rubs) {
  const auto c = static_cast<std::size_t>(chunk);
  for (std::size_t k = first_collected_[c]; k < first_collected_[c + 1]; ++k) {
    const auto [sphere, place] = collected_[k];
    force[static_cast<std::size_t>(sphere)].add(force[static_cast<std::size_t>(place)].vector());
    if (rubs) moment[static_cast<std::size_t>(sphere)].add(moment[static_cast<std::size_t>(place)].vector());
  }
}

}  // namespace dalembert
