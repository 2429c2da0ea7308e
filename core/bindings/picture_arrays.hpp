// Arrays of numbers that pictures are made of.
#pragma once

#include <pybind11/numpy.h>

#include <optional>
#include <span>
#include <string>

#include "dalembert/pictures/picture.hpp"

namespace dalembert {

namespace py = pybind11;

template <class T>
using Numbers = py::array_t<T, py::array::c_style | py::array::forcecast>;

template <class T>
std::span<const T> all(const Numbers<T>& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

// Checks the array size: numbers per entry times `count`; `who` is the class name.
template <class T>
std::span<const T> each(const char* who, const Numbers<T>& array, std::size_t count, std::size_t numbers,
                        const char* name) {
  const auto values = all(array);
  if (values.size() != count * numbers)
    throw py::value_error(std::string(who) + ": " + name + ": expected " + std::to_string(count * numbers) +
                          " numbers, received " + std::to_string(values.size()));
  return values;
}

// A mesh without numbers of items.
inline Mesh checked_mesh(const char* who, const Numbers<double>& points, const std::optional<Numbers<double>>& normals,
                         const Numbers<float>& colors, const Numbers<std::int32_t>& triangles) {
  const auto n = static_cast<std::size_t>(points.size()) / 3, m = static_cast<std::size_t>(triangles.size()) / 3;
  const Mesh mesh{each(who, points, n, 3, "points"),
                  normals ? each(who, *normals, n, 3, "normals") : std::span<const double>{},
                  each(who, colors, n, 4, "colors"),
                  each(who, triangles, m, 3, "triangles"),
                  {}};
  for (const std::int32_t i : mesh.triangles)
    if (i < 0 || static_cast<std::size_t>(i) >= n)
      throw py::index_error(std::string(who) + ": triangles: there is no point " + std::to_string(i));
  return mesh;
}

}  // namespace dalembert
