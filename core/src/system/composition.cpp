// Rotations of Lie-group nodes and their increments, several nodes at once.
#include <cmath>

#include "dalembert/batches/groups.hpp"
#include "dalembert/math/rotations.hpp"
#include "dalembert/system/large_vectors.hpp"
#include "dalembert/system/parts.hpp"

namespace dalembert {
namespace {

constexpr std::size_t blocks_to_share = numbers_to_share / 20;  // each takes as long as some twenty numbers
constexpr std::size_t few_blocks = 2;  // processed one by one

// Cosine and axis times sine of half a rotation vector.
template <class S>
struct HalfTurn {
  S cosine;
  Vec3<S> sine_axis;
};
template <class S>
// rotations of a step are small: the series is exact to rounding
DALEMBERT_INLINE inline HalfTurn<S> small_half_turn(const Vec3<S>& v, const S& square) {
  return {1.0 - square * 0.5 *
                    (1.0 - square * (1.0 / 12) *
                               (1.0 - square * (1.0 / 30) * (1.0 - square * (1.0 / 56) * (1.0 - square * (1.0 / 90))))),
          S(0.5 * (1.0 - square * (1.0 / 6) *
                             (1.0 - square * (1.0 / 20) * (1.0 - square * (1.0 / 42) * (1.0 - square * (1.0 / 72)))))) *
              v};
}
template <class S>
DALEMBERT_INLINE inline HalfTurn<S> any_half_turn(const Vec3<S>& v, const S& square) {
  using std::sqrt;
  const S angle = sqrt(square);
  const auto [sine, cosine] = sine_cosine(angle);
  return {cosine, S(0.5 * sine / angle) * v};
}
constexpr double small = 0.01;
DALEMBERT_INLINE inline HalfTurn<double> half_turn(const Vec3<double>& v) {
  const double square = 0.25 * dot(v, v);
  return square < small ? small_half_turn(v, square) : any_half_turn(v, square);
}
template <int N>
DALEMBERT_INLINE inline HalfTurn<Pack<N>> half_turn(const Vec3<Pack<N>>& v) {
  const Pack<N> square = 0.25 * dot(v, v);
  HalfTurn<Pack<N>> half = small_half_turn(v, square);
  const auto is_small = less(square, Pack<N>(small));
  const Pack<N> others = Pack<N>::chosen(is_small, Pack<N>(), square);
  if (is_zero(others)) return half;
  const HalfTurn<Pack<N>> any = any_half_turn(v, one_for_zero(others));
  half.cosine = Pack<N>::chosen(is_small, half.cosine, any.cosine);
  for (int i = 0; i < 3; ++i) half.sine_axis[i] = Pack<N>::chosen(is_small, half.sine_axis[i], any.sine_axis[i]);
  return half;
}

constexpr double no_turn = 1e-300;
inline double by_sine(double angle, double sine) { return sine < no_turn ? 1.0 : angle / sine; }
template <int N>
DALEMBERT_INLINE inline Pack<N> by_sine(const Pack<N>& angle, const Pack<N>& sine) {
  const auto is_none = less(sine, Pack<N>(no_turn));
  return Pack<N>::chosen(is_none, Pack<N>(1.0), angle) / Pack<N>::chosen(is_none, Pack<N>(1.0), sine);
}
template <class S>
DALEMBERT_INLINE inline S any_angle_by_sine(const S& sine_squared, const S& cosine) {
  using std::sqrt;
  const S sine = sqrt(sine_squared);
  return by_sine(angle_of(sine, cosine), sine);
}
// An angle in [0, pi] by its sine.
DALEMBERT_INLINE inline double angle_by_sine(double sine_squared, double cosine) {
  return sine_squared < small && cosine > 0.0 ? small_angle_by_sine(sine_squared)
                                              : any_angle_by_sine(sine_squared, cosine);
}
template <int N>
DALEMBERT_INLINE inline Pack<N> angle_by_sine(const Pack<N>& sine_squared, const Pack<N>& cosine) {
  const Pack<N> series = small_angle_by_sine(sine_squared), one(1.0);
  const Pack<N> others = Pack<N>::chosen(less(Pack<N>(), cosine),
                                         Pack<N>::chosen(less(sine_squared, Pack<N>(small)), Pack<N>(), one), one);
  if (is_zero(others)) return series;
  return Pack<N>::chosen(equal(others, Pack<N>()), series, any_angle_by_sine(sine_squared, cosine));
}

// The rotation vector of exp(v) exp(increment), by Euler parameters; its length is in [0, 2 pi], so that it goes on
// steadily when a rotation passes pi.
template <class S>
DALEMBERT_INLINE inline Vec3<S> composed_rotation_vector(const Vec3<S>& v, const Vec3<S>& increment) {
  const auto [c0, s0] = half_turn(v);
  const auto [c1, s1] = half_turn(increment);
  const S cosine = c0 * c1 - dot(s0, s1);
  const Vec3<S> sine_axis = c1 * s0 + c0 * s1 + cross(s0, s1);
  return S(2.0 * angle_by_sine(dot(sine_axis, sine_axis), cosine)) * sine_axis;
}

// Three translations come before the rotations.
struct Composition {
  const double *reference, *q0;
  std::span<const WeightedVector> increment;
  double* q;

  template <int L>
  DALEMBERT_INLINE void operator()(const Group<L>& group, std::span<const System::LieBlock> blocks) const {
    using S = Numbers<L>;
    const auto of = [&](const double* x) DALEMBERT_INLINE {
      return gathered<6>(group.each([&](std::size_t i) DALEMBERT_INLINE { return x + blocks[i].rotation - 3; }));
    };
    Vec<S, 6> change{};
    for (const WeightedVector& part : increment) change += part.factor * of(part.x);
    const Vec<S, 6> from = of(q0), first = of(reference);
    const Vec3<S> composed =
        composed_rotation_vector(segment<3>(first, 3) + segment<3>(from, 3), segment<3>(change, 3));
    const Vec<S, 6> result = joined(segment<3>(from, 0) + segment<3>(change, 0), composed - segment<3>(first, 3));
    store_numbers(result, group.each([&](std::size_t i) DALEMBERT_INLINE { return q + blocks[i].rotation - 3; }));
  }
};

}  // namespace

void System::compose(std::span<const double> q0, std::span<const WeightedVector> increment, std::span<double> q) const {
  const Composition composition{parts_->state(ConfigurationType::Reference).q.data(), q0.data(), increment, q.data()};
  const std::span<const LieBlock> blocks = parts_->lie_blocks;
  if (blocks.size() <= few_blocks) {
    for (std::size_t i = 0; i < blocks.size(); ++i) composition(Group<1>{i, 1}, blocks);
    return;
  }
  // single nodes are not computed separately: ranges differ with the number of threads
  const auto compose_some = [&](std::size_t begin, std::size_t end) {
    in_wide_registers([&]() DALEMBERT_INLINE {
      for (std::size_t i = begin; i < end; i += 4)
        composition(Group<4>{i, static_cast<int>(std::min<std::size_t>(4, end - i))}, blocks);
    });
  };
  if (blocks.size() < blocks_to_share)
    compose_some(0, blocks.size());
  else
    each_stretch(*this, blocks.size(), compose_some);
}

void System::compose(std::span<const double> q0, std::span<const double> increment, std::span<double> q) const {
  const WeightedVector all{1.0, increment.data()};
  compose(q0, std::span(&all, 1), q);
}

}  // namespace dalembert
