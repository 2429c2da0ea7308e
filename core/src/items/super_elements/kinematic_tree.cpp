// ObjectKinematicTree, specs/super_elements/kinematic_tree.toml: all trees side by side, each by recursions over its links.
#include "dalembert/items/super_elements/kinematic_tree.hpp"

#include <algorithm>
#include <string>

#include "dalembert/batches/sized_law.hpp"
#include "dalembert/math/aligned_vector.hpp"
#include "dalembert/math/wide_registers.hpp"
#include "dalembert/model/value_checks.hpp"
#include "dalembert/system/physics.hpp"
#include "dalembert/system/tree_term.hpp"
#include "dalembert/trees/articulated_bodies.hpp"
#include "dalembert/trees/joint_masses.hpp"
#include "dalembert/trees/link_loads.hpp"
#include "dalembert/trees/tree_tangent.hpp"

namespace dalembert {
namespace {

using Parameters = ObjectKinematicTreeParameters;
using Record = ObjectKinematicTreeRecord;

// Controller forces of a joint; forces and user functions are those of any body of run-time size.
SizedLaw law_of(const Parameters& p) {
  return {.force_vector = &p.jointForceVector, .force_parameter = "jointForceVector", .force = p.forceUserFunction};
}

// Links of one tree as recursions over S leave them.
template <class S>
struct Links {
  AlignedVector<LinkPlace<S>> places;
  AlignedVector<LinkMass<S>> masses;
  AlignedVector<LinkMotion<S>> motions;
  AlignedVector<LinkWrench<S>> wrenches;
  std::vector<double> placed_at;  // the coordinates that places and masses belong to

  void make(std::size_t links) {
    places.resize(links);
    masses.resize(links);
    motions.resize(links);
    wrenches.resize(links);
    placed_at.clear();
  }
  // A state is often asked for more than once.
  void place(const Tree& tree, const double* q) {
    if (std::equal(placed_at.begin(), placed_at.end(), q, q + tree.count())) return;
    placed_at.assign(q, q + tree.count());
    trees::place_links<S>(tree, q, places);
    trees::place_masses<S>(tree, places, masses);
  }
  // Null accelerations are zero.
  void find_inertia_forces(const Tree& tree, const double* q, const double* v, const double* a,
                           const Vec3<double>& gravity) {
    place(tree, q);
    trees::move_links<S>(tree, places, v, a, Vec3<S>{} + (-gravity), motions);
    for (std::size_t i = 0; i < tree.links.size(); ++i)
      wrenches[i] = trees::inertia_force(tree.links[i], masses[i], motions[i]);
  }
};

// Work space of the recursions of one tree: forces and accelerations have vectors in registers.
struct Room {
  Links<Spread> links;
  AlignedVector<ArticulatedBody<Spread>> articulated;  // used for many links
  JointMasses masses;  // of few
  Links<double> single;
  std::vector<CompositeBody<double>> bodies;
  std::vector<JointIncrement<double>> increments;
  std::vector<Vec3<double>> origins;
  std::vector<LinkLoad> loads;
  std::vector<double> block;
  LawOfBody::Work law;

  void make(std::size_t count) {
    links.make(count);
    single.make(count);
    bodies.resize(count);
    increments.resize(count);
    origins.resize(count);
  }
};

// Vectors with a number for each joint, which controllers of the user set at each step.
bool is_of_drives(const Row& row) { return row.storage == Storage::vector && row.name.starts_with("joint"); }

class TreeBody {
 public:
  explicit TreeBody(const Placement& placement) : first_(placement.dofs.empty() ? 0 : placement.dofs.front()) {
    law_.place(2, placement, 0);
  }
  void read(const Record& record) {
    const Parameters& p = record.parameters;
    law_.read(law_of(p), false);
    tree_ = tree_of(p);
    gravity_ = p.gravity;
    read_controllers(p);
    const std::size_t n = tree_.links.size();
    loads_.assign(p.linkForces.empty() && p.linkTorques.empty() ? 0 : n, {});
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      if (!p.linkForces.empty()) loads_[i].force = p.linkForces[i];
      if (!p.linkTorques.empty()) loads_[i].couple = p.linkTorques[i];
    }
  }
  // Reads the control laws and user functions that drive the joints.
  void read_drives(const Record& record) {
    law_.read(law_of(record.parameters), false);
    read_controllers(record.parameters);
  }
  void make(Room& room) const {
    room.make(tree_.links.size());
    if (count() > few_links)
      room.articulated.resize(tree_.links.size());
    else
      room.masses.make(tree_);
    room.law.make_room(law_);
  }
  int item() const { return law_.item(); }
  int count() const { return tree_.count(); }
  double reach() const {
    std::vector<double> far(tree_.links.size());
    double farthest = 0;
    for (std::size_t i = 0; i < far.size(); ++i) {
      const TreeLink& link = tree_.links[i];
      far[i] = norm(link.offset) + (link.parent < 0 ? 0 : far[static_cast<std::size_t>(link.parent)]);
      farthest = std::max(farthest, far[i] + (link.mass > 0 ? norm(link.moment) / link.mass : 0));
    }
    return farthest;
  }
  bool same_structure(const TreeBody& other) const {
    const auto alike = [](const TreeLink& a, const TreeLink& b) { return a.parent == b.parent; };
    return law_.same_places(other.law_) && std::ranges::equal(tree_.links, other.tree_.links, alike);
  }

