// Output variables of nodes, objects, markers, loads and sensors, in any configuration.
#include <algorithm>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/item.hpp"
#include "dalembert/reflection/callback.hpp"
#include "dalembert/sensors/body_parameters.hpp"
#include "dalembert/sensors/load_parameters.hpp"
#include "dalembert/sensors/marker_parameters.hpp"
#include "dalembert/sensors/node_parameters.hpp"
#include "dalembert/sensors/object_parameters.hpp"
#include "dalembert/sensors/super_element_parameters.hpp"
#include "dalembert/sensors/user_function_parameters.hpp"
#include "dalembert/math/rotations.hpp"
#include "dalembert/system/parts.hpp"

namespace dalembert {
namespace {

using Variable = OutputVariableType;
using Values = std::vector<double>;

Values list(const Vec3<double>& v) { return {v[0], v[1], v[2]}; }
Values slice(const std::vector<double>& from, int first, int count) {
  return first < 0 ? Values{} : Values(from.begin() + first, from.begin() + first + count);
}

std::string variable_name(Variable variable) {
  for (const EnumTable& table : enum_tables())
    if (table.name == "OutputVariableType")
      for (const EnumEntry& entry : table.entries)
        if (entry.value == static_cast<std::uint32_t>(variable)) return std::string(entry.name);
  return std::to_string(static_cast<std::uint32_t>(variable));
}

[[noreturn]] void no_output(const std::string& item, Variable variable, std::span<const Variable> available) {
  std::string names;
  for (const Variable v : available) names += (names.empty() ? "" : ", ") + variable_name(v);
  refuse(ErrorKind::value, {item, "", "has no output variable " + variable_name(variable), "",
                            names.empty() ? "" : "one of " + names, ""});
}

// What a motion says; `reference()` gives the motion of the same point in the reference configuration.
template <class Reference>
bool frame_output(Variable variable, const Motion<double>& m, Reference&& reference, Values& values) {
  const auto local = [&](const Vec3<double>& v) { return list(transposed_times(m.rotation, v)); };
  switch (variable) {
    case Variable::Position: values = list(m.position); return true;
    case Variable::Displacement: values = list(m.position - reference().position); return true;
    case Variable::DisplacementLocal: values = local(m.position - reference().position); return true;
    case Variable::Velocity: values = list(m.velocity); return true;
    case Variable::VelocityLocal: values = local(m.velocity); return true;
    case Variable::Acceleration: values = list(m.acceleration); return true;
    case Variable::AccelerationLocal: values = local(m.acceleration); return true;
    case Variable::RotationMatrix: values.assign(m.rotation.x.begin(), m.rotation.x.end()); return true;
    case Variable::Rotation: values = list(tait_bryan_angles(m.rotation)); return true;
    case Variable::AngularVelocity: values = list(m.angular_velocity); return true;
    case Variable::AngularVelocityLocal: values = local(m.angular_velocity); return true;
    case Variable::AngularAcceleration: values = list(m.angular_acceleration); return true;
    case Variable::AngularAccelerationLocal: values = local(m.angular_acceleration); return true;
    default: return false;
  }
}

bool coordinate_output(Variable variable, const Evaluation& e, std::span<const int> ode2, std::span<const int> ode1,
                       const State& reference, Values& values) {
  const auto pick = [&](const double* from, std::span<const int> dofs) {
    for (const int i : dofs) values.push_back(from[i]);
  };
  values.clear();
  switch (variable) {
    case Variable::Coordinates: pick(e.u, ode2); pick(e.y, ode1); return true;
    case Variable::Coordinates_t: pick(e.v, ode2); pick(e.y_t, ode1); return true;
    case Variable::Coordinates_tt: pick(e.a, ode2); return true;
    case Variable::CoordinatesTotal:
      pick(e.q, ode2);
      for (const int i : ode1) values.push_back(e.y[i] + reference.y[i]);
      return true;
    default: return false;
  }
}

// Frames of the markers for an output. A user function may ask in the middle of an evaluation, which then goes on with its
// own frames.
class PortsFor {
 public:
  PortsFor(SystemParts& parts, const Evaluation& e, ConfigurationType configuration, bool needed) : parts_(parts) {
    if (!needed || (parts.evaluating && configuration == ConfigurationType::Current)) return;
    if (parts.evaluating) kept_ = parts.ports.values;
    parts.update_ports(e);
  }
  ~PortsFor() {
    if (!kept_.empty()) parts_.ports.values = kept_;
  }
  PortsFor(const PortsFor&) = delete;
  PortsFor& operator=(const PortsFor&) = delete;

