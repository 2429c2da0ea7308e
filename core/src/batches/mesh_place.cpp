#include "dalembert/batches/mesh_place.hpp"

#include <algorithm>

#include "dalembert/model/errors.hpp"

namespace dalembert {
namespace {

[[noreturn]] void complain(int marker, const std::string& problem, const std::string& expected) {
  refuse(ErrorKind::value, {"marker " + std::to_string(marker), "meshNodeNumbers", problem, "", expected, ""});
}

int first_coordinate(const Placement& on, int node) {
  int first = 0;
  for (int i = 0; i < node; ++i) first += on.node_sizes[static_cast<std::size_t>(i)];
  return first;
}

// Each number once, in the order of the list.
std::vector<int> distinct(std::span<const int> numbers) {
  std::vector<int> once;
  for (const int n : numbers)
    if (std::ranges::find(once, n) == once.end()) once.push_back(n);
  return once;
}

Mat3<double> inverse(const Mat3<double>& m) {
  const Vec3<double> a = column(m, 0), b = column(m, 1), c = column(m, 2);
  const Vec3<double> rows[] = {cross(b, c), cross(c, a), cross(a, b)};
  const double determinant = dot(a, rows[0]);
  return matrix_of<3, 3>([&](int i, int j) { return rows[i][j] / determinant; });
}

// Adds to rows(:, coordinate) the map of the effect of each coordinate on its node.
template <class Map>
std::vector<double> rows_of(const MeshNodes& mesh, const Map& map) {
  const auto n = static_cast<std::size_t>(mesh.coordinates);
  std::vector<double> rows(3 * n, 0.0);
  for (const MeshNodes::Shape& s : mesh.shapes) {
    const Vec3<double> d = map(static_cast<std::size_t>(s.node), s.by);
    for (std::size_t i = 0; i < 3; ++i) rows[i * n + static_cast<std::size_t>(s.coordinate)] += d[static_cast<int>(i)];
  }
  return rows;
}

FramePlace mean_position(const MeshNodes& mesh, const std::vector<double>& weights) {
  FramePlace place;
  for (std::size_t i = 0; i < mesh.rest.size(); ++i) place.rest += weights[i] * mesh.rest[i];
  place.translation = rows_of(mesh, [&](std::size_t node, const Vec3<double>& by) { return weights[node] * by; });
  return place;
}

}  // namespace

MeshNodes mesh_of_nodes(std::span<const int> numbers, const Placement& on, std::span<const ItemType* const> types) {
  MeshNodes mesh;
  std::vector<int> columns(types.size(), -1);  // first coordinate of each node
  for (const int number : numbers) {
    const auto i = static_cast<std::size_t>(number);
    const auto size = static_cast<std::size_t>(on.node_sizes[i]);
    if (columns[i] < 0) columns[i] = std::exchange(mesh.coordinates, mesh.coordinates + on.node_sizes[i]);
    const std::vector<double> zeros(size);
    NodeView view;
    view.q = std::span(on.reference).subspan(static_cast<std::size_t>(first_coordinate(on, number)), size);
    view.u = view.v = view.a = zeros;
    Motion<double> m;
    const auto& node = dynamic_cast<const NodePhysics&>(*types[i]->physics);
    if (!node.motion(on.node_records[i], view, m))
      complain(
          on.item,
          "mesh node " + std::to_string(number) + " is a " + std::string(types[i]->name) + ", which has no position",
          "mesh nodes with a position");
    for (int axis = 0; axis < std::min(node.translations(), on.node_sizes[i]); ++axis) {
      mesh.shapes.push_back({static_cast<int>(mesh.rest.size()), columns[i] + axis, {}});
      mesh.shapes.back().by[axis] = 1;
    }
    mesh.rest.push_back(m.position);
  }
  return mesh;
}

std::vector<int> coordinates_of_nodes(const Placement& on, std::span<const int> numbers) {
  std::vector<int> positions;
  for (const int node : distinct(numbers))
    for (int i = 0; i < on.node_sizes[static_cast<std::size_t>(node)]; ++i)
      positions.push_back(first_coordinate(on, node) + i);
  return positions;
}

// The mean rotation is that of a rigid body with the weights as masses, or one weighted by squared distances.
FramePlace mean_place(const MeshNodes& mesh, const MeshMean& mean, int marker) {
  const std::vector<double>& weights = mean.weights;
  if (weights.size() != mesh.rest.size())
    complain(marker, "the number of its mesh nodes has changed since the system was assembled",
             "as many mesh nodes as before");
  FramePlace place = mean_position(mesh, weights);
  if (mean.rotation == MeshMean::Rotation::none) return place;
  std::vector<Vec3<double>> arms;
  Vec3<double> sum{};
  Mat3<double> inertia{};
  double second_moment = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    arms.push_back(mesh.rest[i] - place.rest);
    sum += weights[i] * arms[i];
    inertia = inertia - weights[i] * (skew(arms[i]) * skew(arms[i]));
    second_moment += weights[i] * dot(arms[i], arms[i]);
  }
  if (!mean.of_momentum) inertia = second_moment * identity();
  const double determinant = dot(column(inertia, 0), cross(column(inertia, 1), column(inertia, 2)));
  if (!(std::abs(determinant) > 1e-14 * std::abs(second_moment * second_moment * second_moment)))
    complain(marker, "its weighted mesh nodes lie on a line, and define no rotation",
             "three nodes that span a plane, or more, with positive weights");
  const Mat3<double> turn = inverse(inertia);
  place.rotation = rows_of(mesh, [&](std::size_t node, const Vec3<double>& by) {
    return turn * (weights[node] * (cross(arms[node], by) - cross(sum, by)));
  });
  place.rest += mean.offset;
  place.exponential_map = mean.rotation != MeshMean::Rotation::linear;
  place.exact_rate = mean.rotation == MeshMean::Rotation::exact;
  place.turns_moments = mean.of_momentum && place.exponential_map;
  return place;
}

}  // namespace dalembert
