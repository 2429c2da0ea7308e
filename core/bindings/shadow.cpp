#include "shadow.hpp"

#include "dalembert/contact/contact_set.hpp"
#include "python_callback.hpp"

#include <pybind11/stl.h>

namespace dalembert {

Shadow::Shadow(const std::shared_ptr<MainSystem>& original) : original_(original) {}

Shadow::News Shadow::follow(Tap::Part wanted) {
  News news;
  const auto original = original_.lock();
  if (!original) return news;
  const bool assembled = original->consistent();
  const std::uint64_t structure = original->model.structure_changes(), version = original->system.version();
  news.structure =
      structure != structure_ || assembled != assembled_ || (version != version_ && original->work == nullptr);
  const std::uint64_t contacts = contacts_of(*original);
  news.structure = news.structure || contacts != contacts_;
  contacts_ = contacts;
  if (news.structure) {
    release();
    copy_items(*original);
    structure_ = structure;
    assembled_ = assembled;
    version_ = version;
  }
  news.items = renew_items(*original) || news.structure;
  news.state = assembled && follow_state(*original, wanted);
  return news;
}

// Functions of the user get the copy as their system.
void Shadow::copy_items(const MainSystem& original) {
  Model model;
  for (int k = 0; k < item_kinds; ++k) {
    for (Item item : original.model.items(static_cast<ItemKind>(k))) {
      item.record = bind_user_functions(*item.type, std::move(item.record), *system_);
      model.add(std::move(item));
    }
  }
  watch_.look(original.model);
  for (const auto& source : original.model.term_sources())
    model.add(std::make_shared<ContactSet>(static_cast<const ContactSet&>(*source)));
  system_->variables = original.variables;
  system_->sys = original.sys;
  system_->container = original.container;
  system_->become(std::move(model), original.consistent());
  is_complete_ = true;  // its initial state
}

// A version that changes when the data of general contacts change.
std::uint64_t Shadow::contacts_of(const MainSystem& original) {
  std::uint64_t result = 0;
  for (const auto& source : original.model.term_sources()) {
    const auto& set = static_cast<const ContactSet&>(*source);
    result = 31 * result + 4 * set.shapes + 2 * (set.active ? 1 : 0) + (set.spheres_touch ? 1 : 0);
  }
  return result;
}

bool Shadow::renew_items(const MainSystem& original) {
  return watch_.look(original.model, [this](ItemKind kind, int number, const Item& item) {
    system_->renew(kind, number, bind_user_functions(*item.type, item.record, *system_));
  });
}

bool Shadow::follow_state(MainSystem& original, Tap::Part wanted) {
  State& shown = system_->system.state(ConfigurationType::Visualization);
  if (original.work != nullptr) {
    original.tap.want(wanted);
    const Tap::Part taken = original.tap.take(shown);
    if (taken != Tap::Part::none) is_complete_ = taken == Tap::Part::all;
    return taken != Tap::Part::none;
  }
  is_complete_ = true;
  const State& state = original.system.state(ConfigurationType::Visualization);
  const bool same = state.time == shown.time && state.q == shown.q && state.v == shown.v && state.a == shown.a &&
                    state.y == shown.y && state.y_t == shown.y_t && state.lambda == shown.lambda &&
                    state.data == shown.data;
  if (!same) shown = state;
  return !same;
}

void Shadow::grab(int object, const Vec3<double>& point, int link) {
  release();
  System& system = system_->assembled("the viewer");
  grip_ = system.grip(object, point, link, ConfigurationType::Visualization);
}

void Shadow::pull(const Vec3<double>& target, double strength) {
  if (!grip_) return;
  tell([&](MainSystem& original) {
    if (original.work != nullptr) original.tap.pull(Pull{*grip_, target, strength});
  });
}

void Shadow::release() {
  if (grip_) tell([](MainSystem& original) { original.tap.pull({}); });
  grip_.reset();
}

std::optional<Vec3<double>> Shadow::gripped() const {
  if (!grip_) return std::nullopt;
  return system_->system.position_of(*grip_, ConfigurationType::Visualization);
}

using Numbers = std::array<double, 3>;

void register_shadow(py::module_& module) {
  py::class_<Shadow>(module, "_Shadow", "A copy of a system for viewers, which follows it while it is being solved.")
      .def(py::init<const std::shared_ptr<MainSystem>&>(), py::arg("original"))
      .def_property_readonly("system", &Shadow::system)
      .def(
          "follow",
          [](Shadow& shadow, bool places) {
            const Shadow::News news = shadow.follow(places ? Tap::Part::places : Tap::Part::all);
            return py::make_tuple(news.state, news.items, news.structure);
          },
          py::arg("places") = false,
          "Take over what has changed; tells whether that is the state, items, and which items there are. With "
          "`places`, solvers are asked only for "
          "where items are.")
      .def_property_readonly("complete", &Shadow::complete,
                             "Whether all of the state is known, not only where items are.")
      .def(
          "grab",
          [](Shadow& shadow, int object, const Numbers& point, int link) { shadow.grab(object, {point}, link); },
          py::arg("object"), py::arg("point"), py::arg("link") = -1,
          "Grip the point of an object that is nearest to a point in space. ValueError: it has no position or no mass, "
          "or rests.")
      .def(
          "pull", [](Shadow& shadow, const Numbers& target, double strength) { shadow.pull({target}, strength); },
          py::arg("target"), py::arg("strength"),
          "Let the solver of the original pull the gripped point to `target`, until `release`: a critically damped "
          "spring, with the stiffness mass x strength (1/s^2).")
      .def("release", &Shadow::release, "End the pull.")
      .def_property_readonly(
          "gripped",
          [](const Shadow& shadow) -> std::optional<Numbers> {
            const auto point = shadow.gripped();
            return point ? std::optional(point->x) : std::nullopt;
          },
          "The gripped point, in the state that is shown; None: there is none.")
      .def(
          "pause",
          [](Shadow& shadow, bool flag) { shadow.tell([flag](MainSystem& original) { original.tap.pause(flag); }); },
          py::arg("flag"), "Let the solver of the original wait between two steps, or go on.")
      .def(
          "ask",
          [](Shadow& shadow) { shadow.tell([](MainSystem& original) { original.tap.ask(original.work != nullptr); }); },
          "Let the solver of the original, if there is one at work, run the requests of viewers.")
      .def_property_readonly(
          "solving",
          [](Shadow& shadow) {
            bool result = false;
            shadow.tell([&](MainSystem& original) { result = original.work != nullptr; });
            return result;
          },
          "Whether a solver is at work on the original.");
}

}  // namespace dalembert
