// Kinematics of the links of a robot, as dalembert.robotics has them: read from its objects at each call, as they are then.
#include "dalembert/trees/robot_kinematics.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <optional>

#include "dalembert/model/errors.hpp"
#include "module.hpp"

namespace dalembert::robots {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

Pose read_pose(const double* t) {
  return {{t[0], t[1], t[2], t[4], t[5], t[6], t[8], t[9], t[10]}, {t[3], t[7], t[11]}};
}
void write_pose(const Pose& pose, double* to) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) to[4 * row + column] = pose.A(row, column);
    to[4 * row + 3] = pose.r[row];
    to[12 + row] = 0;
  }
  to[15] = 1;
}

// The words are kept as long as the module is.
struct Names {
  PyObject *jointType = word("jointType"), *parent = word("parent"), *preHT = word("_preHT"),
           *localHT = word("_localHT"), *mass = word("mass"), *COM = word("COM");
  static PyObject* word(const char* text) { return PyUnicode_InternFromString(text); }
};

class Attributes {
 public:
  explicit Attributes(py::handle of) : of_(of) {}
  py::object get(PyObject* name) const {
    PyObject* value = PyObject_GetAttr(of_.ptr(), name);
    if (value == nullptr) throw py::error_already_set();
    return py::reinterpret_steal<py::object>(value);
  }
  Numbers numbers(PyObject* name, py::ssize_t size) const {
    Numbers found = Numbers::ensure(get(name));
    if (!found) throw py::error_already_set();
    if (found.size() != size)
      throw py::value_error("Robot: a link has another number of values in " + std::string(py::str(py::handle(name))));
    return found;
  }

 private:
  py::handle of_;
};

std::vector<Link> read_links(const py::list& links, bool with_mass = false) {
  static const Names names;
  std::vector<Link> result;
  result.reserve(links.size());
  for (const py::handle object : links) {
    const Attributes link(object);
    const std::string type = link.get(names.jointType).cast<std::string>();
    Link& read = result.emplace_back();
    read.parent = link.get(names.parent).cast<int>();
    if (read.parent < -1 || read.parent >= static_cast<int>(result.size()) - 1)
      throw py::value_error("Robot: link " + std::to_string(result.size() - 1) + " has no parent before it");
    read.slides = type.at(0) != 'R';
    read.axis = type.at(1) - 'x';
    read.before = read_pose(link.numbers(names.preHT, 16).data());
    read.behind = read_pose(link.numbers(names.localHT, 16).data());
    if (!with_mass) continue;
    read.mass = link.get(names.mass).cast<double>();
    const Numbers centre = link.numbers(names.COM, 3);
    read.centre = {centre.at(0), centre.at(1), centre.at(2)};
  }
  return result;
}

// The transformations of some joints, each an array of one or many states.
class Placed {
 public:
  explicit Placed(const py::sequence& HT) {
    for (const py::handle T : HT) {
      arrays_.push_back(Numbers::ensure(T));
      const Numbers& array = arrays_.back();
      if (!array) throw py::error_already_set();
      if (array.ndim() < 2 || array.shape(array.ndim() - 1) != 4 || array.shape(array.ndim() - 2) != 4 ||
          array.size() != arrays_[0].size())
        throw py::value_error("Robot: HT: expected a list of 4x4 transformations, as JointHT returns it");
    }
  }
  std::size_t count() const { return arrays_.size(); }
  py::ssize_t states() const { return arrays_.empty() ? 0 : arrays_[0].size() / 16; }
  // The shape of results: that of the states, and `more`.
  std::vector<py::ssize_t> shape(std::initializer_list<py::ssize_t> more) const {
    std::vector<py::ssize_t> all;
    if (!arrays_.empty()) all.assign(arrays_[0].shape(), arrays_[0].shape() + arrays_[0].ndim() - 2);
    all.insert(all.end(), more);
    return all;
  }
  void read(py::ssize_t state, std::vector<Pose>& joints) const {
    joints.clear();
    for (const Numbers& array : arrays_) joints.push_back(read_pose(array.data() + 16 * state));
  }

 private:
  std::vector<Numbers> arrays_;
};

Numbers joint_poses(const py::list& links, const Numbers& base, const Numbers& q) {
  const std::vector<Link> read = read_links(links);
  const auto n = static_cast<py::ssize_t>(read.size());
  std::vector<py::ssize_t> shape{n};
  shape.insert(shape.end(), q.shape(), q.shape() + q.ndim() - 1);
  shape.insert(shape.end(), {4, 4});
  Numbers result(shape);
  std::vector<Pose> joints(read.size());
  const py::ssize_t states = n == 0 ? 0 : q.size() / n;
  for (py::ssize_t k = 0; k < states; ++k) {
    place_joints(read, read_pose(base.data()), q.data() + k * n, joints);
    for (py::ssize_t i = 0; i < n; ++i)
      write_pose(joints[static_cast<std::size_t>(i)], result.mutable_data() + 16 * (i * states + k));
  }
  return result;
}

