// Contract of everything with coordinates and points: bodies on a node, finite elements, nodes.
// A body on one node uses only the motion of the node (BodyKernel); OnNode combines it with the node to an element.
// An item with its own coordinates (ANCF cable) is an element itself (ElementKernel). A kernel declares its constant
// properties and closed forms in `traits`: the compiler checks their names and requires the named members. A kernel
// derives from NoCheck, NoDoubt, NoNodeOutputs or NoElementOutputs for each part that it lacks. So a member that is
// missing, misspelt or has another signature does not compile.
#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dalembert/contracts/context.hpp"
#include "dalembert/contracts/planar_node.hpp"
#include "dalembert/contracts/rotating_node.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/math/rotations.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

// Request for an output of an element. `reference` contains the coordinates of the reference configuration.
struct OutputRequest {
  OutputVariableType variable{};
  Vec3<double> local;
  std::span<const double> reference;
  bool of_reference = false;  // the reference configuration itself is asked for
};

// ---- nodes --------------------------------------------------------------------------------------------------------------
struct NodeTraits {
  int translations = 0;  // number of leading coordinates that are components of the position
  bool constant_jacobian = false;  // constant Jacobian of the motion
  bool oriented = true;            // else it has a position only
  bool planar = false;             // contracts/planar_node.hpp
  int unit_from = -1;              // coordinates from this one on form a vector of length one
  int lie_rotation = -1;  // three coordinates from this one on form a rotation vector, and take increments on the group
  bool rotation_alone = false;  // `rotation` costs less than `motion`
  bool rotation_tangent = false;  // it states the derivatives of its rotation: contracts/rotating_node.hpp
  bool in_packs = false;  // motion and pull-back take numbers side by side: batches/groups.hpp
};
// Base of kernels of nodes and bodies without a check of parameters.
struct NoCheck {
  static void check(const auto&, const ItemLabel&) {}
};
struct NoNodeOutputs {
  static bool output(OutputVariableType, const NodeView&, std::vector<double>&) { return false; }
};

template <class N>
concept RotationAlone = requires(const Coordinates<double, N::size>& x) {
  { N::template rotation<double>(x) } -> std::same_as<Mat3<double>>;
};
template <class N>
concept NodeKernel =
    requires(const typename N::Parameters& p, const Coordinates<double, N::size>& x, const Vec3<double>& w,
             const NodeView& view, const ItemLabel& item, std::vector<double>& values) {
      { N::item } -> std::convertible_to<std::string_view>;  // 'NodePoint'
      requires std::same_as<decltype(N::traits), const NodeTraits>;
      { N::template motion<double>(x) } -> std::same_as<Motion<double>>;
      { N::template pull_back<double>(x, w, w) } -> std::same_as<Vec<double, N::size>>;  // force, moment about the node
      { N::check(p, item) } -> std::same_as<void>;
      { N::output(OutputVariableType::_None, view, values) } -> std::same_as<bool>;
      requires N::traits.rotation_alone == RotationAlone<N>;
      requires N::traits.rotation_tangent == RotatingNode<N>;
    };

// A node whose coordinates take increments on the group: three of them form a rotation vector.
template <class N>
concept LieKernel = requires { requires N::traits.lie_rotation >= 0; };

// ---- bodies -------------------------------------------------------------------------------------------------------------
struct BodyTraits {
  bool constant_mass = false;  // in body axes; the node determines the mass matrix of its coordinates
  bool pure_inertia = false;  // mass times acceleration, the same in all directions, and nothing else
  bool planar_tangent = false;  // it differentiates its residual on planar nodes: contracts/planar_node.hpp
};
// Warnings about parameters that no real body has, although they can be computed.
struct NoDoubt {
  static std::string doubt(const auto&) { return {}; }
};
struct NoElementOutputs {
  static bool output(const auto&, const Context&, const auto&, const OutputRequest&, std::vector<double>&) {
    return false;
  }
};

// A body defines its inertia forces either at the frame of the node or, if they are simple in body axes, as a
// RotatingBody.
template <class B>
concept FrameBody =
    requires(const typename B::Parameters& p, const Context& c, const Motion<double>& m, const Vec3<double>& g) {
      { B::template residual<double>(p, c, m) } -> std::same_as<Wrench<double>>;  // r of M a + f = 0, at the node
      {
        B::template mass_load<double>(p, m, g)
      } -> std::same_as<Wrench<double>>;  // applied force of an acceleration field
    };
