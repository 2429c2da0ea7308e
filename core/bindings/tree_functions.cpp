// Mechanics of a kinematic tree as functions of arrays of states: dalembert._core._TreeFunctions, on which TreeDynamics stands.
#include "dalembert/trees/tree_functions.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "dalembert/items/super_elements/kinematic_tree.hpp"
#include "dalembert/model/errors.hpp"
#include "main_system.hpp"
#include "module.hpp"

#include "item_arguments.hpp"

namespace dalembert {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

// Functions of a tree in an assembled system, whose parameters have been checked.
TreeFunctions functions_of(MainSystem& main, const py::object& number) {
  const int object = item_number_argument(main, ItemKind::object, number.ptr(), "TreeDynamics");
  main.assembled("TreeDynamics");
  const Item& item = main.model.items(ItemKind::object)[static_cast<std::size_t>(object)];
  if (item.type->name != "ObjectKinematicTree")
    refuse(ErrorKind::value, {"TreeDynamics(...)", "objectNumber", "", main.model.describe(ItemKind::object, object),
                              "an ObjectKinematicTree", ""});
  const auto& p = static_cast<const ObjectKinematicTreeRecord*>(item.record.get())->parameters;
  return {tree_of(p), p.gravity};
}

// States are rows of equal length; Python has seen to it.
std::size_t states_of(const Numbers& q) { return static_cast<std::size_t>(q.shape(0)); }
Numbers room(const TreeFunctions& f, const Numbers& q, std::initializer_list<py::ssize_t> shape) {
  if (q.ndim() != 2 || q.shape(1) != f.tree().count())
    throw std::logic_error("_TreeFunctions: states are rows, one number per joint");
  std::vector<py::ssize_t> all{q.shape(0)};
  all.insert(all.end(), shape);
  return Numbers(all);
}

Numbers inverse_dynamics(const TreeFunctions& f, const Numbers& q, const Numbers& v, const py::object& a) {
  const Numbers accelerations = a.is_none() ? Numbers() : Numbers(a);
  Numbers forces = room(f, q, {f.tree().count()});
  const double* with = a.is_none() ? nullptr : accelerations.data();
  double* to = forces.mutable_data();
  const py::gil_scoped_release release;
  f.inverse_dynamics(states_of(q), q.data(), v.data(), with, to);
  return forces;
}
Numbers forward_dynamics(const TreeFunctions& f, const Numbers& q, const Numbers& v, const Numbers& forces) {
  Numbers a = room(f, q, {f.tree().count()});
  double* to = a.mutable_data();
  int loose = -1;
  {
    const py::gil_scoped_release release;
    loose = f.forward_dynamics(states_of(q), q.data(), v.data(), forces.data(), to);
  }
  if (loose >= 0)
    refuse(ErrorKind::value,
           {"TreeDynamics.ForwardDynamics(...)", "", "nothing resists joint " + std::to_string(loose), "", "",
            "Links at the ends of the tree need mass, and inertia about the axes of their joints"});
  return a;
}
Numbers mass_matrix(const TreeFunctions& f, const Numbers& q) {
  Numbers matrices = room(f, q, {f.tree().count(), f.tree().count()});
  double* to = matrices.mutable_data();
  const py::gil_scoped_release release;
  f.mass_matrix(states_of(q), q.data(), to);
  return matrices;
}
py::tuple derivatives(const TreeFunctions& f, const Numbers& q, const Numbers& v, const Numbers& a) {
  Numbers by_q = room(f, q, {f.tree().count(), f.tree().count()}),
          by_v = room(f, q, {f.tree().count(), f.tree().count()});
  double *to_q = by_q.mutable_data(), *to_v = by_v.mutable_data();
  {
    const py::gil_scoped_release release;
    f.derivatives(states_of(q), q.data(), v.data(), a.data(), to_q, to_v);
  }
  return py::make_tuple(by_q, by_v);
}
py::tuple frames(const TreeFunctions& f, const Numbers& q) {
  Numbers rotations = room(f, q, {f.tree().count(), 3, 3}), origins = room(f, q, {f.tree().count(), 3});
  double *to_rotations = rotations.mutable_data(), *to_origins = origins.mutable_data();
  {
    const py::gil_scoped_release release;
    f.frames(states_of(q), q.data(), to_rotations, to_origins);
  }
  return py::make_tuple(rotations, origins);
}
Numbers jacobian(const TreeFunctions& f, const Numbers& q, int link, const std::array<double, 3>& local) {
  Numbers matrices = room(f, q, {6, f.tree().count()});
  double* to = matrices.mutable_data();
  const py::gil_scoped_release release;
  f.jacobian(states_of(q), q.data(), link, {local}, to);
  return matrices;
}
Numbers centre_of_mass(const TreeFunctions& f, const Numbers& q) {
  Numbers points = room(f, q, {3});
  double* to = points.mutable_data();
  const py::gil_scoped_release release;
  f.centre_of_mass(states_of(q), q.data(), to);
  return points;
}
Numbers kinetic_energy(const TreeFunctions& f, const Numbers& q, const Numbers& v) {
  Numbers energies = room(f, q, {});
  double* to = energies.mutable_data();
  const py::gil_scoped_release release;
  f.energies(states_of(q), q.data(), v.data(), to, nullptr);
  return energies;
}
Numbers potential_energy(const TreeFunctions& f, const Numbers& q) {
  Numbers energies = room(f, q, {});
  double* to = energies.mutable_data();
  const py::gil_scoped_release release;
  f.energies(states_of(q), q.data(), nullptr, nullptr, to);
  return energies;
}

}  // namespace

void register_tree_functions(py::module_& module) {
  py::class_<TreeFunctions>(module, "_TreeFunctions",
                            "Mechanics of a kinematic tree; states are rows of arrays. See dalembert.treeDynamics.")
      .def(py::init(&functions_of), py::arg("mbs"), py::arg("objectNumber"))
      .def("links", [](const TreeFunctions& f) { return f.tree().count(); })
      .def("inverse_dynamics", &inverse_dynamics, py::arg("q"), py::arg("v"), py::arg("a"))
      .def("forward_dynamics", &forward_dynamics, py::arg("q"), py::arg("v"), py::arg("forces"))
      .def("mass_matrix", &mass_matrix, py::arg("q"))
      .def("derivatives", &derivatives, py::arg("q"), py::arg("v"), py::arg("a"))
      .def("frames", &frames, py::arg("q"))
      .def("jacobian", &jacobian, py::arg("q"), py::arg("link"), py::arg("local"))
      .def("centre_of_mass", &centre_of_mass, py::arg("q"))
      .def("kinetic_energy", &kinetic_energy, py::arg("q"), py::arg("v"))
      .def("potential_energy", &potential_energy, py::arg("q"));
}

}  // namespace dalembert
