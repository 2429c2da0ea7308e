// Connectors whose force depends only on the span between two points (or coordinates) and on its rate.
#pragma once

#include <concepts>

#include "dalembert/math/fixed.hpp"
#include "dalembert/math/traced.hpp"

namespace dalembert {

// Derivatives of the force on the first marker; its opposite acts on the second.
template <int N, class S = double>
struct SpanTangent {
  Mat<S, N, N> by_span, by_rate;
};

// Kernels test whether points coincide. The value of traced numbers is unknown and counts as nonzero. If it is zero,
// results are NaN, which the caller detects.
inline bool is_zero(const Vec3<Traced>&) { return false; }

// `has_tangent(p)`: not with user functions, which only the sweep of dual numbers differentiates.
template <class K>
concept SpanConnector = requires(const typename K::Parameters& p, const typename K::Port::template Frame<double>& m) {
  { K::has_tangent(p) } -> std::same_as<bool>;
  { K::tangent(p, m, m) } -> std::same_as<SpanTangent<K::Port::forces>>;
};

// `tangent` takes frames of any scalar.
template <class K>
concept TracedSpanConnector =
    SpanConnector<K> && requires(const typename K::Parameters& p, const typename K::Port::template Frame<Traced>& m) {
      K::tangent(p, m, m).by_span;
    };

// Besides span and rate, the force depends only on a few numbers, its law: several connectors are computed side by
// side. Law<S> consists of scalars; `force(law, span, rate)` acts on the first marker, and `tangent(law, span, rate)`
// has its derivatives. A connector has it if `has_tangent`.
template <class K>
concept SpanLawConnector =
    SpanConnector<K> &&
    requires(const typename K::Parameters& p, const typename K::template Law<double>& law, const Vec3<double>& v) {
      { K::law(p) } -> std::same_as<typename K::template Law<double>>;
      { K::force(law, v, v) } -> std::same_as<Vec3<double>>;
      { K::tangent(law, v, v) } -> std::same_as<SpanTangent<3>>;
    };

}  // namespace dalembert
