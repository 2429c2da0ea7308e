// ObjectGenericODE1, specs/bodies/generic_ode1.toml
#pragma once

#include "dalembert/bodies/generic_ode1_parameters.hpp"
#include "dalembert/contracts/sized_body.hpp"

namespace dalembert {

struct ObjectGenericODE1 {
  using Parameters = ObjectGenericODE1Parameters;
  using Frame = NoFrame;
  using Constants = NothingPrepared;
  static constexpr std::string_view item = "ObjectGenericODE1";
  static constexpr int order = 1;
  static constexpr std::string_view coordinates = "coordinates of the object's nodes";
  static constexpr Mesh mesh = Mesh::none;
  static constexpr bool computes_parameters = false;

  // y_t = A y + f + f_user
  static SizedLaw law(const Parameters& p) {
    return {.matrices = {ConstantMatrix("systemMatrix", StateVector::first_order, p.systemMatrix)},
            .force_vector = &p.rhsVector,
            .force_parameter = "rhsVector",
            .force = p.rhsUserFunction};
  }
  static bool takes(std::string_view, int) { return true; }
  static void check(const Parameters&, const Placement&, const ItemLabel&) {}
};

}  // namespace dalembert
