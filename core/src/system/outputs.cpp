// Output variables of nodes, objects, markers, loads and sensors, in any configuration.
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/item.hpp"
#include "dalembert/math/rotations.hpp"
#include "dalembert/system/marker_forces.hpp"
#include "dalembert/system/parts.hpp"

namespace dalembert {
namespace {

using Variable = OutputVariableType;
using Values = std::vector<double>;

void assign(const Vec3<double>& v, Values& values) { values.assign(v.x.begin(), v.x.end()); }
// A 4 x 4 matrix, row by row.
void assign_transformation(const Mat3<double>& rotation, const Vec3<double>& position, Values& values) {
  values.assign(16, 0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    std::copy_n(rotation.x.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                values.begin() + static_cast<std::ptrdiff_t>(4 * i));
    values[4 * i + 3] = position[static_cast<int>(i)];
  }
  values[15] = 1;
}
Values slice(const std::vector<double>& from, int first, int count) {
  return first < 0 ? Values{} : Values(from.begin() + first, from.begin() + first + count);
}

[[noreturn]] void no_output(const std::string& item, Variable variable, std::span<const Variable> available) {
  refuse(ErrorKind::value, {item, "", "has no output variable " + std::string(variable_name(variable)), "",
                            available.empty() ? "" : "one of " + variable_names(available), ""});
}

[[noreturn]] void unknown_energy(const std::string& item, Variable variable) {
  refuse(
      ErrorKind::value,
      {item, "",
       std::string(variable_name(variable)) + " is not available, because a user function defines its forces or masses",
       "", "", "Use dalembert.physics.ComputeEnergies(mbs), which integrates the forces along a path"});
}

// Outputs of a motion; `reference()` returns the motion of the same point in the reference configuration.
template <class Reference>
bool frame_output(Variable variable, const Motion<double>& m, Reference&& reference, Values& values) {
  const auto global = [&](const Vec3<double>& v) {
    assign(v, values);
    return true;
  };
  const auto local = [&](const Vec3<double>& v) { return global(transposed_times(m.rotation, v)); };
  switch (variable) {
    case Variable::Position: return global(m.position);
    case Variable::Displacement: return global(m.position - reference().position);
    case Variable::DisplacementLocal: return local(m.position - reference().position);
    case Variable::Velocity: return global(m.velocity);
    case Variable::VelocityLocal: return local(m.velocity);
    case Variable::Acceleration: return global(m.acceleration);
    case Variable::AccelerationLocal: return local(m.acceleration);
    case Variable::RotationMatrix: values.assign(m.rotation.x.begin(), m.rotation.x.end()); return true;
    case Variable::Rotation: return global(tait_bryan_angles(m.rotation));
    case Variable::AngularVelocity: return global(m.angular_velocity);
    case Variable::AngularVelocityLocal: return local(m.angular_velocity);
    case Variable::AngularAcceleration: return global(m.angular_acceleration);
    case Variable::AngularAccelerationLocal: return local(m.angular_acceleration);
    case Variable::HomogeneousTransformation: assign_transformation(m.rotation, m.position, values); return true;
    default: return false;
  }
}

// Outputs that follow from an orientation: a finite element has one if it has the output Rotation.
bool asks_orientation(Variable variable) {
  static constexpr Variable oriented[] = {Variable::RotationMatrix,      Variable::Rotation,
                                          Variable::AngularVelocity,     Variable::AngularVelocityLocal,
                                          Variable::AngularAcceleration, Variable::AngularAccelerationLocal,
                                          Variable::DisplacementLocal,   Variable::VelocityLocal,
                                          Variable::AccelerationLocal};
  return std::ranges::find(oriented, variable) != std::end(oriented);
}
bool lacks(const ItemType& type, Variable variable) {
  return type.category == "FiniteElement" && asks_orientation(variable) &&
         std::ranges::find(type.outputs, Variable::Rotation) == type.outputs.end();
}

// Coordinates are relative to the reference; the reference configuration has the reference values.
bool coordinate_output(Variable variable, const Evaluation& e, std::span<const int> ode2, std::span<const int> ode1,
                       bool of_reference, const State& reference, Values& values) {
  const auto pick = [&](const double* from, std::span<const int> dofs) {
    for (const int i : dofs) values.push_back(from[i]);
  };
  values.clear();
  switch (variable) {
    case Variable::Coordinates:
      pick(of_reference ? reference.q.data() : e.u, ode2);
      pick(e.y, ode1);
      return true;
    case Variable::Coordinates_t:
      pick(e.v, ode2);
      pick(e.y_t, ode1);
      return true;
    case Variable::Coordinates_tt: pick(e.a, ode2); return true;
    case Variable::CoordinatesTotal:
      pick(e.q, ode2);
      for (const int i : ode1) values.push_back(of_reference ? e.y[i] : e.y[i] + reference.y[i]);
      return true;
    default: return false;
  }
}

// How many reactions of an object are not unique.
double not_unique(const SystemParts& parts, const ObjectPlace& object) {
  if (parts.not_unique.empty()) return std::numeric_limits<double>::quiet_NaN();
  if (object.equations == 0) return 0;
  const auto first = parts.not_unique.begin() + object.first_ae;
  return static_cast<double>(std::count(first, first + object.equations, 1));
}

// Frames of the markers for an output. A user function may ask in the middle of an evaluation, which then goes on with its
// own frames.
class PortsFor {
 public:
  PortsFor(SystemParts& parts, ConfigurationType configuration) : parts_(parts) {
    const State& state = parts.state(configuration);
    if (parts.recording && parts.recorded == &state) return;
    if (parts.evaluating && !parts.current_moved && configuration == ConfigurationType::Current) return;
    if (parts.evaluating) kept_ = parts.ports.values;
    parts.update_ports(parts.output_evaluation(state));
    parts.recorded = parts.evaluating ? nullptr : &state;
  }
  ~PortsFor() {
    if (!kept_.empty()) parts_.ports.values = kept_;
  }
  PortsFor(const PortsFor&) = delete;
  PortsFor& operator=(const PortsFor&) = delete;

