// Definition of general contact before assembly: spheres, convex shapes, triangles and planes at markers, their
// surfaces and options.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "dalembert/contact/contact_law.hpp"
#include "dalembert/contact/convex_shape.hpp"
#include "dalembert/math/triangle.hpp"
#include "dalembert/model/term_source.hpp"

namespace dalembert {

struct ContactSurface {
  double stiffness = 0, damping = 0;
  int material = 0;  // row and column of the coefficients of friction; -1: without friction
};
struct ContactSphere {
  int marker = -1;
  double radius = 0;
  ContactSurface surface;
};
// Triangles rest in the frame of a marker.
struct ContactCarrier {
  int marker = -1;
  ContactSurface surface;
};
// An element of a planar cable, which is as thick as twice the half height.
struct ContactCable {
  int object = -1;
  double half_height = 0;
  ContactSurface surface;
};
struct ContactTriangle {
  int carrier = 0;
  Triangle points;
};
struct ContactConvex {
  int marker = -1;
  ConvexDefinition definition;
  ContactSurface surface;
};
// A half-space below a plane that rests in the frame of a marker.
struct ContactPlane {
  int marker = -1;
  Vec3<double> normal, point;  // the normal has length one
  ContactSurface surface;
};

// Tangential springs and dampers of contacts, as ratios of the normal ones, and the ratio of static to kinetic
// friction. If the stiffness is zero, friction is regularized by the slip velocity.
struct ContactBristles {
  double stiffness = 0, damping = 0, holding = 1;
  bool grow() const { return stiffness > 0; }
  StickSlip law(const ContactPairing& along_normal) const {
    return {stiffness * along_normal.stiffness, damping * along_normal.damping};
  }
};

class ContactSet final : public SystemTermSource {
 public:
  std::vector<ContactSphere> spheres;
  std::vector<ContactCable> cables;
  std::vector<ContactCarrier> carriers;
  std::vector<ContactTriangle> triangles;  // triangles of one carrier need not be contiguous
  std::vector<ContactConvex> convex;
  std::vector<ContactPlane> planes;
  std::vector<double> friction;  // friction coefficients of pairs of materials, row by row
  int materials = 0;
  double proportional_zone = 1e-3;        // m/s
  // smallest distance of a center from a triangle, in radii; the normal is undefined below
  double nearest_relative_distance = 1e-10;
  ContactBristles bristles;
  bool active = true, spheres_touch = true;
  std::uint64_t shapes = 0;  // counts changes of radii and triangles: who keeps anything made of them looks here

  ContactPairing pairing(const ContactSurface& a, const ContactSurface& b) const {
    const double stiffness = a.stiffness * b.stiffness / (a.stiffness + b.stiffness);
    const bool rubs = a.material >= 0 && b.material >= 0;
    return {stiffness, a.damping + b.damping,
            rubs ? friction[static_cast<std::size_t>(a.material * materials + b.material)] : 0.0};
  }
  // Settings of the interface that change nothing here; kept to be read again.
  std::map<std::string, double> without_effect;
  std::array<int, 3> cells{};  // cells of a search tree, without effect
  std::array<double, 6> box{0, 0, 0, -1, -1, -1};  // lower and upper corner, without effect; empty if not given

  // Global numbers: spheres, then cables, then triangles, then convex shapes, then planes.
  int first_cable() const { return static_cast<int>(spheres.size()); }
  int first_triangle() const { return first_cable() + static_cast<int>(cables.size()); }
  int first_convex() const { return first_triangle() + static_cast<int>(triangles.size()); }
  int first_plane() const { return first_convex() + static_cast<int>(convex.size()); }
  bool empty() const {
    return spheres.empty() && convex.empty();
  }  // nothing that moves by contact: triangles and planes touch these

  std::unique_ptr<SystemTerm> make_term(const Ports& ports, const std::string& name) const override;
  void check(const Model& model, const std::string& name) const override;
  void shift_references(ItemKind kind, int removed, const std::string& name, std::vector<std::string>& lost) override;
};

}  // namespace dalembert
