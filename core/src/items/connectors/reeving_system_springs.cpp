// ObjectConnectorReevingSystemSprings, specs/connectors/reeving_system_springs.toml: a rope over any number of sheaves.
#include <cmath>
#include <numbers>

#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/connectors/reeving_system_springs_parameters.hpp"
#include "dalembert/contracts/context.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {
namespace {

using Parameters = ObjectConnectorReevingSystemSpringsParameters;

const Parameters& parameters(const void* record) {
  return static_cast<const ObjectConnectorReevingSystemSpringsRecord*>(record)->parameters;
}

Vec3<double> value_of(const Vec3<auto>& v) { return {dalembert::value_of(v[0]), dalembert::value_of(v[1]), dalembert::value_of(v[2])}; }

// A circle about its axis; a point if its radius is zero.
template <class S>
struct Circle {
  Vec3<S> centre, axis;
  double radius;
};

// The contact vector of a circle as a function of an angle, in a basis made of its axis and the line of centres.
template <class S>
struct Contact {
  Vec3<S> cosine{}, sine{};  // contact vector: cosine * cos(angle) - sine * sin(angle)

  Contact(const Contact<auto>& other)
    requires std::is_same_v<S, double>
      : cosine(value_of(other.cosine)), sine(value_of(other.sine)) {}
  Contact(const Circle<S>& circle, const Vec3<S>& normal) : sine(circle.radius * normal) { cosine = cross(sine, circle.axis); }
  Vec3<S> at(const S& angle) const {
    using std::cos;
    using std::sin;
    return cos(angle) * cosine - sin(angle) * sine;
  }
};

// The common tangent of two circles: where it touches them, from their centres. Both contact vectors are measured by the
// sine between the first axis and the line of centres: the second radius is exact for axes at the same angle to that line.
template <class S>
struct Tangent {
  Vec3<S> first{}, second{};
  bool found = true;

  Tangent(const Circle<S>& a, const Circle<S>& b) {
    if (a.radius == 0 && b.radius == 0) return;
    const Vec3<S> centres = b.centre - a.centre;
    const Vec3<S> normal = cross(a.axis, centres);
    const S scale = 1.0 / norm(normal);
    const Contact<S> on_a(a, scale * normal), on_b(b, scale * cross(b.axis, centres));
    found = solve(Contact<double>(on_a), Contact<double>(on_b), value_of(centres), {a.radius, b.radius});
    // One more step of Newton's method, with the derivatives of the residual: those of the angles follow.
    const Vec3<S> r0 = on_a.at(S(angle_[0])), r1 = on_b.at(S(angle_[1]));
    const S f0 = dot(centres + r1, r0) - a.radius * a.radius, f1 = dot(centres - r0, r1) + b.radius * b.radius;
    first = on_a.at(angle_[0] - (inverse_[0] * f0 + inverse_[1] * f1));
    second = on_b.at(angle_[1] - (inverse_[2] * f0 + inverse_[3] * f1));
  }

 private:
  static constexpr int iterations = 8;

  // Newton's method for the angles at which both contact vectors are normal to the tangent.
  bool solve(const Contact<double>& on_a, const Contact<double>& on_b, const Vec3<double>& centres, std::array<double, 2> radii) {
    const double sum = radii[0] + radii[1], tolerance = 1e-12 * sum * (norm(centres) + sum);
    for (int i = 0; i < iterations; ++i) {
      const Vec3<double> r0 = on_a.at(angle_[0]), r1 = on_b.at(angle_[1]);
      const Vec3<double> d0 = on_a.at(angle_[0] + right), d1 = on_b.at(angle_[1] + right);
      const double f0 = dot(centres + r1, r0) - radii[0] * radii[0], f1 = dot(centres - r0, r1) + radii[1] * radii[1];
      double j00 = dot(centres + r1, d0), j01 = dot(d1, r0), j10 = -dot(d0, r1), j11 = dot(centres - r0, d1);
      if (dot(d0, d0) == 0) j00 = 1;
      if (dot(d1, d1) == 0) j11 = 1;
      const double determinant = j00 * j11 - j01 * j10;
      if (!std::isfinite(determinant) || determinant == 0) return false;
      inverse_ = {j11 / determinant, -j01 / determinant, -j10 / determinant, j00 / determinant};
      if (std::hypot(f0, f1) <= tolerance) return true;
      angle_[0] -= inverse_[0] * f0 + inverse_[1] * f1;
      angle_[1] -= inverse_[2] * f0 + inverse_[3] * f1;
    }
    return false;
  }

