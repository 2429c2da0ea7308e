// The mean position and rotation of mesh nodes that are the object's own nodes.
#include <algorithm>
#include <cmath>

#include "dalembert/batches/mesh_marker.hpp"
#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/markers/super_element_rigid_parameters.hpp"
#include "dalembert/math/rotations.hpp"
#include "dalembert/model/errors.hpp"

namespace dalembert {
namespace {

using Parameters = MarkerSuperElementRigidParameters;

const Parameters& parameters(const void* record) { return static_cast<const MarkerSuperElementRigidRecord*>(record)->parameters; }

// Where a node rests, from its reference coordinates.
Vec3<double> reference_position(const ItemType& type, const void* record, std::span<const double> reference) {
  const std::vector<double> zeros(reference.size());
  NodeView view;
  view.q = reference;
  view.u = view.v = view.a = zeros;
  Motion<double> m;
  dynamic_cast<const NodePhysics&>(*type.physics).motion(record, view, m);
  return m.position;
}

// d(rotation vector)/dt to local angular velocity, for the exponential map.
template <class S>
Mat3<S> tangent_map(const Vec3<S>& rotation) {
  S sinc, versine, residue;
  const S square = dot(rotation, rotation);
  RodriguesSeries::terms(square, sinc, versine, residue);
  const Mat3<S> k = skew(rotation), kk = k * k;
  Mat3<S> t = identity<S>();
  for (int i = 0; i < 9; ++i) t.x[i] += residue * kk.x[i] - versine * k.x[i];
  return t;
}

Mat3<double> inverse(const Mat3<double>& m) {
  Mat3<double> r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
      r(j, i) = m(a, c) * m(b, d) - m(a, d) * m(b, c);
    }
  const double determinant = m(0, 0) * r(0, 0) + m(0, 1) * r(1, 0) + m(0, 2) * r(2, 0);
  for (double& x : r.x) x /= determinant;
  return r;
}

// The weighted nodes of one marker, in the reference configuration.
struct Patch {
  Parameters parameters;
  std::vector<Vec3<double>> rest, arms;  // positions, and those relative to their mean
  Mat3<double> inverse_inertia;          // of the weights about their mean

  // False if the nodes do not define a rotation.
  bool prepare() {
    Vec3<double> mean{};
    for (std::size_t i = 0; i < rest.size(); ++i) mean += weight(i) * rest[i];
    Mat3<double> inertia{};
    double second_moment = 0;
    arms.clear();
    for (std::size_t i = 0; i < rest.size(); ++i) {
      arms.push_back(rest[i] - mean);
      const Mat3<double> k = skew(arms[i]), kk = k * k;
      for (int j = 0; j < 9; ++j) inertia.x[j] -= weight(i) * kk.x[j];
      second_moment += weight(i) * dot(arms[i], arms[i]);
    }
    if (!parameters.useAlternativeApproach) {
      inertia = {};
      for (int j = 0; j < 3; ++j) inertia(j, j) = second_moment;
    }
    inverse_inertia = inverse(inertia);
    const double size = second_moment * second_moment * second_moment;
    const double determinant = 1 / dot(column(inverse_inertia, 0), cross(column(inverse_inertia, 1), column(inverse_inertia, 2)));
    return std::isfinite(determinant) && std::abs(determinant) > 1e-14 * size;
  }
  double weight(std::size_t i) const { return parameters.weightingFactors[i]; }

  template <class S>
  RigidFrame<S> frame(const std::vector<PointFrame<S>>& nodes) const {
    RigidFrame<S> f{};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      f.position += weight(i) * nodes[i].position;
      f.velocity += weight(i) * nodes[i].velocity;
    }
    const Vec3<S> angle = rotation(nodes);
    Vec3<S> rate{};
    for (std::size_t i = 0; i < nodes.size(); ++i) rate += weight(i) * cross(arms[i], nodes[i].velocity - f.velocity);
    rate = inverse_inertia * rate;
    f.position += parameters.offset;
    if (parameters.rotationsExponentialMap == 0) {
      f.rotation = identity<S>() + skew(angle);
    } else {
      f.rotation = rotation_vector_rotation(angle);
    }
    if (parameters.rotationsExponentialMap == 2) rate = tangent_map(angle) * rate;
    f.angular_velocity = f.rotation * rate;
    return f;
  }

