// All bodies of run-time size of one type: the linear law, and the residual in sweeps. There is no other loop over
// them.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "dalembert/batches/sized_law.hpp"
#include "dalembert/batches/sized_marker.hpp"

namespace dalembert {

template <class B, class Record>
class SizedBodyBatch final : public Term {
 public:
  void add(const void* record, const Placement& placement, const Ports&) override {
    Entry e;
    e.law.place(B::order, placement, frame_size<B>);
    e.reference = placement.reference;
    read(e, record);
    make_room(work_, e);
    entries_.push_back(std::move(e));
  }
  void refresh(int entry, const void* record) override {
    Entry renewed = entries_[entry];
    read(renewed, record);
    if (!renewed.law.same_places(entries_[entry].law))
      refuse(ErrorKind::state, {"object " + std::to_string(renewed.law.item()) + " (" + std::string(B::item) + ")", "",
                                "its matrices have entries at other places than when the system was assembled", "", "",
                                "Use mbs.ModifyObject(...), then mbs.Assemble()"});
    make_room(work_, renewed);
    entries_[entry] = std::move(renewed);
  }
  // A new force vector leaves matrices and coordinates as they are.
  void refresh_row(int entry, const void* record, const Row& row) override {
    const auto& parameters = static_cast<const Record*>(record)->parameters;
    const SizedLaw law = B::law(parameters);
    if (has_residual<B> || row.name != law.force_parameter || !entries_[entry].law.take_force(law))
      return refresh(entry, record);
    entries_[entry].parameters = &parameters;
  }
  void visit(BlockVisitor& visitor, const Ports&) const override {
    for (const Entry& e : entries_) e.law.visit(visitor);
  }

  void residual(const Evaluation& evaluation, Ports&, double* r) const override {
    for (const Entry& e : entries_) {
      e.law.add_forces(evaluation, work_.law, r);
      if constexpr (has_residual<B>) {
        work_.vectors.gather(evaluation, e.law.dofs());
        add_residual(e, work_, r);
      }
      if (evaluation.inertia) e.law.add_inertia(evaluation, work_.law, r);
    }
  }
  void tangent(const Evaluation& evaluation, const Weights& w, Ports&, double* values) const override {
    SlotCursor slot(slots.data(), values);
    for (const Entry& e : entries_) {
      if (e.law.full()) {
        const std::size_t n = e.law.dofs().size();
        const std::span<double> block(work_.block.data(), n * n);
        std::ranges::fill(block, 0.0);
        if constexpr (has_residual<B>) {
          work_.vectors.gather(evaluation, e.law.dofs());
          sweep(e, w, block);
        }
        e.law.add_tangent(evaluation, w, work_.law, block);
        for (const double entry : block) slot.add(entry);
      }
      e.law.add_sparse(w, slot);
    }
  }
  void mass(const Evaluation& evaluation, Ports& ports, double* values) const override {
    tangent(evaluation, {.q = 0, .v = 0, .a = 1, .y = 0, .y_t = 0}, ports, values);
  }
  bool has_mass() const override { return B::order == 2; }
  bool constant_mass() const override {
    return !has_residual<B> && std::ranges::none_of(entries_, [](const Entry& e) { return e.law.has_mass_function(); });
  }