  void visit(BlockVisitor& visitor) const {
    trees::each_pair(tree_, [&](int k, int j) {
      visitor.entry(first_ + k, first_ + j);
      if (j != k) visitor.entry(first_ + j, first_ + k);
    });
    law_.visit(visitor);
  }

  void add_residual(const Evaluation& e, Room& room, double* r) const {
    in_wide_registers([&] { add_own_forces(e, room.links, r); });
    law_.add_forces(e, room.law, r);
  }
  void add_mass(const Evaluation& e, double factor, Room& room, SlotCursor& slot) const {
    Links<double>& links = room.single;
    links.place(tree_, q(e));
    trees::compose<double>(tree_, links.places, links.masses, room.bodies);
    trees::mass_matrix<double>(tree_, links.places, room.bodies, [&](int k, int j, double m) {
      slot.add(factor * m);
      if (j != k) slot.add(factor * m);
    });
    if (law_.full()) slot.skip(count() * count());
  }
  void add_tangent(const Evaluation& e, const Weights& w, Room& room, SlotCursor& slot) const {
    Links<double>& links = room.single;
    links.find_inertia_forces(tree_, q(e), v(e), accelerations(e), gravity_);
    trees::sum_to_base<double>(tree_, links.places, links.wrenches, [](std::size_t, double) {});
    trees::compose<double>(tree_, links.places, links.masses, links.motions, room.bodies);
    for (std::size_t i = 0; i < tree_.links.size(); ++i)
      room.increments[i] = trees::increment_of(tree_.links[i], links.places[i].axis, links.motions[i], w);
    if (!loads_.empty()) {
      room.loads = loads_;
      trees::sum_to_base(tree_, links.places, room.loads);
    }
    const auto add = [&](int k, int j, double row, double column) {
      const auto behind = static_cast<std::size_t>(k), before = static_cast<std::size_t>(j);
      if (!loads_.empty()) {
        const trees::LoadChange change = trees::load_change(tree_, links.places, room.loads, k, j);
        row -= w.q * change.of_behind;
        column -= w.q * change.of_before;
      }
      if (j == k) row += w.q * stiffness_[behind] + w.v * damping_[before];
      slot.add(row);
      if (j != k) slot.add(column);
    };
    trees::tangent<double>(tree_, links.places, room.bodies, links.wrenches, room.increments, w, add);
    if (!law_.full()) return;
    room.block.assign(tree_.links.size() * tree_.links.size(), 0.0);
    law_.add_tangent(e, w, room.law, room.block);
    for (const double entry : room.block) slot.add(entry);
  }

  int solve_masses(const Evaluation& e, Room& room, double* x) const {
    int loose = -1;
    in_wide_registers([&] {
      Links<Spread>& links = room.links;
      links.place(tree_, q(e));
      loose = count() > few_links ? trees::accelerate<Spread>(tree_, links.places, links.masses, room.articulated,
                                                              links.wrenches, x + first_)
                                  : trees::accelerate(tree_, links.places, links.masses, room.masses, x + first_);
    });
    return loose < 0 ? -1 : first_ + loose;
  }