  // The mean rotation vector.
  template <class S>
  Vec3<S> rotation(const std::vector<PointFrame<S>>& nodes) const {
    Vec3<S> mean{}, sum{};
    for (std::size_t i = 0; i < nodes.size(); ++i) mean += weight(i) * (nodes[i].position - rest[i]);
    for (std::size_t i = 0; i < nodes.size(); ++i) sum += weight(i) * cross(arms[i], nodes[i].position - rest[i] - mean);
    return inverse_inertia * sum;
  }

  // A force and a moment on the marker, shared out to the nodes.
  template <class S>
  std::vector<Force<S>> forces(const std::vector<PointFrame<S>>& nodes, const double* wrench) const {
    Vec3<S> moment{S(wrench[3]), S(wrench[4]), S(wrench[5])};
    if (parameters.useAlternativeApproach && parameters.rotationsExponentialMap > 0)
      moment = transposed_times(tangent_map(rotation(nodes)), moment);
    moment = transposed_times(inverse_inertia, moment);
    std::vector<Force<S>> shares(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Vec3<S> f = cross(moment, arms[i]);
      for (int j = 0; j < 3; ++j) f[j] += wrench[j];
      shares[i].force = weight(i) * f;
    }
    return shares;
  }
};

class MeshRigidBatch final : public MarkerBatch {
 public:
  explicit MeshRigidBatch(std::span<const ItemType* const> nodes) : types_(nodes.begin(), nodes.end()) {}

  int value_count(const void*, const Placement&) const override { return RigidPort::values; }
  int force_count(const void*, const Placement&) const override { return RigidPort::forces; }

  void add(const void* record, const Placement& placement, const Ports&) override {
    Entry e;
    e.marker = placement.item;
    e.patch.parameters = parameters(record);
    std::span<const int> dofs = placement.dofs;
    for (const int node : e.patch.parameters.meshNodeNumbers) {
      const auto size = static_cast<std::size_t>(placement.node_sizes[node]);
      int before = 0;
      for (int i = 0; i < node; ++i) before += placement.node_sizes[i];
      const void* node_record = placement.node_records[node];
      e.nodes.push_back(nodes_.add(*types_[node], FrameShape::point, node_record, dofs.first(size)));
      if (e.nodes.back() < 0)
        complain(e.marker, "mesh node " + std::to_string(node) + " is a " + std::string(types_[node]->name) + ", which has no position",
                 "mesh nodes with a position");
      e.patch.rest.push_back(reference_position(*types_[node], node_record, std::span(placement.reference).subspan(before, size)));
      dofs = dofs.subspan(size);
    }
    if (!e.patch.prepare()) complain(e.marker, "its mesh nodes lie on a line, and define no rotation", "three nodes that span a plane, or more");
    entries_.push_back(std::move(e));
  }
  void refresh(int entry, const void* record) override {
    Entry& e = entries_[entry];
    Patch renewed = e.patch;
    renewed.parameters = parameters(record);
    if (renewed.parameters.weightingFactors.size() != renewed.rest.size())
      complain(e.marker, "the number of its mesh nodes has changed since the system was assembled", "as many mesh nodes as before");
    if (!renewed.prepare()) complain(e.marker, "its weights define no rotation", "positive weights");
    e.patch = std::move(renewed);
  }
  // The part of each marker, then the parts of its nodes.
  void visit(BlockVisitor& visitor, const Ports& ports) const override {
    for (const Entry& e : entries_) visitor.block(ports.marker_dofs(e.marker), ports.marker_dofs(e.marker));
    nodes_.visit(visitor);
  }

