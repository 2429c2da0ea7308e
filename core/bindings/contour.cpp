// Colors of many numbers, as pages get them.
#include "dalembert/pictures/contour.hpp"

#include <string>

#include "picture_arrays.hpp"
#include "system_container.hpp"

namespace dalembert {
namespace {

py::array shades(const Numbers<double>& numbers, double low, double high, const Numbers<std::uint8_t>& table) {
  const auto rows = all(table);
  if (rows.size() < fewest_shades * bytes_of_shade || rows.size() % bytes_of_shade != 0)
    throw py::value_error("_shades(...): table: expected 4 or more rows of 3 bytes, received " +
                          std::to_string(rows.size()) + " bytes");
  py::array_t<std::uint8_t> result({numbers.size(), static_cast<py::ssize_t>(bytes_of_shade)});
  contour_shades(all(numbers), low, high, rows, result.mutable_data());
  return result;
}

}  // namespace

void register_contour(py::module_& module) {
  module.def("_shades", &shades, py::arg("numbers"), py::arg("low"), py::arg("high"), py::arg("table"),
             "Colors (n x 3 bytes) of numbers: rows of a table for values below a range, equal steps in it, and values "
             "above.");
}

}  // namespace dalembert
