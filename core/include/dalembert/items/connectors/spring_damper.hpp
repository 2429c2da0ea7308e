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

  // Force along the line between the points, or along their relative velocity while they coincide; without either, none.
  template <class S>
  static std::array<Force<S>, 2> forces(const Parameters& p, const Context& c, const PointFrame<S>& m0, const PointFrame<S>& m1) {
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

  // The tension changes along the line, the line turns with what moves across it. Where the points coincide, it is the relative
  // velocity that turns it; that the line jumps once they part has no derivative.
  template <class S>
  static SpanTangent<3, S> tangent(const Parameters& p, const PointFrame<S>& m0, const PointFrame<S>& m1) {
    const Line<S> line(m0, m1);
    if (is_zero(line.axis)) return {};
    const bool coincide = is_zero(line.span);
    Vec3<S> slope = p.stiffness * line.axis;
    if (!coincide) slope += (p.damping / line.length) * (m1.velocity - m0.velocity - line.rate * line.axis);
    SpanTangent<3, S> t;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        t.by_span(i, j) = line.axis[i] * slope[j];
        t.by_rate(i, j) = p.damping * line.axis[i] * line.axis[j];
      }
    const S turning = tension(p, Context{}, line) / (coincide ? line.rate : line.length);
    Mat3<S>& turned = coincide ? t.by_rate : t.by_span;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) turned(i, j) += turning * ((i == j ? 1.0 : 0.0) - line.axis[i] * line.axis[j]);
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
      default: return false;
    }
  }

 private:
  template <class S>
  struct Line {
    Vec3<S> span, axis{};
    S length{}, rate{};

    Line(const PointFrame<S>& m0, const PointFrame<S>& m1) : Line(m1.position - m0.position, m1.velocity - m0.velocity) {}
    Line(const Vec3<S>& from_0_to_1, const Vec3<S>& velocity) : span(from_0_to_1) {
      Vec3<S> along = span;
      S square = dot(along, along);
      const bool coincide = any_zero(square);
      if (coincide) [[unlikely]] {
        along = where_zero(square, velocity, span);
        square = dot(along, along);
        if constexpr (OneNumber<S>) {
          if (any_zero(square)) return;  // derivatives have no value there
        }
      }
      using std::sqrt;
      length = sqrt(square);
      axis = (1.0 / one_for_zero(length)) * along;
      if (coincide) [[unlikely]] length = dot(axis, span);
      rate = dot(axis, velocity);
    }
  };

  template <OneNumber S>
  static bool any_zero(const S& square) {
    return value_of(square) == 0;
  }
  static bool any_zero(const Traced&) { return false; }
  template <int N>
  DALEMBERT_INLINE static bool any_zero(const Pack<N>& square) {
    const auto zero = square.x == typename Pack<N>::Register{};
    auto any = zero[0];
    for (int lane = 1; lane < N; ++lane) any |= zero[lane];
    return any != 0;
  }
  // The first vector where the square is zero, else the second.
  template <OneNumber S>
  static Vec3<S> where_zero(const S&, const Vec3<S>& first, const Vec3<S>&) {
    return first;
  }
  template <int N>
  DALEMBERT_INLINE static Vec3<Pack<N>> where_zero(const Pack<N>& square, const Vec3<Pack<N>>& first, const Vec3<Pack<N>>& second) {
    return vector_of<3>([&](int i) { return Pack<N>(square.x == 0.0 ? first[i].x : second[i].x); });
  }

  template <class S>
  static S tension(const Parameters& p, const Context& c, const Line<S>& line) {
    if (p.springForceUserFunction)
      return call_scalar(p.springForceUserFunction, c, line.length - p.referenceLength, line.rate - p.velocityOffset, p.stiffness,
                         p.damping, p.force);
    return law(p).tension(line.length, line.rate);
  }
};

}  // namespace dalembert
