// Trees of rigid links, each with a parent joint of one coordinate, which rotates about or slides along an axis:
// constants, positions and motions, computed from the base to the leaves. Vectors are in global axes. Moments and
// inertias of a link are about the origin of its frame, which lies on the axis of its joint: on the path to the
// parent they are shifted, not rotated, and numbers remain of the size of the links. Accelerations are those of
// points, not spatial ones. The recursions are those of R. Featherstone, Rigid Body Dynamics Algorithms, Springer,
// 2008.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "dalembert/frames.hpp"
#include "dalembert/math/pack_functions.hpp"
#include "dalembert/math/spread.hpp"
#include "dalembert/math/tensors.hpp"

namespace dalembert {

struct TreeLink {
  int parent = -1;                              // -1: the base; parents come before their children
  bool slides = false;  // prismatic joint; otherwise revolute
  int axis = 0;                                 // x, y or z of its frame
  Mat3<double> orientation = identity<double>();  // orientation of its frame in that of the parent, at coordinate zero
  Vec3<double> offset{};  // position of its origin in the frame of the parent, at coordinate zero
  double mass = 0;
  Vec3<double> moment{};  // mass times centre of mass, in the frame of the link
  Mat3<double> inertia{};  // about the origin of the link
};

struct Tree {
  std::vector<TreeLink> links;
  Vec3<double> base{};  // origin of the base, whose axes are the global ones

  int count() const { return static_cast<int>(links.size()); }
};

// Pose of a link.
template <class S>
struct LinkPlace {
  S sine, cosine;  // sine and cosine of its coordinate
  Mat3<S> rotation;  // A_0l, of the frame of the link
  Vec3<S> axis;  // axis of its joint
  Vec3<S> arm;  // from the origin of the parent to that of the link
};

// How its mass lies there.
template <class S>
struct LinkMass {
  Vec3<S> moment;  // mass times centre of mass, from the origin of the link
  Mat3<S> inertia;  // about the origin
};

// How it moves: its frame as a whole, and the origin of that.
template <class S>
struct LinkMotion {
  Vec3<S> spin, spin_rate, velocity, acceleration;
};

// Recursions are inlined into the functions that select the registers (math/wide_registers.hpp): separate functions
// would use the baseline instruction set.
namespace trees {

// Sines and cosines of all coordinates; single states process four at a time.
template <class S>
DALEMBERT_INLINE inline void find_sines(const NumberOf<S>* q, std::span<LinkPlace<S>> places) {
  const auto keep = [](LinkPlace<S>& place, const S& sine, const S& cosine) {
    place.sine = sine;
    place.cosine = cosine;
  };
  if constexpr (holds_packs<S>) {
    each_sine_cosine(q, places.size(), [&](std::size_t i, const S& sine, const S& cosine) DALEMBERT_INLINE {
      keep(places[i], sine, cosine);
    });
  } else {
    for (std::size_t first = 0; first < places.size(); first += 4) {
      const std::size_t count = std::min<std::size_t>(4, places.size() - first);
      const auto [sine, cosine] =
          sine_cosine(Pack<4>::of_each([&](std::size_t lane) { return q[first + std::min(lane, count - 1)]; }));
      for (std::size_t i = 0; i < count; ++i)
        keep(places[first + i], sine[static_cast<int>(i)], cosine[static_cast<int>(i)]);
    }
  }
}

// Calls f.operator()<axis>(): constants known at compile time stay in registers.
template <class F>
DALEMBERT_INLINE inline void with_axis(int axis, const F& f) {
  if (axis == 2)
    f.template operator()<2>();
  else if (axis == 1)
    f.template operator()<1>();
  else
    f.template operator()<0>();
}

// Turns the other two axes of the frame of a link.
template <int axis, class S>
DALEMBERT_INLINE inline void turn_about(Mat3<S>& rotation, const S& sine, const S& cosine) {
  constexpr int y = (axis + 1) % 3, z = (axis + 2) % 3;
  const Vec3<S> along_y = column(rotation, y), along_z = column(rotation, z);
  set_column(rotation, y, cosine * along_y + sine * along_z);
  set_column(rotation, z, cosine * along_z - sine * along_y);
}

template <class S>
DALEMBERT_INLINE inline void place_links(const Tree& tree, const NumberOf<S>* q, std::span<LinkPlace<S>> places) {
  find_sines(q, places);
  const Mat3<S> A_00 = diagonal(S(1.0));
  Mat3<S> A_0l = A_00;  // rotation of the previous link; for chains this is the parent
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink& link = tree.links[i];
    LinkPlace<S>& place = places[i];
    if (link.parent + 1 != static_cast<int>(i))
      A_0l = link.parent < 0 ? A_00 : places[static_cast<std::size_t>(link.parent)].rotation;
    place.arm = A_0l * link.offset;
    A_0l = A_0l * link.orientation;
    with_axis(link.axis, [&]<int axis>() {
      place.axis = column(A_0l, axis);
      if (link.slides)
        place.arm += q[i] * place.axis;
      else
        turn_about<axis>(A_0l, place.sine, place.cosine);
    });
    place.rotation = A_0l;
  }
}

template <class S>
DALEMBERT_INLINE inline void place_masses(const Tree& tree, std::span<const LinkPlace<S>> places,
                                          std::span<LinkMass<S>> masses) {
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink& link = tree.links[i];
    masses[i] = {places[i].rotation * link.moment, turned(places[i].rotation, link.inertia)};
  }
}

