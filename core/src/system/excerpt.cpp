#include "dalembert/system/excerpt.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"

namespace dalembert {
namespace {

class Copier {
 public:
  explicit Copier(const Model& from) : from_(from) {}

  // Copies an item after those that it refers to, with their new numbers; each one once.
  int copy(ItemKind kind, int number) {
    const auto [found, is_new] = numbers_.try_emplace({kind, number}, being_copied);
    if (found->second == being_copied && !is_new)
      refuse(ErrorKind::value,
             {from_.describe(kind, number), "", "it refers to itself, by what it refers to", "", "", ""});
    if (!is_new) return found->second;
    const ItemChange here{{kind, number}};
    from_.check({&here, 1});  // also that there is a body where one is asked for
    const Item& item = from_.item(kind, number);
    sources.push_back({kind, number, item.record});
    const std::shared_ptr<void> record = copy_references(kind, number);
    name_in(*item.type, record.get()).clear();
    const int copied = to.add({item.type, record});
    to.entitle(kind, copied, from_.describe(kind, number));
    return numbers_[{kind, number}] = copied;
  }

  // Copies the items that an item refers to. Returns a copy of its record with their new numbers.
  std::shared_ptr<void> copy_references(ItemKind kind, int number) {
    const Item& item = from_.item(kind, number);
    std::shared_ptr<void> record = item.type->record.copy(item.record.get());
    for (const Row& row : item.type->rows) {
      const IndexStorage storage = index_storage(row.storage);
      if (!storage.is_index) continue;
      for (int& reference : index_values(row, record.get()))
        if (reference >= 0 && from_.find_item(storage.kind, reference) != nullptr)
          reference = copy(storage.kind, reference);
    }
    return record;
  }

  // Sets the current state of the copied nodes to that of the nodes in `whole`, from which they were copied.
  void copy_state(System& whole, System& part) const {
    const State& from = whole.state(ConfigurationType::Current);
    State& current = part.state(ConfigurationType::Current);
    current.time = from.time;
    for (const auto& [source, copied] : numbers_) {
      if (source.first != ItemKind::node) continue;
      const auto take = [&, number = source.second, copied = copied](System::Coordinates kind, auto... members) {
        const std::vector<int> there = whole.node_ltg(number, kind), here = part.node_ltg(copied, kind);
        for (std::size_t i = 0; i < here.size(); ++i) (((current.*members)[here[i]] = (from.*members)[there[i]]), ...);
      };
      take(System::Coordinates::ode2, &State::q, &State::v);
      take(System::Coordinates::ode1, &State::y, &State::y_t);
      take(System::Coordinates::data, &State::data);
    }
    std::ranges::fill(current.lambda, 0.0);
    std::ranges::fill(current.a, 0.0);
  }

  Model to;
  std::vector<Excerpt::Source> sources;

 private:
  static constexpr int being_copied = -1;

  const Model& from_;
  std::map<std::pair<ItemKind, int>, int> numbers_;
};

// Records never change, they are replaced.
bool is_current(const Excerpt& excerpt, const Model& model) {
  return std::ranges::all_of(excerpt.sources, [&](const Excerpt::Source& source) {
    const Item* item = model.find_item(source.kind, source.number);
    return item != nullptr && item->record == source.record;
  });
}

}  // namespace

Excerpt excerpt(const Model& model, ItemKind kind, int number) {
  Copier copier(model);
  Excerpt part{std::make_unique<System>(), copier.copy(kind, number), std::move(copier.sources)};
  part.system->assemble(copier.to);
  return part;
}

namespace {

constexpr Conditions forces_alone{.inertia = false, .loads = false};

std::vector<double> picked(const std::vector<double>& values, const std::vector<int>& rows) {
  std::vector<double> found;
  for (const int row : rows) found.push_back(values[static_cast<std::size_t>(row)]);
  return found;
}

std::vector<double> residual_of(System& system) {
  std::vector<double> r(static_cast<std::size_t>(system.sizes().total()));
  system.residual(system.state(ConfigurationType::Current), forces_alone, r);
  return r;
}

}  // namespace

ObjectEquations::ObjectEquations(const Model& model, System& whole, int object) {
  const auto assemble = [&](Part& part, const Copier& copier) {
    part.system = std::make_unique<System>();
    part.system->assemble(copier.to);
    copier.copy_state(whole, *part.system);
  };
  Copier carriers(model), all(model);
  carriers.copy_references(ItemKind::object, object);
  const int number = all.copy(ItemKind::object, object);
  assemble(without_, carriers);
  assemble(with_, all);
  without_.rows = with_.rows = with_.system->object_ltg(number, System::Coordinates::ode2);
  const int first = with_.system->sizes().first_ae();
  for (const int equation : with_.system->object_ltg(number, System::Coordinates::ae)) {
    with_.rows.push_back(first + equation);
    ++equations_;
  }
}

std::vector<double> ObjectEquations::residual() {
  std::vector<double> r = picked(residual_of(*with_.system), with_.rows);
  const std::vector<double> carriers = picked(residual_of(*without_.system), without_.rows);
  for (std::size_t i = 0; i < carriers.size(); ++i) r[i] -= carriers[i];
  return r;
}

template <class Evaluate>
std::vector<double> ObjectEquations::matrix(Evaluate&& evaluate) {
  const auto n = static_cast<std::size_t>(coordinates());
  std::vector<double> result(with_.rows.size() * n);
  const auto add = [&](Part& part, double factor) {
    const Pattern& pattern = part.system->pattern(false);
    std::vector<double> values(static_cast<std::size_t>(pattern.values()));
    evaluate(*part.system, pattern, values);
    std::vector<std::vector<std::size_t>> places(static_cast<std::size_t>(part.system->sizes().total()));
    for (std::size_t i = 0; i < part.rows.size(); ++i) places[static_cast<std::size_t>(part.rows[i])].push_back(i);
    for (int column = 0; column < pattern.size(); ++column)
      for (const std::size_t j : places[static_cast<std::size_t>(column)])
        for (int k = pattern.column_start()[column]; j < n && k < pattern.column_start()[column + 1]; ++k)
          for (const std::size_t i : places[static_cast<std::size_t>(pattern.row_index()[k])])
            result[i * n + j] += factor * values[static_cast<std::size_t>(k)];
  };
  add(with_, 1);
  add(without_, -1);
  return result;
}

std::vector<double> ObjectEquations::tangent(double cq, double cv) {
  return matrix([&](System& system, const Pattern& pattern, std::vector<double>& values) {
    system.tangent(system.state(ConfigurationType::Current), forces_alone, {.q = cq, .v = cv, .a = 0, .y = 1, .y_t = 0},
                   pattern, values);
  });
}

std::vector<double> ObjectEquations::mass_matrix() {
  std::vector<double> all = matrix([](System& system, const Pattern& pattern, std::vector<double>& values) {
    system.mass_matrix(system.state(ConfigurationType::Current), pattern, values);
  });
  all.resize(static_cast<std::size_t>(coordinates() * coordinates()));
  return all;
}

std::shared_ptr<const Excerpt> Excerpts::of(const Model& model, ItemKind kind, int number) {
  for (const auto& known : kept_) {
    if (!known || known->sources[0].kind != kind || known->sources[0].number != number) continue;
    if (is_current(*known, model)) return known;
  }
  auto made = std::make_shared<const Excerpt>(excerpt(model, kind, number));
  kept_[std::exchange(next_, (next_ + 1) % kept_.size())] = made;
  return made;
}

}  // namespace dalembert