  static constexpr double right = std::numbers::pi / 2;
  std::array<double, 2> angle_{right, right};
  std::array<double, 4> inverse_{1, 0, 0, 1};  // of the Jacobian, row by row
};

// One free span: unit direction, length, and what it adds to the rate of the rope's length.
template <class S>
struct Span {
  Vec3<S> direction{}, velocity{};  // of its end against its start
  S length{}, rate{};

  Span(const RigidFrame<S>& a, const RigidFrame<S>& b, const Tangent<S>& touch) {
    const Vec3<S> line = b.position + touch.second - a.position - touch.first;
    velocity = b.velocity + cross(b.angular_velocity, touch.second) - a.velocity - cross(a.angular_velocity, touch.first);
    if (dot(value_of(line), value_of(line)) == 0) return;
    length = norm(line);
    direction = (1.0 / length) * line;
    rate = dot(velocity, direction);
  }
};

double saturated(double x) { return std::tanh(x); }
template <int N>
Dual<N> saturated(const Dual<N>& x) {
  const double t = std::tanh(x.value);
  return x.chain(t, 1 - t * t);
}

// Markers of one rope: rigid ones along it, and the two coordinates that add rope at its ends.
template <class S>
struct Rope {
  std::vector<RigidFrame<S>> frames;
  std::array<ScalarFrame<S>, 2> ends{};
  std::vector<Tangent<S>> touches;
  std::vector<Span<S>> spans;
  S length{}, rate{}, force{};

  void evaluate(const Parameters& p, const Context& c) {
    const int n = static_cast<int>(frames.size());
    const auto circle = [&](int i) {
      return Circle<S>{frames[i].position, frames[i].rotation * p.sheavesAxes[i], p.sheavesRadii[i]};
    };
    for (int i = 0; i + 1 < n; ++i) {
      const Circle<S> a = circle(i);
      touches.emplace_back(a, circle(i + 1));
      if (!touches[i].found) refuse_geometry(c, i);
      spans.emplace_back(frames[i], frames[i + 1], touches[i]);
      length += spans[i].length;
      rate += spans[i].rate;
      if (i > 0 && a.radius != 0) length += arc(a, touches[i - 1].second, touches[i].first);
    }
    force = tension(p);
  }

  // Tension at both ends of every span, at the points where it touches the sheaves.
  std::vector<Wrench<S>> wrenches(const Parameters& p) const {
    std::vector<Wrench<S>> w(frames.size());
    for (std::size_t i = 0; i < spans.size(); ++i) {
      const Span<S>& span = spans[i];
      Vec3<S> f = force * span.direction, moment{};
      if (p.dampingShear != 0 && dalembert::value_of(span.length) != 0)
        f += (p.dampingShear / span.length) * (span.velocity - span.rate * span.direction);
      if (p.dampingTorsional != 0)
        moment = (p.dampingTorsional * dot(frames[i + 1].angular_velocity - frames[i].angular_velocity, span.direction)) * span.direction;
      w[i].force += f;
      w[i].moment += moment + cross(touches[i].first, f);
      w[i + 1].force -= f;
      w[i + 1].moment -= moment + cross(touches[i].second, f);
    }
    return w;
  }

 private:
  // Length of rope on a sheave, in the sense of rotation of its axis, less than a full turn.
  static S arc(const Circle<S>& sheave, const Vec3<S>& from, const Vec3<S>& to) {
    using std::atan2;
    S angle = atan2(dot(cross(sheave.axis, from), to), dot(from, to));
    if (angle < 0.0) angle += S(2 * std::numbers::pi);
    return sheave.radius * angle;
  }

