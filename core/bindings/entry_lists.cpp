// Vector2DList, Vector3DList, Vector6DList, Matrix3DList, Matrix6DList.
#include <pybind11/numpy.h>

#include "containers.hpp"
#include "conversion.hpp"
#include "dalembert/model/member.hpp"
#include "python_errors.hpp"
#include "sequence.hpp"

namespace dalembert {
namespace {

template <class Entry>
constexpr int rank = is_mat<Entry> ? 2 : 1;

template <class Entry>
constexpr Storage storage_of() {
  if constexpr (is_mat<Entry>) return row_count<Entry> == 3 ? Storage::matrix3 : Storage::matrix6;
  if constexpr (row_count<Entry> == 2) return Storage::vector2;
  return row_count<Entry> == 3 ? Storage::vector3 : Storage::vector6;
}

template <class Entry>
std::string list_name() {
  return std::string(is_mat<Entry> ? "Matrix" : "Vector") + std::to_string(row_count<Entry>) + "DList";
}

// `position` names the entry in errors.
template <class Entry>
Entry read_entry(PyObject* value, const std::string& position) {
  static const Row row{.name = "entry", .storage = storage_of<Entry>(), .offset = 0, .role = Role::parameter};
  Entry entry;
  try {
    from_python(value, row, &entry);
  } catch (const Refusal& refusal) {
    refuse(refusal.kind, {.item = list_name<Entry>() + position,
                          .received = show(value),
                          .expected = refusal.expected,
                          .advice = refusal.advice});
  }
  return entry;
}

bool is_single_matrix(PyObject* value) {
  return is_number_array(value) && py::reinterpret_borrow<py::array>(value).ndim() == 2;
}

template <class Entry>
EntryList<Entry> make_list(const py::object& value) {
  if (value.is_none()) return {};
  if (py::isinstance<EntryList<Entry>>(value)) return value.cast<EntryList<Entry>>();
  if (is_mat<Entry> && is_single_matrix(value.ptr()) && py::len(value) > 0)
    return {{read_entry<Entry>(value.ptr(), "")}};
  EntryList<Entry> list;
  try {
    const Items items(value.ptr(), std::string("a list of ") + (is_mat<Entry> ? "matrices" : "vectors"));
    for (Py_ssize_t i = 0; i < items.size(); ++i)
      list.entries.push_back(read_entry<Entry>(items[i], ", entry " + std::to_string(i)));
  } catch (const Refusal& refusal) {
    refuse(refusal.kind, {.item = list_name<Entry>(), .received = show(value.ptr()), .expected = refusal.expected});
  }
  return list;
}

template <class Entry>
py::array_t<double> entry_array(const Entry& entry) {
  std::vector<py::ssize_t> shape(rank<Entry>, row_count<Entry>);
  return new_array(std::move(shape), entry.x.data());
}

template <class Entry>
std::size_t position_in(const EntryList<Entry>& list, py::ssize_t index) {
  const auto n = static_cast<py::ssize_t>(list.entries.size());
  const py::ssize_t position = index < 0 ? index + n : index;
  if (position < 0 || position >= n)
    refuse(ErrorKind::index, {.item = list_name<Entry>(),
                              .problem = "there is no entry " + std::to_string(index),
                              .advice = "The list has " + std::to_string(n) + " entries."});
  return static_cast<std::size_t>(position);
}

template <class Entry>
py::list entries_of(const EntryList<Entry>& list) {
  py::list entries;
  for (const Entry& entry : list.entries) entries.append(entry_array(entry));
  return entries;
}

// n x size, or n x size x size.
template <class Entry>
py::array_t<double> whole_array(const EntryList<Entry>& list) {
  std::vector<py::ssize_t> shape(rank<Entry> + 1, row_count<Entry>);
  shape[0] = static_cast<py::ssize_t>(list.entries.size());
  py::array_t<double> array(std::move(shape));
  double* out = array.mutable_data();
  for (const Entry& entry : list.entries) out = std::copy(entry.x.begin(), entry.x.end(), out);
  return array;
}

template <class Entry>
void register_entry_list(py::module_& module) {
  using List = EntryList<Entry>;
  const std::string name = list_name<Entry>();
  py::class_<List> list(module, name.c_str(), "A list of vectors or matrices of one size. Entries come out as copies.");
  list.def(py::init<>());
  list.def(py::init(&make_list<Entry>), py::arg("listOfArrays"),
           "From None, a list of lists, a list of arrays, or an array.");
  list.def(
      "Append",
      [](List& self, const py::object& value) { self.entries.push_back(read_entry<Entry>(value.ptr(), ".Append")); },
      py::arg("pyArray"), "Append one entry: a list or an array.");
  list.def("GetPythonObject", &entries_of<Entry>, "The entries as a list of arrays.");
  list.def("__len__", [](const List& self) { return self.entries.size(); });
  list.def("__getitem__",
           [](const List& self, py::ssize_t index) { return entry_array(self.entries[position_in(self, index)]); });
  list.def("__setitem__", [](List& self, py::ssize_t index, const py::object& value) {
    const std::size_t position = position_in(self, index);
    self.entries[position] = read_entry<Entry>(value.ptr(), ", entry " + std::to_string(index));
  });
  list.def("__array__", [](const List& self, const py::args&, const py::kwargs& options) {
    const py::object array = whole_array(self);
    const bool typed = options.contains("dtype") && !options["dtype"].is_none();
    return typed ? py::object(array.attr("astype")(options["dtype"])) : array;
  });
  list.def("__repr__", [](const List& self) { return py::repr(entries_of(self)); });
  list.def("__copy__", [](const List& self) { return List(self); });
  list.def("__deepcopy__", [](const List& self, const py::dict&) { return List(self); });
  list.def(py::pickle([](const List& self) { return entries_of(self); },
                      [](const py::list& state) { return make_list<Entry>(state); }));
}

}  // namespace

void register_entry_lists(py::module_& module) {
  register_entry_list<Vec<double, 2>>(module);
  register_entry_list<Vec<double, 3>>(module);
  register_entry_list<Vec<double, 6>>(module);
  register_entry_list<Mat<double, 3, 3>>(module);
  register_entry_list<Mat<double, 6, 6>>(module);
}

}  // namespace dalembert