  // Motion in the frame; further points are mesh nodes.
  bool motion(int entry, const Evaluation& evaluation, const Vec3<double>& local, Motion<double>& m) const override {
    if constexpr (is_framed<B>) {
      m = FramePlace{.rest = local}.motion<Frame>(own_work(entries_[entry], evaluation).vectors.values());
    }
    return is_framed<B>;
  }
  bool output(int entry, OutputVariableType variable, const Vec3<double>&, const Evaluation& evaluation, const Ports&,
              std::vector<double>& values) const override {
    if (B::order != 2 || variable != OutputVariableType::Force) return false;
    const Entry& e = entries_[entry];
    const std::vector<int>& dofs = e.law.dofs();
    const auto highest = std::ranges::max_element(dofs);
    std::vector<double> r(highest == dofs.end() ? 0 : static_cast<std::size_t>(*highest) + 1, 0.0);
    Work work = own_work(e, evaluation);
    e.law.add_forces(evaluation, work.law, r.data());
    if constexpr (has_residual<B>) {
      work.vectors.stop();
      add_residual(e, work, r.data());
    }
    values.clear();
    for (const int i : dofs) values.push_back(r[i]);
    return true;
  }
  // v' M v / 2, and the work of the linear forces between the reference configuration and u, half of u (F(u) + F(0)).
  bool energy(int entry, Energy kind, const Evaluation& evaluation, double& value) const override {
    const Entry& e = entries_[entry];
    const std::vector<int>& dofs = e.law.dofs();
    if (B::order != 2 || e.law.has_mass_function() || (kind == Energy::potential && e.law.calls_forces())) return false;
    const std::size_t size = dofs.empty() ? 0 : static_cast<std::size_t>(*std::ranges::max_element(dofs)) + 1;
    const std::vector<double> none(size, 0.0);
    std::vector<double> first(size, 0.0), second(size, 0.0);
    Evaluation at = evaluation;
    at.v = at.a = none.data();
    const auto add_all = [&](const double* a, std::vector<double>& r) {
      at.a = a;
      Work work = own_work(e, at);
      e.law.add_inertia(at, work.law, r.data());
      if constexpr (has_residual<B>) add_residual(e, work, r.data());
    };
    value = 0;
    if (kind == Energy::kinetic) {
      add_all(evaluation.v, first);
      add_all(none.data(), second);
      for (const int i : dofs)
        value += 0.5 * evaluation.v[i] * (first[static_cast<std::size_t>(i)] - second[static_cast<std::size_t>(i)]);
      return true;
    }
    Work work = own_work(e, at);
    e.law.add_forces(at, work.law, first.data());
    at.u = none.data();
    e.law.add_forces(at, work.law, second.data());
    for (const int i : dofs)
      value += 0.5 * evaluation.u[i] * (first[static_cast<std::size_t>(i)] + second[static_cast<std::size_t>(i)]);
    return true;
  }
  int mesh_nodes(int entry) const override {
    if constexpr (places_mesh<B>) {
      const int count = B::mesh_nodes(*entries_[entry].parameters);
      return count > 0 ? count : -1;  // an empty element must not use the coordinates of the system
    }
    return 0;
  }
  bool mesh_outputs(int entry, int first, int count, OutputVariableType variable, const Evaluation& evaluation,
                    std::vector<double>& values) const override {
    if constexpr (places_mesh<B>) return own_mesh_outputs(entries_[entry], first, count, variable, evaluation, values);
    return false;
  }
  bool has_nodes_in_frame() const override { return B::mesh == Mesh::nodes_in_frame; }

 private:
  using Frame = typename B::Frame;

  struct Entry {
    LawOfBody law;
    std::vector<double> reference;
    const typename B::Parameters* parameters = nullptr;  // the system keeps the record
    typename B::Constants constants;
  };
  // Room that evaluations use again and again. Outputs have their own: they may be asked for in the middle of an evaluation.
  struct Work {
    GatheredVectors vectors;
    LawOfBody::Work law;
    std::vector<double> forces, block;
    std::vector<SweepDual> moving_forces;
  };
  static void make_room(Work& work, const Entry& e) {
    const std::size_t n = e.law.dofs().size();
    work.vectors.make_room(n);
    work.law.make_room(e.law);
    work.forces.resize(std::max(work.forces.size(), n));
    if (e.law.full()) work.block.resize(std::max(work.block.size(), n * n));
    work.moving_forces.resize(work.forces.size());
  }
  static Work own_work(const Entry& e, const Evaluation& evaluation) {
    Work work;
    make_room(work, e);
    work.vectors.gather(evaluation, e.law.dofs());
    return work;
  }

