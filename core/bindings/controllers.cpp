#include "controllers.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "conversion.hpp"
#include "dalembert/control/laws.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/trees/tree_functions.hpp"
#include "item_callback.hpp"
#include "main_system.hpp"
#include "module.hpp"

namespace dalembert {
namespace {

// The Python object of a controller. A period of zero means that the law acts continuously.
struct Controller {
  std::shared_ptr<const ControlLaw> law;
  double period = 0, dead_time = 0;
};

class ControllerCallback : public ItemCallback {
 public:
  ControllerCallback(py::object function, const Row& row, Controller controller)
      : ItemCallback(std::move(function), row), controller_(std::move(controller)) {}

  bool takes_total_coordinates() const override { return true; }
  void call(double time, int item, std::span<const Argument> arguments, std::span<double> results) const override {
    const auto vector = [](const Argument& a) { return std::span(a.data, static_cast<std::size_t>(a.size())); };
    find_forces(time, item, vector(arguments[0]), vector(arguments[1]), results);
  }
  std::vector<double> call_any(double, int item, std::span<const Argument>) const override {
    refuse(ErrorKind::type, {.item = describe(item), .problem = "cannot be a controller"});
  }

 protected:
  const Controller& controller() const { return controller_; }
  void find_forces(double time, int item, std::span<const double> q, std::span<const double> v,
                   std::span<double> forces) const {
    require_size(item, forces.size());
    controller_.law->forces(time, item, q, v, forces);
    if (const auto wrong = std::ranges::find_if_not(forces, [](double x) { return std::isfinite(x); });
        wrong != forces.end())
      refuse(ErrorKind::value,
             {describe(item), "", "", std::to_string(*wrong) + " as force, at time " + std::to_string(time),
              "finite numbers", "Check the controller, and the motion that it follows."});
  }
  void require_size(int item, std::size_t coordinates) const {
    if (const std::size_t count = controller_.law->count(); count != 0 && count != coordinates)
      refuse(ErrorKind::value, {describe(item), "", "", "a controller of " + std::to_string(count) + " coordinates",
                                "one of " + std::to_string(coordinates) + ", as the object has", ""});
  }

 private:
  std::shared_ptr<ItemCallback> copy() const override {
    return std::make_shared<ControllerCallback>(function(), row(), controller_);
  }

  Controller controller_;
};

// Each object has its own callback, because its state belongs to a solution.
class SampledCallback final : public ControllerCallback {
 public:
  SampledCallback(py::object function, const Row& row, const Controller& controller)
      : ControllerCallback(std::move(function), row, controller), sampled_(controller.period, controller.dead_time) {}

  void call(double, int item, std::span<const Argument>, std::span<double> results) const override {
    require_size(item, results.size());
    if (sampled_.begun())
      std::ranges::copy(sampled_.held(), results.begin());
    else
      std::ranges::fill(results, 0.0);
  }
  bool act(const State& state, const State& reference, int item, std::span<const int> coordinates) const {
    std::vector<double> q, v;
    for (const int i : coordinates) {
      q.push_back(reference.q[static_cast<std::size_t>(i)] + state.q[static_cast<std::size_t>(i)]);
      v.push_back(state.v[static_cast<std::size_t>(i)]);
    }
    return sampled_.act(state.time, [&](std::span<double> forces) { find_forces(state.time, item, q, v, forces); });
  }
  SampledForces& sampled() const { return sampled_; }

 private:
  std::shared_ptr<ItemCallback> copy() const override {
    return std::make_shared<SampledCallback>(function(), row(), controller());
  }

  mutable SampledForces sampled_;
};

// An object with a sampled controller.
struct SampledObject {
  int number;
  std::shared_ptr<const Callback> kept;
  const SampledCallback* callback;
  std::vector<int> coordinates;
};

std::vector<SampledObject> sampled_objects(const MainSystem& main) {
  std::vector<SampledObject> found;
  const ItemType* type = nullptr;
  const Row* row = nullptr;
  for (int i = 0; i < main.model.count(ItemKind::object); ++i) {
    const Item& object = main.model.item(ItemKind::object, i);
    if (object.type != type) row = find_row(*(type = object.type), "forceUserFunction");
    if (row == nullptr || row->storage != Storage::user_function) continue;
    const auto& function = *static_cast<const UserFunction*>(member(object.record.get(), *row));
    if (const auto* callback = dynamic_cast<const SampledCallback*>(function.callback.get()))
      found.push_back({i, function.callback, callback, main.system.object_ltg(i, System::Coordinates::ode2)});
  }
  return found;
}

class SampledControllers final : public Schedule {
 public:
  explicit SampledControllers(const std::shared_ptr<MainSystem>& main) : main_(main) {}

