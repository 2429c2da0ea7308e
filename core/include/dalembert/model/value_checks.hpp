// Requirements on values beyond their type: one check for arguments, parameters and models.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "dalembert/math/fixed.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/reflection/row.hpp"

namespace dalembert {

// Doubtful values are used, with a warning.
enum class Fit : std::uint8_t { right, doubtful, wrong };

struct Verdict {
  Fit fit = Fit::right;
  std::string problem = {};  // the fault as a sentence; empty if there is none
};

// Rotations are orthogonal and have the determinant 1, both to 1e-8. Reflections are doubtful if only some columns
// matter.
Verdict judge_rotation(const Mat3<double>& a, Fit of_reflections = Fit::wrong);
// Unit length, to 1e-8.
Verdict judge_unit_vector(const Vec3<double>& v);
// Red, green, blue and opacity, each from 0 to 1; a negative red stands for a default color.
Verdict judge_color(const Vec<double, 4>& v);
// Checks a member by the check of its row; a list has the result of its worst entry.
Verdict judge(const Row& row, const void* member);

// Requirement of a check, as in "but expected ...", and the remedy; empty for checks of numbers.
std::string demand(Check check);
std::string advice(Check check);

// The inertia of a body about a reference point, with the center of mass relative to it. Principal moments about the
// center of mass must not be negative (wrong), nor larger than the sum of the other two (doubtful). Numbers of a few
// digits may be off by 1e-4 of the largest component.
Verdict judge_inertia(double mass, const Mat3<double>& about_reference, const Vec3<double>& centre);

// For kernels: the parameters physicsMass, physicsInertia and physicsCenterOfMass, the latter in the plane for planar bodies.
void check_inertia(double mass, const Mat3<double>& about_reference, const Vec3<double>& centre, const ItemLabel& item);
void check_planar_inertia(double mass, double about_reference, const Vec<double, 2>& centre, const ItemLabel& item);
// Values of length 1, to 1e-8.
void check_unit_length(std::span<const double> values, const char* parameter, const char* expected,
                       const ItemLabel& item);

}  // namespace dalembert
