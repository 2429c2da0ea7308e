// ObjectGenericODE2, specs/super_elements/generic_ode2.toml
#pragma once

#include "dalembert/contracts/sized_body.hpp"
#include "dalembert/super_elements/generic_ode2_parameters.hpp"

namespace dalembert {

struct ObjectGenericODE2 {
  using Parameters = ObjectGenericODE2Parameters;
  using Frame = NoFrame;
  using Constants = NothingPrepared;
  static constexpr std::string_view item = "ObjectGenericODE2";
  static constexpr int order = 2;
  static constexpr std::string_view coordinates = "coordinates of the object's nodes";
  static constexpr Mesh mesh = Mesh::nodes;
  static constexpr bool computes_parameters = false;

  // M q_tt + D q_t + K q = f + f_user, with displacements q; a mass matrix of the user takes the place of the constant one.
  static SizedLaw law(const Parameters& p) {
    SizedLaw law{.matrices = {ConstantMatrix("stiffnessMatrix", StateVector::displacement, p.stiffnessMatrix),
                              ConstantMatrix("dampingMatrix", StateVector::velocity, p.dampingMatrix)},
                 .force_vector = &p.forceVector,
                 .force_parameter = "forceVector",
                 .force = p.forceUserFunction,
                 .mass = p.massMatrixUserFunction,
                 .jacobian = p.jacobianUserFunction};
    if (!law.mass) law.matrices[2] = ConstantMatrix("massMatrix", StateVector::acceleration, p.massMatrix);
    return law;
  }
  static bool takes(std::string_view, int) { return true; }
  static void check(const Parameters&, const Placement&, const ItemLabel&) {}
};

}  // namespace dalembert