 private:
  SystemParts& parts_;
  AlignedVector<double> kept_;
};

// Rotation from the joint frame at marker 0 or 1 to the frame of the marker.
Mat3<double> rotation_at_marker(const ItemType& type, const void* record, std::size_t which) {
  const Row* row = find_row(type, which == 0 ? "rotationMarker0" : "rotationMarker1");
  return row == nullptr ? identity<double>() : *static_cast<const Mat3<double>*>(member(record, *row));
}

// The force on the markers of an object, as its own variables of output; -1: another variable.
int marker_of(Variable variable) {
  switch (variable) {
    case Variable::WrenchOnMarker0:
    case Variable::WrenchOnMarker0Local: return 0;
    case Variable::WrenchOnMarker1:
    case Variable::WrenchOnMarker1Local: return 1;
    default: return -1;
  }
}
bool is_local(Variable variable) {
  return variable == Variable::WrenchOnMarker0Local || variable == Variable::WrenchOnMarker1Local;
}

// Forces go to memory of their own: a user function may ask in the middle of an evaluation.
class OwnForces {
 public:
  explicit OwnForces(SystemParts& parts) : parts_(parts) {
    parts_.output_forces.resize(parts_.ports.forces.size());
    parts_.ports.forces.swap(parts_.output_forces);
  }
  ~OwnForces() { parts_.ports.forces.swap(parts_.output_forces); }
  OwnForces(const OwnForces&) = delete;
  OwnForces& operator=(const OwnForces&) = delete;

 private:
  SystemParts& parts_;
};

// Consecutive coordinates; the few of most nodes need no heap.
struct Range {
  Range(int first, int count) {
    const auto n = static_cast<std::size_t>(count);
    if (n > few.size()) many.resize(n);
    int* begin = n > few.size() ? many.data() : few.data();
    for (int i = 0; i < count; ++i) begin[i] = first + i;
    all = {begin, n};
  }
  Range(const Range&) = delete;
  Range& operator=(const Range&) = delete;

