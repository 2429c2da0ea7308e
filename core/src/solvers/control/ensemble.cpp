#include "dalembert/solvers/ensemble.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "../lockstep/lockstep.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"

namespace dalembert {
namespace {

template <class T>
class ValuesOf final : public VariedValues {
 public:
  explicit ValuesOf(int variations) : values_(static_cast<std::size_t>(variations)) {}
  void keep(int variation, const void* member) override { values_[at(variation)] = *static_cast<const T*>(member); }
  void write(int variation, void* member) const override { *static_cast<T*>(member) = values_[at(variation)]; }

 private:
  static std::size_t at(int variation) { return static_cast<std::size_t>(variation); }
  std::vector<T> values_;
};

// Disables files, console output and realtime: they belong to one simulation at a time.
void keep_to_itself(SimulationSettings& settings, bool histories) {
  auto& solution = settings.solutionSettings;
  solution.writeSolutionToFile = solution.writeRestartFile = solution.sensorsAppendToFile = false;
  solution.recordImagesInterval = -1;
  solution.sensorsStoreAndWriteFiles = histories;
  settings.timeIntegration.verboseMode = settings.timeIntegration.verboseModeFile = 0;
  settings.staticSolver.verboseMode = settings.staticSolver.verboseModeFile = 0;
  settings.timeIntegration.simulateInRealtime = false;
  settings.parallel.numberOfThreads = 1;
}

bool belongs_to_node(const VariedParameter& parameter) { return parameter.kind == ItemKind::node; }

// Assemble alone reads nodes. Values without a fixed size, counts and switches may change the structure.
bool calls_for_assemble(const VariedParameter& parameter) {
  if (belongs_to_node(parameter) || parameter.row->needs_assemble) return true;
  return with_type(parameter.row->storage, []<class T>(TypeTag<T>) {
    return !(std::is_same_v<T, double> || std::is_same_v<T, bool> || is_vec<T> || is_mat<T>);
  });
}

bool same(const Sizes& a, const Sizes& b) {
  return a.ode2 == b.ode2 && a.ode1 == b.ode1 && a.ae == b.ae && a.data == b.data;
}

Sizes sizes_of(const State& state) {
  const auto size = [](const std::vector<double>& part) { return static_cast<int>(part.size()); };
  return {.ode2 = size(state.q), .ode1 = size(state.y), .ae = size(state.lambda), .data = size(state.data)};
}

// A thread's copy of everything that a variation changes.
class Workplace {
 public:
  Workplace(const Ensemble& ensemble, const Model& model, const State& initial, const std::atomic<bool>& stop)
      : ensemble_(ensemble), initial_(initial), model_(model), settings_(ensemble.simulation) {
    reassembles_ = std::ranges::any_of(ensemble.parameters, calls_for_assemble);
    starts_from_nodes_ = std::ranges::any_of(ensemble.parameters, belongs_to_node);
    if (!reassembles_) system_.assemble(model_);
    environment_.hooks.interrupted = [&stop] { return stop.load(std::memory_order_relaxed); };
    environment_.hooks.timeout = ensemble.timeout;
    environment_.model = &model_;
    environment_.hooks.warn = [this](std::string_view text) {
      warnings_.append(warnings_.empty() ? "" : "\n").append(text);
    };
    if (!ensemble.histories) return;
    SensorChannel silent;
    silent.write_to_file = false;
    environment_.sensors.assign(static_cast<std::size_t>(model_.count(ItemKind::sensor)), silent);
    for (const int sensor : ensemble.sensors)
      environment_.sensors[static_cast<std::size_t>(sensor)].store_internal = true;
    environment_.sensor_storage = &storage_;
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  // Solves a variation alone; errors are stored in the result.
  VariationResult solve(int variation) {
    VariationResult result;
    try {
      prepare(variation);
      result.solved = solver_->solve_system();
      collect(result);
    } catch (const std::exception& error) {
      result.solved = false;
      result.message = error.what();
    }
    result.warnings = warnings_;
    return result;
  }

  // Returns the solver of a variation, ready for its first step. A null pointer means that the variation has to be
  // solved alone; `obstacle` is the reason if it holds for all variations, else empty.
  SecondOrderSolver* begin(int variation, std::string& obstacle) {
    obstacle.clear();
    try {
      prepare(variation);
      auto* solver = dynamic_cast<SecondOrderSolver*>(solver_.get());
      if (!solver) obstacle = "the solver: only implicit ones of second order take steps side by side";
      if (!solver || !solver->initialize()) return nullptr;
      obstacle = Lockstep::obstacle(*solver);
      if (!obstacle.empty()) return nullptr;
      solver->timer.reset(settings_.displayComputationTime);
      return solver;
    } catch (const std::exception&) {
      return nullptr;  // solve() reports the error
    }
  }
  // Finishes a variation after its last step.
  VariationResult end() {
    VariationResult result;
    result.solved = true;
    solver_->finalize();
    collect(result);
    result.warnings = warnings_;
    return result;
  }

 private:
  void prepare(int variation) {
    storage_.clear();
    warnings_.clear();
    for (const VariedParameter& p : ensemble_.parameters)
      model_.edit(p.kind, p.number, *p.row, [&](void* member) { p.values->write(variation, member); });
    if (!reassembles_) {
      system_.refresh(model_);
    } else {
      system_.assemble(model_);
      if (!same(system_.sizes(), sizes_of(initial_)))
        refuse(ErrorKind::value, {.problem = "the numbers of coordinates are not those of the assembled model",
                                  .advice = "Vary values only, or solve models of other sizes by themselves."});
    }
    State& start = system_.state(ConfigurationType::Initial);
    if (!starts_from_nodes_) start = initial_;
    for (const VariedCoordinates& c : ensemble_.coordinates) {
      std::vector<double>& part = start.*c.part;
      const auto first = c.values.begin() + static_cast<std::ptrdiff_t>(part.size()) * variation;
      std::copy_n(first, part.size(), part.begin());
    }
    char* settings = reinterpret_cast<char*>(&settings_);
    for (const VariedSetting& s : ensemble_.settings) s.values->write(variation, settings + s.offset);
    keep_to_itself(settings_, ensemble_.histories);
    solver_ = ensemble_.make_solver();
    solver_->attach(system_, settings_, environment_);
  }

  void collect(VariationResult& result) {
    const State& end = system_.state(ConfigurationType::Current);
    result.time = end.time;
    if (ensemble_.histories)
      for (int i = 0; i < model_.count(ItemKind::sensor); ++i) result.histories.push_back(storage_.table(i));
    if (!result.solved) {
      const Diagnosis& diagnosis = solver_->diagnosis();
      result.message = diagnosis.failed() ? diagnosis.text() : solver_->error_string();
    } else {
      if (ensemble_.states) result.state = end;
      for (const int sensor : ensemble_.sensors) {
        system_.sensor_values(sensor, ConfigurationType::Current, sensor_values_);
        result.values.insert(result.values.end(), sensor_values_.begin(), sensor_values_.end());
      }
    }
  }

  const Ensemble& ensemble_;
  const State& initial_;
  Model model_;
  System system_;
  SimulationSettings settings_;
  SolverEnvironment environment_;
  SensorStorage storage_;
  std::vector<double> sensor_values_;
  std::string warnings_;
  std::unique_ptr<Solver> solver_;
  bool reassembles_ = false, starts_from_nodes_ = false;
};

// The workplaces of one thread, for variations that take their steps side by side.
class Workplaces {
 public:
  Workplaces(const Ensemble& ensemble, const Model& model, const State& initial, const std::atomic<bool>& stop)
      : make_workplace_([&] { return std::make_unique<Workplace>(ensemble, model, initial, stop); }) {}

