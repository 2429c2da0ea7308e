// The object that mbs.AddGeneralContact() returns, and the argument parsing of its methods.
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "conversion.hpp"
#include "dalembert/contact/general_contact.hpp"
#include "general_contact_checks.hpp"
#include "main_system.hpp"
#include "python_errors.hpp"
#include "sequence.hpp"

namespace dalembert {

struct ContactHandle {
  std::shared_ptr<MainSystem> main;
  std::shared_ptr<ContactSet> set;

  int number() const {
    const auto sources = main->model.term_sources();
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (sources[i] == set) return static_cast<int>(i);
    refuse(ErrorKind::state, {"GeneralContact", "", "it was deleted from its system", "", "",
                              "Take another one by mbs.AddGeneralContact()."});
  }
  static std::string called(const char* method) { return "GeneralContact." + std::string(method) + "(...)"; }
  // Assembled, with the frames of the current state.
  const GeneralContact& term(const char* method, const Ports*& ports) const {
    System& system = this->system(method);
    ports = &system.current_ports();
    return static_cast<const GeneralContact&>(system.term(number()));
  }
  System& system(const char* method) const {
    const int which = number();
    return main->assembled([&] { return "GetGeneralContact(" + std::to_string(which) + ")." + method; });
  }
};

// Methods that add convex shapes, planes and height fields.
void register_convex_contact(py::class_<ContactHandle>& contact);

inline int require_number(const char* method, int number, std::size_t count, const char* of) {
  if (number >= 0 && number < static_cast<int>(count)) return number;
  refuse(ErrorKind::index, {ContactHandle::called(method), "localIndex", "", std::to_string(number),
                            "the number of a " + std::string(of) + "; there are " + std::to_string(count), ""});
}

inline Vec3<double> vector_argument(const char* method, const char* parameter, const py::object& value) {
  Vec3<double> result;
  if (read_plain_reals(value.ptr(), 1, result.x)) return result;
  try {
    const std::vector<double> numbers = read_reals(value.ptr());
    if (numbers.size() == 3) return {numbers[0], numbers[1], numbers[2]};
  } catch (const Refusal&) {
  }
  refuse_value(method, parameter, show(value.ptr()), "3 finite numbers (unit m)");
}

// An array with so many columns.
template <class A>
A table_argument(const char* method, const char* parameter, const py::object& value, py::ssize_t columns) {
  A array = A::ensure(value);
  if (!array) PyErr_Clear();
  if (!array || array.ndim() != 2 || array.shape(1) != columns)
    refuse_value(method, parameter, show(value.ptr()),
                 "a list or an array with " + std::to_string(columns) + " columns");
  return array;
}

// All of one body; returns the number of the first of them.
inline int add_triangles_of_body(const ContactHandle& self, const char* method, int marker,
                                 const ContactSurface& surface, const std::vector<Triangle>& triangles) {
  Model& model = self.main->restructure(ContactHandle::called(method));
  const int first = static_cast<int>(self.set->triangles.size()), carrier = static_cast<int>(self.set->carriers.size());
  self.set->carriers.push_back({marker, surface});
  for (const Triangle& points : triangles) self.set->triangles.push_back({carrier, points});
  ++self.set->shapes;
  model.term_source_changed();
  return first;
}

}  // namespace dalembert
