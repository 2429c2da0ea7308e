// What sensors measure.
#include <algorithm>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/reflection/callback.hpp"
#include "dalembert/sensors/body_parameters.hpp"
#include "dalembert/sensors/kinematic_tree_parameters.hpp"
#include "dalembert/sensors/load_parameters.hpp"
#include "dalembert/sensors/marker_parameters.hpp"
#include "dalembert/sensors/node_parameters.hpp"
#include "dalembert/sensors/object_parameters.hpp"
#include "dalembert/sensors/super_element_parameters.hpp"
#include "dalembert/sensors/user_function_parameters.hpp"
#include "dalembert/system/parts.hpp"

namespace dalembert {
namespace {

using Variable = OutputVariableType;
using Values = std::vector<double>;

// What a sensor of type `Record` measures.
template <class Record, auto measure>
void read_sensor(System& system, const void* record, int sensor, ConfigurationType configuration, Values& values) {
  measure(system, static_cast<const Record*>(record)->parameters, sensor, configuration, values);
}

void measure_node(System& system, const SensorNodeParameters& p, int, ConfigurationType configuration, Values& values) {
  system.node_output(p.nodeNumber.value, p.outputVariableType, configuration, values);
}
void measure_object(System& system, const SensorObjectParameters& p, int, ConfigurationType configuration, Values& values) {
  system.object_output(p.objectNumber.value, p.outputVariableType, configuration, values);
}
void measure_body(System& system, const SensorBodyParameters& p, int, ConfigurationType configuration, Values& values) {
  system.body_output(p.bodyNumber.value, p.outputVariableType, p.localPosition.x, configuration, values);
}
void measure_super_element(System& system, const SensorSuperElementParameters& p, int, ConfigurationType configuration,
                           Values& values) {
  system.super_element_output(p.bodyNumber.value, p.outputVariableType, p.meshNodeNumber, configuration, values);
}
void measure_link(System& system, const SensorKinematicTreeParameters& p, int, ConfigurationType configuration, Values& values) {
  system.link_output(p.objectNumber.value, p.outputVariableType, p.linkNumber, p.localPosition.x, configuration, values);
}
void measure_marker(System& system, const SensorMarkerParameters& p, int, ConfigurationType configuration, Values& values) {
  system.marker_output(p.markerNumber.value, p.outputVariableType, configuration, values);
}
void measure_load(System& system, const SensorLoadParameters& p, int, ConfigurationType configuration, Values& values) {
  system.load_values(p.loadNumber.value, system.state(configuration).time, values);
}
void call_user_function(System& system, const SensorUserFunctionParameters& p, int sensor, ConfigurationType configuration,
                        Values& values) {
  values.clear();
  if (!p.sensorUserFunction) return;
  Values numbers;
  for (const SensorIndex& index : p.sensorNumbers) numbers.push_back(index.value);
  const double kind = static_cast<double>(configuration);
  const Argument arguments[] = {{numbers.data(), static_cast<int>(numbers.size()), 0},
                                {p.factors.data(), static_cast<int>(p.factors.size()), 0},
                                {&kind, 0, 0}};
  values = p.sensorUserFunction.callback->call_any(system.state(configuration).time, sensor, arguments);
  system.state_may_have_changed();
}

// The item and the output variable that a sensor names.
struct Subject {
  ItemKind kind = ItemKind::node;
  int number = -1;
  Variable variable = Variable::_None;
};
template <class Record, auto number>
Subject subject_of(const void* record) {
  const auto& p = static_cast<const Record*>(record)->parameters;
  const auto& index = p.*number;
  return {kind_of<std::remove_cvref_t<decltype(index)>>, index.value, p.outputVariableType};
}

struct SensorKind {
  std::string_view type;
  SensorReader read;
  Subject (*subject)(const void* record) = nullptr;  // null: what it gives is not an output variable of one item
};

constexpr SensorKind sensor_kinds[] = {
    {"Node", &read_sensor<SensorNodeRecord, measure_node>, &subject_of<SensorNodeRecord, &SensorNodeParameters::nodeNumber>},
    {"Object", &read_sensor<SensorObjectRecord, measure_object>, &subject_of<SensorObjectRecord, &SensorObjectParameters::objectNumber>},
    {"Body", &read_sensor<SensorBodyRecord, measure_body>, &subject_of<SensorBodyRecord, &SensorBodyParameters::bodyNumber>},
    {"Marker", &read_sensor<SensorMarkerRecord, measure_marker>, &subject_of<SensorMarkerRecord, &SensorMarkerParameters::markerNumber>},
    {"SuperElement", &read_sensor<SensorSuperElementRecord, measure_super_element>},
    {"KinematicTree", &read_sensor<SensorKinematicTreeRecord, measure_link>},
    {"Load", &read_sensor<SensorLoadRecord, measure_load>},
    {"UserFunction", &read_sensor<SensorUserFunctionRecord, call_user_function>},
};

// Null: planned.
const SensorKind* kind_of_sensor(const ItemType& type) {
  const auto* found = std::ranges::find(sensor_kinds, type.type_name, &SensorKind::type);
  return found == std::end(sensor_kinds) ? nullptr : found;
}

}  // namespace

StateReading translation_reading(const NodePlace& node, Variable variable) {
  if (node.translations == 0) return {};
  switch (variable) {
    case Variable::Position: return {&State::q, node.ode2, node.translations, true};
    case Variable::Displacement: return {&State::q, node.ode2, node.translations};
    case Variable::Velocity: return {&State::v, node.ode2, node.translations};
    case Variable::Acceleration: return {&State::a, node.ode2, node.translations};
    default: return {};
  }
}

void StateReading::read(const State& state, const State& reference, Values& values) const {
  const double* given = (state.*from).data() + first;
  const double* rest = reference.q.data() + first;
  values.assign(3, 0.0);
  for (int i = 0; i < count; ++i) values[static_cast<std::size_t>(i)] = (is_total ? rest[i] : 0.0) + given[i];
}

SensorPlace SystemParts::place_sensor(const Item& item) const {
  const SensorKind* kind = kind_of_sensor(*item.type);
  SensorPlace place{item.type, kind == nullptr ? nullptr : kind->read, item.record, {}};
  if (kind == nullptr || kind->subject == nullptr) return place;
  const Subject subject = kind->subject(item.record.get());
  if (subject.kind == ItemKind::node) place.reading = translation_reading(nodes[static_cast<std::size_t>(subject.number)], subject.variable);
  return place;
}

void SystemParts::check_sensors() const {
  for (int i = 0; i < static_cast<int>(sensors.size()); ++i) {
    const SensorPlace& sensor = sensors[static_cast<std::size_t>(i)];
    const SensorKind* kind = kind_of_sensor(*sensor.type);
    if (kind == nullptr || kind->subject == nullptr) continue;
    const Subject subject = kind->subject(sensor.record.get());
    const ItemType& type = type_of(subject.kind, subject.number);
    if (may_have(type, subject.variable)) continue;
    refuse(ErrorKind::value, {describe(ItemKind::sensor, i), "outputVariableType", "", std::string(variable_name(subject.variable)),
                              "an output variable of " + describe(subject.kind, subject.number),
                              type.outputs.empty() ? "" : "Use one of " + variable_names(type.outputs)});
  }
}

void System::sensor_values(int sensor, ConfigurationType configuration, Values& values) {
  SystemParts& parts = *parts_;
  const SensorPlace& place = parts.sensors.at(static_cast<std::size_t>(sensor));
  if (place.reading && configuration != ConfigurationType::Reference) {
    place.reading.read(parts.state(configuration), parts.state(ConfigurationType::Reference), values);
    return;
  }
  if (place.read == nullptr)
    refuse(ErrorKind::planned,
           {parts.describe(ItemKind::sensor, sensor), "", "this sensor's physics is planned", "", "", ""});
  place.read(*this, place.record.get(), sensor, configuration, values);
}

}  // namespace dalembert
