// The batch of a marker that passes on a frame: the closed form of its element where there is one.
#pragma once

#include <memory>

#include "dalembert/batches/planar_marker.hpp"
#include "dalembert/batches/rotating_marker.hpp"

namespace dalembert {

// Marker on a rotating node, for which a force on the whole mass acts at one point.
template <class Shape, class E>
concept RotatesWith = RotatingElement<E> && (Shape::values > 0 || RotatingBodyElement<E>);

// There is no orientation: all coordinates are components of the position, or the element declares it.
template <class E>
concept PointMotion = E::size > 0 && (E::traits.translations == E::size || !E::traits.oriented);

// Markers of points on a node whose position is among its coordinates need no more of it.
template <class E>
struct PointElement {
  using Type = E;
};
template <class Node>
  requires(Node::traits.translations == 3 && !RotatingNode<Node>)
struct PointElement<AtNode<Node>> {
  using Type = AtNode<PositionOf<Node>>;
};

// `OwnerRecord` is void for nodes. Returns nullptr if the element does not have such a frame.
template <class E, class OwnerRecord>
std::unique_ptr<MarkerBatch> make_frame_marker(FrameShape shape) {
  const auto make = [&]<template <class> class Shape, class On = E>() -> std::unique_ptr<MarkerBatch> {
    if constexpr (E::traits.planar)
      return std::make_unique<PlanarMarkerBatch<E, OwnerRecord, Shape>>();
    else if constexpr (RotatesWith<Shape<E>, E>)
      return std::make_unique<RotatingMarkerBatch<E, OwnerRecord, Shape>>();
    else
      return std::make_unique<FrameMarkerBatch<On, OwnerRecord, Shape>>();
  };
  switch (shape) {
    case FrameShape::point: return make.template operator()<PointShape, typename PointElement<E>::Type>();
    case FrameShape::rigid:
      if constexpr (PointMotion<E>)
        return nullptr;
      else
        return make.template operator()<RigidShape>();
    case FrameShape::mass:
      if constexpr (requires(const typename E::Parameters& p, const Coordinates<double, E::size>& x,
                             const Vec3<double>& g) { E::template mass_load<double>(p, x, g); })
        return make.template operator()<MassShape>();
  }
  return nullptr;
}

}  // namespace dalembert
