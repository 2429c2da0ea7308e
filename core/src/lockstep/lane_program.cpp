#include "lane_program.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <unordered_map>

namespace dalembert {

bool ConstantClasses::refine(std::span<const double> constants) {
  const auto bits = [&](int k) { return std::bit_cast<std::uint64_t>(constants[static_cast<std::size_t>(k)]); };
  const auto forget = [](std::optional<double>& always) {
    const bool used = always == 0.0 || always == 1.0;
    always.reset();
    return used;
  };
  bool refined = false;
  for (std::size_t k = 0; k < first_.size(); ++k)
    if (always_[k] && std::bit_cast<std::uint64_t>(*always_[k]) != bits(first_[k])) refined |= forget(always_[k]);
  const auto fits = [&](int i) { return bits(i) == bits(first(of(i))); };
  bool split = class_.empty();
  for (int i = 0; i < static_cast<int>(class_.size()) && !split; ++i) split = !fits(i);
  if (!split) return refined;
  const bool known = !class_.empty();
  class_.resize(constants.size(), 0);
  std::map<std::pair<int, std::uint64_t>, int> places;
  const std::vector<std::optional<double>> before = std::move(always_);
  always_.clear();
  first_.clear();
  for (int i = 0; i < static_cast<int>(class_.size()); ++i) {
    int& mine = class_[static_cast<std::size_t>(i)];
    const auto [place, is_new] = places.try_emplace({mine, bits(i)}, count());
    if (is_new) {
      first_.push_back(i);
      const std::optional<double> all_before =
          known ? before[static_cast<std::size_t>(mine)] : constants[static_cast<std::size_t>(i)];
      const bool still = all_before && std::bit_cast<std::uint64_t>(*all_before) ==
                                           bits(i);  // not so if this part left the class by its value
      always_.push_back(still ? all_before : std::nullopt);
    }
    mine = place->second;
  }
  return true;
}

// Values are numbered: inputs, classes of constants, results.
class LaneProgram::Compiler {
 public:
  Compiler(const Trace& trace, const ConstantClasses& classes, LaneProgram& program)
      : trace_(trace), classes_(classes), program_(program), first_result_(trace.inputs + classes.count()) {}

  void compile() {
    number_values();
    uses_.assign(values_.size(), 0);
    place_.assign(values_.size(), none);
    divide_into_parts();
    place_inputs();
    for (const auto& part : members_) {
      program_.parts_.push_back({program_.runs_.size(), program_.instructions_.size()});
      schedule(part);
    }
    program_.parts_.push_back({program_.runs_.size(), program_.instructions_.size()});
    for (const int output : outputs_) {
      program_.outputs_.push_back(static_cast<std::uint16_t>(place_[static_cast<std::size_t>(output)]));
      program_.zero_.push_back(is_always(output, 0.0));
    }
    program_.memory_.resize(places_);
  }

 private:
  static constexpr int none = -1;
  struct Value {
    Operation operation{};
    int a = none, b = none;
    int part = none, partner = none;  // the sine of the same number, for a cosine, and the other way round
  };
  static bool has_two(Operation operation) { return operation <= Operation::divide; }

  bool is_constant(int value) const { return value >= trace_.inputs && value < first_result_; }
  bool is_always(int value, double x) const {
    return is_constant(value) && classes_.is_always(value - trace_.inputs, x);
  }

  int value_at(int place) const {
    if (place < 0) return trace_.inputs + classes_.of(-place - 1);
    return place < trace_.inputs ? place : results_[static_cast<std::size_t>(place - trace_.inputs)];
  }

  void number_values() {
    values_.resize(static_cast<std::size_t>(first_result_));
    std::unordered_map<std::uint64_t, int> known;
    for (const Trace::Note& note : trace_.notes) {
      int a = value_at(note.a), b = value_at(note.b);
      if (note.operation == Operation::multiply && (is_always(a, 1.0) || is_always(b, 1.0))) {
        results_.push_back(is_always(a, 1.0) ? b : a);
        continue;
      }
      if (note.operation == Operation::add || note.operation == Operation::multiply)
        if (a > b) std::swap(a, b);
      const auto wide = [](auto x) { return static_cast<std::uint64_t>(x); };
      const auto key = wide(note.operation) << 60 | wide(a) << 30 | wide(b);
      const auto [entry, is_new] = known.try_emplace(key, static_cast<int>(values_.size()));
      if (is_new) values_.push_back({note.operation, a, b});
      results_.push_back(entry->second);
    }
    for (const int output : trace_.outputs) outputs_.push_back(value_at(output));
  }

