// Checks of the numbers of general contact; errors name the method or the entry of a dictionary.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "conversion.hpp"
#include "dalembert/contact/contact_set.hpp"

namespace dalembert {

struct ValueSource {
  const char* method = nullptr;
  std::string place;  // position in a dictionary; method is then empty

  ValueSource(const char* of_contact) : method(of_contact) {}
  static ValueSource at(std::string place) {
    ValueSource result(nullptr);
    result.place = std::move(place);
    return result;
  }
  std::string name() const { return method == nullptr ? place : "GeneralContact." + std::string(method) + "(...)"; }
};

[[noreturn]] inline void refuse_value(const ValueSource& by, const std::string& parameter, const std::string& received,
                                      const std::string& expected) {
  refuse(ErrorKind::value, {by.name(), parameter, "", received, expected, ""});
}
inline std::string text_of(double x) { return py::str(py::float_(x)); }

inline double require(const ValueSource& by, const std::string& parameter, double value, bool positive,
                      const char* unit) {
  if (std::isfinite(value) && (positive ? value > 0 : value >= 0)) return value;
  refuse_value(by, parameter, text_of(value),
               std::string(positive ? "a positive number" : "a number that is not negative") + " (unit " + unit + ")");
}
constexpr bool is_material(int index) { return index >= -1; }
inline int require_material(const ValueSource& by, int material) {
  if (is_material(material)) return material;
  refuse_value(by, "frictionMaterialIndex", std::to_string(material),
               "a number from 0, of a row of frictionPairings, or -1: without friction");
}
inline ContactSurface surface_of(const ValueSource& by, double stiffness, double damping, int material) {
  return {require(by, "contactStiffness", stiffness, true, "N/m"),
          require(by, "contactDamping", damping, false, "Ns/m"), require_material(by, material)};
}
inline void require_area(const ValueSource& by, const std::string& parameter, const Triangle& points) {
  const Vec3<double> area = area_vector(points);
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    longest = std::max(longest, dot(points[(i + 1) % 3] - points[i], points[(i + 1) % 3] - points[i]));
  if (!(norm(area) > 1e-14 * longest)) refuse_value(by, parameter, "points on one line", "a triangle with an area");
}

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

// Coefficients of friction by rows, symmetric.
Array friction_argument(const ValueSource& by, const py::object& pairings);
py::array_t<double> friction_out(const ContactSet& set);
// Ratios of stiffness, of damping and of static friction.
ContactBristles bristles_from(const ValueSource& by, const std::array<double, 3>& ratios);
std::vector<double> bristles_out(const ContactSet& set);

// Settings of the interface without effect here. They are stored, and can be read. A value other than the default
// gives a warning with the reason, unless it requests the default behaviour.
struct KeptSetting {
  const char* name;
  double value;
  bool is_flag;
  const char* reason;
};
inline constexpr const char *own_search = "the search finds its own way, by which results do not change",
                            *own_threads = "threads share the work by themselves",
                            *exact_stretches =
                                "stretches of cables in contact are found exactly, as zeros of a polynomial";
inline constexpr KeptSetting kept_settings[] = {
    {"verboseMode", 0, false, "the verboseMode of the solver selects the output"},
    {"resetSearchTreeInterval", 10000, false, own_search},
    {"sphereSphereFrictionRecycle", 0, true,
     "sticking and sliding states are fixed during Newton's method, and updated after it"},
    {"excludeOverlappingTrigSphereContacts", 1, true, "coinciding contact points of a mesh count once"},
    {"excludeDuplicatedTrigSphereContactPoints", 0, true, ""},
    {"computeExactStaticTriangleBins", 1, true, own_search},
    {"computeContactForces", 0, true, ""},
    {"ancfCableUseExactMethod", 1, true, exact_stretches},
    {"ancfCableNumberOfContactSegments", 1, false, exact_stretches},
    {"ancfCableMeasuringSegments", 20, false, "distances from cables are measured exactly"},
    {"parallelTaskSplit", 12, false, own_threads},
    {"parallelTaskSplitBoundingBoxes", 48, false, own_threads},
    {"parallelTaskSplitThreshold", 12, false, own_threads},
    {"parallelTaskSplitBoundingBoxesThreshold", 400, false, own_threads},
};

}  // namespace dalembert
