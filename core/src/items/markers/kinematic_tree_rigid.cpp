// MarkerKinematicTreeRigid, specs/markers/kinematic_tree_rigid.toml: points of links. Markers on one tree share their
// computations.
#include <algorithm>
#include <string>

#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/items/super_elements/kinematic_tree.hpp"
#include "dalembert/markers/kinematic_tree_rigid_parameters.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/system/physics.hpp"
#include "dalembert/trees/link_loads.hpp"
#include "dalembert/trees/tree_tangent.hpp"

namespace dalembert {
namespace {

using Parameters = MarkerKinematicTreeRigidParameters;
using TreeParameters = ObjectKinematicTreeParameters;

const Parameters& parameters(const void* record) {
  return static_cast<const MarkerKinematicTreeRigidRecord*>(record)->parameters;
}
const TreeParameters& tree_parameters(const void* record) {
  return static_cast<const ObjectKinematicTreeRecord*>(record)->parameters;
}

// Joints between the base and a link, those at the base first.
std::vector<int> path_to(const TreeParameters& p, int link) {
  std::vector<int> path;
  for (int i = link; i >= 0; i = p.linkParents[static_cast<std::size_t>(i)]) path.push_back(i);
  std::ranges::reverse(path);
  return path;
}

// The links of one tree that carry markers, with those between them and the base.
class CarryingLinks {
 public:
  CarryingLinks(const void* owner, int first) : owner_(owner), first_(first) {}

  bool is_of(const void* owner, int first) const { return owner_ == owner && first_ == first; }
  // Returns numbers among these links.
  std::vector<int> carry(const std::vector<int>& path) {
    std::vector<int> own;
    for (const int number : path) {
      const auto place = static_cast<int>(std::ranges::find(numbers_, number) - numbers_.begin());
      if (place == static_cast<int>(numbers_.size())) {
        numbers_.push_back(number);
        parents_.push_back(own.empty() ? -1 : own.back());
      }
      own.push_back(place);
    }
    refresh(owner_);
    return own;
  }
  void refresh(const void* owner) {
    owner_ = owner;
    tree_ = {{}, tree_parameters(owner).baseOffset};
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      tree_.links.push_back(link_of(tree_parameters(owner), static_cast<std::size_t>(numbers_[i])));
      tree_.links.back().parent = parents_[i];
    }
    const std::size_t n = numbers_.size();
    for (auto* list : {&q_, &v_, &a_}) list->resize(n);
    placed_at_.clear();
    places_.resize(n);
    motions_.resize(n);
    origins_.resize(n);
    loads_.resize(n);
  }

  const Tree& tree() const { return tree_; }
  int dof(int link) const { return first_ + numbers_[static_cast<std::size_t>(link)]; }
  std::vector<LinkLoad>& loads() { return loads_; }
  std::span<const LinkPlace<double>> places() const { return places_; }
  const LinkPlace<double>& place(int link) const { return places_[static_cast<std::size_t>(link)]; }
  const LinkMotion<double>& motion(int link) const { return motions_[static_cast<std::size_t>(link)]; }
  const Vec3<double>& origin(int link) const { return origins_[static_cast<std::size_t>(link)]; }

  // A state is evaluated more than once, and user functions may request other states in between.
  void go_to(const Evaluation& e) {
    gather(e.q, q_);
    if (q_ == placed_at_) return;
    placed_at_ = q_;
    trees::place_links<double>(tree_, q_.data(), places_);
    trees::find_origins<double>(tree_, places_, origins_);
  }
  void move(const Evaluation& e) {
    go_to(e);
    gather(e.v, v_);
    trees::move_links<double>(tree_, places_, v_.data(), nullptr, {}, motions_);
  }
  void accelerate(const Evaluation& e) {
    go_to(e);
    gather(e.v, v_);
    gather(e.a, a_);
    trees::move_links<double>(tree_, places_, v_.data(), a_.data(), {}, motions_);
  }

 private:
  void gather(const double* from, std::vector<double>& to) const {
    for (std::size_t i = 0; i < numbers_.size(); ++i) to[i] = from[first_ + numbers_[i]];
  }