  void begin(const State& state, bool is_static) override {
    const auto main = main_.lock();
    find_objects(*main);
    if (is_static && !objects_.empty())
      refuse(ErrorKind::state, {.item = "user function 'forceUserFunction' of " +
                                        main->model.describe(ItemKind::object, objects_.front().number),
                                .problem = "a sampled controller acts in time, which static solutions do not know",
                                .advice = "Use its law without sampling."});
    for (const SampledObject& o : objects_) o.callback->sampled().begin(state.time, o.coordinates.size());
  }
  double next() const override {
    double time = std::numeric_limits<double>::infinity();
    for (const SampledObject& o : objects_) time = std::min(time, o.callback->sampled().next());
    return time;
  }
  bool act(const State& state) override {
    const auto main = main_.lock();
    if (!main) return false;
    if (others_may_be_sampled(main->model)) find_objects(*main);
    const State& reference = main->system.state(ConfigurationType::Reference);
    bool changed = false;
    for (const SampledObject& o : objects_) {
      if (!o.callback->sampled().begun())
        o.callback->sampled().begin(state.time, o.coordinates.size());  // the user has set another one
      changed = o.callback->act(state, reference, o.number, o.coordinates) || changed;
    }
    return changed;
  }
  std::vector<double> numbers() const override {
    std::vector<double> all;
    for (const SampledObject& o : objects_) {
      const std::vector<double> own = o.callback->sampled().numbers();
      all.push_back(static_cast<double>(own.size()));
      all.insert(all.end(), own.begin(), own.end());
    }
    return all;
  }
  void take_numbers(std::span<const double> numbers) override {
    std::size_t at = 0;
    for (const SampledObject& o : objects_) {
      const std::size_t size = at < numbers.size() ? static_cast<std::size_t>(numbers[at]) : 0;
      const auto count = static_cast<double>(o.coordinates.size());
      if (size < 4 || at + size >= numbers.size() || numbers[at + 3] != count ||
          static_cast<double>(size) != 4 + count * (1 + numbers[at + 4]))
        throw ModelError(ErrorKind::value, "restart file: it has other sampled controllers than the system");
      o.callback->sampled().take_numbers(numbers.subspan(at + 1, size));
      at += size + 1;
    }
    if (at != numbers.size())
      throw ModelError(ErrorKind::value, "restart file: it has other sampled controllers than the system");
  }

 private:
  void find_objects(const MainSystem& main) {
    objects_ = sampled_objects(main);
    structure_ = main.model.structure_changes();
    values_ = main.model.value_changes();
  }
  // Whether there are other objects since, or some have been given other parameters.
  bool others_may_be_sampled(const Model& model) {
    const auto changed = model.changed_since(std::exchange(values_, model.value_changes()));
    return structure_ != model.structure_changes() || !changed ||
           std::ranges::any_of(*changed, [](const ItemReference& item) { return item.kind == ItemKind::object; });
  }

  std::weak_ptr<MainSystem> main_;
  std::vector<SampledObject> objects_;
  std::uint64_t structure_ = 0, values_ = 0;  // versions of the model at the last search
};

std::vector<double> forces(const Controller& controller, double time, const std::vector<double>& q,
                           const std::vector<double>& v) {
  std::vector<double> f(q.size());
  controller.law->forces(time, -1, q, v, f);
  return f;
}

}  // namespace

std::shared_ptr<const Callback> controller_callback(PyObject* value, const Row& row) {
  if (!py::isinstance<Controller>(value)) return nullptr;
  const auto& controller = py::handle(value).cast<const Controller&>();
  const bool of_forces = row.name == "forceUserFunction" && row.signature != nullptr &&
                         row.signature->result == Signature::Kind::open_vector && row.signature->arguments.size() == 2;
  if (!of_forces)
    throw Refusal{ErrorKind::type, "another function",
                  "Controllers take the place of forceUserFunction of kinematic trees and of generic objects."};
  py::object function = py::reinterpret_borrow<py::object>(value);
  if (controller.period > 0) return std::make_shared<SampledCallback>(std::move(function), row, controller);
  return std::make_shared<ControllerCallback>(std::move(function), row, controller);
}

bool is_sampled(const Callback& callback) { return dynamic_cast<const SampledCallback*>(&callback) != nullptr; }

std::shared_ptr<Schedule> schedule_of(const std::shared_ptr<MainSystem>& main) {
  return sampled_objects(*main).empty() ? nullptr : std::make_shared<SampledControllers>(main);
}

void register_controllers(py::module_& module) {
  py::class_<DesiredMotion, std::shared_ptr<DesiredMotion>>(module, "_DesiredMotion",
                                                            "What a controller is to follow. See dalembert.control.")
      .def(py::init<std::size_t, std::vector<double>, std::vector<double>, std::vector<double>>(), py::arg("count"),
           py::arg("times"), py::arg("coefficients"), py::arg("ends"))
      .def(py::init([](std::size_t count, std::uintptr_t address) {
             return std::make_shared<DesiredMotion>(count, reinterpret_cast<DesiredMotion::Function>(address));
           }),
           py::arg("count"), py::arg("address"));
  py::class_<Controller>(module, "_Controller", "A controller without Python. See dalembert.control.")
      .def(py::init([](std::shared_ptr<DesiredMotion> desired, std::vector<double> stiffness,
                       std::vector<double> damping, std::vector<double> forces) {
             return Controller{std::make_shared<ProportionalDerivative>(
                 std::move(desired), Gains{std::move(stiffness), std::move(damping)}, std::move(forces))};
           }),
           py::arg("desired"), py::arg("stiffness"), py::arg("damping"), py::arg("forces"))
      .def(py::init([](std::shared_ptr<DesiredMotion> desired, std::vector<double> stiffness,
                       std::vector<double> damping, const TreeFunctions& tree) {
             return Controller{std::make_shared<ComputedTorque>(tree.tree(), tree.gravity(), std::move(desired),
                                                                Gains{std::move(stiffness), std::move(damping)})};
           }),
           py::arg("desired"), py::arg("stiffness"), py::arg("damping"), py::arg("tree"))
      .def(py::init([](std::uintptr_t address) {
             return Controller{std::make_shared<CompiledLaw>(reinterpret_cast<CompiledLaw::Function>(address))};
           }),
           py::arg("address"))
      .def(py::init([](const Controller& law, double period, double dead_time) {
             return Controller{law.law, period, dead_time};
           }),
           py::arg("law"), py::arg("period"), py::arg("dead_time"))
      .def("_forces", &forces, py::arg("time"), py::arg("q"), py::arg("q_t"));
}

}  // namespace dalembert