  // A result belongs to the first part whose outputs need it.
  void divide_into_parts() {
    std::size_t begin = 0;
    std::vector<int> open;
    for (const Trace::Part& part : trace_.parts) {
      const int number = static_cast<int>(members_.size());
      std::vector<int>& members = members_.emplace_back();
      open.assign(outputs_.begin() + static_cast<std::ptrdiff_t>(begin),
                  outputs_.begin() + static_cast<std::ptrdiff_t>(part.outputs));
      for (const int output : open) ++uses_[static_cast<std::size_t>(output)];  // never used up
      while (!open.empty()) {
        const int v = open.back();
        open.pop_back();
        Value& value = values_[static_cast<std::size_t>(v)];
        if (v < first_result_ || value.part != none) continue;
        value.part = number;
        members.push_back(v);
        for (const int operand : operands(value)) {
          ++uses_[static_cast<std::size_t>(operand)];
          open.push_back(operand);
        }
      }
      std::ranges::sort(members);
      find_partners(members);
      begin = part.outputs;
    }
  }

  std::span<const int> operands(const Value& value) const { return {&value.a, has_two(value.operation) ? 2u : 1u}; }

  void find_partners(const std::vector<int>& members) {
    std::map<int, int> sines;
    const auto each = [&](Operation operation, auto&& f) {
      for (const int v : members)
        if (Value& value = values_[static_cast<std::size_t>(v)]; value.operation == operation) f(v, value);
    };
    each(Operation::sine, [&](int v, const Value& value) { sines[value.a] = v; });
    each(Operation::cosine, [&](int v, Value& value) {
      if (const auto sine = sines.find(value.a); sine != sines.end()) {
        value.partner = sine->second;
        values_[static_cast<std::size_t>(sine->second)].partner = v;
      }
    });
  }

  void place_inputs() {
    for (int i = 0; i < trace_.inputs; ++i) {
      place_[static_cast<std::size_t>(i)] = new_place();
      ++uses_[static_cast<std::size_t>(i)];
    }
    for (int k = 0; k < classes_.count(); ++k) {
      const auto value = static_cast<std::size_t>(trace_.inputs + k);
      if (uses_[value]++ == 0) continue;
      place_[value] = new_place();
      program_.constants_.push_back({classes_.first(k), static_cast<std::uint16_t>(place_[value])});
    }
  }

  // The operations that there are most of go next, among those whose operands are known.
  void schedule(const std::vector<int>& members) {
    std::array<std::vector<int>, static_cast<std::size_t>(Kind::turn) + 1> ready;
    std::unordered_map<int, std::vector<int>> followers;
    std::unordered_map<int, int> missing;
    const auto add_ready = [&](int v) {
      const Value& value = values_[static_cast<std::size_t>(v)];
      if (value.partner == none)
        ready[static_cast<std::size_t>(value.operation)].push_back(v);
      else if (value.operation == Operation::cosine)
        ready[static_cast<std::size_t>(Kind::turn)].push_back(v);
    };
    const int part = members.empty() ? 0 : values_[static_cast<std::size_t>(members.front())].part;
    for (const int v : members) {
      int count = 0;
      for (const int operand : operands(values_[static_cast<std::size_t>(v)]))
        if (values_[static_cast<std::size_t>(operand)].part == part) {
          followers[operand].push_back(v);
          ++count;
        }
      missing[v] = count;
      if (count == 0) add_ready(v);
    }
    for (;;) {
      const auto most = std::ranges::max_element(ready, {}, [](const auto& list) { return list.size(); });
      if (most->empty()) return;
      const auto kind = static_cast<Kind>(most - ready.begin());
      const std::vector<int> now = std::move(*most);
      most->clear();
      for (const int v : now) emit(kind, v);
      program_.runs_.push_back({kind, static_cast<std::uint32_t>(program_.instructions_.size())});
      const auto tell = [&](int v) {
        for (const int follower : followers[v])
          if (--missing[follower] == 0) add_ready(follower);
      };
      for (const int v : now) {
        tell(v);
        if (kind == Kind::turn) tell(values_[static_cast<std::size_t>(v)].partner);
      }
    }
  }

