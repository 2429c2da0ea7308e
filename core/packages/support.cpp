// Compiled into every item package: the initialization of its module, and functions of the core, by its table.
// DALEMBERT_ITEM_MODULE, _SOURCE, _REBUILD and DALEMBERT_HEADERS are texts, see python/dalembert/_tools/item_packages.py.
#define Py_LIMITED_API 0x030B0000
#include <Python.h>

#include "dalembert/reflection/item_package.hpp"

namespace dalembert {
namespace {

const CoreFunctions* core = nullptr;

}  // namespace

void refuse(ErrorKind kind, const Complaint& complaint) {
  core->refuse(kind, complaint);
  __builtin_unreachable();
}
ItemLabel::operator std::string() const { return core->describe(*this); }
Traced Traced::note(Operation operation, const Traced& a, const Traced& b) { return core->note(operation, a, b); }
Instructions instructions() { return core->instructions(); }

void check_inertia(double mass, const Mat3<double>& about_reference, const Vec3<double>& centre,
                   const ItemLabel& item) {
  core->check_inertia(mass, about_reference, centre, item);
}
Verdict judge_inertia(double mass, const Mat3<double>& about_reference, const Vec3<double>& centre) {
  return core->judge_inertia(mass, about_reference, centre);
}
void check_planar_inertia(double mass, double about_reference, const Vec<double, 2>& centre, const ItemLabel& item) {
  core->check_planar_inertia(mass, about_reference, centre, item);
}
void check_unit_length(std::span<const double> values, const char* parameter, const char* expected,
                       const ItemLabel& item) {
  core->check_unit_length(values, parameter, expected, item);
}

void System::node_output(int node, OutputVariableType variable, ConfigurationType configuration, Values& values) {
  (this->*core->node_output)(node, variable, configuration, values);
}
void System::object_output(int object, OutputVariableType variable, ConfigurationType configuration, Values& values) {
  (this->*core->object_output)(object, variable, configuration, values);
}
void System::body_output(int object, OutputVariableType variable, std::array<double, 3> local,
                         ConfigurationType configuration, Values& values) {
  (this->*core->body_output)(object, variable, local, configuration, values);
}
void System::super_element_output(int object, OutputVariableType variable, int mesh_node,
                                  ConfigurationType configuration, Values& values) {
  (this->*core->super_element_output)(object, variable, mesh_node, configuration, values);
}
void System::link_output(int object, OutputVariableType variable, int link, std::array<double, 3> local,
                         ConfigurationType configuration, Values& values) {
  (this->*core->link_output)(object, variable, link, local, configuration, values);
}
void System::marker_output(int marker, OutputVariableType variable, ConfigurationType configuration, Values& values) {
  (this->*core->marker_output)(marker, variable, configuration, values);
}
void System::load_values(int load, double time, Values& values) { (this->*core->load_values)(load, time, values); }
void System::state_may_have_changed() { (this->*core->state_may_have_changed)(); }

namespace {

const ItemPackage& package() {
  static const std::string stamp = stamp_of(DALEMBERT_HEADERS);
  static const ItemPackage own{sizeof(ItemPackage),
                               stamp.c_str(),
                               DALEMBERT_ITEM_MODULE,
                               DALEMBERT_ITEM_SOURCE,
                               DALEMBERT_ITEM_REBUILD,
                               own_item_types(),
                               own_item_texts(),
                               own_item_transformations(),
                               &core};
  return own;
}

// Returns false if a Python error is set.
bool hand_over(PyObject* module) {
  PyObject* const dalembert_core = PyImport_ImportModule("dalembert._core");
  if (dalembert_core == nullptr) return false;
  PyObject* const capsule = PyCapsule_New(const_cast<ItemPackage*>(&package()), ItemPackage::capsule, nullptr);
  PyObject* const added =
      capsule == nullptr ? nullptr : PyObject_CallMethod(dalembert_core, "_add_item_package", "OO", capsule, module);
  Py_XDECREF(added);
  Py_XDECREF(capsule);
  Py_DECREF(dalembert_core);
  return added != nullptr;
}

}  // namespace
}  // namespace dalembert

PyMODINIT_FUNC PyInit__items() {
  static PyModuleDef definition{
      PyModuleDef_HEAD_INIT, DALEMBERT_ITEM_MODULE "._items", nullptr, -1, nullptr, nullptr, nullptr, nullptr, nullptr};
  PyObject* const module = PyModule_Create(&definition);
  if (module == nullptr || dalembert::hand_over(module)) return module;
  Py_DECREF(module);
  return nullptr;
}
