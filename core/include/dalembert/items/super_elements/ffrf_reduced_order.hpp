// ObjectFFRFreducedOrder, specs/super_elements/ffrf_reduced_order.toml: a body frame F, in whose axes the mesh deforms by modes.
//
// Let w and w_t be the spin of F and its rate, and a the acceleration of its origin, all in the axes of F. A point of the mesh that
// is at y = x + Psi zeta accelerates by
//
//      a + w_t x y + w x (w x y) + 2 w x (Psi zeta_t) + Psi zeta_tt .
//
// Its virtual work with translations, rotations and modes, summed up over the mass, leaves integrals that are constant: A. Zwoelfer
// and J. Gerstmayr, Acta Mechanica 232 (2021); A. A. Shabana, Dynamics of Multibody Systems, chapter 5. By i and j, modes:
//
//      mPhitTPsi          int Psi_j                 first moments
//      mXRefTildePsi      -int x x Psi_j            mXRefTildePsiTilde   -int x~ Psi_j~       a~ b = a x b
//      mPsiTildePsi       -int Psi_i x Psi_j        mPsiTildePsiTilde    -int Psi_i~ Psi_j~
#pragma once

#include "dalembert/contracts/sized_body.hpp"
#include "dalembert/super_elements/ffrf_reduced_order_parameters.hpp"

namespace dalembert {

// The integrals, ordered such that products with modal coordinates read contiguous memory.
struct ModalInertia {
  bool acts = false;
  int modes = 0;
  double mass = 0;
  Vec3<double> moment{};  // mass times centre of mass
  Mat3<double> inertia{};  // inertia of the undeformed body, about the origin of the frame
  std::vector<Vec3<double>> moments, arms;  // per mode, mPhitTPsi and mXRefTildePsi
  std::vector<Mat3<double>> inertias;  // per mode, mXRefTildePsiTilde
  std::vector<double> crossed, products;  // per mode, 3 and 9 rows of modes: mPsiTildePsi, mPsiTildePsiTilde

  std::span<const double> rows(const std::vector<double>& of, int first, int count) const {
    return {of.data() + static_cast<std::size_t>(first * modes), static_cast<std::size_t>(count * modes)};
  }
};

struct ObjectFFRFreducedOrder {
  using Parameters = ObjectFFRFreducedOrderParameters;
  using Constants = ModalInertia;
  static constexpr std::string_view item = "ObjectFFRFreducedOrder";
  static constexpr int order = 2;
  static constexpr std::string_view coordinates = "modal coordinates of the object";
  static constexpr Mesh mesh = Mesh::own;
  static constexpr bool computes_parameters = true;

  static bool takes(std::string_view node, int position) { return position == 0 || node == "NodeGenericODE2"; }
  static SizedLaw law(const Parameters& p);
  static void check(const Parameters& p, const Placement& on, const ItemLabel& item);
  // The derived integrals, unless they are given.
  static void complete(Parameters& p, const Placement& on);
  static ModalInertia prepare(const Parameters& p);

  static int mesh_nodes(const Parameters& p) { return static_cast<int>(p.referencePositions.size() / 3); }
  static Vec3<double> rest(const Parameters& p, int node) {
    return load<double, 3>(p.referencePositions.data() + 3 * node);
  }
  template <class Shape>
  static void each_shape(const Parameters& p, int node, const Shape& shape) {
    const int modes = p.modeBasis.columns;
    const double* const rows = p.modeBasis.values.data() + static_cast<std::ptrdiff_t>(3 * node) * modes;
    for (int mode = 0; mode < modes; ++mode)
      shape(mode, Vec3<double>{rows[mode], rows[modes + mode], rows[2 * modes + mode]});
  }
  // The variable of outputVariableModeBasis: linear in the modal coordinates, which come last.
  static bool mesh_outputs(const Parameters& p, const SizedCoordinates<double>& x, int first, int count,
                           OutputVariableType variable, std::vector<double>& values);

  template <class Node>
  struct On;
};

// Coordinates of the node that is its frame.
template <class Node>
struct ObjectFFRFreducedOrder::On : ObjectFFRFreducedOrder {
  using Frame = Node;

  static FramePlace whole_mass(const Parameters& p) {
    const auto modes = static_cast<std::size_t>(p.mPhitTPsi.columns), n = Node::size + modes;
    FramePlace place{.scale = p.physicsMass,
                     .rest = p.physicsMass * p.physicsCenterOfMass,
                     .translation = std::vector<double>(3 * n)};
    for (std::size_t axis = 0; axis < (modes > 0 ? 3 : 0); ++axis)
      std::copy_n(p.mPhitTPsi.values.begin() + static_cast<std::ptrdiff_t>(axis * modes), modes,
                  place.translation.begin() + static_cast<std::ptrdiff_t>(axis * n + Node::size));
    return place;
  }

  template <class S>
  static void residual(const ModalInertia& k, const SizedCoordinates<S>& x, std::span<S> r) {
    std::ranges::fill(r, S(0));
    if (!k.acts) return;
    const auto at_node = x.template of_first<Node>();
    const SpinMotion<S> frame = spin_motion<Node, S>(at_node);
    const Mat3<S>& A_0F = frame.rotation;
    const Vec3<S>&w = frame.spin, &w_t = frame.spin_rate, a = transposed_times(A_0F, frame.acceleration);
    Vec3<S> s = Vec3<S>{} + k.moment, s_t{}, s_tt{}, moment{};
    Mat3<S> inertia = Mat3<S>{} + k.inertia, changing{};  // and half of its rate, as far as it makes moments
    for (int j = 0; j < k.modes; ++j) {
      const S zeta = x.u[Node::size + j], zeta_t = x.v[Node::size + j], zeta_tt = x.a[Node::size + j];
      const Mat3<S> n = inertia_by(k, j, x.u);
      const auto crossed = k.rows(k.crossed, 3 * j, 3);
      const Vec3<S> arm = k.arms[j] + x.combined(x.u, crossed, Node::size),
                    arm_t = x.combined(x.v, crossed, Node::size);
      s += zeta * k.moments[j];
      s_t += zeta_t * k.moments[j];
      s_tt += zeta_tt * k.moments[j];
      const Mat3<S> both = n + transpose(k.inertias[j]);
      for (int i = 0; i < 9; ++i) inertia.x[i] += zeta * both.x[i], changing.x[i] += zeta_t * n.x[i];
      moment -= zeta_tt * arm;
      r[Node::size + j] = dot(k.moments[j], a) - dot(arm, w_t) - dot(w, n * w) - 2.0 * dot(arm_t, w);
    }
    moment += cross(s, a) + inertia * w_t + cross(w, inertia * w) + 2.0 * (changing * w);
    const Vec3<S> force = k.mass * a + cross(w_t, s) + cross(w, cross(w, s)) + 2.0 * cross(w, s_t) + s_tt;
    const auto whole = pull_back_spin_wrench<Node, S>(at_node, A_0F * force, moment);
    for (int i = 0; i < Node::size; ++i) r[i] = whole[i];
  }

 private:
  // The integral -int (x + Psi zeta)~ Psi_j~, whose symmetric part is half of the derivative of the inertia with
  // respect to mode j.
  template <class S>
  static Mat3<S> inertia_by(const ModalInertia& k, int j, const SizedVector<S>& zeta) {
    Mat3<S> n = Mat3<S>{} + k.inertias[j];
    for (int entry = 0; entry < 9; ++entry)
      n.x[entry] += zeta.combined(k.rows(k.products, 9 * j + entry, 1), Node::size);
    return n;
  }
};

}  // namespace dalembert