  const void* owner_;
  int first_;  // coordinate of the tree
  std::vector<int> numbers_, parents_;  // numbers in the tree, and parents among these links
  Tree tree_;
  std::vector<double> q_, v_, a_, placed_at_;
  std::vector<LinkPlace<double>> places_;
  std::vector<LinkMotion<double>> motions_;
  std::vector<Vec3<double>> origins_;
  std::vector<LinkLoad> loads_;
};

class LinkMarkerBatch final : public MarkerBatch {
 public:
  int value_count(const void*, const Placement&) const override { return RigidPort::values; }
  int force_count(const void*, const Placement&) const override { return RigidPort::forces; }
  void add(const void* record, const Placement& placement, const Ports&) override {
    const Parameters& p = parameters(record);
    const std::vector<int> path = path_to(tree_parameters(placement.owner), p.linkNumber);
    const int first = placement.dofs.front() - path.front();
    auto tree = std::ranges::find_if(trees_, [&](const CarryingLinks& t) { return t.is_of(placement.owner, first); });
    const bool is_first = tree == trees_.end();
    if (is_first) tree = trees_.emplace(tree, placement.owner, first);
    entries_.push_back({placement.item, static_cast<std::size_t>(tree - trees_.begin()), is_first, tree->carry(path),
                        p.localPosition});
  }
  void refresh(int entry, const void* record) override { entries_[entry].local = parameters(record).localPosition; }
  void refresh_owner(int entry, const void* record) override {
    if (entries_[entry].is_first) tree_of(entries_[entry]).refresh(record);
  }
  void visit(BlockVisitor& visitor, const Ports&) const override {
    for (const CarryingLinks& tree : trees_)
      trees::each_pair(tree.tree(), [&](int k, int j) {
        visitor.entry(tree.dof(k), tree.dof(j));
        if (j != k) visitor.entry(tree.dof(j), tree.dof(k));
      });
  }