  Motion<double> motion(const Evaluation& e, int link, const Vec3<double>& local, Room& room) const {
    Links<double>& links = room.single;
    links.place(tree_, q(e));
    trees::move_links<double>(tree_, links.places, v(e), e.a + first_, {}, links.motions);
    trees::find_origins<double>(tree_, links.places, room.origins);
    const auto i = static_cast<std::size_t>(link);
    return trees::motion_at(links.places[i], links.motions[i], room.origins[i], local);
  }
  // Everything but inertia forces of accelerations.
  void forces(Evaluation e, std::vector<double>& values) const {
    Room room;
    make(room);
    std::vector<double> r(static_cast<std::size_t>(first_ + count()), 0.0);
    e.inertia = false;
    add_residual(e, room, r.data());
    values.assign(r.begin() + first_, r.end());
  }
  // v' M v / 2, or the work against weight, forces on links and joint forces since the reference configuration, and the
  // springs of the joint controllers.
  bool energy(Energy kind, Evaluation e, double& value) const {
    if (kind == Energy::potential && law_.calls_forces()) return false;
    Room room;
    make(room);
    value = 0;
    Links<double>& links = room.single;
    links.place(tree_, q(e));
    if (kind == Energy::kinetic) {
      const std::vector<double> rest(tree_.links.size(), 0.0);
      links.find_inertia_forces(tree_, q(e), rest.data(), v(e), {});
      trees::sum_to_base<double>(tree_, links.places, links.wrenches,
                                 [&](std::size_t i, double force) { value += 0.5 * v(e)[i] * force; });
      return true;
    }
    const double* const u = e.u + first_;
    std::vector<double> reference(q(e), q(e) + count()), forces(static_cast<std::size_t>(first_ + count()), 0.0);
    for (std::size_t i = 0; i < reference.size(); ++i) reference[i] -= u[i];
    const auto work_of_places = [&](double sign) {
      trees::find_origins<double>(tree_, links.places, room.origins);
      for (std::size_t i = 0; i < tree_.links.size(); ++i) {
        const Vec3<double> force = tree_.links[i].mass * gravity_ + (loads_.empty() ? Vec3<double>{} : loads_[i].force);
        value -= sign * (dot(force, room.origins[i]) + dot(gravity_, links.masses[i].moment));
      }
    };
    work_of_places(1);
    links.place(tree_, reference.data());
    work_of_places(-1);
    law_.add_forces(e, room.law, forces.data());
    for (std::size_t i = 0; i < reference.size(); ++i) {
      const double turn = q(e)[i] - desired_[i];
      value += 0.5 * stiffness_[i] * turn * turn + u[i] * forces[static_cast<std::size_t>(first_) + i];
    }
    return true;
  }
  void coordinates(const Evaluation& e, std::vector<double>& values) const { values.assign(q(e), q(e) + count()); }

 private:
  void read_controllers(const Parameters& p) {
    const auto fill = [n = tree_.links.size()](const std::vector<double>& from, std::vector<double>& list) {
      list = from;
      list.resize(n);
    };
    fill(p.jointPControlVector, stiffness_);
    fill(p.jointDControlVector, damping_);
    fill(p.jointPositionOffsetVector, desired_);
    fill(p.jointVelocityOffsetVector, desired_rates_);
  }
  const double* q(const Evaluation& e) const { return e.q + first_; }
  const double* v(const Evaluation& e) const { return e.v + first_; }

  const double* accelerations(const Evaluation& e) const { return e.inertia ? e.a + first_ : nullptr; }

  // Inertia, weight, loads and controllers.
  DALEMBERT_INLINE void add_own_forces(const Evaluation& e, Links<Spread>& links, double* r) const {
    links.find_inertia_forces(tree_, q(e), v(e), accelerations(e), gravity_);
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      links.wrenches[i].force -= loads_[i].force;
      links.wrenches[i].moment -= loads_[i].couple;
    }
    trees::sum_to_base<Spread>(tree_, links.places, links.wrenches, [&](std::size_t i, const Spread& force) {
      r[first_ + static_cast<int>(i)] +=
          number(force) - stiffness_[i] * (desired_[i] - q(e)[i]) - damping_[i] * (desired_rates_[i] - v(e)[i]);
    });
  }