  // Solves the variations from `first` on.
  void solve(int first, std::span<VariationResult> results) {
    const bool together = obstacle_.empty() && results.size() > 1;
    const std::vector<bool> solved =
        together ? solve_together(first, results.size()) : std::vector<bool>(results.size());
    const std::string alone = !obstacle_.empty() ? obstacle_
                              : together         ? "it starts, iterates or fails in another way than those beside it"
                                                 : "no other variation is left for its thread";
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (solved[i]) results[i] = workplace(i).end();
    }
    for (std::size_t i = 0; i < results.size(); ++i) {  // one workplace suffices: systems may be large
      if (solved[i]) continue;
      results[i] = workplace(0).solve(first + static_cast<int>(i));
      results[i].alone = alone;
    }
  }

 private:
  // Returns false for variations that have to be solved alone, which also reports their errors.
  std::vector<bool> solve_together(int first, std::size_t count) {
    std::vector<SecondOrderSolver*> solvers;
    std::vector<std::size_t> who;
    for (std::size_t i = 0; i < count; ++i) {
      SecondOrderSolver* solver = workplace(i).begin(first + static_cast<int>(i), obstacle_);
      if (!obstacle_.empty()) return std::vector<bool>(count);
      if (!solver) continue;
      solvers.push_back(solver);
      who.push_back(i);
    }
    std::vector<bool> solved(count);
    if (!solvers.empty()) {
      try {
        const std::vector<bool> together = lockstep_.solve_steps(solvers);
        for (std::size_t k = 0; k < who.size(); ++k) solved[who[k]] = together[k];
      } catch (const std::exception&) {
        lockstep_ = {};
      }
    }
    return solved;
  }