  void evaluate(const Evaluation& evaluation, Ports& ports) const override {
    nodes_.evaluate(evaluation);
    for (const Entry& e : entries_) {
      const RigidFrame<double> frame = e.patch.frame(e.frames(nodes_.ports));
      std::copy_n(reinterpret_cast<const double*>(&frame), RigidPort::values, ports.frame(e.marker));
    }
  }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    nodes_.evaluate_tangent(evaluation, weights);
    for (const Entry& e : entries_) {
      const int n = ports.ports[e.marker].n;
      double* derivative = ports.derivative(e.marker);
      for (int first = 0; first < n; first += sweep_width) {
        const RigidFrame<SweepDual> frame = e.patch.frame(e.moving_frames(nodes_.ports, first));
        const auto* values = reinterpret_cast<const SweepDual*>(&frame);
        for (int i = 0; i < RigidPort::values; ++i)
          for (int j = first; j < std::min(n, first + sweep_width); ++j) derivative[i * n + j] = values[i].d[j - first];
      }
      set_jacobian(e, n, ports.jacobian(e.marker));
    }
  }
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override {
    share_forces(ports);
    nodes_.pull_back(evaluation, r);
  }
  void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports, double* values) const override {
    share_forces(ports);
    std::span<const int> slot = slots;
    for (const Entry& e : entries_) {
      const int n = ports.ports[e.marker].n;
      for (int first = 0; first < n; first += sweep_width) {
        const auto shares = e.patch.forces(e.moving_frames(nodes_.ports, first), ports.force(e.marker));
        int offset = 0;
        for (std::size_t i = 0; i < e.nodes.size(); ++i) {
          Columns<1> columns(nodes_.ports, {e.nodes[i]});
          columns.offset[0] = std::exchange(offset, offset + columns.total);
          columns.total = n;
          scatter_forces<PointPort, 1>(nodes_.ports, {e.nodes[i]}, columns, first, -1.0, {shares[i]}, slot.data(), values);
        }
      }
      slot = slot.subspan(static_cast<std::size_t>(n * n));
    }
    nodes_.geometric(evaluation, weights, slot, values);
  }
  bool motion(int entry, const Evaluation& evaluation, Motion<double>& m) const override {
    nodes_.evaluate(evaluation);
    const RigidFrame<double> f = entries_[entry].patch.frame(entries_[entry].frames(nodes_.ports));
    m = {.position = f.position, .velocity = f.velocity, .rotation = f.rotation, .angular_velocity = f.angular_velocity};
    return true;
  }

 private:
  struct Entry {
    Patch patch;
    int marker = -1;
    std::vector<int> nodes;  // ports, one per mesh node

    std::vector<PointFrame<double>> frames(const Ports& ports) const {
      std::vector<PointFrame<double>> f;
      for (const int node : nodes) f.push_back(read_frame<PointPort>(ports, node));
      return f;
    }
    std::vector<PointFrame<SweepDual>> moving_frames(const Ports& ports, int first) const {
      std::vector<PointFrame<SweepDual>> f;
      int offset = 0;
      for (const int node : nodes) {
        f.push_back(read_moving_frame<PointPort>(ports, node, offset, first));
        offset += ports.ports[node].n;
      }
      return f;
    }
  };

  [[noreturn]] static void complain(int marker, const std::string& problem, const std::string& expected) {
    refuse(ErrorKind::value, {"marker " + std::to_string(marker) + " (MarkerSuperElementRigid)", "meshNodeNumbers", problem, "", expected, ""});
  }

  void share_forces(const Ports& ports) const {
    nodes_.clear_forces();
    for (const Entry& e : entries_) {
      const auto shares = e.patch.forces(e.frames(nodes_.ports), ports.force(e.marker));
      for (std::size_t i = 0; i < e.nodes.size(); ++i) add_forces<PointPort, 1>(nodes_.ports, {e.nodes[i]}, 1.0, {shares[i]});
    }
  }
  void set_jacobian(const Entry& e, int n, double* jacobian) const {
    const auto frames = e.frames(nodes_.ports);
    for (int row = 0; row < RigidPort::forces; ++row) {
      std::array<double, RigidPort::forces> unit{};
      unit[row] = 1;
      const auto shares = e.patch.forces(frames, unit.data());
      int column = row * n;
      for (std::size_t i = 0; i < e.nodes.size(); ++i) {
        const int own = nodes_.ports.ports[e.nodes[i]].n;
        const double* of_node = nodes_.ports.jacobian(e.nodes[i]);
        for (int j = 0; j < own; ++j, ++column) {
          jacobian[column] = 0;
          for (int k = 0; k < PointPort::forces; ++k) jacobian[column] += of_node[k * own + j] * shares[i].force[k];
        }
      }
    }
  }

  std::vector<const ItemType*> types_;
  std::vector<Entry> entries_;
  mutable InnerMarkers nodes_;  // its ports are work space
};

}  // namespace

std::unique_ptr<MarkerBatch> make_mesh_rigid_marker(std::span<const ItemType* const> nodes) {
  return std::make_unique<MeshRigidBatch>(nodes);
}

}  // namespace dalembert