  Tree tree_;
  LawOfBody law_;
  int first_ = 0;  // start of its coordinates
  Vec3<double> gravity_{};
  std::vector<double> stiffness_, damping_, desired_, desired_rates_;  // controllers of joints
  std::vector<LinkLoad> loads_;
};

class KinematicTreeBatch final : public Term, public LinkedBodies, public MassSolver {
 public:
  void add(const void* record, const Placement& placement, const Ports&) override {
    for (const Entry& other : entries_) share_a_node_ = share_a_node_ || other.node == placement.nodes.front();
    Entry& e = entries_.emplace_back(placement);
    e.read(record);
  }
  void refresh(int entry, const void* record) override {
    TreeBody renewed = entries_[entry].body;
    renewed.read(*static_cast<const Record*>(record));
    if (!renewed.same_structure(entries_[entry].body))
      refuse(ErrorKind::state, {"object " + std::to_string(renewed.item()) + " (ObjectKinematicTree)", "",
                                "it had no user function, or other parents of links, when the system was assembled", "",
                                "", "Use mbs.ModifyObject(...), then mbs.Assemble()"});
    entries_[entry].read(record);
  }
  void refresh_row(int entry, const void* record, const Row& row) override {
    if (!is_of_drives(row)) return refresh(entry, record);
    entries_[entry].body.read_drives(*static_cast<const Record*>(record));
  }
  void visit(BlockVisitor& visitor, const Ports&) const override {
    for (const Entry& e : entries_) e.body.visit(visitor);
  }
  void residual(const Evaluation& evaluation, Ports&, double* r) const override {
    for (const Entry& e : entries_) e.body.add_residual(evaluation, e.room, r);
  }
  void tangent(const Evaluation& evaluation, const Weights& w, Ports&, double* values) const override {
    SlotCursor slot(slots.data(), values);
    for (const Entry& e : entries_) e.body.add_tangent(evaluation, w, e.room, slot);
  }
  void mass(const Evaluation& evaluation, Ports&, double* values) const override {
    SlotCursor slot(slots.data(), values);
    for (const Entry& e : entries_) e.body.add_mass(evaluation, 1, e.room, slot);
  }
  bool has_mass() const override { return true; }
  bool constant_mass() const override { return false; }
  bool is_separate() const override { return !share_a_node_; }
  int solve_masses(const Evaluation& evaluation, double* x) const override {
    for (const Entry& e : entries_)
      if (const int loose = e.body.solve_masses(evaluation, e.room, x); loose >= 0) return loose;
    return -1;
  }

  bool output(int entry, OutputVariableType variable, const Vec3<double>&, const Evaluation& evaluation, const Ports&,
              std::vector<double>& values) const override {
    const TreeBody& body = entries_[entry].body;
    if (variable == OutputVariableType::Coordinates)
      body.coordinates(evaluation, values);
    else if (variable == OutputVariableType::Force)
      body.forces(evaluation, values);
    else
      return false;
    return true;
  }
  bool energy(int entry, Energy kind, const Evaluation& evaluation, double& value) const override {
    return entries_[entry].body.energy(kind, evaluation, value);
  }
  int links(int entry) const override { return entries_[entry].body.count(); }
  double reach(int entry) const override { return entries_[entry].body.reach(); }
  Motion<double> link_motion(int entry, int link, const Vec3<double>& local,
                             const Evaluation& evaluation) const override {
    return entries_[entry].body.motion(evaluation, link, local, entries_[entry].output_room);
  }

 private:
  struct Entry {
    int node;
    TreeBody body;
    mutable Room room, output_room;  // outputs may be asked for in the middle of an evaluation

    explicit Entry(const Placement& placement) : node(placement.nodes.front()), body(placement) {}
    void read(const void* record) {
      body.read(*static_cast<const Record*>(record));
      body.make(room);
      body.make(output_room);
    }
  };
  std::vector<Entry> entries_;
  bool share_a_node_ = false;
};

void check_length(const char* parameter, std::size_t given, int links, bool required, const ItemLabel& item) {
  if (given == static_cast<std::size_t>(links) || (given == 0 && !required)) return;
  refuse(ErrorKind::value, {item, parameter, "", "a list of length " + std::to_string(given),
                            "a list of length " + std::to_string(links) +
                                ", one entry for each coordinate of the node" + (required ? "" : ", or none"),
                            ""});
}