  static void read(Entry& e, const void* record) {
    e.parameters = &static_cast<const Record*>(record)->parameters;
    e.law.read(B::law(*e.parameters), has_residual<B>);
    if constexpr (has_residual<B>) e.constants = B::prepare(*e.parameters);
  }
  static void add_residual(const Entry& e, Work& work, double* r) {
    const std::vector<int>& dofs = e.law.dofs();
    B::template residual<double>(e.constants, work.vectors.values(), std::span(work.forces).first(dofs.size()));
    for (std::size_t i = 0; i < dofs.size(); ++i) r[dofs[i]] += work.forces[i];
  }
  void sweep(const Entry& e, const Weights& w, std::span<double> block) const {
    const std::size_t n = e.law.dofs().size();
    const std::span<SweepDual> r = std::span(work_.moving_forces).first(n);
    each_sweep(n, [&](int first, int count) {
      B::template residual<SweepDual>(e.constants, work_.vectors.template seeded<SweepDual>(w, first), r);
      for (std::size_t i = 0; i < n; ++i)
        std::copy_n(r[i].d.begin(), count, block.begin() + static_cast<std::ptrdiff_t>(i * n) + first);
    });
  }
  static bool own_mesh_outputs(const Entry& e, int first, int count, OutputVariableType variable,
                               const Evaluation& evaluation, std::vector<double>& values) {
    const typename B::Parameters& p = *e.parameters;
    GatheredVectors vectors;
    vectors.make_room(e.law.dofs().size());
    vectors.gather(evaluation, e.law.dofs());
    const SizedCoordinates<double> x = vectors.values();
    if (B::mesh_outputs(p, x, first, count, variable, values)) return true;
    const auto give = [&](const auto& row) {
      values.resize(3 * static_cast<std::size_t>(count));
      double* to = values.data();
      for (int node = first; node < first + count; ++node) to = std::ranges::copy(row(node).x, to).out;
      return true;
    };
    const auto combined = [&](const SizedVector<double>& of, int node) {
      Vec3<double> sum{};
      B::each_shape(p, node, [&](int i, const Vec3<double>& by) { sum += of[frame_size<B> + i] * by; });
      return sum;
    };
    const auto deformed = [&](int node) { return B::rest(p, node) + combined(x.u, node); };
    const Motion<double> frame = frame_motion<Frame>(x);
    const auto motion = [&](int node) {
      return motion_in(frame, deformed(node), combined(x.v, node), combined(x.a, node));
    };
    const auto position = [&](int node) { return frame.position + frame.rotation * deformed(node); };
    switch (variable) {
      case OutputVariableType::Position: return give(position);
      case OutputVariableType::Velocity: return give([&](int node) { return motion(node).velocity; });
      case OutputVariableType::Acceleration: return give([&](int node) { return motion(node).acceleration; });
      case OutputVariableType::DisplacementLocal: return give([&](int node) { return combined(x.u, node); });
      case OutputVariableType::VelocityLocal: return give([&](int node) { return combined(x.v, node); });
      case OutputVariableType::Displacement: {
        GatheredVectors reference;
        reference.make_room(e.reference.size());
        reference.rest_at(e.reference);
        const Motion<double> rest = frame_motion<Frame>(reference.values());
        return give([&](int node) { return position(node) - (rest.position + rest.rotation * B::rest(p, node)); });
      }
      default: return false;
    }
  }

