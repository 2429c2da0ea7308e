// Values of sensors.
#include <optional>

#include "dalembert/model/errors.hpp"
#include "dalembert/system/parts.hpp"

namespace dalembert {
namespace {

using Variable = OutputVariableType;
using Values = std::vector<double>;

// Null: planned.
const SensorPhysics* physics_of(const ItemType& type) { return static_cast<const SensorPhysics*>(type.physics); }

// There is such a link, and such an output of it.
void check_link(const SystemParts& parts, const SensorSubject& subject, int sensor) {
  const Membership<Term>& member = parts.objects[static_cast<std::size_t>(subject.number)].member;
  const auto* bodies = dynamic_cast<const LinkedBodies*>(member.batch);
  const std::string item = parts.describe(ItemKind::sensor, sensor);
  const auto& [link, object] = *subject.link;
  if (bodies == nullptr)
    refuse(ErrorKind::value,
           {item, "objectNumber", "", parts.describe(subject.kind, subject.number), std::string(object), ""});
  if (const int links = bodies->links(member.entry); link < 0 || link >= links)
    refuse(ErrorKind::value,
           {item, "linkNumber", "", std::to_string(link), "a link from 0 to " + std::to_string(links - 1), ""});
  if (!follows_from_motion(subject.variable))
    refuse(ErrorKind::value,
           {item, "outputVariableType", "", std::string(variable_name(subject.variable)), "an output variable of links",
            "Use Position, Displacement, Velocity, Acceleration, Rotation, RotationMatrix, AngularVelocity or "
            "AngularAcceleration"});
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
  SensorPlace place{item.type, item.record, {}};
  const SensorPhysics* physics = physics_of(*item.type);
  const auto subject = physics == nullptr ? std::nullopt : physics->subject(item.record.get());
  if (subject && subject->is_value && subject->kind == ItemKind::node)
    place.reading = translation_reading(nodes[static_cast<std::size_t>(subject->number)], subject->variable);
  return place;
}

void SystemParts::check_sensors() const {
  for (int i = 0; i < static_cast<int>(sensors.size()); ++i) {
    const SensorPlace& sensor = sensors[static_cast<std::size_t>(i)];
    const SensorPhysics* physics = physics_of(*sensor.type);
    const auto subject = physics == nullptr ? std::nullopt : physics->subject(sensor.record.get());
    if (!subject) continue;
    if (subject->link) {
      check_link(*this, *subject, i);
      continue;
    }
    const ItemType& type = type_of(subject->kind, subject->number);
    if (may_have(type, subject->variable)) continue;
    refuse(ErrorKind::value,
           {describe(ItemKind::sensor, i), "outputVariableType", "", std::string(variable_name(subject->variable)),
            "an output variable of " + describe(subject->kind, subject->number),
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
  const SensorPhysics* physics = physics_of(*place.type);
  if (physics == nullptr)
    refuse(ErrorKind::planned,
           {parts.describe(ItemKind::sensor, sensor), "", "this sensor's physics is planned", "", "", ""});
  physics->measure(*this, place.record.get(), sensor, configuration, values);
}

}  // namespace dalembert