void check_lengths(const Parameters& p, int links, const ItemLabel& item) {
  check_length("jointTypes", p.jointTypes.size(), links, true, item);
  check_length("linkParents", p.linkParents.size(), links, true, item);
  check_length("jointTransformations", p.jointTransformations.size(), links, true, item);
  check_length("jointOffsets", p.jointOffsets.size(), links, true, item);
  check_length("linkInertiasCOM", p.linkInertiasCOM.size(), links, true, item);
  check_length("linkCOMs", p.linkCOMs.size(), links, true, item);
  check_length("linkMasses", p.linkMasses.size(), links, true, item);
  check_length("linkForces", p.linkForces.size(), links, false, item);
  check_length("linkTorques", p.linkTorques.size(), links, false, item);
  check_length("jointForceVector", p.jointForceVector.size(), links, false, item);
  check_length("jointPositionOffsetVector", p.jointPositionOffsetVector.size(), links, false, item);
  check_length("jointVelocityOffsetVector", p.jointVelocityOffsetVector.size(), links, false, item);
  check_length("jointPControlVector", p.jointPControlVector.size(), links, false, item);
  check_length("jointDControlVector", p.jointDControlVector.size(), links, false, item);
  check_length("linkNames", p.linkNames.size(), links, false, item);
  check_length("jointNames", p.jointNames.size(), links, false, item);
}

void check_names(const char* parameter, const std::vector<std::string>& names, const ItemLabel& item) {
  for (std::size_t i = 1; i < names.size(); ++i)
    if (const auto before = names.begin() + static_cast<std::ptrdiff_t>(i);
        !names[i].empty() && std::find(names.begin(), before, names[i]) != before)
      refuse(ErrorKind::value, {item, parameter, "", "'" + names[i] + "' twice", "names that differ",
                                "Links without a name have an empty string"});
}

void check_link(const Parameters& p, int i, const ItemLabel& item) {
  const auto at = static_cast<std::size_t>(i);
  const std::string entry = "entry " + std::to_string(i) + ": ";
  if (p.jointTypes[at] == JointType::_None)
    refuse(ErrorKind::value, {item, "jointTypes", "", entry + "JointType._None", "a revolute or prismatic joint", ""});
  if (const int parent = p.linkParents[at]; parent < -1 || parent >= i)
    refuse(ErrorKind::value,
           {item, "linkParents", "", entry + std::to_string(parent), "a link with a smaller number, or -1 for the base",
            "Number the links such that parents come before their children"});
  if (!(p.linkMasses[at] >= 0))
    refuse(ErrorKind::value,
           {item, "linkMasses", "", entry + std::to_string(p.linkMasses[at]), "masses that are not negative", ""});
  if (const Verdict verdict = judge_inertia(p.linkMasses[at], p.linkInertiasCOM[at], {}); verdict.fit == Fit::wrong)
    refuse(ErrorKind::value,
           {item, "linkInertiasCOM", "entry " + std::to_string(i) + " is not an inertia about the centre of mass",
            verdict.problem, "symmetric matrices without negative principal moments", ""});
}

struct KinematicTree final : ObjectPhysics {
  std::unique_ptr<Term> make_batch(std::span<const ItemType* const>) const override {
    return std::make_unique<KinematicTreeBatch>();
  }
  void check_row(const void* record, const Placement& on, const Ports& ports, const ItemLabel& item,
                 const Row& row) const override {
    if (!is_of_drives(row)) return check(record, on, ports, item);
    check_lengths(static_cast<const Record*>(record)->parameters, static_cast<int>(on.dofs.size()), item);
  }
  void check(const void* record, const Placement& on, const Ports&, const ItemLabel& item) const override {
    const Parameters& p = static_cast<const Record*>(record)->parameters;
    const int links = static_cast<int>(on.dofs.size());
    if (links == 0)
      refuse(ErrorKind::value, {item, "nodeNumber", "its node has no coordinates", "",
                                "a NodeGenericODE2 with one coordinate per link", ""});
    check_lengths(p, links, item);
    check_names("linkNames", p.linkNames, item);
    check_names("jointNames", p.jointNames, item);
    for (int i = 0; i < links; ++i) check_link(p, i, item);
  }
};

}  // namespace

const Physics& object_kinematic_tree_physics() {
  static const KinematicTree physics;
  return physics;
}

}  // namespace dalembert