template <class B>
concept ChecksParameters = requires(const typename B::Parameters& p, const ItemLabel& item) {
  { B::check(p, item) } -> std::same_as<void>;
  { B::doubt(p) } -> std::same_as<std::string>;
};
// Body on a node with any number of coordinates.
template <class B, int N>
concept OutputsOf = requires(const typename B::Parameters& p, const Context& c, const Coordinates<double, N>& x,
                             const OutputRequest& request, std::vector<double>& values) {
  { B::output(p, c, x, request, values) } -> std::same_as<bool>;
};
template <class B>
concept BodyKernel = FrameBody<B> != RotatingBody<B> && ChecksParameters<B> &&
                     requires { requires std::same_as<decltype(B::traits), const BodyTraits>; };

// ---- elements -----------------------------------------------------------------------------------------------------------
struct ElementTraits {
  int translations = 0;  // number of leading coordinates that are components of the position
  bool constant_mass = false;  // constant mass matrix of its coordinates
  bool constant_jacobian = false;  // constant Jacobian of the motion of its points
  bool oriented = true;  // else its points have a position only
  bool planar = false;  // stands on a planar node
  bool pure_inertia = false;  // nothing without accelerations
  bool diagonal = false;  // its mass matrix
  bool tangent = false;  // it states the derivative of its residual
};
struct NoLieRotations {
  static constexpr std::array<int, 0> lie_rotations{};
};

// Parameters of an element that also reads its reference coordinates, wherever it has parameters.
template <class Given, int N>
struct WithReference : Given {
  Vec<double, N> reference{};
};
template <class P>
concept ReadsReference = requires(const P& p) { []<class Given, int N>(const WithReference<Given, N>&) {}(p); };

// An element may make constants of its parameters and reference coordinates, once: its residual gets them in addition.
template <class E>
concept PreparedKernel = requires(const typename E::Parameters& p, const Vec<double, E::size>& reference) {
  { E::prepare(p, reference) } -> std::same_as<typename E::Prepared>;
};
struct NothingPrepared {};
template <class E>
struct PreparedOf {
  using Type = NothingPrepared;
};
template <PreparedKernel E>
struct PreparedOf<E> {
  using Type = typename E::Prepared;
};
template <class E>
typename PreparedOf<E>::Type prepared(const typename E::Parameters& p, const Vec<double, E::size>& reference) {
  if constexpr (PreparedKernel<E>) {
    return E::prepare(p, reference);
  } else {
    return {};
  }
}
template <class E, class S>
Vec<S, E::size> element_residual(const typename E::Parameters& p, const typename PreparedOf<E>::Type& constants,
                                 const Context& c, const Coordinates<S, E::size>& x) {
  if constexpr (PreparedKernel<E>) {
    return E::template residual<S>(p, constants, c, x);
  } else {
    return E::template residual<S>(p, c, x);
  }
}

// The derivative of the residual along the weights, in closed form; tests compare it with differences.
template <class E>
concept TangentKernel = requires(const typename E::Parameters& p, const typename PreparedOf<E>::Type& constants,
                                 const Context& c, const Coordinates<double, E::size>& x, const Weights& w) {
  { E::tangent(p, constants, c, x, w) } -> std::same_as<Mat<double, E::size, E::size>>;
};

// An element on a node that states its rotation's derivatives (contracts/rotating_node.hpp).
template <class E>
concept RotatingElement = requires { requires !std::is_void_v<typename E::OwnRotation>; };
template <class E>
concept RotatingBodyElement = RotatingElement<E> && RotatingBody<typename E::Kernel>;

// Elements of the same law may be computed as lanes (math/pack.hpp): residual and tangent are templates over them.
// The coordinates of a node, three or more, lie side by side. Up to `most_lanes`, four or eight, are computed at once.
template <class E>
concept LaneKernel = requires(const typename E::Parameters& p, const typename PreparedOf<E>::Type& k) {
  { E::same_law(p, k, p, k) } -> std::same_as<bool>;
  requires E::most_lanes == 4 || E::most_lanes == 8;
  requires E::node_size >= 3;
};