  std::array<int, 8> few{};
  std::vector<int> many;
  std::span<const int> all;
};

NodeView view(const SystemParts& parts, const NodePlace& node, const State& state, const Evaluation& e,
              Values& y_total) {
  const auto part = [](const double* from, int first, int count) {
    return first < 0 ? std::span<const double>{} : std::span(from + first, static_cast<std::size_t>(count));
  };
  const Sizes& n = node.sizes;
  y_total = slice(state.y, node.ode1, n.ode1);
  const State& reference = parts.states[static_cast<std::size_t>(ConfigurationType::Reference)];
  for (int i = 0; i < n.ode1; ++i) y_total[i] += reference.y[node.ode1 + i];
  return {part(e.q, node.ode2, n.ode2),   part(e.u, node.ode2, n.ode2),  part(e.v, node.ode2, n.ode2),
          part(e.a, node.ode2, n.ode2),   part(e.y, node.ode1, n.ode1),  y_total,
          part(e.y_t, node.ode1, n.ode1), part(e.lambda, node.ae, n.ae), part(e.data, node.data, n.data)};
}

}  // namespace

void System::node_output(int node, Variable variable, ConfigurationType configuration, Values& values) {
  SystemParts& parts = *parts_;
  const NodePlace& place = parts.nodes.at(static_cast<std::size_t>(node));
  const State& state = parts.state(configuration);
  const State& rest = parts.state(ConfigurationType::Reference);
  if (const StateReading reading = translation_reading(place, variable); reading && &state != &rest) {
    reading.read(state, rest, values);
    return;
  }
  Values y_total;
  if (variable == Variable::Coordinates && place.sizes.data > 0) {
    values = slice(state.data, place.data, place.sizes.data);
    return;
  }
  const Range dofs(place.ode2, place.sizes.ode2), rates(place.ode1, place.sizes.ode1);
  const Evaluation e = parts.output_evaluation(state, dofs.all);
  const NodeView now = view(parts, place, state, e, y_total);
  if (place.physics->output(place.record.get(), variable, now, values)) return;
  if (coordinate_output(variable, e, dofs.all, rates.all, &state == &rest, rest, values)) return;
  Motion<double> m;
  const auto reference = [&] {
    Motion<double> r;
    place.physics->motion(place.record.get(),
                          view(parts, place, rest, parts.output_evaluation(rest, dofs.all), y_total), r);
    return r;
  };
  if (place.physics->motion(place.record.get(), now, m) && frame_output(variable, m, reference, values)) return;
  no_output(parts.describe(ItemKind::node, node), variable, place.type->outputs);
}

namespace {

// A temporary list that is returned to a pool: outputs may be nested.
struct NumberList {
  explicit NumberList(std::vector<int>& memory) : numbers(std::move(memory)), memory_(memory) {}
  ~NumberList() { memory_ = std::move(numbers); }
  NumberList(const NumberList&) = delete;
  NumberList& operator=(const NumberList&) = delete;
  std::vector<int> numbers;

