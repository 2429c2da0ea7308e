#include "dalembert/math/traced.hpp"

#include <cmath>

namespace dalembert {

namespace {

thread_local Trace* in_progress = nullptr;

double computed(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::add: return a + b;
    case Operation::subtract: return a - b;
    case Operation::multiply: return a * b;
    case Operation::divide: return a / b;
    case Operation::negate: return -a;
    case Operation::square_root: return std::sqrt(a);
    case Operation::sine: return std::sin(a);
    case Operation::cosine: return std::cos(a);
  }
  return a;
}

}  // namespace

Traced Traced::note(Operation operation, const Traced& a, const Traced& b) {
  if (a.is_constant() && b.is_constant()) return computed(operation, a.value_, b.value_);
  Trace& trace = *in_progress;
  const int first = trace.operand(a), second = &a == &b ? first : trace.operand(b);
  Traced result;
  result.place_ = trace.inputs_ + static_cast<int>(trace.notes_);
  trace.keep(trace.notes, trace.notes_, {operation, first, second});
  return result;
}

template <class T>
void Trace::keep(std::vector<T>& list, std::size_t& count, const T& entry) {
  if (!known_) {
    list.push_back(entry);
  } else {
    same_ &= count < list.size() && list[count] == entry;
  }
  ++count;
}

int Trace::operand(const Traced& x) {
  if (!x.is_constant()) return x.place_;
  constants.push_back(x.value_);
  return -static_cast<int>(constants.size());
}

void Trace::begin() {
  in_progress = this;
  constants.clear();
  same_ = true;
  inputs_ = 0;
  notes_ = outputs_ = parts_ = 0;
}

Traced Trace::input() {
  Traced x;
  x.place_ = inputs_++;
  return x;
}

void Trace::output(std::span<const Traced> numbers) {
  for (const Traced& x : numbers) keep(outputs, outputs_, operand(x));
}

void Trace::end_part() { keep(parts, parts_, {notes_, outputs_}); }

bool Trace::end() {
  in_progress = nullptr;
  if (!known_) inputs = inputs_;
  const bool complete =
      inputs_ == inputs && notes_ == notes.size() && outputs_ == outputs.size() && parts_ == parts.size();
  known_ = true;
  return same_ && complete;
}

}  // namespace dalembert
