#include "dalembert/trees/robot_kinematics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dalembert/math/decompositions.hpp"

namespace dalembert::robots {
namespace {

constexpr double settled_error = 1e-12;   // of a pose that is reached but for rounding
constexpr double steady_step = 1e-8;      // in the null space, the last one
constexpr double longest_step = 0.2;      // in the null space, m and rad
constexpr double negligible_share = 1e-14;  // of an eigenvalue, with respect to the largest

// Euler parameters of largest scalar part without cancellation: S. W. Shepperd, Quaternion from rotation matrix, J. Guidance and
// Control 1, 1978.
Vec3<double> rotation_vector(const Mat3<double>& a) {
  const double trace = a(0, 0) + a(1, 1) + a(2, 2);
  const std::array<double, 4> squares{1 + trace, 1 + 2 * a(0, 0) - trace, 1 + 2 * a(1, 1) - trace,
                                      1 + 2 * a(2, 2) - trace};
  const std::array<std::array<double, 4>, 4> products{{
      {squares[0], a(2, 1) - a(1, 2), a(0, 2) - a(2, 0), a(1, 0) - a(0, 1)},
      {a(2, 1) - a(1, 2), squares[1], a(0, 1) + a(1, 0), a(0, 2) + a(2, 0)},
      {a(0, 2) - a(2, 0), a(0, 1) + a(1, 0), squares[2], a(1, 2) + a(2, 1)},
      {a(1, 0) - a(0, 1), a(0, 2) + a(2, 0), a(1, 2) + a(2, 1), squares[3]},
  }};
  const auto& p = products[static_cast<std::size_t>(std::ranges::max_element(squares) - squares.begin())];
  const double sign = p[0] < 0 ? -1 : 1;
  const Vec3<double> vector{sign * p[1], sign * p[2], sign * p[3]};
  const double half_sine = norm(vector);
  return half_sine == 0 ? Vec3<double>{} : (2 * std::atan2(half_sine, sign * p[0]) / half_sine) * vector;
}

double norm_of(const Vec<double, 6>& v) { return norm(v); }

double largest(std::span<const double> list) {
  double most = 0;
  for (const double x : list) most = std::max(most, std::abs(x));
  return most;
}

// A search for coordinates by damped least squares: C. W. Wampler, IEEE Trans. Systems, Man, and Cybernetics 16, 1986.
class Search {
 public:
  Search(std::span<const Link> links, const Reach& task)
      : links_(links),
        task_(task),
        joints_(links.size()),
        jacobian_(6 * links.size()),
        step_(links.size()),
        free_(links.size()) {}

  Vec<double, 6> error_at(const std::vector<double>& q) {
    place_joints(links_, task_.base, q.data(), joints_);
    return pose_error(task_.goal, frame());
  }
  // A damped step from q, where the joints have been placed last, and towards other coordinates where it is free to go there.
  // Joints at a limit that the step would leave are held.
  const std::vector<double>& step(const std::vector<double>& q, const Vec<double, 6>& error, double damping,
                                  const std::vector<double>& towards) {
    find_jacobian(links_, joints_, task_.carrier, frame().r, jacobian_.data());
    std::ranges::fill(free_, 1);
    while (true) {
      find_step(error, damping, towards);
      bool is_held = false;
      for (std::size_t i = 0; i < q.size(); ++i) {
        const bool leaves = (q[i] <= task_.lower[i] && step_[i] < 0) || (q[i] >= task_.upper[i] && step_[i] > 0);
        is_held = is_held || (leaves && free_[i] != 0);
        if (leaves) held_.push_back(i);
      }
      if (!is_held) break;
      for (const std::size_t i : held_) free_[i] = 0;
      held_.clear();
    }
    held_.clear();
    for (std::size_t i = 0; i < q.size(); ++i) step_[i] *= free_[i];
    return step_;
  }

 private:
  Pose frame() const {
    return joints_[static_cast<std::size_t>(task_.carrier)] * links_[static_cast<std::size_t>(task_.carrier)].behind *
           task_.local;
  }
  double row(int r, std::size_t i) const { return jacobian_[static_cast<std::size_t>(r) * links_.size() + i]; }

  void find_step(const Vec<double, 6>& error, double damping, const std::vector<double>& towards) {
    const std::size_t n = links_.size();
    Eigen::MatrixXd matrix(6, 6);
    Eigen::VectorXd wanted(6);
    for (int r = 0; r < 6; ++r) {
      wanted[r] = error[r];
      for (std::size_t i = 0; i < n; ++i) wanted[r] -= row(r, i) * free_[i] * towards[i];
      for (int c = 0; c < 6; ++c) {
        matrix(r, c) = r == c ? damping : 0;
        for (std::size_t i = 0; i < n; ++i) matrix(r, c) += row(r, i) * task_.compliance[i] * free_[i] * row(c, i);
      }
    }
    const SymmetricEigenpairs pairs = symmetric_eigenpairs(matrix);
    const double negligible = negligible_share * pairs.values.cwiseAbs().maxCoeff();
    Eigen::VectorXd parts = pairs.vectors.transpose() * wanted;
    for (int r = 0; r < 6; ++r) parts[r] = std::abs(pairs.values[r]) > negligible ? parts[r] / pairs.values[r] : 0;
    const Eigen::VectorXd force = pairs.vectors * parts;
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0;
      for (int r = 0; r < 6; ++r) sum += row(r, i) * force[r];
      step_[i] = task_.compliance[i] * free_[i] * sum + free_[i] * towards[i];
    }
  }