// The residual is a constant mass matrix times accelerations, and zero without accelerations. For a body: an
// isotropic mass.
template <class E>
concept PureInertia = requires { requires E::traits.pure_inertia; };

// Bodies without closed forms that only doubles have: their arithmetic may be noted (math/traced.hpp).
template <class E>
concept TracedElement = E::size > 0 && !RotatingElement<E> && (PureInertia<E> || E::traits.planar);

template <class E>
concept ElementKernel = requires(const typename E::Parameters& p, const typename PreparedOf<E>::Type& constants,
                                 const Context& c, const Coordinates<double, E::size>& x, const Vec3<double>& local) {
  { element_residual<E, double>(p, constants, c, x) } -> std::same_as<Vec<double, E::size>>;
  { E::template motion<double>(p, x, local) } -> std::same_as<Motion<double>>;
  { E::template pull_back<double>(p, x, local, local, local) } -> std::same_as<Vec<double, E::size>>;
  { E::template mass_load<double>(p, x, local) } -> std::same_as<Vec<double, E::size>>;
  { E::lie_rotations.size() };  // starts of rotation vectors with increments on the group
  requires std::same_as<decltype(E::traits), const ElementTraits>;
  requires E::traits.tangent == TangentKernel<E>;
  requires OutputsOf<E, E::size>;
};

// Only the rotation, if a node computes it at lower cost than its motion.
template <class Node, class S>
Mat3<S> node_rotation(const Coordinates<S, Node::size>& x) {
  if constexpr (Node::traits.rotation_alone) {
    return Node::template rotation<S>(x);
  } else {
    return Node::template motion<S>(x).rotation;
  }
}

// The own axes of a node that speaks of global ones only.
template <class Node, class S>
SpinMotion<S> spin_motion(const Coordinates<S, Node::size>& x) {
  if constexpr (RotatingNode<Node>) {
    return Node::template spin_motion<S>(x);
  } else {
    const Motion<S> m = Node::template motion<S>(x);
    return {m.acceleration, m.rotation, transposed_times(m.rotation, m.angular_velocity),
            transposed_times(m.rotation, m.angular_acceleration)};
  }
}
template <class Node, class S>
Vec<S, Node::size> pull_back_spin_wrench(const Coordinates<S, Node::size>& x, const Vec3<S>& force,
                                         const Vec3<S>& moment) {
  if constexpr (RotatingNode<Node>) {
    const auto turn = Node::template pull_back_spin<S>(x, moment);
    Vec<S, Node::size> r{force[0], force[1], force[2]};
    for (int i = 3; i < Node::size; ++i) r[i] = turn[i - 3];
    return r;
  } else {
    return Node::template pull_back<S>(x, force, node_rotation<Node, S>(x) * moment);
  }
}

// Starts of rotation vectors with increments on the group, among the coordinates of an element on this node.
template <class Node>
constexpr auto lie_rotations_of() {
  if constexpr (LieKernel<Node>)
    return std::array{Node::traits.lie_rotation};
  else
    return std::array<int, 0>{};
}

// Only the position of a node, for bodies that do not rotate with it.
template <class Node>
struct PositionOf : NoNodeOutputs {
  using Parameters = typename Node::Parameters;
  static constexpr std::string_view item = Node::item;
  static constexpr int size = Node::size, dimensions = Node::traits.translations;
  static constexpr NodeTraits traits{.translations = dimensions, .constant_jacobian = true, .oriented = false};

  static void check(const Parameters& p, const ItemLabel& label) { Node::check(p, label); }
  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    Motion<S> m;
    for (int i = 0; i < dimensions; ++i) m.position[i] = x.q[i], m.velocity[i] = x.v[i], m.acceleration[i] = x.a[i];
    return m;
  }
  template <class S>
  static Vec<S, size> pull_back(const Coordinates<S, size>&, const Vec3<S>& force, const Vec3<S>&) {
    Vec<S, size> q{};
    for (int i = 0; i < dimensions; ++i) q[i] = force[i];
    return q;
  }
};

