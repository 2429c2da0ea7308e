// Items between any number of markers, each with a port of its own shape: rigid frame, point, coordinates, points of a cable.
//
//   markers ──frames──▶ ┌──────────┐ ──forces───▶ on each of the markers
//   unknowns ─────────▶ │ evaluate │ ──equations▶ one for each unknown
//   data ─────────────▶ └──────────┘
//
// A kernel has one function of all its arguments; its tangent follows by sweeps of dual numbers over the coordinates of the
// markers and its own unknowns. Unknowns are algebraic (multipliers, or coordinates such as the position of a slider), with
// equations that have to vanish; or first-order coordinates of its nodes, with equations for their rates.
//
// There are no optional members. A kernel declares a missing part by deriving from AllMarkersAct, NoAlgebraicEquations,
// NoHistory, NoSwitches or NoOutputs. A member that is missing, misspelt or has another signature does not compile.
#pragma once

#include <algorithm>
#include <concepts>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "dalembert/contracts/context.hpp"
#include "dalembert/contracts/data_node.hpp"
#include "dalembert/contracts/switches.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/reflection/item_type.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

// Positions in an item's list of markers. Some act always, of the remaining ones (alternatives) one at a time, such
// as the cable elements under a slider. Alternatives are coupled with the item, and not with each other.
struct ActingMarkers {
  std::vector<int> always, alternatives;
};

// Frames and unknowns that an item reads, and forces and equations that it computes. The active alternative comes
// last.
template <class S>
class Exchange {
 public:
  struct Place {
    int value = 0, values = 0, force = 0, forces = 0;  // start and number
    bool moves = false;  // it has coordinates
  };

  Exchange(std::span<const Place> markers, const S* values, S* forces)
      : values_(values), forces_(forces), places_(markers) {}

  int markers() const { return static_cast<int>(places_.size()); }
  template <class Port>
  const typename Port::template Frame<S>& frame(int marker) const {
    return *reinterpret_cast<const typename Port::template Frame<S>*>(values(marker).data());
  }
  std::span<const S> values(int marker) const {
    return {values_ + place(marker).value, static_cast<std::size_t>(place(marker).values)};
  }
  std::span<S> forces(int marker) {
    return {forces_ + place(marker).force, static_cast<std::size_t>(place(marker).forces)};
  }
  int selected(int marker) const { return place(marker).forces; }  // how many numbers of a marker have forces
  bool moves(int marker) const { return place(marker).moves; }  // or it rests on ground
  // Adds the force on a marker.
  template <class Force>
  void apply(int marker, const Force& force) {
    const S* from = reinterpret_cast<const S*>(&force);
    S* to = forces_ + place(marker).force;
    for (std::size_t i = 0; i < sizeof(Force) / sizeof(S); ++i) to[i] += from[i];
  }

  std::span<const S> unknowns;  // algebraic ones, then those of first order
  std::span<S> equations;
  bool rate_level = false;  // time derivatives of constraints are asked for in the place of constraints

 private:
  const Place& place(int marker) const { return places_[static_cast<std::size_t>(marker)]; }

  const S* values_;
  S* forces_;
  std::span<const Place> places_;
};

// History of an item after Newton's method: data coordinates at the start of the step and now, and its algebraic
// unknowns, which may be stored as data.
struct History {
  const double* start;
  double* data;
  std::span<double> algebraic;
};

// The nodes and markers of an item, for checks.
class Connections {
 public:
  Connections(const Placement& on, const Ports& ports, const ItemLabel& item) : on_(on), ports_(ports), item_(item) {}

  int markers() const { return static_cast<int>(on_.markers.size()); }
  const Placement& placement() const { return on_; }
  const ItemLabel& item() const { return item_; }
  int coordinates(int position) const { return port(position).forces; }
  const ItemType& type(int position) const { return *on_.marker_types[static_cast<std::size_t>(position)]; }
  // Whether the frame of the port can be read at a marker: that of a rigid body begins with that of a point.
  template <class Port>
  bool gives(int position) const {
    const PortLayout& at = port(position);
    const auto is = [&]<class P>(P) { return at.values == P::values && at.forces == P::forces; };
    if constexpr (Port::forces == ScalarPort::forces)
      return provides(position, "Coordinate") && is(ScalarPort());
    else if constexpr (Port::forces == RigidPort::forces)
      return provides(position, "Orientation") && is(RigidPort());
    else
      return provides(position, "Position") && (is(PointPort()) || is(RigidPort()));
  }

