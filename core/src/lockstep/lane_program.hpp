// The operations of a trace on several computations at once: sorted into runs of the same operation, without repetitions and
// without what no output needs. They are done one by one, nothing is fused: every number is the one that the scalar
// computation gives, bit for bit.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dalembert/math/lane_block.hpp"
#include "dalembert/math/traced.hpp"

namespace dalembert {

// Which constants of a trace have been equal in all computations so far, and which have always been the same.
class ConstantClasses {
 public:
  // True: these constants tell some of them apart, and programs made before do not fit.
  bool refine(std::span<const double> constants);

  int count() const { return static_cast<int>(first_.size()); }
  int of(int constant) const { return class_[static_cast<std::size_t>(constant)]; }
  int first(int k) const { return first_[static_cast<std::size_t>(k)]; }  // constant of a class
  bool is_always(int k, double value) const { return always_[static_cast<std::size_t>(k)] == value; }

 private:
  std::vector<int> class_, first_;
  std::vector<std::optional<double>> always_;
};

class LaneProgram {
 public:
  LaneProgram() = default;
  LaneProgram(const Trace& trace, const ConstantClasses& classes);

  void set_constants(int lane, std::span<const double> constants);
  using Places = std::array<const double*, block_lanes>;
  void read(std::span<const Places> inputs);
  // After the part of the trace that it belongs to has run; until an earlier part runs again.
  const LaneBlock& output(int k) const { return memory_[outputs_[static_cast<std::size_t>(k)]]; }
  // Always zero, in all computations.
  bool is_zero(int k) const { return zero_[static_cast<std::size_t>(k)]; }
  void run(int part);

 private:
  enum class Kind : std::uint8_t { add, subtract, multiply, divide, negate, square_root, sine, cosine, turn };
  struct Instruction {
    std::uint16_t result, a, b;  // places in memory; of a turn, b is the place of the sine
  };
  struct Run {
    Kind kind;
    std::uint32_t end;  // in `instructions_`
  };
  struct Constant {
    int first;
    std::uint16_t place;
  };
  class Compiler;
  // Runs up to `end`, from instruction `next` on; the runs count from `first`.
  static void execute(const Run* run, const Run* end, const Instruction* first, const Instruction* next, LaneBlock* memory);

  std::vector<LaneBlock> memory_;
  std::vector<Constant> constants_;
  std::vector<std::uint16_t> outputs_;
  std::vector<char> zero_;
  std::vector<Instruction> instructions_;
  std::vector<Run> runs_;
  struct Part {
    std::size_t run, instruction;  // where it begins
  };
  std::vector<Part> parts_;  // and the end
};

}  // namespace dalembert
