// ObjectConnectorSpringDamper, specs/connectors/spring_damper.toml
#pragma once

#include "dalembert/connectors/spring_damper_parameters.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/contracts/span_forces.hpp"
#include "dalembert/contracts/user_function.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/math/pack.hpp"

namespace dalembert {

struct ObjectConnectorSpringDamper : NoPairHistory {
  using Parameters = ObjectConnectorSpringDamperParameters;
  using Port = PointPort;
  static constexpr ConnectorForms closed_forms{.tangent = true, .law = true};

  // Force along the line between the points, or along their relative velocity if they coincide; zero if both vanish.
  template <class S>
  static std::array<Force<S>, 2> forces(const Parameters& p, const Context& c, const PointFrame<S>& m0,
                                        const PointFrame<S>& m1) {
    const Line<S> line(m0, m1);
    const Vec3<S> f = tension(p, c, line) * line.axis;
    return {Force<S>{f}, Force<S>{-f}};
  }
  static bool has_tangent(const Parameters& p) { return !p.springForceUserFunction; }

  template <class S>
  struct Law {
    S stiffness, damping, reference_length, force_at_rest;

    template <class T>
    T tension(const T& length, const T& rate) const {
      return stiffness * (length - reference_length) + damping * rate + force_at_rest;
    }
  };
  static Law<double> law(const Parameters& p) {
    return {p.stiffness, p.damping, p.referenceLength, p.force - p.damping * p.velocityOffset};
  }
  template <class S>
  static Vec3<S> force(const Law<S>& law, const Vec3<S>& span, const Vec3<S>& rate) {
    const Line<S> line(span, rate);
    return law.tension(line.length, line.rate) * line.axis;
  }

  template <class S>
  static SpanTangent<3, S> tangent(const Parameters& p, const PointFrame<S>& m0, const PointFrame<S>& m1) {
    return tangent(law(p), Vec3<S>(m1.position - m0.position), Vec3<S>(m1.velocity - m0.velocity));
  }
  // The tension changes along the line, and the line rotates with the transverse motion. If the points coincide, the
  // relative velocity defines the direction; the jump of the direction when they separate has no derivative.
  template <class L, class S>
  static SpanTangent<3, S> tangent(const Law<L>& law, const Vec3<S>& span, const Vec3<S>& rate) {
    const Line<S> line(span, rate);
    const S per_length = inverse_or_zero(line.length), tension = law.tension(line.length, line.rate),
            turning = tension * per_length;
    const Vec3<S> slope = law.stiffness * line.axis + (law.damping * per_length) * (rate - line.rate * line.axis);
    SpanTangent<3, S> t;
    const auto across = [&](int i, int j)
                            DALEMBERT_INLINE { return (i == j ? 1.0 : 0.0) - line.axis[i] * line.axis[j]; };
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        t.by_span(i, j) = line.axis[i] * slope[j] + turning * across(i, j);
        t.by_rate(i, j) = law.damping * (line.axis[i] * line.axis[j]);
      }
    if (any_zero(line.length)) [[unlikely]] {
      const S turning_by_rate = where_zero(line.length, tension * inverse_or_zero(line.rate), S(0.0));
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) t.by_rate(i, j) += turning_by_rate * across(i, j);
    }
    return t;
  }

  static bool output(const Parameters& p, const Context& c, const PointFrame<double>& m0, const PointFrame<double>& m1,
                     OutputVariableType variable, std::vector<double>& values) {
    const Line<double> line(m0, m1);
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    switch (variable) {
      case OutputVariableType::Distance: values = {line.length}; return true;
      case OutputVariableType::Displacement: vector(line.span); return true;
      case OutputVariableType::Velocity: vector(m1.velocity - m0.velocity); return true;
      case OutputVariableType::Force: vector((p.activeConnector ? tension(p, c, line) : 0.0) * line.axis); return true;
      case OutputVariableType::ForceLocal: values = {p.activeConnector ? tension(p, c, line) : 0.0}; return true;
      case OutputVariableType::PotentialEnergy: {
        const double stretch = line.length - p.referenceLength;
        values = {p.activeConnector ? 0.5 * p.stiffness * stretch * stretch + p.force * stretch : 0.0};
        return !p.springForceUserFunction;
      }
      default: return false;
    }
  }

 private:
  template <class S>
  struct Line {
    Vec3<S> span, axis{};
    S length{}, rate{};

    Line(const PointFrame<S>& m0, const PointFrame<S>& m1)
        : Line(m1.position - m0.position, m1.velocity - m0.velocity) {}
    Line(const Vec3<S>& from_0_to_1, const Vec3<S>& velocity) : span(from_0_to_1) {
      const S square = dot(span, span);
      if (any_zero(square)) [[unlikely]] {
        const Vec3<S> along = where_zero(square, velocity, span);
        const S square_along = dot(along, along);
        if constexpr (OneNumber<S>) {
          if (any_zero(square_along)) return;  // derivatives have no value there
        }
        take(along, square_along);
        length = where_zero(square, dot(axis, span), length);
      } else {
        take(span, square);
      }
      rate = dot(axis, velocity);
    }

   private:
    void take(const Vec3<S>& along, const S& square) {
      using std::sqrt;
      length = sqrt(square);
      axis = (1.0 / one_for_zero(length)) * along;
    }
  };

  template <OneNumber S>
  static bool any_zero(const S& square) {
    return value_of(square) == 0;
  }
  static bool any_zero(const Traced&) { return false; }
  template <int N>
  DALEMBERT_INLINE static bool any_zero(const Pack<N>& square) {
    return !Pack<N>::is_none(equal(square, Pack<N>()));
  }
  // Returns the first value if `number` is zero, otherwise the second. Callers with a single number have already
  // tested it.
  template <OneNumber S, class V>
  static V where_zero(const S&, const V& first, const V&) {
    return first;
  }
  template <int N>
  DALEMBERT_INLINE static Pack<N> where_zero(const Pack<N>& number, const Pack<N>& first, const Pack<N>& second) {
    return Pack<N>::chosen(equal(number, Pack<N>()), first, second);
  }
  template <int N>
  DALEMBERT_INLINE static Vec3<Pack<N>> where_zero(const Pack<N>& number, const Vec3<Pack<N>>& first,
                                                   const Vec3<Pack<N>>& second) {
    return vector_of<3>([&](int i) { return where_zero(number, first[i], second[i]); });
  }
  template <class S>
  DALEMBERT_INLINE static S inverse_or_zero(const S& number) {
    if (any_zero(number)) [[unlikely]] {
      if constexpr (OneNumber<S>)
        return 0.0;
      else
        return where_zero(number, S(0.0), 1.0 / one_for_zero(number));
    }
    return 1.0 / number;
  }

  template <class S>
  static S tension(const Parameters& p, const Context& c, const Line<S>& line) {
    if (p.springForceUserFunction)
      return call_scalar(p.springForceUserFunction, c, line.length - p.referenceLength, line.rate - p.velocityOffset,
                         p.stiffness, p.damping, p.force);
    return law(p).tension(line.length, line.rate);
  }
};

}  // namespace dalembert