  [[noreturn]] void refuse(const char* parameter, const std::string& received, const std::string& expected) const {
    dalembert::refuse(ErrorKind::value, {item_, parameter, "", received, expected, ""});
  }
  void require(bool holds, int position, const char* parameter, const std::string& expected) const {
    if (!holds)
      refuse(parameter,
             "marker " + std::to_string(on_.markers[static_cast<std::size_t>(position)]) + " (" +
                 std::string(type(position).name) + ")",
             expected);
  }
  // The last coordinate that moves a marker, of the system.
  int last_coordinate(int position) const {
    return ports_.marker_dofs(on_.markers[static_cast<std::size_t>(position)]).back();
  }
  void require_data(int count, const char* parameter = "nodeNumber") const {
    if (on_.data_count != count)
      refuse(parameter, "a node with " + std::to_string(on_.data_count) + " data coordinates", data_node_of(count));
  }

 private:
  bool provides(int position, std::string_view what) const {
    return std::ranges::find(type(position).provides, what) != type(position).provides.end();
  }
  const PortLayout& port(int position) const {
    return ports_.ports[static_cast<std::size_t>(on_.markers[static_cast<std::size_t>(position)])];
  }

  const Placement& on_;
  const Ports& ports_;
  const ItemLabel& item_;
};

struct AllMarkersAct {
  static ActingMarkers acting(const auto&, int markers) {
    ActingMarkers all;
    all.always.resize(static_cast<std::size_t>(markers));
    std::iota(all.always.begin(), all.always.end(), 0);
    return all;
  }
  static int alternative(const auto&, const Context&) { return 0; }
};
struct NoAlgebraicEquations {
  static int algebraic_equations(const auto&, std::span<const int>) { return 0; }
  static bool is_multiplier(const auto&, int) { return true; }
  static bool forces_follow_motion(const auto&) { return true; }
};
struct NoHistory : NoSwitches {
  static constexpr bool has_history = false;
  static PostNewton update(const auto&, const Context&, const Exchange<double>&, const History&) { return {}; }
};
struct NoOutputs {
  static bool output(const auto&, const Context&, const Exchange<double>&, OutputVariableType, std::vector<double>&) {
    return false;
  }
};

// Kernels between two markers of one shape declare `Port` instead (batches/connector.hpp, batches/constraint.hpp).
template <class K>
concept ManyPortsKernel =
    requires(const typename K::Parameters& p, const Context& c, Exchange<double>& x, const Exchange<double>& given,
             const Connections& on, const History& history, Switches& switches, std::span<const int> coordinates,
             OutputVariableType variable, std::vector<double>& values) {
      { K::acting(p, 0) } -> std::same_as<ActingMarkers>;
      { K::alternative(p, c) } -> std::same_as<int>;  // the active one: its index among the alternatives
      // arguments: numbers of coordinates that the markers select
      { K::algebraic_equations(p, coordinates) } -> std::same_as<int>;
      // whether an algebraic unknown is a Lagrange multiplier; otherwise it is a coordinate
      { K::is_multiplier(p, 0) } -> std::same_as<bool>;
      {
        K::forces_follow_motion(p)
      } -> std::same_as<bool>;  // false: reactions of a linear constraint, which coordinates do not change
      { K::template evaluate<double>(p, c, x) } -> std::same_as<void>;
      requires std::same_as<decltype(K::has_history), const bool>;
      { K::update(p, c, given, history) } -> std::same_as<PostNewton>;
      requires std::same_as<decltype(K::has_switches), const bool>;
      requires K::has_switches == requires {
        { K::switch_count(p) } -> std::same_as<int>;
        { K::find_switches(p, c, given, switches) } -> std::same_as<void>;  // so many
      };
      requires K::switches_by_update != requires {
        { K::switch_over(p, c, given, history) } -> std::same_as<void>;
      };
      requires K::settles == requires {
        { K::settle(p, c, given, history) } -> std::same_as<PostNewton>;
      };
      { K::output(p, c, given, variable, values) } -> std::same_as<bool>;
      { K::check(p, on) } -> std::same_as<void>;
    };

}  // namespace dalembert
