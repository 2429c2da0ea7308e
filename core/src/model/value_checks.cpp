#include "dalembert/model/value_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "dalembert/model/member.hpp"
#include "dalembert/output/numbers.hpp"

namespace dalembert {
namespace {

constexpr double exact_to = 1e-8, digits_typed = 1e-4;

std::string number(double value) { return format_number(value, 3); }

double determinant(const Mat3<double>& a) { return dot(column(a, 0), cross(column(a, 1), column(a, 2))); }

// Eigenvalues of a symmetric matrix, ascending, by the trigonometric solution of its characteristic equation.
std::array<double, 3> eigenvalues(const Mat3<double>& a) {
  const double mean = (a(0, 0) + a(1, 1) + a(2, 2)) / 3;
  const Mat3<double> deviator = a - mean * identity();
  double square = 0;
  for (const double x : deviator.x) square += x * x;
  const double radius = std::sqrt(square / 6);
  if (radius == 0) return {mean, mean, mean};
  const double angle = std::acos(std::clamp(determinant((1 / radius) * deviator) / 2, -1.0, 1.0)) / 3,
               third = 2 * std::numbers::pi / 3;
  return {mean + 2 * radius * std::cos(angle + third), mean + 2 * radius * std::cos(angle - third),
          mean + 2 * radius * std::cos(angle)};
}

Verdict judge_member(Check check, const Mat3<double>& a) {
  if (check == Check::rotation) return judge_rotation(a);
  return check == Check::orthogonal ? judge_rotation(a, Fit::doubtful) : Verdict{};
}
Verdict judge_member(Check check, const Vec3<double>& v) {
  return check == Check::unit_vector ? judge_unit_vector(v) : Verdict{};
}
Verdict judge_member(Check check, const Vec<double, 4>& v) {
  return check == Check::color ? judge_color(v) : Verdict{};
}
Verdict judge_member(Check, const auto&) { return {}; }

template <class Entry>
  requires(is_vec<Entry> || is_mat<Entry>)
Verdict judge_member(Check check, const std::vector<Entry>& list) {
  Verdict worst;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Verdict verdict = judge_member(check, list[i]);
    if (verdict.fit > worst.fit) worst = {verdict.fit, "Entry " + std::to_string(i) + ": " + verdict.problem};
  }
  return worst;
}

}  // namespace

Verdict judge_rotation(const Mat3<double>& a, Fit of_reflections) {
  const Mat3<double> difference = a * transpose(a) - identity();
  double deviation = 0;
  for (const double x : difference.x) deviation = std::max(deviation, std::abs(x));
  if (deviation > exact_to)
    return {Fit::wrong,
            "It is not orthogonal: A A^T differs from the identity matrix by up to " + number(deviation) + "."};
  if (determinant(a) < 0)
    return {of_reflections, "It is a reflection: its determinant is -1, its axes are left-handed."};
  return {};
}

Verdict judge_unit_vector(const Vec3<double>& v) {
  const double length = norm(v);
  if (length == 0) return {Fit::wrong, "A vector of zeros has no direction."};
  return std::abs(length - 1) <= exact_to ? Verdict{}
                                          : Verdict{Fit::wrong, "Its length is " + format_number(length, 10) + "."};
}

Verdict judge_color(const Vec<double, 4>& v) {
  constexpr double rounding = 1e-6;  // tolerance for numbers that were stored in single precision
  constexpr double first_material = 1000, last_material = 1999;  // replaces the opacity: dalembert.graphics.material
  if (v[0] < 0) return {};
  constexpr std::array<const char*, 4> names{"red", "green", "blue", "opacity"};
  const bool is_material = v[3] >= first_material && v[3] <= last_material && v[3] == std::floor(v[3]);
  for (std::size_t i = 0; i < (is_material ? 3 : names.size()); ++i)
    if (v[i] < 0 || v[i] > 1 + rounding)
      return {Fit::wrong, "Its " + std::string(names[i]) + " is " + number(v[i]) + "."};
  return {};
}

Verdict judge(const Row& row, const void* member) {
  return with_type(row.storage,
                   [&]<class T>(TypeTag<T>) { return judge_member(row.check, *static_cast<const T*>(member)); });
}

std::string demand(Check check) {
  switch (check) {
    case Check::rotation:
    case Check::orthogonal: return "a rotation matrix: orthogonal, with determinant 1";
    case Check::unit_vector: return "a vector of length 1";
    case Check::color: return "red, green, blue and opacity, each from 0 to 1";
    default: return "";
  }
}
std::string advice(Check check) {
  switch (check) {
    case Check::rotation:
    case Check::orthogonal:
      return "Its columns are unit vectors, normal to each other and right-handed; RotationMatrixZ(angle), for "
             "instance, makes one.";
    case Check::unit_vector: return "Divide it by its length.";
    case Check::color: return "Divide numbers from 0 to 255 by 255.";
    default: return "";
  }
}

Verdict judge_inertia(double mass, const Mat3<double>& about_reference, const Vec3<double>& centre) {
  Mat3<double> about_centre = about_reference;
  double scale = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      about_centre(i, j) += mass * (centre[i] * centre[j] - (i == j ? dot(centre, centre) : 0));
      scale = std::max(scale, std::abs(about_reference(i, j)));
    }
  const std::array<double, 3> moment = eigenvalues(about_centre);
  static constexpr const char* about = "a principal moment about the center of mass is ";
  const auto moments = [&] {
    return ": they are " + number(moment[0]) + ", " + number(moment[1]) + " and " + number(moment[2]);
  };
  if (moment[0] < -digits_typed * scale) return {Fit::wrong, std::string(about) + "negative" + moments()};
  if (moment[0] + moment[1] < moment[2] - digits_typed * scale)
    return {Fit::doubtful, std::string(about) + "larger than the sum of the others, which no body has" + moments()};
  return {};
}

namespace {

[[noreturn]] void refuse_inertia(const std::string& problem, const ItemLabel& item) {
  refuse(ErrorKind::value, {item, "physicsInertia", problem, "", "",
                            "It is the inertia about the reference point, which is the node: RigidBodyInertia turns "
                            "one about the center of mass into it."});
}

}  // namespace

void check_inertia(double mass, const Mat3<double>& about_reference, const Vec3<double>& centre,
                   const ItemLabel& item) {
  if (const Verdict verdict = judge_inertia(mass, about_reference, centre); verdict.fit == Fit::wrong)
    refuse_inertia(verdict.problem, item);
}

void check_planar_inertia(double mass, double about_reference, const Vec<double, 2>& centre, const ItemLabel& item) {
  const double about_centre = about_reference - mass * dot(centre, centre);
  if (about_centre < -digits_typed * about_reference)
    refuse_inertia("the moment of inertia about the center of mass is negative: it is " + number(about_centre), item);
}

void check_unit_length(std::span<const double> values, const char* parameter, const char* expected,
                       const ItemLabel& item) {
  double square = 0;
  for (const double x : values) square += x * x;
  if (std::abs(std::sqrt(square) - 1) <= exact_to) return;
  refuse(ErrorKind::value,
         {item, parameter, "", "values of length " + format_number(std::sqrt(square), 9), expected,
          "Their length is 1; RotationMatrix2EulerParameters(...), for instance, gives such values."});
}

}  // namespace dalembert