// A body on a node, as an element.
template <class Body, class Node>
struct OnNode {
  using Kernel = Body;
  using OwnRotation = std::conditional_t<RotatingNode<Node>, Node, void>;  // whose closed forms markers may use
  using Parameters = typename Body::Parameters;
  static constexpr int size = Node::size;
  static_assert(Node::size == 0 || NodeKernel<Node>, "see core/include/dalembert/contracts/element.hpp");
  static_assert(OutputsOf<Body, size>, "see core/include/dalembert/contracts/element.hpp");
  static_assert(!PlanarNode<Node> || Body::traits.planar_tangent == PlanarBody<Body, Node>,
                "see core/include/dalembert/contracts/planar_node.hpp");
  static constexpr bool pure_inertia = Body::traits.pure_inertia && Node::traits.constant_jacobian;
  static constexpr ElementTraits traits{
      .translations = Node::traits.translations,
      .constant_mass = Body::traits.constant_mass && Node::traits.constant_jacobian,
      .oriented = Node::traits.oriented,
      .planar = PlanarNode<Node>,
      .pure_inertia = pure_inertia,
      .diagonal = pure_inertia && Node::traits.translations == size,  // isotropic mass
      .tangent = PlanarBody<Body, Node>};
  static constexpr auto lie_rotations = lie_rotations_of<Node>();

  template <class S>
  static Vec<S, size> residual(const Parameters& p, const Context& c, const Coordinates<S, size>& x) {
    if constexpr (RotatingBody<Body>) {
      const SpinWrench<S> w = Body::inertia(Body::mass_properties(p), spin_motion<Node, S>(x));
      return pull_back_spin_wrench<Node, S>(x, w.force, w.moment);
    } else {
      const auto w = Body::template residual<S>(p, c, Node::template motion<S>(x));
      return Node::template pull_back<S>(x, w.force, w.moment);
    }
  }
  template <class S>
  static Mat<S, size, size> tangent(const Parameters& p, const NothingPrepared&, const Context&,
                                    const Coordinates<S, size>& x, const Weights& w)
    requires PlanarBody<Body, Node>
  {
    return Body::planar_tangent(p, x, w);
  }
  template <class S>
  static Motion<S> motion(const Parameters&, const Coordinates<S, size>& x, const Vec3<double>& local) {
    const Motion<S> at_node = Node::template motion<S>(x);
    Motion<S> point = moved(at_node, at_node.rotation * local);
    if constexpr (RotatingNode<Node>)
      point.velocity = at_node.velocity + at_node.rotation * cross(Node::template spin_motion<S>(x).spin, local);
    return point;
  }
  // The same virtual power as that of `motion`.
  template <class S>
  static Vec<S, size> pull_back(const Parameters&, const Coordinates<S, size>& x, const Vec3<double>& local,
                                const Vec3<S>& force, const Vec3<S>& moment) {
    const Mat3<S> rotation = node_rotation<Node, S>(x);
    if constexpr (RotatingNode<Node>) {
      Vec<S, size> r = Node::template pull_back<S>(x, force, moment);
      const auto turn = Node::template pull_back_spin<S>(x, cross(local, transposed_times(rotation, force)));
      for (int i = 3; i < size; ++i) r[i] += turn[i - 3];
      return r;
    }
    return Node::template pull_back<S>(x, force, moment + cross(rotation * local, force));
  }
  template <class S>
  static Vec<S, size> mass_load(const Parameters& p, const Coordinates<S, size>& x, const Vec3<S>& g) {
    if constexpr (RotatingBody<Body>) {
      return pull_back(p, x, Body::centre(p), Vec3<S>(Body::mass(p) * g), Vec3<S>{});
    } else {
      const auto w = Body::template mass_load<S>(p, Node::template motion<S>(x), g);
      return Node::template pull_back<S>(x, w.force, w.moment);
    }
  }
  static bool output(const Parameters& p, const Context& c, const Coordinates<double, size>& x,
                     const OutputRequest& request, std::vector<double>& values) {
    return Body::output(p, c, x, request, values);
  }
};

