// Adhesive elasto-plastic contact: stiffer in unloading than at first loading, with an attraction that grows with the penetration.
//
// Thakur, Morrissey, Sun, Chen, Ooi: Micromechanical analysis of cohesive granular materials using the discrete element method
//   with an adhesive elasto-plastic contact model, Granular Matter 16 (2014).
#pragma once

#include <cmath>

#include "dalembert/laws/impact.hpp"

namespace dalembert {

struct AdhesiveLaw {
  double stiffness, exponent, plasticity, pull_off, attraction, attraction_exponent;

  template <class Parameters>
  explicit AdhesiveLaw(const Parameters& p)
      : stiffness(p.contactStiffness),
        exponent(p.contactStiffnessExponent),
        plasticity(p.contactPlasticityRatio),
        pull_off(p.constantPullOffForce),
        attraction(p.adhesionCoefficient),
        attraction_exponent(p.adhesionExponent) {}

  // Plastic part of the penetration after first loading.
  double plastic_overlap(double penetration) const {
    return plasticity == 0 ? 0 : std::pow(plasticity, 1 / exponent) * penetration;
  }

  // Loading and unloading coincide without plasticity; attraction acts only if unloading would be tensile.
  template <class S>
  S normal_force(const S& penetration, double overlap) const {
    const S loading = stiffness * odd_power(penetration, exponent);
    if (plasticity == 0) return loading - pull_off;
    const S unloading = (1 / (1 - plasticity)) * (loading - stiffness * std::pow(overlap, exponent));
    if (!(unloading < loading)) return loading - pull_off;
    const S pulling = -(attraction * odd_power(penetration, attraction_exponent));
    return (unloading < pulling ? pulling : unloading) - pull_off;
  }
};

}  // namespace dalembert