  S tension(const Parameters& p) const {
    S own(p.referenceLength), own_rate(0);
    for (int k = 0; k < 2; ++k) {
      own += p.coordinateFactors[k] * ends[k].value;
      own_rate += p.coordinateFactors[k] * ends[k].rate;
    }
    const S stretch = p.stiffnessPerLength * (length - own) + p.dampingPerLength * (rate - own_rate);
    const S f = dalembert::value_of(own) == 0 ? 1e3 * stretch : stretch / own;
    const double limit = p.regularizationForce;
    return limit > 0 && f < 0.0 ? limit * saturated((1 / limit) * f) : f;
  }

  [[noreturn]] static void refuse_geometry(const Context& c, int i) {
    refuse(ErrorKind::value,
           {"object " + std::to_string(c.item) + " (ObjectConnectorReevingSystemSprings)", "sheavesAxes",
            "the sheaves " + std::to_string(i) + " and " + std::to_string(i + 1) + " have no common tangent at time " + std::to_string(c.time),
            "", "sheaves that do not overlap, and axes that are not parallel to the line between their centres", ""});
  }
};

class ReevingBatch final : public Term {
 public:
  void add(const void* record, const Placement& placement, const Ports&) override {
    entries_.push_back({parameters(record), placement.markers, placement.item});
  }
  void refresh(int entry, const void* record) override { entries_[entry].parameters = parameters(record); }
  void visit(BlockVisitor& visitor, const Ports& ports) const override {
    for (const Entry& e : entries_) {
      std::vector<int> all;
      for (const int marker : e.markers) {
        const auto own = ports.marker_dofs(marker);
        all.insert(all.end(), own.begin(), own.end());
      }
      visitor.block(all, all);
    }
  }

  void residual(const Evaluation& evaluation, Ports& ports, double*) const override {
    for (const Entry& e : entries_) {
      if (!e.parameters.activeConnector) continue;
      const Rope<double> rope = e.rope(evaluation, ports);
      const auto wrenches = rope.wrenches(e.parameters);
      for (std::size_t i = 0; i < e.markers.size(); ++i) {
        const std::array marker{e.markers[i]};
        if (i < wrenches.size()) {
          add_forces<RigidPort, 1>(ports, marker, 1.0, {wrenches[i]});
        } else {
          add_forces<ScalarPort, 1>(ports, marker, 1.0, {ScalarForce<double>{e.factor(i) * rope.force}});
        }
      }
    }
  }
  void tangent(const Evaluation& evaluation, const Weights&, Ports& ports, double* values) const override {
    const int* slot = slots.data();
    for (const Entry& e : entries_) {
      const std::vector<Columns<1>> columns = e.columns(ports);
      const int total = columns[0].total;
      if (e.parameters.activeConnector)
        for (int first = 0; first < total; first += sweep_width) add_sweep(e, evaluation, ports, columns, first, slot, values);
      slot += total * total;
    }
  }

  bool output(int entry, OutputVariableType variable, const Vec3<double>&, const Evaluation& evaluation, const Ports& ports,
              std::vector<double>& values) const override {
    const Entry& e = entries_[entry];
    const Rope<double> rope = e.rope(evaluation, ports);
    switch (variable) {
      case OutputVariableType::Distance: values = {rope.length}; return true;
      case OutputVariableType::VelocityLocal: values = {rope.rate}; return true;
      case OutputVariableType::ForceLocal: values = {e.parameters.activeConnector ? rope.force : 0.0}; return true;
      default: return false;
    }
  }

 private:
  struct Entry {
    Parameters parameters;
    std::vector<int> markers;
    int item = -1;

    std::size_t rigid_markers() const { return markers.size() - (parameters.hasCoordinateMarkers ? 2 : 0); }
    double factor(std::size_t i) const { return parameters.coordinateFactors[static_cast<int>(i - rigid_markers())]; }