  void emit(Kind kind, int v) {
    const Value& value = values_[static_cast<std::size_t>(v)];
    const auto at = [&](int x) { return static_cast<std::uint16_t>(place_[static_cast<std::size_t>(x)]); };
    Instruction instruction{0, at(value.a), has_two(value.operation) ? at(value.b) : std::uint16_t{0}};
    // The sine is written before the cosine, which may be where the angle was.
    if (kind == Kind::turn) {
      place_[static_cast<std::size_t>(value.partner)] = new_place();
      instruction.b = at(value.partner);
      release(value.a);
    }
    for (const int operand : operands(value)) release(operand);
    place_[static_cast<std::size_t>(v)] = new_place();
    instruction.result = at(v);
    program_.instructions_.push_back(instruction);
  }

  int new_place() {
    if (free_.empty()) return static_cast<int>(places_++);
    const int place = free_.back();
    free_.pop_back();
    return place;
  }
  void release(int value) {
    if (--uses_[static_cast<std::size_t>(value)] == 0) free_.push_back(place_[static_cast<std::size_t>(value)]);
  }

  const Trace& trace_;
  const ConstantClasses& classes_;
  LaneProgram& program_;
  int first_result_;
  std::vector<Value> values_;
  std::vector<int> results_, outputs_;         // values of the notes, and of the outputs
  std::vector<std::vector<int>> members_;      // results of each part
  std::vector<int> uses_, place_, free_;
  std::size_t places_ = 0;
};

LaneProgram::LaneProgram(const Trace& trace, const ConstantClasses& classes) {
  Compiler(trace, classes, *this).compile();
}

void LaneProgram::set_constants(int lane, std::span<const double> constants) {
  for (const Constant& c : constants_) memory_[c.place].at(lane) = constants[static_cast<std::size_t>(c.first)];
}

DALEMBERT_INLINE inline void LaneProgram::execute(const Run* run, const Run* end, const Instruction* first,
                                                  const Instruction* next, LaneBlock* memory) {
  const auto each = [&](std::uint32_t last, auto&& f) {
    for (const Instruction* stop = first + last; next != stop; ++next) f(*next);
  };
  const auto lane_by_lane = [](LaneBlock& to, const LaneBlock& from, auto&& f) {
    to = LaneBlock::of_each([&](int lane) { return f(from[lane]); });
  };
  for (; run != end; ++run) {
    switch (run->kind) {
      case Kind::add:
        each(run->end, [&](const Instruction& i) { memory[i.result] = memory[i.a] + memory[i.b]; });
        break;
      case Kind::subtract:
        each(run->end, [&](const Instruction& i) { memory[i.result] = memory[i.a] - memory[i.b]; });
        break;
      case Kind::multiply:
        each(run->end, [&](const Instruction& i) { memory[i.result] = memory[i.a] * memory[i.b]; });
        break;
      case Kind::divide:
        each(run->end, [&](const Instruction& i) { memory[i.result] = memory[i.a] / memory[i.b]; });
        break;
      case Kind::negate: each(run->end, [&](const Instruction& i) { memory[i.result] = -memory[i.a]; }); break;
      case Kind::square_root:
        each(run->end, [&](const Instruction& i) {
          lane_by_lane(memory[i.result], memory[i.a], [](double x) { return std::sqrt(x); });
        });
        break;
      case Kind::sine:
        each(run->end, [&](const Instruction& i) {
          lane_by_lane(memory[i.result], memory[i.a], [](double x) { return std::sin(x); });
        });
        break;
      case Kind::cosine:
        each(run->end, [&](const Instruction& i) {
          lane_by_lane(memory[i.result], memory[i.a], [](double x) { return std::cos(x); });
        });
        break;
      case Kind::turn:
        each(run->end, [&](const Instruction& i) {
          LaneBlock sine, cosine;
          for (int k = 0; k < block_lanes; ++k) {
            cosine.at(k) = std::cos(memory[i.a][k]);
            sine.at(k) = std::sin(memory[i.a][k]);
          }
          memory[i.b] = sine;
          memory[i.result] = cosine;
        });
        break;
    }
  }
}

// Put together in registers: blocks that are stored lane by lane could be loaded only after all of these stores are done.
void LaneProgram::read(std::span<const Places> inputs) {
  in_block_registers([&] {
    LaneBlock* to = memory_.data();
    for (const Places& from : inputs)
      *to++ = LaneBlock::of_each([&](int lane) { return *from[static_cast<std::size_t>(lane)]; });
  });
}

void LaneProgram::run(int part) {
  const Part& begin = parts_[static_cast<std::size_t>(part)];
  const Part& end = parts_[static_cast<std::size_t>(part) + 1];
  in_block_registers([&] {
    execute(runs_.data() + begin.run, runs_.data() + end.run, instructions_.data(),
            instructions_.data() + begin.instruction, memory_.data());
  });
}

}  // namespace dalembert