// A body on a node without coordinates: it rests with the node.
template <class Body, class Node>
struct OnRestingNode : NoLieRotations, NoElementOutputs {
  using RestingNode = Node;
  struct Parameters {
    typename Body::Parameters body;
    typename Node::Parameters node;
  };
  static constexpr int size = 0;
  static constexpr ElementTraits traits{.constant_mass = true};

  template <class S>
  static Vec<S, 0> residual(const Parameters&, const Context&, const Coordinates<S, 0>&) {
    return {};
  }
  template <class S>
  static Motion<S> motion(const Parameters& p, const Coordinates<S, 0>& x, const Vec3<double>& local) {
    const Motion<S> at_node = Node::template motion<S>(p.node, x, {});
    return moved(at_node, at_node.rotation * local);
  }
  template <class S>
  static Vec<S, 0> pull_back(const Parameters&, const Coordinates<S, 0>&, const Vec3<double>&, const Vec3<S>&,
                             const Vec3<S>&) {
    return {};
  }
  template <class S>
  static Vec<S, 0> mass_load(const Parameters&, const Coordinates<S, 0>&, const Vec3<S>&) {
    return {};
  }
};

// A node as an element of its own: for markers on nodes.
template <class Node>
struct AtNode {
  struct Parameters {};
  using OwnRotation = std::conditional_t<RotatingNode<Node>, Node, void>;
  static constexpr int size = Node::size;
  static constexpr ElementTraits traits{.translations = Node::traits.translations,
                                        .constant_jacobian = Node::traits.constant_jacobian,
                                        .oriented = Node::traits.oriented,
                                        .planar = PlanarNode<Node>};
  static constexpr auto lie_rotations = lie_rotations_of<Node>();

  template <class S>
  static Motion<S> motion(const Parameters&, const Coordinates<S, size>& x, const Vec3<double>&) {
    return Node::template motion<S>(x);
  }
  template <class S>
  static Vec<S, size> pull_back(const Parameters&, const Coordinates<S, size>& x, const Vec3<double>&,
                                const Vec3<S>& force, const Vec3<S>& moment) {
    return Node::template pull_back<S>(x, force, moment);
  }
};

// The coordinates of an element out of the system's vectors.
template <int N, class S>
Coordinates<S, N> gather(const EvaluationOf<S>& e, const int* dofs) {
  Coordinates<S, N> x;
  for (int i = 0; i < N; ++i) {
    x.q[i] = e.q[dofs[i]];
    x.v[i] = e.v[dofs[i]];
    x.a[i] = e.inertia ? e.a[dofs[i]] : S(0);
  }
  return x;
}

// Gathers coordinates with `Count` directions, from coordinate `begin` on: one derivative per coordinate, along the
// weights. Increments of a rotation vector on the group are converted to rates of its components by the inverse
// tangent map.
template <class E, int Count, class S, int N>
Coordinates<Dual<Count, S>, N> seeded_from(int begin, const Coordinates<S, N>& x, const Weights& w) {
  using D = Dual<Count, S>;
  const auto has_direction = [begin](int i) { return i >= begin && i < begin + Count; };
  const auto with_direction = [&](const S& value, int i, double weight) {
    return has_direction(i) ? D::seed(value, i - begin, weight) : D(value);
  };
  Coordinates<D, N> s;
  for (int i = 0; i < N; ++i) {
    s.q[i] = with_direction(x.q[i], i, w.q);
    s.v[i] = with_direction(x.v[i], i, w.v);
    s.a[i] = with_direction(x.a[i], i, w.a);
  }
  for (const int r : E::lie_rotations)
    if constexpr (std::is_same_v<S, double>) {
      const Vec3<double> rotation = segment<3>(x.q, r);
      for (int j = 0; j < 3; ++j) {
        if (!has_direction(r + j)) continue;
        Vec3<double> axis;
        axis[j] = 1;
        const Vec3<double> rate = rotation_vector_rate(rotation, axis);
        for (int i = 0; i < 3; ++i) s.q[r + i].d[r + j - begin] = w.q * rate[i];
      }
    }
  return s;
}
template <class E, class S, int N>
Coordinates<Dual<N, S>, N> seeded(const Coordinates<S, N>& x, const Weights& w) {
  return seeded_from<E, N>(0, x, w);
}

}  // namespace dalembert
