// Vectors and matrices in messages of solvers, in the notation of Python.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"

namespace dalembert {

inline std::string vector_text(std::span<const double> values, int precision) {
  std::string text = "[";
  for (const double x : values) {
    if (text.size() > 1) text += ", ";
    append_number(text, x, precision);
  }
  return text + "]";
}

// Writes `values` row by row.
inline std::string matrix_text(std::span<const double> values, int size, int precision) {
  std::string text = "[";
  const auto n = static_cast<std::size_t>(size);
  for (std::size_t row = 0; row < n; ++row)
    text += (row == 0 ? "" : ",\n     ") + vector_text(values.subspan(row * n, n), precision);
  return text + "]";
}

// Writes the leading rows and columns of a matrix that is stored in the order of a pattern.
inline std::vector<double> dense_rows(const Pattern& pattern, std::span<const double> values, int size) {
  std::vector<double> rows(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0.0);
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (row < size && column < size)
      rows[static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + column] = values[slot];
  });
  return rows;
}

}  // namespace dalembert