  void evaluate(const Evaluation& evaluation, Ports& ports) const override {
    for (CarryingLinks& tree : trees_) tree.move(evaluation);
    for (const Entry& e : entries_) {
      const Motion<double> m = motion_of(e, tree_of(e));
      *reinterpret_cast<RigidFrame<double>*>(ports.frame(e.marker)) = {m.position, m.velocity, m.rotation,
                                                                       m.angular_velocity};
    }
  }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& w, Ports& ports) const override {
    for (CarryingLinks& tree : trees_) tree.move(evaluation);
    for (const Entry& e : entries_)
      for (std::size_t i = 0; i < e.path.size(); ++i) differentiate(e, i, w, ports);
  }
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override {
    collect(evaluation, ports);
    for (CarryingLinks& tree : trees_)
      for (int i = 0; i < tree.tree().count(); ++i) {
        const LinkLoad& load = tree.loads()[static_cast<std::size_t>(i)];
        const Vec3<double> acting = tree.tree().links[static_cast<std::size_t>(i)].slides ? load.force : load.moment();
        r[tree.dof(i)] -= dot(tree.place(i).axis, acting);
      }
  }
  bool geometric_follows_tangent() const override { return false; }
  void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports,
                 double* values) const override {
    collect(evaluation, ports);
    SlotCursor slot(slots.data(), values);
    for (CarryingLinks& tree : trees_)
      trees::each_pair(tree.tree(), [&](int k, int j) {
        const trees::LoadChange change = trees::load_change(tree.tree(), tree.places(), tree.loads(), k, j);
        slot.add(-weights.q * change.of_behind);
        if (j != k) slot.add(-weights.q * change.of_before);
      });
  }
  bool motion(int entry, const Evaluation& evaluation, Motion<double>& m) const override {
    const Entry& e = entries_[entry];
    CarryingLinks tree = tree_of(e);  // an output may be asked for in the middle of an evaluation
    tree.accelerate(evaluation);
    m = motion_of(e, tree);
    return true;
  }

 private:
  struct Entry {
    int marker = -1;
    std::size_t tree = 0;
    bool is_first = false;  // first of the markers on this tree
    std::vector<int> path;  // among the carrying links, from the base on
    Vec3<double> local;
  };
  CarryingLinks& tree_of(const Entry& e) const { return trees_[e.tree]; }
  static Motion<double> motion_of(const Entry& e, const CarryingLinks& tree) {
    const int link = e.path.back();
    return trees::motion_at(tree.place(link), tree.motion(link), tree.origin(link), e.local);
  }

  // Column i of the derivatives along the weights, and of the Jacobian: the effect of joint i of the path on the
  // frame.
  void differentiate(const Entry& e, std::size_t i, const Weights& w, Ports& ports) const {
    const CarryingLinks& tree = tree_of(e);
    const int joint = e.path[i];
    const Vec3<double>& axis = tree.place(joint).axis;
    const LinkMotion<double>& before = tree.motion(joint);
    const RigidFrame<double>& frame = read_frame<RigidPort>(ports, e.marker);
    RigidFrame<double> change{};
    Wrench<double> along{axis, {}};  // components of a force and a moment along the joint
    const Vec3<double> turning = cross(before.spin, axis), added = w.v * axis + w.q * turning;
    if (tree.tree().links[static_cast<std::size_t>(joint)].slides) {
      change.position = w.q * axis;
      change.velocity = added;
    } else {
      const Vec3<double> arm = frame.position - tree.origin(joint);
      along = {cross(axis, arm), axis};
      change.position = w.q * along.force;
      change.velocity = w.q * cross(axis, frame.velocity - before.velocity) + cross(added, arm);
      for (int c = 0; c < 3; ++c) {
        const Vec3<double> turned = w.q * cross(axis, column(frame.rotation, c));
        for (int row = 0; row < 3; ++row) change.rotation(row, c) = turned[row];
      }
      change.angular_velocity = w.q * cross(axis, frame.angular_velocity) + added;
    }
    const std::size_t n = e.path.size();
    const auto* changes = reinterpret_cast<const double*>(&change);
    for (std::size_t k = 0; k < RigidPort::values; ++k) ports.derivative(e.marker)[k * n + i] = changes[k];
    const auto* rows = reinterpret_cast<const double*>(&along);
    for (std::size_t k = 0; k < RigidPort::forces; ++k) ports.jacobian(e.marker)[k * n + i] = rows[k];
  }

  // Sums forces on the links from the leaves to the base.
  void collect(const Evaluation& evaluation, const Ports& ports) const {
    for (CarryingLinks& tree : trees_) {
      tree.go_to(evaluation);
      std::ranges::fill(tree.loads(), LinkLoad{});
    }
    for (const Entry& e : entries_) {
      CarryingLinks& tree = tree_of(e);
      const int link = e.path.back();
      const double* force = ports.force(e.marker);
      tree.loads()[static_cast<std::size_t>(link)].add(tree.place(link).rotation * e.local, load<double, 3>(force),
                                                       load<double, 3>(force + 3));
    }
    for (CarryingLinks& tree : trees_) trees::sum_to_base(tree.tree(), tree.places(), tree.loads());
  }

  std::vector<Entry> entries_;
  mutable std::vector<CarryingLinks> trees_;
};

struct KinematicTreeRigid final : MarkerPhysics {
  void check(const void* record, const Placement& on, const Ports&, const ItemLabel& item) const override {
    if (on.owner_type->name != "ObjectKinematicTree")
      refuse(ErrorKind::value,
             {item, "objectNumber", "", std::string(on.owner_type->name), "an ObjectKinematicTree", ""});
    const auto& parents = tree_parameters(on.owner).linkParents;
    const int link = parameters(record).linkNumber, links = static_cast<int>(parents.size());
    if (link < 0 || link >= links)
      refuse(ErrorKind::value,
             {item, "linkNumber", "", std::to_string(link), "a link from 0 to " + std::to_string(links - 1), ""});
    for (int i = 0; i < links; ++i)
      if (parents[static_cast<std::size_t>(i)] >= i)
        refuse(ErrorKind::value, {item, "objectNumber", "the parents of its links have no smaller numbers", "",
                                  "a tree whose linkParents are right", ""});
  }
  std::vector<int> coordinates(const void* record, const Placement& on) const override {
    return path_to(tree_parameters(on.owner), parameters(record).linkNumber);
  }
  std::unique_ptr<MarkerBatch> make_batch(const ItemType&, std::span<const ItemType* const>) const override {
    return std::make_unique<LinkMarkerBatch>();
  }
};

}  // namespace

const Physics& marker_kinematic_tree_rigid_physics() {
  static const KinematicTreeRigid physics;
  return physics;
}

}  // namespace dalembert