// `base`: the acceleration of the base; minus gravity, if it acts. If `a` is null, joint accelerations are zero.
template <class S>
DALEMBERT_INLINE inline void move_links(const Tree& tree, std::span<const LinkPlace<S>> places, const NumberOf<S>* v,
                                        const NumberOf<S>* a, const Vec3<S>& base, std::span<LinkMotion<S>> motions) {
  const LinkMotion<S> rest{{}, {}, {}, base};
  LinkMotion<S> own = rest;  // motion of the previous link at first
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink& link = tree.links[i];
    const Vec3<S>&axis = places[i].axis, &arm = places[i].arm;
    if (link.parent + 1 != static_cast<int>(i))
      own = link.parent < 0 ? rest : motions[static_cast<std::size_t>(link.parent)];
    const Vec3<S> swing = cross(own.spin, arm), turning = v[i] * cross(own.spin, axis);
    own.velocity += swing;
    own.acceleration += crosses(own.spin_rate, arm, own.spin, swing);
    if (link.slides) {
      own.velocity += v[i] * axis;
      own.acceleration += turning + turning;
      if (a != nullptr) own.acceleration += a[i] * axis;
    } else {
      own.spin += v[i] * axis;
      own.spin_rate += turning;
      if (a != nullptr) own.spin_rate += a[i] * axis;
    }
    motions[i] = own;
  }
}

// Origins of the links.
template <class S>
void find_origins(const Tree& tree, std::span<const LinkPlace<S>> places, std::span<Vec3<S>> origins) {
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const int parent = tree.links[i].parent;
    origins[i] = places[i].arm + (parent < 0 ? Vec3<S>{} + tree.base : origins[static_cast<std::size_t>(parent)]);
  }
}

// The motion of a point that is fixed to a link.
template <class S>
Motion<S> motion_at(const LinkPlace<S>& place, const LinkMotion<S>& link, const Vec3<S>& origin,
                    const Vec3<double>& r_l) {
  const Vec3<S> r_0 = place.rotation * r_l, swing = cross(link.spin, r_0);
  return {.position = origin + r_0,
          .velocity = link.velocity + swing,
          .acceleration = link.acceleration + crosses(link.spin_rate, r_0, link.spin, swing),
          .rotation = place.rotation,
          .angular_velocity = link.spin,
          .angular_acceleration = link.spin_rate};
}

}  // namespace trees
}  // namespace dalembert