 private:
  SystemParts& parts_;
  Values kept_;
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

NodeView view(const SystemParts& parts, const NodePlace& node, const State& state, const Evaluation& e, Values& y_total) {
  const auto part = [](const double* from, int first, int count) {
    return first < 0 ? std::span<const double>{} : std::span(from + first, static_cast<std::size_t>(count));
  };
  const Sizes& n = node.sizes;
  y_total = slice(state.y, node.ode1, n.ode1);
  const State& reference = parts.states[static_cast<std::size_t>(ConfigurationType::Reference)];
  for (int i = 0; i < n.ode1; ++i) y_total[i] += reference.y[node.ode1 + i];
  return {part(e.q, node.ode2, n.ode2), part(e.u, node.ode2, n.ode2), part(e.v, node.ode2, n.ode2),
          part(e.a, node.ode2, n.ode2), part(e.y, node.ode1, n.ode1), y_total, part(e.y_t, node.ode1, n.ode1),
          part(e.lambda, node.ae, n.ae), part(e.data, node.data, n.data)};
}

}  // namespace

std::vector<double> System::node_output(int node, Variable variable, ConfigurationType configuration) {
  SystemParts& parts = *parts_;
  const NodePlace& place = parts.nodes.at(static_cast<std::size_t>(node));
  const State& state = parts.state(configuration);
  Values values, y_total;
  if (variable == Variable::Coordinates && place.sizes.data > 0) return slice(state.data, place.data, place.sizes.data);
  const Range dofs(place.ode2, place.sizes.ode2), rates(place.ode1, place.sizes.ode1);
  const Evaluation e = parts.output_evaluation(state, dofs.all);
  const NodeView now = view(parts, place, state, e, y_total);
  if (place.physics->output(place.record.get(), variable, now, values)) return values;
  const State& rest = parts.state(ConfigurationType::Reference);
  if (coordinate_output(variable, e, dofs.all, rates.all, rest, values)) return values;
  Motion<double> m;
  const auto reference = [&] {
    Motion<double> r;
    place.physics->motion(place.record.get(), view(parts, place, rest, parts.output_evaluation(rest, dofs.all), y_total), r);
    return r;
  };
  if (place.physics->motion(place.record.get(), now, m) && frame_output(variable, m, reference, values)) return values;
  no_output(parts.describe(ItemKind::node, node), variable, place.type->outputs);
}

std::vector<double> System::body_output(int object, Variable variable, std::array<double, 3> local,
                                        ConfigurationType configuration) {
  SystemParts& parts = *parts_;
  const ObjectPlace& place = parts.objects.at(static_cast<std::size_t>(object));
  const Vec3<double> at{local[0], local[1], local[2]};
  const State& state = parts.state(configuration);
  const bool from_markers = !place.markers.empty();
  const auto dofs = object_ltg(object, Coordinates::ode2);
  const Evaluation e = from_markers ? parts.output_evaluation(state) : parts.output_evaluation(state, dofs);
  Values values;
  const auto& [batch, entry] = place.member;
  const PortsFor ports(parts, e, configuration, from_markers);
  evaluated_ = parts.evaluating ? evaluated_ : nullptr;
  if (batch->output(entry, variable, at, e, parts.ports, values)) return values;
  const State& rest = parts.state(ConfigurationType::Reference);
  if (coordinate_output(variable, e, dofs, object_ltg(object, Coordinates::ode1), rest, values)) return values;
  Motion<double> m;
  const auto reference = [&] {
    Motion<double> r;
    batch->motion(entry, parts.output_evaluation(rest, dofs), at, r);
    return r;
  };
  if (batch->motion(entry, e, at, m) && frame_output(variable, m, reference, values)) return values;
  no_output(parts.describe(ItemKind::object, object), variable, place.type->outputs);
}

std::vector<double> System::object_output(int object, Variable variable, ConfigurationType configuration) {
  return body_output(object, variable, {0, 0, 0}, configuration);
}

std::vector<double> System::super_element_output(int object, Variable variable, int mesh_node, ConfigurationType configuration) {
  const ObjectPlace& place = parts_->objects.at(static_cast<std::size_t>(object));
  if (mesh_node < 0 || mesh_node >= static_cast<int>(place.nodes.size()))
    refuse(ErrorKind::value, {parts_->describe(ItemKind::object, object), "meshNodeNumber", "", std::to_string(mesh_node),
                              "a mesh node from 0 to " + std::to_string(static_cast<int>(place.nodes.size()) - 1), ""});
  return node_output(place.nodes[static_cast<std::size_t>(mesh_node)], variable, configuration);
}

std::vector<double> System::marker_output(int marker, Variable variable, ConfigurationType configuration) {
  SystemParts& parts = *parts_;
  const MarkerPlace& place = parts.markers.at(static_cast<std::size_t>(marker));
  const Evaluation e = parts.output_evaluation(parts.state(configuration));
  const bool values_of_coordinates = variable == Variable::Coordinates, rates = variable == Variable::Coordinates_t;
  if (provides(*place.type, "Coordinate") && (values_of_coordinates || rates)) {
    const PortsFor ports(parts, e, configuration, true);
    evaluated_ = parts.evaluating ? evaluated_ : nullptr;
    const PortLayout& port = parts.ports.ports[static_cast<std::size_t>(marker)];
    const double* frame = parts.ports.frame(marker);
    return rates ? Values(frame + port.values / 2, frame + port.values) : Values(frame, frame + port.values / 2);
  }
  Motion<double> m;
  Values values;
  const auto reference = [&] {
    Motion<double> r;
    place.member.batch->motion(place.member.entry, parts.output_evaluation(parts.state(ConfigurationType::Reference)), r);
    return r;
  };
  if (place.member.batch->motion(place.member.entry, e, m) && frame_output(variable, m, reference, values)) return values;
  no_output(parts.describe(ItemKind::marker, marker), variable, {});
}

std::vector<double> System::load_values(int load, double time) {
  const LoadPlace& place = parts_->loads.at(static_cast<std::size_t>(load));
  return static_cast<const LoadPhysics*>(place.type->physics)->values(place.record.get(), time);
}

namespace {

Values user_sensor(System& system, const SensorUserFunctionParameters& p, int sensor, ConfigurationType configuration) {
  Values numbers;
  for (const SensorIndex& index : p.sensorNumbers) numbers.push_back(index.value);
  const double kind = static_cast<double>(configuration);
  const Argument arguments[] = {{numbers.data(), static_cast<int>(numbers.size()), 0},
                                {p.factors.data(), static_cast<int>(p.factors.size()), 0},
                                {&kind, 0, 0}};
  if (p.sensorUserFunction) return p.sensorUserFunction.callback->call_any(system.state(configuration).time, sensor, arguments);
  return {};
}

}  // namespace

std::vector<double> System::sensor_values(int sensor, ConfigurationType configuration) {
  const SensorPlace& place = parts_->sensors.at(static_cast<std::size_t>(sensor));
  const auto as = [&]<class Record>() -> const auto& { return static_cast<const Record*>(place.record.get())->parameters; };
  const std::string_view kind = place.type->type_name;
  if (kind == "Node") {
    const auto& p = as.operator()<SensorNodeRecord>();
    return node_output(p.nodeNumber.value, p.outputVariableType, configuration);
  }
  if (kind == "Object") {
    const auto& p = as.operator()<SensorObjectRecord>();
    return object_output(p.objectNumber.value, p.outputVariableType, configuration);
  }
  if (kind == "Body") {
    const auto& p = as.operator()<SensorBodyRecord>();
    return body_output(p.bodyNumber.value, p.outputVariableType, p.localPosition.x, configuration);
  }
  if (kind == "SuperElement") {
    const auto& p = as.operator()<SensorSuperElementRecord>();
    return super_element_output(p.bodyNumber.value, p.outputVariableType, p.meshNodeNumber, configuration);
  }
  if (kind == "Marker") {
    const auto& p = as.operator()<SensorMarkerRecord>();
    return marker_output(p.markerNumber.value, p.outputVariableType, configuration);
  }
  if (kind == "Load") return load_values(as.operator()<SensorLoadRecord>().loadNumber.value, state(configuration).time);
  if (kind == "UserFunction") return user_sensor(*this, as.operator()<SensorUserFunctionRecord>(), sensor, configuration);
  refuse(ErrorKind::planned, {parts_->describe(ItemKind::sensor, sensor), "", "this sensor's physics is planned", "", "", ""});
}

}  // namespace dalembert
