// Bodies and finite elements: physics of an item type from its kernel and the nodes that it stands on.
#pragma once

#include <algorithm>
#include <memory>

#include "dalembert/batches/make_frame_marker.hpp"
#include "dalembert/batches/strain_element.hpp"
#include "dalembert/batches/rotating_body.hpp"
#include "dalembert/model/errors.hpp"

namespace dalembert {

template <class Body, class Record, class... Nodes>
struct BodyPhysics final : ObjectPhysics {
  static_assert(ChecksParameters<Body>, "see core/include/dalembert/contracts/element.hpp");

  std::unique_ptr<Term> make_batch(std::span<const ItemType* const> nodes) const override {
    std::unique_ptr<Term> batch;
    choose(nodes, [&]<class E>() {
      if constexpr (RotatingBodyElement<E>)
        batch = std::make_unique<RotatingBodyBatch<E, Record>>();
      else
        batch = std::make_unique<ElementBatch<E, Record>>();
    });
    return batch;
  }
  std::unique_ptr<MarkerBatch> make_marker(FrameShape shape, std::span<const ItemType* const> nodes) const override {
    std::unique_ptr<MarkerBatch> batch;
    choose(nodes, [&]<class E>() { batch = make_frame_marker<E, Record>(shape); });
    return batch;
  }
  void check_values(const void* record, const ItemLabel& item) const override {
    Body::check(static_cast<const Record*>(record)->parameters, item);
  }
  std::string doubt(const void* record) const override {
    return Body::doubt(static_cast<const Record*>(record)->parameters);
  }
  void check(const void*, const Placement& on, const Ports&, const ItemLabel& item) const override {
    if constexpr (requires { Body::size; })
      if (static_cast<int>(on.dofs.size()) != Body::size)
        refuse(ErrorKind::value,
               {item, "nodeNumber", "", "nodes with " + std::to_string(on.dofs.size()) + " coordinates together",
                std::to_string(Body::size), ""});
  }

 private:
  template <class Node>
  static auto standing_on() {
    if constexpr (Node::size == 0)
      return std::type_identity<OnRestingNode<Body, Node>>{};
    else if constexpr (Body::traits.pure_inertia && Node::traits.translations < Node::size)
      return std::type_identity<OnNode<Body, PositionOf<Node>>>{};
    else
      return std::type_identity<OnNode<Body, Node>>{};
  }
  template <class Node>
  using StandingOn = typename decltype(standing_on<Node>())::type;

  template <class F>
  static void choose(std::span<const ItemType* const> nodes, F&& f) {
    [[maybe_unused]] const auto all = [&](std::string_view name) {
      return std::ranges::all_of(nodes, [&](const ItemType* node) { return node->name == name; });
    };
    if constexpr (requires { Body::node_items; }) {  // nodes of given types
      static_assert(ElementKernel<Body>, "see core/include/dalembert/contracts/element.hpp");
      if (std::ranges::equal(nodes, Body::node_items, {}, &ItemType::name)) f.template operator()<Body>();
    } else if constexpr (sizeof...(Nodes) == 0) {  // it rests
      static_assert(ElementKernel<Body> && Body::size == 0, "see core/include/dalembert/contracts/element.hpp");
      f.template operator()<Body>();
    } else if constexpr (requires { Body::node_counts; }) {  // different numbers of nodes
      [&]<std::size_t... i>(std::index_sequence<i...>) {
        const auto choose_count = [&]<int count>() {
          if (static_cast<int>(nodes.size()) == count)
            f.template operator()<StrainElement<typename Body::template On<count>>>();
        };
        if ((all(Nodes::item) || ...)) (choose_count.template operator()<Body::node_counts[i]>(), ...);
      }(std::make_index_sequence<Body::node_counts.size()>{});
    } else if constexpr (requires { Body::nodes; }) {  // motions of several nodes of one type
      ((all(Nodes::item) ? (f.template operator()<StrainElement<typename Body::template On<Nodes>>>(), true) : false) ||
       ...);
    } else if constexpr (requires { Body::size; }) {
      using Element = typename ElementOf<Body>::Type;
      static_assert(ElementKernel<Element>, "see core/include/dalembert/contracts/element.hpp");
      ((all(Nodes::item) ? (f.template operator()<Element>(), true) : false) || ...);
    } else {
      static_assert(BodyKernel<Body>, "see core/include/dalembert/contracts/element.hpp");
      ((nodes[0]->name == Nodes::item ? (f.template operator()<StandingOn<Nodes>>(), true) : false) || ...);
    }
  }
};

}  // namespace dalembert
