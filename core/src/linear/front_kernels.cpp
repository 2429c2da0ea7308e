#include "front_kernels.hpp"

#include <bit>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "dalembert/linear/linear_solver.hpp"
#include "dalembert/math/processor.hpp"
#include "elimination_list.hpp"
#include "listed_lu.hpp"
#include "packs.hpp"

// Registers instead of arrays.
#define UNROLL _Pragma("GCC unroll 8")
#define FRONT_KERNELS \
  factorize, eliminate, substitute, add_columns, pack, forward, backward, take_listed, factorize_listed, solve_listed

namespace dalembert {

namespace portable {
#define NARROW 2
#define WIDE 2
#define TILE_ROWS 2
#define TILE_COLUMNS 4
#include "front_kernels.inc"
#include "solution_sweeps.inc"
#undef NARROW
#undef WIDE
#undef TILE_ROWS
#undef TILE_COLUMNS
constexpr FrontKernels kernels{"portable", FRONT_KERNELS};
}  // namespace portable

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define DALEMBERT_DISPATCH

#pragma GCC push_options
#pragma GCC target("avx2,fma")
namespace avx2 {
#define NARROW 4
#define WIDE 4
#define TILE_ROWS 3
#define TILE_COLUMNS 4
#include "front_kernels.inc"
#include "solution_sweeps.inc"
#undef NARROW
#undef WIDE
#undef TILE_ROWS
#undef TILE_COLUMNS
constexpr FrontKernels kernels{"avx2", FRONT_KERNELS};
}  // namespace avx2
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx512f,avx512vl,avx512dq,avx2,fma")
namespace avx512 {
#define NARROW 4
#define WIDE 8
#define TILE_ROWS 3
#define TILE_COLUMNS 8
#include "front_kernels.inc"
#include "solution_sweeps.inc"
#undef NARROW
#undef WIDE
#undef TILE_ROWS
#undef TILE_COLUMNS
constexpr FrontKernels kernels{"avx512", FRONT_KERNELS};
}  // namespace avx512
#pragma GCC pop_options

#endif

std::span<const FrontKernels* const> available_front_kernels() {
  static const FrontKernels* const sets[] = {
#ifdef DALEMBERT_DISPATCH
      &avx512::kernels, &avx2::kernels,
#endif
      &portable::kernels};
#ifdef DALEMBERT_DISPATCH
  const auto missing = static_cast<std::size_t>(Instructions::avx512) - static_cast<std::size_t>(instructions());
  return std::span(sets).subspan(missing);
#else
  return sets;
#endif
}

const FrontKernels& front_kernels(std::string_view name) {
  const auto sets = available_front_kernels();
  if (name.empty()) return *sets.front();
  for (const FrontKernels* set : sets) {
    if (name == set->name) return *set;
  }
  throw std::invalid_argument("instructions: received '" + std::string(name) + "', which this processor does not have");
}

std::vector<std::string> instruction_sets() {
  std::vector<std::string> names;
  for (const FrontKernels* set : available_front_kernels()) names.emplace_back(set->name);
  return names;
}

}  // namespace dalembert