  std::span<const Link> links_;
  const Reach& task_;
  std::vector<Pose> joints_;
  std::vector<double> jacobian_, step_, free_;  // free: 1 or 0
  std::vector<std::size_t> held_;
};

}  // namespace

void place_joints(std::span<const Link> links, const Pose& base, const double* q, std::span<Pose> joints) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Link& link = links[i];
    const auto parent = static_cast<std::size_t>(link.parent);
    Pose& joint = joints[i];
    joint = (link.parent < 0 ? base : joints[parent] * links[parent].behind) * link.before;
    if (link.slides) {
      joint.r += q[i] * column(joint.A, link.axis);
      continue;
    }
    const int next = (link.axis + 1) % 3, last = (link.axis + 2) % 3;
    const double cosine = std::cos(q[i]), sine = std::sin(q[i]);
    for (int row = 0; row < 3; ++row) {
      const double y = joint.A(row, next), z = joint.A(row, last);
      joint.A(row, next) = y * cosine + z * sine;
      joint.A(row, last) = z * cosine - y * sine;
    }
  }
}

void find_jacobian(std::span<const Link> links, std::span<const Pose> joints, int link, const Vec3<double>& point,
                   double* jacobian) {
  const std::size_t n = joints.size();
  std::fill_n(jacobian, 6 * n, 0.0);
  for (int i = link; i >= 0; i = links[static_cast<std::size_t>(i)].parent) {
    const auto column_of = static_cast<std::size_t>(i);
    const Vec3<double> axis = column(joints[column_of].A, links[column_of].axis);
    const bool slides = links[column_of].slides;
    const Vec3<double> velocity = slides ? axis : cross(axis, point - joints[column_of].r);
    for (int row = 0; row < 3; ++row) {
      jacobian[static_cast<std::size_t>(row) * n + column_of] = velocity[row];
      if (!slides) jacobian[static_cast<std::size_t>(row + 3) * n + column_of] = axis[row];
    }
  }
}

void find_static_torques(std::span<const Link> links, std::span<const Pose> joints, const Vec3<double>& gravity,
                         double* torques) {
  std::fill_n(torques, links.size(), 0.0);
  for (std::size_t k = 0; k < links.size(); ++k) {
    const Pose& behind = links[k].behind;
    const Vec3<double> weight = links[k].mass * gravity,
                       centre = joints[k].r + joints[k].A * (behind.r + behind.A * links[k].centre);
    for (int i = static_cast<int>(k); i >= 0; i = links[static_cast<std::size_t>(i)].parent) {
      const auto j = static_cast<std::size_t>(i);
      const Vec3<double> axis = column(joints[j].A, links[j].axis);
      torques[j] += dot(links[j].slides ? axis : cross(axis, centre - joints[j].r), weight);
    }
  }
}

Vec<double, 6> pose_error(const Pose& goal, const Pose& pose) {
  const Vec3<double> way = goal.r - pose.r, turn = rotation_vector(goal.A * transpose(pose.A));
  return {way[0], way[1], way[2], turn[0], turn[1], turn[2]};
}

std::vector<double> reach(std::span<const Link> links, const Reach& task, std::vector<double> q, double& error) {
  Search search(links, task);
  const std::size_t n = q.size();
  double damping = 1e-3;
  Vec<double, 6> missing = search.error_at(q);
  bool is_reached = false, is_placed = true;
  std::vector<double> reached, towards(n), tried(n);
  for (int iteration = 0; iteration < task.most_iterations; ++iteration) {
    const double size = norm_of(missing);
    const bool settled = size < settled_error;
    if (settled) {
      reached = q;
      is_reached = true;
      for (std::size_t i = 0; i < n; ++i) towards[i] = task.start[i] - q[i];
      const double factor = std::min(1.0, longest_step / std::max(largest(towards), longest_step));
      for (double& x : towards) x *= factor;
    } else {
      std::ranges::fill(towards, 0.0);
    }
    if (!is_placed) search.error_at(q);
    const std::vector<double>& step = search.step(q, missing, damping * size * size, towards);
    for (std::size_t i = 0; i < n; ++i) tried[i] = std::clamp(q[i] + step[i], task.lower[i], task.upper[i]);
    const Vec<double, 6> left = search.error_at(tried);
    is_placed = settled || norm_of(left) < size;
    if (is_placed) {
      std::swap(q, tried);
      missing = left;
      damping = std::max(damping / 4, 1e-6);
      if (settled && largest(step) < steady_step) break;
    } else if (damping * size * size > 1e9) {
      break;
    } else {
      damping *= 8;
    }
  }
  if (is_reached) q = reached;
  error = norm_of(search.error_at(q));
  return q;
}

}  // namespace dalembert::robots