 private:
  std::vector<int>& memory_;
};

}  // namespace

// What an object exerts on one of its markers. Multipliers of statics get the sign that they have in equations of motion.
void System::wrench_output(int object, Variable variable, ConfigurationType configuration, Values& values) {
  SystemParts& parts = *parts_;
  const ObjectPlace& place = parts.objects[static_cast<std::size_t>(object)];
  const auto* forces = dynamic_cast<const MarkerForces*>(place.member.batch);
  const auto markers = place.markers.of(parts.references);
  const auto which = static_cast<std::size_t>(marker_of(variable));
  if (forces == nullptr || which >= markers.size())
    no_output(parts.describe(ItemKind::object, object), variable, place.type->outputs);
  const int marker = markers[which];
  const PortsFor ports(parts, configuration);
  ports_hold(parts.evaluating ? evaluated_ : nullptr);
  const State& state = parts.state(configuration);
  Evaluation e = parts.output_evaluation(state);
  if (place.equations > 0 && state.sign == MultiplierSign::statics) {
    parts.output_multipliers = state.lambda;
    for (std::size_t i = 0; i < state.lambda.size(); ++i) parts.output_multipliers[i] *= parts.static_signs[i];
    e.lambda = parts.output_multipliers.data();
  } else if (place.equations > 0 && state.sign == MultiplierSign::unknown) {
    refuse(ErrorKind::state, {parts.describe(ItemKind::object, object), "",
                              "has no output variable " + std::string(variable_name(variable)) +
                                  " in this configuration: its Lagrange multipliers were set by mbs.systemData, and "
                                  "those of statics and dynamics differ in sign",
                              "", "", "Ask after SolveStatic or SolveDynamic, before other coordinates are set"});
  }
  {
    const OwnForces own(parts);
    for (const int each : markers) {
      const PortLayout& port = parts.ports.ports[static_cast<std::size_t>(each)];
      std::fill_n(parts.ports.forces.begin() + port.first_force, port.forces, 0.0);
    }
    forces->add_marker_forces(place.member.entry, e, parts.ports);
    const double* first = parts.ports.force(marker);
    values.assign(first, first + parts.ports.ports[static_cast<std::size_t>(marker)].forces);
  }
  const MarkerPlace& at = parts.markers[static_cast<std::size_t>(marker)];
  if (!provides(*at.type, "Position") || (values.size() != 3 && values.size() != 6)) {  // coordinates
    if (is_local(variable)) no_output(parts.describe(ItemKind::object, object), variable, place.type->outputs);
    return;
  }
  values.resize(6);
  if (!is_local(variable)) return;
  Motion<double> motion;
  if (!provides(*at.type, "Orientation") || !at.member.batch->motion(at.member.entry, e, motion))
    refuse(ErrorKind::value, {parts.describe(ItemKind::object, object), "",
                              "has no output variable " + std::string(variable_name(variable)) + ", because " +
                                  parts.describe(ItemKind::marker, marker) + " has no axes",
                              "", "",
                              which == 0 ? "Use WrenchOnMarker0, whose components are in global axes"
                                         : "Use WrenchOnMarker1, whose components are in global axes"});
  const Mat3<double> axes = motion.rotation * rotation_at_marker(*place.type, place.record.get(), which);
  for (std::size_t i = 0; i < 6; i += 3) {
    const Vec3<double> components = transposed_times(axes, Vec3<double>{values[i], values[i + 1], values[i + 2]});
    std::ranges::copy(components.x, values.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void System::body_output(int object, Variable variable, std::array<double, 3> local, ConfigurationType configuration,
                         Values& values) {
  SystemParts& parts = *parts_;
  const ObjectPlace& place = parts.objects.at(static_cast<std::size_t>(object));
  if (marker_of(variable) >= 0) return wrench_output(object, variable, configuration, values);
  if (variable == Variable::NonUniqueReactions && provides(*place.type, "Constraint"))
    return values.assign(1, not_unique(parts, place));
  const Vec3<double> at{local[0], local[1], local[2]};
  const State& state = parts.state(configuration);
  NumberList list(parts.free_numbers);
  const std::vector<int>& dofs = list.numbers;
  parts.list_coordinates(place, Coordinates::ode2, list.numbers);
  const auto batch = place.member.batch;
  const int entry = place.member.entry;
  std::optional<PortsFor> ports;
  if (place.markers.count > 0) ports.emplace(parts, configuration);
  const Evaluation e = parts.output_evaluation(state, dofs);
  ports_hold(parts.evaluating ? evaluated_ : nullptr);
  if (variable == Variable::KineticEnergy || (variable == Variable::PotentialEnergy && place.markers.count == 0)) {
    if (std::ranges::find(place.type->outputs, variable) == place.type->outputs.end())
      no_output(parts.describe(ItemKind::object, object), variable, place.type->outputs);
    values.assign(1, 0.0);
    if (!batch->energy(entry, variable == Variable::KineticEnergy ? Energy::kinetic : Energy::potential, e, values[0]))
      unknown_energy(parts.describe(ItemKind::object, object), variable);
    return;
  }
  if (batch->output(entry, variable, at, e, parts.ports, values)) return;
  if (variable == Variable::PotentialEnergy &&
      std::ranges::find(place.type->outputs, variable) != place.type->outputs.end())
    unknown_energy(parts.describe(ItemKind::object, object), variable);
  if ((variable == Variable::HomogeneousTransformation || variable == Variable::HomogeneousTransformationLocal) &&
      place.markers.count >= 2 && std::ranges::find(place.type->outputs, variable) != place.type->outputs.end()) {
    std::array<Motion<double>, 2> joint;
    const Evaluation whole = parts.output_evaluation(state);
    for (std::size_t i = 0; i < 2; ++i) {
      const MarkerPlace& marker = parts.markers[static_cast<std::size_t>(place.markers.of(parts.references)[i])];
      if (!marker.member.batch->motion(marker.member.entry, whole, joint[i]))
        no_output(parts.describe(ItemKind::object, object), variable, place.type->outputs);
      joint[i].rotation = joint[i].rotation * rotation_at_marker(*place.type, place.record.get(), i);
    }
    if (variable == Variable::HomogeneousTransformation)
      return assign_transformation(joint[0].rotation, joint[0].position, values);
    return assign_transformation(transpose(joint[0].rotation) * joint[1].rotation,
                                 transposed_times(joint[0].rotation, joint[1].position - joint[0].position), values);
  }
  const State& rest = parts.state(ConfigurationType::Reference);
  if (coordinate_output(variable, e, dofs, object_ltg(object, Coordinates::ode1), &state == &rest, rest, values))
    return;
  Motion<double> m;
  const auto reference = [&] {
    Motion<double> r;
    batch->motion(entry, parts.output_evaluation(rest, dofs), at, r);
    return r;
  };
  if (!lacks(*place.type, variable) && batch->motion(entry, e, at, m) && frame_output(variable, m, reference, values))
    return;
  no_output(parts.describe(ItemKind::object, object), variable, place.type->outputs);
}

void System::object_output(int object, Variable variable, ConfigurationType configuration, Values& values) {
  body_output(object, variable, {0, 0, 0}, configuration, values);
}

void System::link_output(int object, Variable variable, int link, std::array<double, 3> local,
                         ConfigurationType configuration, Values& values) {
  SystemParts& parts = *parts_;
  const ObjectPlace& place = parts.objects.at(static_cast<std::size_t>(object));
  const auto* bodies = dynamic_cast<const LinkedBodies*>(place.member.batch);
  const int entry = place.member.entry;
  const int count = bodies == nullptr ? 0 : bodies->links(entry);
  if (link < 0 || link >= count)
    refuse(ErrorKind::value,
           {parts.describe(ItemKind::object, object), "linkNumber", "", std::to_string(link),
            count == 0 ? "a kinematic tree: this object has no links" : "a link from 0 to " + std::to_string(count - 1),
            ""});
  NumberList list(parts.free_numbers);
  parts.list_coordinates(place, Coordinates::ode2, list.numbers);
  const auto motion_in = [&](const State& state) {
    return bodies->link_motion(entry, link, {local[0], local[1], local[2]},
                               parts.output_evaluation(state, list.numbers));
  };
  const auto reference = [&] { return motion_in(parts.state(ConfigurationType::Reference)); };
  if (frame_output(variable, motion_in(parts.state(configuration)), reference, values)) return;
  refuse(ErrorKind::value, {parts.describe(ItemKind::object, object), "",
                            "its links have no output variable " + std::string(variable_name(variable)), "",
                            "Position, Displacement, Velocity, Acceleration, Rotation, RotationMatrix, "
                            "AngularVelocity, AngularAcceleration, or one of these with Local",
                            ""});
}

void System::super_element_output(int object, Variable variable, int mesh_node, ConfigurationType configuration,
                                  Values& values) {
  SystemParts& parts = *parts_;
  const ObjectPlace& place = parts.objects.at(static_cast<std::size_t>(object));
  const auto& [batch, entry] = place.member;
  if (dynamic_cast<const LinkedBodies*>(batch) != nullptr)
    return link_output(object, variable, mesh_node, {0, 0, 0}, configuration, values);
  const int own = batch->mesh_nodes(entry), count = own != 0 ? std::max(own, 0) : static_cast<int>(place.nodes.count);
  if (mesh_node < 0 || mesh_node >= count)
    refuse(ErrorKind::value, {parts.describe(ItemKind::object, object), "meshNodeNumber", "", std::to_string(mesh_node),
                              count == 0 ? "an object with mesh nodes: this one has none"
                                         : "a mesh node from 0 to " + std::to_string(count - 1),
                              ""});
  if (own == 0)
    return node_output(place.nodes.of(parts.references)[static_cast<std::size_t>(mesh_node)], variable, configuration,
                       values);
  NumberList list(parts.free_numbers);
  parts.list_coordinates(place, Coordinates::ode2, list.numbers);
  if (batch->mesh_outputs(entry, mesh_node, 1, variable,
                          parts.output_evaluation(parts.state(configuration), list.numbers), values))
    return;
  refuse(
      ErrorKind::value,
      {parts.describe(ItemKind::object, object), "",
       "its mesh nodes have no output variable " + std::string(variable_name(variable)), "",
       "Position, Displacement, Velocity, Acceleration, DisplacementLocal, VelocityLocal, or that of its modes", ""});
}

void System::with_ports(ConfigurationType configuration, const std::function<void(const Ports&)>& look) {
  const PortsFor ports(*parts_, configuration);
  ports_hold(parts_->evaluating ? evaluated_ : nullptr);
  look(parts_->ports);
}

void System::marker_output(int marker, Variable variable, ConfigurationType configuration, Values& values) {
  SystemParts& parts = *parts_;
  const MarkerPlace& place = parts.markers.at(static_cast<std::size_t>(marker));
  const bool values_of_coordinates = variable == Variable::Coordinates, rates = variable == Variable::Coordinates_t;
  if (provides(*place.type, "Coordinate") && (values_of_coordinates || rates)) {
    const PortsFor ports(parts, configuration);
    ports_hold(parts.evaluating ? evaluated_ : nullptr);
    const PortLayout& port = parts.ports.ports[static_cast<std::size_t>(marker)];
    const double* frame = parts.ports.frame(marker);
    const double* first = rates ? frame + port.forces : frame;
    values.assign(first, first + port.forces);
    return;
  }
  if (variable == Variable::CoordinatesTotal && place.member.batch->shows_coordinates()) {
    const auto dofs = parts.ports.marker_dofs(marker);
    const Evaluation e = parts.output_evaluation(parts.state(configuration), dofs);
    values.assign(static_cast<std::size_t>(parts.ports.ports[static_cast<std::size_t>(marker)].forces),
                  0.0);  // of ground: they rest
    std::ranges::transform(dofs, values.begin(), [&](int i) { return e.q[i]; });
    return;
  }
  Motion<double> m;
  const auto reference = [&] {
    Motion<double> r;
    place.member.batch->motion(place.member.entry, parts.output_evaluation(parts.state(ConfigurationType::Reference)),
                               r);
    return r;
  };
  const Evaluation e = parts.output_evaluation(parts.state(configuration));
  const bool unoriented =
      place.object >= 0 && lacks(*parts.objects[static_cast<std::size_t>(place.object)].type, variable);
  if (!unoriented && place.member.batch->motion(place.member.entry, e, m) &&
      frame_output(variable, m, reference, values))
    return;
  no_output(parts.describe(ItemKind::marker, marker), variable, {});
}

void System::load_values(int load, double time, Values& values) {
  const LoadPlace& place = parts_->loads.at(static_cast<std::size_t>(load));
  values = static_cast<const LoadPhysics*>(place.type->physics)->values(place.record.get(), time);
}

bool follows_from_motion(Variable variable) {
  Values values;
  const Motion<double> rest{};
  return frame_output(variable, rest, [&] { return rest; }, values);
}

// Outputs of kernels are listed in the spec; outputs from motion and coordinates are common to all.
bool may_have(const ItemType& type, Variable variable) {
  if (std::ranges::find(type.outputs, variable) != type.outputs.end()) return true;
  Values values;
  if (coordinate_output(variable, {}, {}, {}, false, {}, values)) return true;
  if (variable == Variable::NonUniqueReactions) return provides(type, "Constraint");
  if (marker_of(variable) >= 0) return provides(type, "Connector");
  const bool moves = type.kind != ItemKind::object || type.category == "Body" || type.category == "FiniteElement" ||
                     type.category == "SuperElement";
  return moves && !lacks(type, variable) && follows_from_motion(variable);
}

System::Recording::Recording(System& system) : system_(system) {
  system_.parts_->recording = true;
  system_.parts_->recorded = nullptr;
}
System::Recording::~Recording() { system_.parts_->recording = false; }

void System::state_may_have_changed() { parts_->recorded = nullptr; }

}  // namespace dalembert