// Points: one, or one for each state; none: the origins of the link.
Numbers jacobian(const py::list& links, const py::sequence& HT, int link, const std::optional<Numbers>& points) {
  const std::vector<Link> read = read_links(links);
  const Placed placed(HT);
  const auto n = static_cast<py::ssize_t>(placed.count());
  if (link >= n) throw py::value_error("Robot.Jacobian: HT has no transformation of link " + std::to_string(link));
  if (points && points->size() != 3 && points->size() != 3 * placed.states())
    throw py::value_error("Robot.Jacobian: toolPosition: expected a vector with 3 components");
  Numbers result(placed.shape({6, n}));
  std::vector<Pose> joints;
  for (py::ssize_t k = 0; k < placed.states(); ++k) {
    placed.read(k, joints);
    Vec3<double> point;
    if (points) {
      const double* at = points->data() + (points->size() == 3 ? 0 : 3 * k);
      point = {at[0], at[1], at[2]};
    } else {
      point = (joints[static_cast<std::size_t>(link)] * read[static_cast<std::size_t>(link)].behind).r;
    }
    find_jacobian(read, joints, link, point, result.mutable_data() + 6 * n * k);
  }
  return result;
}

Numbers static_torques(const py::list& links, const py::sequence& HT, const std::array<double, 3>& gravity) {
  const std::vector<Link> read = read_links(links, true);
  const Placed placed(HT);
  if (placed.count() != read.size())
    throw py::value_error("Robot.StaticTorques: HT: expected a transformation for each link");
  Numbers result(placed.shape({static_cast<py::ssize_t>(read.size())}));
  std::vector<Pose> joints;
  for (py::ssize_t k = 0; k < placed.states(); ++k) {
    placed.read(k, joints);
    find_static_torques(read, joints, {gravity}, result.mutable_data() + k * static_cast<py::ssize_t>(read.size()));
  }
  return result;
}

std::vector<double> list_of(const Numbers& array) { return {array.data(), array.data() + array.size()}; }

py::tuple reach_pose(const py::list& links, const Numbers& base, int carrier, const Numbers& local, const Numbers& goal,
                     const Numbers& start, const Numbers& compliance, const Numbers& lower, const Numbers& upper,
                     int most_iterations) {
  const std::vector<Link> read = read_links(links);
  for (const Numbers& each : {start, compliance, lower, upper})
    if (each.size() != static_cast<py::ssize_t>(read.size()))
      throw py::value_error("InverseKinematicsNumerical: the robot has other links than before");
  if (carrier < 0 || carrier >= static_cast<int>(read.size()))
    throw py::value_error("InverseKinematicsNumerical: no joint moves this frame");
  const Reach task{.base = read_pose(base.data()),
                   .goal = read_pose(goal.data()),
                   .carrier = carrier,
                   .local = read_pose(local.data()),
                   .start = list_of(start),
                   .compliance = list_of(compliance),
                   .lower = list_of(lower),
                   .upper = list_of(upper),
                   .most_iterations = most_iterations};
  double error = 0;
  const std::vector<double> q = reach(read, task, task.start, error);
  return py::make_tuple(Numbers(static_cast<py::ssize_t>(q.size()), q.data()), error);
}

}  // namespace
}  // namespace dalembert::robots

namespace dalembert {

void register_robot_kinematics(py::module_& module) {
  module.def("_joint_poses", &robots::joint_poses, py::arg("links"), py::arg("base"), py::arg("q"),
             "Transformations of the joints of a robot, one after the other; states are rows of q.");
  module.def("_robot_jacobian", &robots::jacobian, py::arg("links"), py::arg("HT"), py::arg("link"), py::arg("points"),
             "See Robot.Jacobian.");
  module.def("_static_torques", &robots::static_torques, py::arg("links"), py::arg("HT"), py::arg("gravity"),
             "See Robot.StaticTorques.");
  module.def("_reach_pose", &robots::reach_pose, py::arg("links"), py::arg("base"), py::arg("carrier"),
             py::arg("local"), py::arg("goal"), py::arg("start"), py::arg("compliance"), py::arg("lower"),
             py::arg("upper"), py::arg("most_iterations"),
             "Coordinates of joints for a pose, and the error that is left; see InverseKinematicsNumerical.");
}

}  // namespace dalembert