    Rope<double> rope(const Evaluation& evaluation, const Ports& ports) const {
      Rope<double> rope;
      for (std::size_t i = 0; i < rigid_markers(); ++i) rope.frames.push_back(read_frame<RigidPort>(ports, markers[i]));
      for (std::size_t i = rigid_markers(); i < markers.size(); ++i)
        rope.ends[i - rigid_markers()] = read_frame<ScalarPort>(ports, markers[i]);
      rope.evaluate(parameters, Context::of(evaluation, item));
      return rope;
    }
    // Where each marker's coordinates begin among all of them.
    std::vector<Columns<1>> columns(const Ports& ports) const {
      std::vector<Columns<1>> columns;
      int total = 0;
      for (const int marker : markers) {
        columns.emplace_back(ports, std::array{marker});
        columns.back().offset[0] = std::exchange(total, total + columns.back().total);
      }
      for (Columns<1>& c : columns) c.total = total;
      return columns;
    }
  };

  static void add_sweep(const Entry& e, const Evaluation& evaluation, const Ports& ports, const std::vector<Columns<1>>& columns, int first,
                        const int* slot, double* values) {
    Rope<SweepDual> rope;
    const std::size_t n = e.rigid_markers();
    for (std::size_t i = 0; i < n; ++i)
      rope.frames.push_back(read_moving_frame<RigidPort>(ports, e.markers[i], columns[i].offset[0], first));
    for (std::size_t i = n; i < e.markers.size(); ++i)
      rope.ends[i - n] = read_moving_frame<ScalarPort>(ports, e.markers[i], columns[i].offset[0], first);
    rope.evaluate(e.parameters, Context::of(evaluation, e.item));
    const auto wrenches = rope.wrenches(e.parameters);
    for (std::size_t i = 0; i < e.markers.size(); ++i) {
      const std::array marker{e.markers[i]};
      if (i < n) {
        scatter_forces<RigidPort, 1>(ports, marker, columns[i], first, -1.0, {wrenches[i]}, slot, values);
      } else {
        scatter_forces<ScalarPort, 1>(ports, marker, columns[i], first, -1.0, {ScalarForce<SweepDual>{e.factor(i) * rope.force}}, slot,
                                      values);
      }
    }
  }

  std::vector<Entry> entries_;
};

struct ReevingPhysics final : ObjectPhysics {
  std::unique_ptr<Term> make_batch(std::span<const ItemType* const>) const override { return std::make_unique<ReevingBatch>(); }
  void check(const void* record, const Placement& on, const Ports& ports, const ItemLabel& item) const override {
    const Parameters& p = parameters(record);
    const int coordinates = p.hasCoordinateMarkers ? 2 : 0, count = static_cast<int>(on.markers.size()), n = count - coordinates;
    const std::string also = coordinates == 0 ? "" : " and two coordinate markers";
    const auto complain = [&](const char* parameter, const std::string& received, const std::string& expected) {
      refuse(ErrorKind::value, {item, parameter, "", received, expected, ""});
    };
    if (n < 2) complain("markerNumbers", std::to_string(count) + " markers", "at least two rigid body markers" + also);
    for (int i = 0; i < count; ++i) {
      const PortLayout& port = ports.ports[on.markers[i]];
      const bool rigid = port.values == RigidPort::values && port.forces == RigidPort::forces;
      const bool scalar = port.values == ScalarPort::values && port.forces == ScalarPort::forces;
      if (i < n ? !rigid : !scalar)
        complain("markerNumbers", "marker " + std::to_string(on.markers[i]) + " at place " + std::to_string(i),
                 i < n ? "a rigid body marker" : "a marker of a single coordinate");
    }
    const std::string each = ", one for each of the " + std::to_string(n) + " rigid body markers";
    if (static_cast<int>(p.sheavesAxes.size()) != n)
      complain("sheavesAxes", std::to_string(p.sheavesAxes.size()) + " axes", std::to_string(n) + " axes" + each);
    if (static_cast<int>(p.sheavesRadii.size()) != n)
      complain("sheavesRadii", std::to_string(p.sheavesRadii.size()) + " radii", std::to_string(n) + " radii" + each);
    if (p.regularizationForce == 0) complain("regularizationForce", "0", "a positive or a negative force");
  }
};

}  // namespace

const Physics& object_connector_reeving_system_springs_physics() {
  static const ReevingPhysics physics;
  return physics;
}

}  // namespace dalembert
