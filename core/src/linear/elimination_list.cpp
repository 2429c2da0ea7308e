#include "elimination_list.hpp"

#include <bit>
#include <limits>

#include "front_kernels.hpp"

namespace dalembert {

namespace {

std::uint16_t narrow(int x) { return static_cast<std::uint16_t>(x); }
std::uint16_t narrow(std::size_t x) { return static_cast<std::uint16_t>(x); }

StepMask bit(int i) { return StepMask{1} << i; }
StepMask after(int i) { return ~(bit(i) | (bit(i) - 1)); }

template <class F>
void each(StepMask steps, F&& f) {
  for (; steps != 0; steps &= steps - 1) f(std::countr_zero(steps));
}

constexpr auto all_but_sign = std::numeric_limits<std::int64_t>::max();  // mask of the bits of a number

}  // namespace

EliminationList::EliminationList(std::span<const int> row_of_step, std::span<const char> occupied)
    : size(static_cast<int>(row_of_step.size())),
      rows_(row_of_step.size()),
      columns_(row_of_step.size()),
      places_(occupied.size()) {
  for (int i = 0; i < size; ++i) {
    rows_[i] = bit(i);
    for (int j = 0; j < size; ++j)
      if (occupied[static_cast<std::size_t>(j * size + row_of_step[i])]) rows_[i] |= bit(j);
  }
  for (int k = 0; k < size; ++k)
    for (int i = k + 1; i < size; ++i)
      if (rows_[i] & bit(k)) rows_[i] |= rows_[k] & after(k);
  for (int i = 0; i < size; ++i) each(rows_[i], [&](int j) { columns_[j] |= bit(i); });
  list_factorization();
  list_back_substitution();
  list_sources(row_of_step, occupied);
}

void EliminationList::list_factorization() {
  for (int k = 0; k < size; ++k) place(k, k) = narrow(entries++);
  for (int k = 0; k < size; ++k) {
    each(columns_[k] & after(k), [&](int i) {
      place(i, k) = narrow(entries++);
      forward.push_back({narrow(i), place(i, k), narrow(k)});
    });
    lower_ends.push_back(narrow(entries));
  }
  for (int k = 0; k < size; ++k) each(rows_[k] & after(k), [&](int j) { place(k, j) = narrow(entries++); });
  for (int k = 0; k < size; ++k) {
    each(rows_[k] & after(k), [&](int j) {
      each(columns_[k] & after(k), [&](int i) { updates.push_back({place(i, j), place(i, k), place(k, j)}); });
    });
    update_ends.push_back(narrow(updates.size()));
  }
}

void EliminationList::list_back_substitution() {
  for (int first = (size - 1) / front_chunk * front_chunk, end = size; first >= 0; end = first, first -= front_chunk) {
    const StepMask earlier = bit(first) - 1;
    const auto list = [&](std::vector<Update>& to, StepMask rows, int j) {
      each(columns_[j] & rows, [&](int i) { to.push_back({narrow(i), place(i, j), narrow(j)}); });
    };
    for (int j = end - 1; j > first; --j) list(within, (bit(j) - 1) & ~earlier, j);
    for (int j = first; j < end; ++j) list(before, earlier, j);
    groups.push_back({narrow(first), narrow(end), narrow(within.size()), narrow(before.size())});
  }
}

void EliminationList::list_sources(std::span<const int> row_of_step, std::span<const char> occupied) {
  unoccupied.assign(occupied.size(), all_but_sign);
  for (int j = 0; j < size; ++j)
    each(columns_[j], [&](int i) {
      const int from = j * size + row_of_step[i];
      if (occupied[static_cast<std::size_t>(from)]) {
        sources.push_back({narrow(from), place(i, j)});
        unoccupied[static_cast<std::size_t>(from)] = 0;
      } else {
        fill.push_back(place(i, j));
      }
    });
}

}  // namespace dalembert