  std::vector<Entry> entries_;
  mutable Work work_;
};

// `Nodes` are those that the frame may be; a body with a frame is a template Body::On<Node>.
template <class Body, class Record, class... Nodes>
struct SizedBodyPhysics final : ObjectPhysics {
  std::unique_ptr<Term> make_batch(std::span<const ItemType* const> nodes) const override {
    return choose<Term>(nodes, []<class B>() { return std::make_unique<SizedBodyBatch<B, Record>>(); });
  }
  std::unique_ptr<MarkerBatch> make_marker(FrameShape shape, std::span<const ItemType* const> nodes) const override {
    return choose<MarkerBatch>(nodes, [&]<class B>() -> std::unique_ptr<MarkerBatch> {
      if constexpr (is_framed<B>) switch (shape) {
          case FrameShape::point: return make<B, PointPort, LocalSeat>(nodes);
          case FrameShape::rigid: return make<B, RigidPort, LocalSeat>(nodes);
          case FrameShape::mass: return make<B, MassPort, MassSeat>(nodes);
        }
      return nullptr;
    });
  }
  std::unique_ptr<MarkerBatch> make_mesh_marker(FrameShape shape, std::span<const ItemType* const> nodes,
                                                MeshMeanReader read) const override {
    return choose<MarkerBatch>(nodes, [&]<class B>() -> std::unique_ptr<MarkerBatch> {
      if constexpr (B::mesh != Mesh::none) switch (shape) {
          case FrameShape::point: return make<B, PointPort, MeshSeat>(nodes, read);
          case FrameShape::rigid: return make<B, RigidPort, MeshSeat>(nodes, read);
          default: break;
        }
      return nullptr;
    });
  }
  int mesh_nodes(const void* record, const Placement& on) const override {
    if constexpr (places_mesh<Plain>) return Plain::mesh_nodes(parameters(record));
    return Plain::mesh == Mesh::nodes ? static_cast<int>(on.nodes.size()) : 0;
  }
  std::vector<int> mesh_coordinates(const void*, const Placement& on, std::span<const int> nodes) const override {
    return Plain::mesh == Mesh::nodes ? coordinates_of_nodes(on, nodes) : all_positions(on.dofs);
  }
  bool completes() const override { return Plain::computes_parameters; }
  std::shared_ptr<const void> completed(const void* record, const Placement& on, const ItemLabel& item) const override {
    if constexpr (Plain::computes_parameters) {
      check(record, on, {}, item);
      auto made = std::make_shared<Record>(*static_cast<const Record*>(record));
      Plain::complete(made->parameters, on);
      return made;
    } else {
      return nullptr;
    }
  }
  void check(const void* record, const Placement& on, const Ports&, const ItemLabel& item) const override {
    const typename Plain::Parameters& p = parameters(record);
    Plain::check(p, on, item);
    const auto all = static_cast<int>((Plain::order == 2 ? on.dofs : on.ode1).size());
    check_sizes(Plain::law(p), all - (is_framed<Plain> ? on.node_sizes[0] : 0), Plain::coordinates, item);
  }

 private:
  template <class Node>
  struct On {
    using Type = typename Body::template On<Node>;
  };
  struct Itself {
    using Type = Body;
  };
  template <class... N>
  struct FirstOf {
    using Type = Itself;
  };
  template <class N, class... Rest>
  struct FirstOf<N, Rest...> {
    using Type = On<N>;
  };
  using Plain = typename FirstOf<Nodes...>::Type::Type;  // part that does not depend on the frame
  static const typename Plain::Parameters& parameters(const void* record) {
    return static_cast<const Record*>(record)->parameters;
  }

  template <class B, class Port, template <class, class> class Seat>
  static std::unique_ptr<MarkerBatch> make(std::span<const ItemType* const> nodes, MeshMeanReader read = nullptr) {
    return std::make_unique<SizedMarkerBatch<B, Record, Port, Seat>>(nodes, read);
  }
  template <class Batch, class F>
  static std::unique_ptr<Batch> choose(std::span<const ItemType* const> nodes, const F& make) {
    static_assert(SizedBody<Plain>, "see core/include/dalembert/contracts/sized_body.hpp");
    std::unique_ptr<Batch> batch;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!Plain::takes(nodes[i]->name, static_cast<int>(i))) return nullptr;
    if constexpr (sizeof...(Nodes) == 0) {
      batch = make.template operator()<Body>();
    } else {
      (void)((!nodes.empty() && nodes[0]->name == Nodes::item
                  ? (batch = make.template operator()<typename On<Nodes>::Type>(), true)
                  : false) ||
             ...);
    }
    return batch;
  }
};

}  // namespace dalembert