  Workplace& workplace(std::size_t i) {
    while (workplaces_.size() <= i) workplaces_.push_back(make_workplace_());
    return *workplaces_[i];
  }

  std::function<std::unique_ptr<Workplace>()> make_workplace_;
  std::vector<std::unique_ptr<Workplace>> workplaces_;
  Lockstep lockstep_;
  std::string obstacle_;  // reason why no variations are solved side by side; set by the first ones
};

// A thread pool: each thread takes the next variations until all are solved.
class Crew {
 public:
  Crew(const Ensemble& ensemble, const Model& model, const State& initial, int threads)
      : results(static_cast<std::size_t>(ensemble.variations)),
        at_once_(even_share(ensemble.variations, threads)),
        working_(threads) {
    for (int i = 0; i < threads; ++i) threads_.emplace_back([&, this] { work(ensemble, model, initial); });
  }

  void wait(const std::function<void()>& poll) {
    std::unique_lock lock(mutex_);
    while (!finished_.wait_for(lock, std::chrono::milliseconds(20), [this] { return working_ == 0; })) {
      lock.unlock();
      try {
        poll();
      } catch (...) {
        fail(std::current_exception());
      }
      lock.lock();
    }
    if (error_) std::rethrow_exception(error_);
  }

  std::vector<VariationResult> results;

 private:
  void work(const Ensemble& ensemble, const Model& model, const State& initial) {
    try {
      Workplaces workplaces(ensemble, model, initial, stop_);
      for (int i = next_.fetch_add(at_once_); i < ensemble.variations && !stop_; i = next_.fetch_add(at_once_)) {
        const int count = std::min(at_once_, ensemble.variations - i);
        workplaces.solve(i, std::span(results).subspan(static_cast<std::size_t>(i), static_cast<std::size_t>(count)));
      }
    } catch (...) {
      fail(std::current_exception());
    }
    const std::scoped_lock lock(mutex_);
    if (--working_ == 0) finished_.notify_all();
  }

  void fail(std::exception_ptr error) {
    stop_ = true;
    const std::scoped_lock lock(mutex_);
    if (!error_) error_ = std::move(error);
  }

  // Returns the number of variations per turn, at most Lockstep::most, such that all threads have equally many turns.
  static int even_share(int variations, int threads) {
    const auto rounded_up = [](int a, int b) { return (a + b - 1) / b; };
    const int turns = std::max(1, rounded_up(variations, threads * Lockstep::most));
    return std::max(1, rounded_up(variations, threads * turns));
  }

  const int at_once_;
  std::atomic<int> next_{0};
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::condition_variable finished_;
  int working_;
  std::exception_ptr error_;
  std::vector<std::jthread> threads_;  // the last member: threads end before other members are destroyed
};

}  // namespace

std::unique_ptr<VariedValues> make_varied_values(Storage storage, int variations) {
  return with_type(storage, [&]<class T>(TypeTag<T>) -> std::unique_ptr<VariedValues> {
    return std::make_unique<ValuesOf<T>>(variations);
  });
}

std::vector<VariationResult> solve_ensemble(const Ensemble& ensemble, const Model& model, const State& initial,
                                            int threads, const std::function<void()>& poll) {
  Crew crew(ensemble, model, initial, std::max(1, std::min(threads, ensemble.variations)));
  crew.wait(poll);
  return std::move(crew.results);
}

}  // namespace dalembert
