// Spheres in a box that touch each other and the walls, without friction: what general contact needs of a system term, at work.
#pragma once

#include <array>
#include <vector>

#include "dalembert/laws/impact.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/system/system_term.hpp"

namespace dalembert {

struct SpheresInBoxParameters {
  std::vector<int> markers;  // at the centres
  std::vector<double> radii;
  Vec3<double> lower, upper;  // corners of the box
  double margin = 0;          // pairs are found that far from each other
  bool all_pairs = false;     // all of them, always: to compare with
  // What the law of impacts reads.
  double contactStiffness = 0, contactStiffnessExponent = 1, contactDamping = 0, restitutionCoefficient = 1, minimumImpactVelocity = 1e-3;
  int impactModel = 1;
  bool limitDamping = true;
};

class SpheresInBox final : public SystemTerm {
 public:
  explicit SpheresInBox(const SpheresInBoxParameters& parameters) : p_(parameters) {}

  std::span<const int> markers() const override { return p_.markers; }
  bool search(const Evaluation& evaluation, const Ports& ports) override;
  void keep() override { pairs_.keep(); }
  void restore() override { pairs_.restore(); }

  void visit(BlockVisitor& visitor, const Ports& ports) const override;
  void residual(const Evaluation& evaluation, Ports& ports, double* r) const override;
  void tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports, double* values) const override;
  PostNewton post_newton(const Evaluation& evaluation, const Ports& ports, const double* start, double* data, double* lambda) override;
  bool has_history() const override { return true; }

 private:
  // Of the last update.
  struct Touch {
    double gap = 1;
    double impact = 0;  // rate of penetration when the contact closed
    bool closed() const { return gap < 0; }
  };
  using Pairs = PairList<Touch>;
  using Pair = Pairs::Pair;  // the second may be a wall: 0 to 2 of the lower corner, 3 to 5 of the upper one, after the spheres

  int spheres() const { return static_cast<int>(p_.markers.size()); }
  bool is_wall(int second) const { return second >= spheres(); }
  template <class S>
  struct Approach;  // gap of a pair, its rate, and the direction of the force on the first
  template <class S>
  Approach<S> approach(const Pair& pair, const PointFrame<S>& first, const PointFrame<S>& second) const;
  Approach<double> approach(const Pair& pair, const Ports& ports) const;
  template <class S>
  Vec3<S> force(const Touch& touch, const Approach<S>& at) const;
  std::vector<Pair> within(double distance, const Ports& ports) const;

  SpheresInBoxParameters p_;
  Pairs pairs_;
};

}  // namespace dalembert
