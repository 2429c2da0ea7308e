// The operations of a trace on several computations at once: sorted into runs of the same operation, without repeated
// or unused operations. Operations are executed one by one without fusing: every number is bit-identical to the
// scalar computation.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dalembert/math/lane_block.hpp"
#include "dalembert/math/traced.hpp"

namespace dalembert {

// Groups constants of a trace that have been equal in all computations so far, and those with a fixed value.
class ConstantClasses {
 public:
  // True: these constants split a group, and earlier programs are invalid.
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
  // Valid after its part of the trace has run; until an earlier part runs again.
  const LaneBlock& output(int k) const { return memory_[outputs_[static_cast<std::size_t>(k)]]; }
  // Always zero, in all computations.
  bool is_zero(int k) const { return zero_[static_cast<std::size_t>(k)]; }
  void run(int part);

 private:
  enum class Kind : std::uint8_t { add, subtract, multiply, divide, negate, square_root, sine, cosine, turn };
  struct Instruction {
    std::uint16_t result, a, b;  // addresses; for a rotation, b is the address of the sine
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
  static void execute(const Run* run, const Run* end, const Instruction* first, const Instruction* next,
                      LaneBlock* memory);

  std::vector<LaneBlock> memory_;
  std::vector<Constant> constants_;
  std::vector<std::uint16_t> outputs_;
  std::vector<char> zero_;
  std::vector<Instruction> instructions_;
  std::vector<Run> runs_;
  struct Part {
    std::size_t run, instruction;  // first run and instruction
  };
  std::vector<Part> parts_;  // and the end
};

}  // namespace dalembert
