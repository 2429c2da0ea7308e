// Numbers that record their arithmetic: computations of templates over the scalar become a list of operations.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace dalembert {

enum class Operation : std::uint8_t { add, subtract, multiply, divide, negate, square_root, sine, cosine };

// A number of the trace in progress, or a constant.
class Traced {
 public:
  Traced() = default;
  Traced(double constant) : value_(constant) {}

  friend Traced operator+(const Traced& a, const Traced& b) { return note(Operation::add, a, b); }
  friend Traced operator-(const Traced& a, const Traced& b) { return note(Operation::subtract, a, b); }
  friend Traced operator*(const Traced& a, const Traced& b) { return note(Operation::multiply, a, b); }
  friend Traced operator/(const Traced& a, const Traced& b) { return note(Operation::divide, a, b); }
  friend Traced operator-(const Traced& a) { return note(Operation::negate, a, a); }
  friend Traced sqrt(const Traced& a) { return note(Operation::square_root, a, a); }
  friend Traced sin(const Traced& a) { return note(Operation::sine, a, a); }
  friend Traced cos(const Traced& a) { return note(Operation::cosine, a, a); }
  Traced& operator+=(const Traced& b) { return *this = *this + b; }
  Traced& operator-=(const Traced& b) { return *this = *this - b; }
  Traced& operator*=(const Traced& b) { return *this = *this * b; }
  // Operations of one operand have it twice.
  static Traced note(Operation operation, const Traced& a, const Traced& b);

 private:
  friend class Trace;
  bool is_constant() const { return place_ < 0; }

  double value_ = 0;  // value of a constant
  int place_ = -1;  // address of a computed number
};

// The operations of one computation. It may be traced again with other constants, which a second trace of the same
// operations provides.
class Trace {
 public:
  // Operands and outputs are places: inputs come first, results follow one by one. Constants are ~k, in the order of use.
  struct Note {
    Operation operation;
    int a, b;  // equal if there is one operand
    bool operator==(const Note&) const = default;
  };
  // Ends of the lists at the end of a part of the computation.
  struct Part {
    std::size_t notes, outputs;
    bool operator==(const Part&) const = default;
  };

  // Operations are noted from here on until `end`, on this thread.
  void begin();
  Traced input();
  void output(std::span<const Traced> numbers);
  void end_part();
  // False: it was another computation than the first one of this trace; only `constants` have changed.
  bool end();

  int inputs = 0;
  std::vector<Note> notes;
  std::vector<double> constants;
  std::vector<int> outputs;
  std::vector<Part> parts;

 private:
  friend class Traced;
  int operand(const Traced& x);
  template <class T>
  void keep(std::vector<T>& list, std::size_t& count, const T& entry);

  bool known_ = false, same_ = true;
  int inputs_ = 0;
  std::size_t notes_ = 0, outputs_ = 0, parts_ = 0;
};

}  // namespace dalembert
