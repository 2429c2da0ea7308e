#include "conversion.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <span>

#include "containers.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/model/references.hpp"
#include "dalembert/model/value_checks.hpp"
#include "index_types.hpp"
#include "python_callback.hpp"
#include "python_errors.hpp"
#include "sequence.hpp"

namespace dalembert {
namespace {

py::handle module_handle;

std::string counted(Py_ssize_t n, const std::string& noun) { return std::to_string(n) + " " + noun; }

std::string length_advice(Py_ssize_t given, Py_ssize_t wanted) {
  return "The length is " + std::to_string(given) + "; pass a list or numpy array of length " + std::to_string(wanted) +
         ".";
}

void require_length(Py_ssize_t given, Py_ssize_t wanted, const std::string& what) {
  if (given != wanted) throw Refusal{ErrorKind::value, what, length_advice(given, wanted)};
}

// ---- conversion from Python, one overload per member type ---------------------------------------------------------

template <class Number>
void check_sign(Number value, Check check, const char* noun) {
  if (check == Check::none || value > 0) return;
  if (check == Check::non_negative && !(value < 0)) return;
  throw Refusal{ErrorKind::value,
                std::string(noun) + (check == Check::positive ? " greater than zero" : " that is not negative"), ""};
}

void read(PyObject* value, const Row&, bool& out) {
  if (PyBool_Check(value)) {
    out = value == Py_True;
    return;
  }
  if (std::string_view(Py_TYPE(value)->tp_name).starts_with("numpy.bool")) {
    out = PyObject_IsTrue(value) == 1;
    return;
  }
  if (PyIndex_Check(value) != 0) {
    const int number = read_integer(value);
    if (number == 0 || number == 1) {
      out = number == 1;
      return;
    }
    throw Refusal{ErrorKind::value, "True or False", ""};
  }
  throw Refusal{ErrorKind::type, "True or False", ""};
}

bool is_name(PyObject* value) { return PyUnicode_Check(value) && PyUnicode_GET_LENGTH(value) > 0; }

void read(PyObject* value, const Row& row, int& out) {
  if (row.named != Named::no && is_name(value)) {
    out = named_reference(to_string(value));
    return;
  }
  const int number = read_integer(value);
  check_sign(number, row.check, "an integer");
  out = number;
}

// A quantity is never true or false; a number without a unit may be: 1 or 0, a switch or a factor.
void refuse_truth_values(PyObject* value, const Row& row, const std::string& what) {
  if (row.unit == "1" || !holds_truth_values(value)) return;
  throw Refusal{ErrorKind::type, what, "True and False stand for numbers without a unit only."};
}

void read(PyObject* value, const Row& row, double& out) {
  if (!PyFloat_Check(value)) refuse_truth_values(value, row, "a number");
  const double number = read_real(value);
  check_sign(number, row.check, "a number");
  out = number;
}

void read(PyObject* value, const Row&, std::string& out) {
  if (!PyUnicode_Check(value)) throw Refusal{ErrorKind::type, "a string", ""};
  out = to_string(value);
}

void read(PyObject* value, const Row&, std::vector<std::string>& out) {
  const char* const what = "a list of strings";
  if (PyUnicode_Check(value)) throw Refusal{ErrorKind::type, what, "Write [...] around it."};
  const Items items(value, what);
  std::vector<std::string> texts;
  for (Py_ssize_t i = 0; i < items.size(); ++i) {
    if (!PyUnicode_Check(items[i]))
      throw Refusal{ErrorKind::type, what, "Entry " + std::to_string(i) + " is " + show(items[i]) + "."};
    texts.push_back(to_string(items[i]));
  }
  out = std::move(texts);
}

void read_fixed(PyObject* value, const Row& row, double* out, int n) {
  if (read_plain_reals(value, 1, {out, static_cast<std::size_t>(n)})) return;
  const std::string what = counted(n, "finite numbers");
  refuse_truth_values(value, row, what);
  const Reals reals(value, what);
  require_length(reals.size(), n, what);
  reals.copy_to(out, what);
}

template <int N>
void read(PyObject* value, const Row& row, Vec<double, N>& out) {
  Vec<double, N> read_values;
  read_fixed(value, row, read_values.x.data(), N);
  out = read_values;
}

std::vector<double> read_vector(PyObject* value, int size) {
  const std::string what = size > 0 ? counted(size, "finite numbers") : "a list or array of finite numbers";
  const Reals reals(value, what);
  if (size > 0) require_length(reals.size(), size, what);
  std::vector<double> values(static_cast<std::size_t>(reals.size()));
  reals.copy_to(values.data(), what);
  return values;
}

void read(PyObject* value, const Row& row, std::vector<double>& out) {
  const bool is_list = PyList_CheckExact(value) || PyTuple_CheckExact(value);
  const Py_ssize_t size = is_list                            ? PySequence_Fast_GET_SIZE(value)
                          : py::isinstance<py::array>(value) ? py::reinterpret_borrow<py::array>(value).size()
                                                             : 0;
  if (size > 0 && (row.size == 0 || size == row.size)) {
    std::vector<double> values(static_cast<std::size_t>(size));
    if (read_plain_reals(value, 1, values)) {
      out = std::move(values);
      return;
    }
  }
  refuse_truth_values(value, row, "finite numbers");
  out = row.takes_number && is_number(value) ? std::vector{read_real(value)} : read_vector(value, row.size);
}

// A matrix of numbers; negative sizes mean any size. `expected` texts describe the expectation.
template <class Number>
DynamicMatrix<Number> read_matrix(PyObject* value, int rows, int columns, const std::string& what) {
  DynamicMatrix<Number> result;
  std::vector<Number> values;
  constexpr bool integers = std::is_same_v<Number, int>;
  const auto take = [&](double number) {
    if (integers && number != std::floor(number)) throw Refusal{ErrorKind::type, what, "Entries must be integers."};
    if (integers && std::abs(number) > std::numeric_limits<int>::max())
      throw Refusal{ErrorKind::value, what, "An entry is too large."};
    values.push_back(static_cast<Number>(number));
  };
  const auto is_right = [&](Py_ssize_t r, Py_ssize_t c) {
    return (rows < 0 || r == rows) && (columns < 0 || c == columns);
  };
  if (is_number_array(value)) {
    const auto array = py::reinterpret_borrow<py::array>(value);
    if (integers && array.dtype().kind() == 'f' && array.size() > 0)
      throw Refusal{ErrorKind::type, what, "Convert the array with astype(int)."};
    if (array.size() == 0 && rows < 0) return result;
    if (array.ndim() != 2 || !is_right(array.shape(0), array.shape(1)))
      throw Refusal{ErrorKind::value, what, "Check the shape of the array."};
    using Wide = std::conditional_t<integers, std::int64_t, double>;
    const auto numbers = py::array_t<Wide, py::array::c_style | py::array::forcecast>::ensure(value);
    result.rows = static_cast<int>(array.shape(0));
    result.columns = static_cast<int>(array.shape(1));
    for (const Wide number : std::span(numbers.data(), static_cast<std::size_t>(numbers.size())))
      take(static_cast<double>(number));
  } else {
    const Items lines(value, what);
    result.rows = static_cast<int>(lines.size());
    for (Py_ssize_t i = 0; i < lines.size(); ++i) {
      std::vector<double> line = read_vector(lines[i], 0);
      if (i == 0) result.columns = static_cast<int>(line.size());
      if (static_cast<int>(line.size()) != result.columns)
        throw Refusal{ErrorKind::value, what, "Row " + std::to_string(i) + " has another length than row 0."};
      for (const double number : line) take(number);
    }
    if (values.empty() && rows < 0) return {};
    if (!is_right(result.rows, result.columns))
      throw Refusal{ErrorKind::value, what, "Check the number of rows and columns."};
  }
  if constexpr (!integers) {
    if (!std::ranges::all_of(values, [](double x) { return std::isfinite(x); }))
      throw Refusal{ErrorKind::value, what, "An entry is not finite."};
  }
  result.values = std::move(values);
  return result;
}

template <int R, int C>
void read(PyObject* value, const Row& row, Mat<double, R, C>& out) {
  const std::string what = "a matrix of " + std::to_string(R) + " x " + std::to_string(C) + " finite numbers";
  refuse_truth_values(value, row, what);
  const auto matrix = read_matrix<double>(value, R, C, what);
  std::ranges::copy(matrix.values, out.x.begin());
}

template <class Number>
void read(PyObject* value, const Row& row, DynamicMatrix<Number>& out) {
  if (value == Py_None) {
    out = {};
    return;
  }
  constexpr bool integers = std::is_same_v<Number, int>;
  const std::string what = integers ? "a matrix of integers" : "a matrix (2-dimensional array) of finite numbers";
  if constexpr (!integers) {
    refuse_truth_values(value, row, what);
    if (row.takes_number && is_number(value)) {
      out = {.rows = 1, .columns = 1, .values = {read_real(value)}};
      return;
    }
  }
  out = read_matrix<Number>(value, -1, -1, what);
}

void read_scipy(py::handle sparse, MatrixContainer& out) {
  const py::object coordinates = sparse.attr("tocoo")();
  const auto shape = coordinates.attr("shape").cast<std::pair<int, int>>();
  const auto rows = coordinates.attr("row").cast<py::array_t<int, py::array::forcecast>>();
  const auto columns = coordinates.attr("col").cast<py::array_t<int, py::array::forcecast>>();
  const std::vector<double> values = read_vector(coordinates.attr("data").ptr(), 0);
  MatrixContainer result;
  result.rows = shape.first;
  result.columns = shape.second;
  result.dense = false;
  std::vector<MatrixContainer::Triplet> triplets;
  for (std::size_t i = 0; i < values.size(); ++i)
    triplets.push_back({rows.at(static_cast<py::ssize_t>(i)), columns.at(static_cast<py::ssize_t>(i)), values[i]});
  result.triplets = std::move(triplets);
  out = std::move(result);
}

void read(PyObject* value, const Row& row, MatrixContainer& out) {
  if (value == Py_None) {
    out = {};
    return;
  }
  if (py::isinstance<MatrixContainer>(value)) {
    out = py::handle(value).cast<const MatrixContainer&>();
    return;
  }
  if (PyObject_HasAttrString(value, "tocoo") != 0) {
    read_scipy(value, out);
    return;
  }
  const std::string what = "a MatrixContainer, a matrix (2-dimensional array) or a scipy sparse matrix";
  refuse_truth_values(value, row, what);
  auto matrix = read_matrix<double>(value, -1, -1, what);
  MatrixContainer result;
  result.rows = matrix.rows;
  result.columns = matrix.columns;
  result.values = std::move(matrix.values);
  out = std::move(result);
}

void read(PyObject* value, const Row& row, std::vector<int>& out) {
  const std::string what = row.size > 0 ? counted(row.size, "integers") : "a list of integers";
  const Items items(value, what);
  if (row.size > 0) require_length(items.size(), row.size, what);
  std::vector<int> numbers;
  for (Py_ssize_t i = 0; i < items.size(); ++i) {
    try {
      numbers.push_back(read_integer(items[i]));
    } catch (Refusal& refusal) {
      throw Refusal{refusal.kind, what, "Entry " + std::to_string(i) + " is " + show(items[i]) + ". " + refusal.advice};
    }
  }
  out = std::move(numbers);
}

// Lists of vectors or matrices, entry by entry.
template <class Entry>
  requires(is_vec<Entry> || is_mat<Entry>)
void read(PyObject* value, const Row& row, std::vector<Entry>& out) {
  constexpr int n = row_count<Entry>;
  const std::string shape = is_vec<Entry> ? "vectors of length " + std::to_string(n)
                                          : "matrices of " + std::to_string(n) + " x " + std::to_string(n);
  const std::string what = "a list of " + shape;
  if (value == Py_None) {
    out.clear();
    return;
  }
  if (py::isinstance<EntryList<Entry>>(value)) {
    out = py::handle(value).cast<const EntryList<Entry>&>().entries;
    return;
  }
  if constexpr (is_mat<Entry>) {  // one matrix
    if (py::isinstance<py::array>(value) && py::reinterpret_borrow<py::array>(value).ndim() == 2) {
      Entry one{};
      read(value, row, one);
      out = {one};
      return;
    }
  }
  const Items items(value, what);
  std::vector<Entry> entries(static_cast<std::size_t>(items.size()));
  for (Py_ssize_t i = 0; i < items.size(); ++i) {
    try {
      read(items[i], row, entries[static_cast<std::size_t>(i)]);
    } catch (Refusal& refusal) {
      throw Refusal{refusal.kind, what, "Entry " + std::to_string(i) + " is " + show(items[i]) + ". " + refusal.advice};
    }
  }
  out = std::move(entries);
}

int read_item_number(PyObject* value, ItemKind wanted) {
  ItemKind kind{};
  int number = -1;
  const auto what = [&] { return with_article(index_name(wanted)) + ", an integer or a name"; };
  const auto advice = [&] { return "Pass what Add" + std::string(kind_title(wanted)) + "(...) returned."; };
  if (read_index(value, kind, number)) {
    if (kind == wanted) return number;
    throw Refusal{ErrorKind::type, what(),
                  "The value is " + with_article(index_name(kind)) + ": it counts " + std::string(kind_name(kind)) +
                      "s, not " + std::string(kind_name(wanted)) + "s. " + advice()};
  }
  if (PyBool_Check(value)) throw Refusal{ErrorKind::type, what(), advice()};
  if (is_name(value)) return named_reference(to_string(value));
  try {
    number = read_integer(value);
  } catch (Refusal& refusal) {
    throw Refusal{refusal.kind, what(), advice()};
  }
  if (number < -1) throw Refusal{ErrorKind::value, "the number of " + with_article(kind_name(wanted)), advice()};
  return number;
}

// False: look closer.
bool quick_item_number(PyObject* value, ItemKind wanted, int& out) {
  ItemKind kind{};
  int number = -1;
  if (PyLong_CheckExact(value)) {
    int overflow = 0;
    const long wide = PyLong_AsLongAndOverflow(value, &overflow);
    if (overflow != 0 || wide < -1 || wide > 0x7fffffff) return false;
    number = static_cast<int>(wide);
  } else if (!read_index(value, kind, number) || kind != wanted) {
    return false;
  }
  out = number;
  return true;
}

template <ItemKind K>
void read(PyObject* value, const Row&, ItemIndex<K>& out) {
  if (quick_item_number(value, K, out.value)) return;
  out.value = read_item_number(value, K);
}

template <ItemKind K>
void read(PyObject* value, const Row& row, std::vector<ItemIndex<K>>& out) {
  // The usual case first: a list or tuple of the right length.
  const bool plain = PyList_CheckExact(value) || PyTuple_CheckExact(value);
  if (plain && (row.size == 0 || PySequence_Fast_GET_SIZE(value) == row.size)) {
    const Py_ssize_t n = PySequence_Fast_GET_SIZE(value);
    std::vector<ItemIndex<K>> numbers(static_cast<std::size_t>(n));
    Py_ssize_t i = 0;
    for (;
         i < n && quick_item_number(PySequence_Fast_GET_ITEM(value, i), K, numbers[static_cast<std::size_t>(i)].value);
         ++i) {
    }
    if (i == n) {
      out = std::move(numbers);
      return;
    }
  }
  const std::string what = (row.size > 0 ? "a list of " + std::to_string(row.size) : std::string("a list of")) + " " +
                           std::string(index_name(K)) + ", integers or names";
  const Items items(value, what);
  if (row.size > 0) require_length(items.size(), row.size, what);
  std::vector<ItemIndex<K>> numbers;
  numbers.reserve(static_cast<std::size_t>(items.size()));
  for (Py_ssize_t i = 0; i < items.size(); ++i) {
    try {
      numbers.push_back({read_item_number(items[i], K)});
    } catch (Refusal& refusal) {
      throw Refusal{refusal.kind, what, "Entry " + std::to_string(i) + " is " + show(items[i]) + ". " + refusal.advice};
    }
  }
  out = std::move(numbers);
}

template <class T>
T read_enum(PyObject* value, const Enumeration& enumeration) {
  if (enumeration.has(value)) return static_cast<T>(Enumeration::number(value));
  const std::string name = enumeration.name;
  throw Refusal{ErrorKind::type, "a member of " + name, member_advice(name, value)};
}

void read(PyObject* value, const Row&, OutputVariableType& out) {
  static const Enumeration variables("OutputVariableType");
  out = read_enum<OutputVariableType>(value, variables);
}
void read(PyObject* value, const Row&, std::vector<JointType>& out) {
  static const Enumeration joints("JointType");
  const Items items(value, "a list of members of JointType");
  std::vector<JointType> types;
  for (Py_ssize_t i = 0; i < items.size(); ++i) types.push_back(read_enum<JointType>(items[i], joints));
  out = std::move(types);
}
void read(PyObject*, const Row&, std::uint32_t&) { throw std::logic_error("items have no rows of other enumerations"); }

void read(PyObject* value, const Row& row, UserFunction& out) { out = read_user_function(value, row); }

void read(PyObject* value, const Row&, BeamSection& out) {
  if (!py::isinstance<BeamSection>(value)) throw Refusal{ErrorKind::type, "a BeamSection", ""};
  out = py::handle(value).cast<const BeamSection&>();
}

// Opaque rows contain lists of graphics data, user functions, or the outline of a beam section, whose class is
// selected here.
const char* section_class(const Row& row) { return row.name == "sectionGeometry" ? "BeamSectionGeometry" : nullptr; }
bool is_function(const Row& row) { return row.name.find("UserFunction") != std::string_view::npos; }

void read(PyObject* value, const Row& row, Opaque& out) {
  // A list or dictionary that the user goes on to fill must not change the item.
  if (PyList_CheckExact(value) && PyList_GET_SIZE(value) == 0 && !is_function(row) && section_class(row) == nullptr) {
    out = {};  // reads as an empty list
  } else if (PyList_CheckExact(value)) {
    out = make_opaque(py::reinterpret_steal<py::object>(PyList_GetSlice(value, 0, PY_SSIZE_T_MAX)).ptr());
  } else if (PyList_Check(value) || PyDict_Check(value)) {
    out = make_opaque(py::object(py::handle(value).attr("copy")()).ptr());
  } else {
    out = make_opaque(value);
  }
}

// ---- to Python -------------------------------------------------------------------------------------------------------

py::object array_of(std::vector<py::ssize_t> shape, const double* data, Form form, PyObject* owner) {
  if (form == Form::view) return py::array_t<double>(std::move(shape), data, py::handle(owner));
  return new_array(std::move(shape), data);
}

py::object write(bool value, Form, PyObject*) { return py::bool_(value); }
py::object write(int value, Form, PyObject*) { return py::int_(value); }
py::object write(double value, Form, PyObject*) { return py::float_(value); }
py::object write(const std::string& value, Form, PyObject*) { return py::str(value); }
py::object write(const std::vector<std::string>& value, Form, PyObject*) {
  py::list list;
  for (const std::string& text : value) list.append(text);
  return list;
}
template <int N>
py::object write(const Vec<double, N>& value, Form form, PyObject* owner) {
  return array_of({N}, value.x.data(), form, owner);
}
template <int R, int C>
py::object write(const Mat<double, R, C>& value, Form form, PyObject* owner) {
  return array_of({R, C}, value.x.data(), form, owner);
}
py::object write(const std::vector<double>& value, Form, PyObject*) {
  return array_of({static_cast<py::ssize_t>(value.size())}, value.data(), Form::copy, nullptr);
}
template <class Number>
py::object write(const DynamicMatrix<Number>& value, Form, PyObject*) {
  return py::array_t<Number>(std::vector<py::ssize_t>{value.rows, value.columns}, value.values.data());
}
py::object write(const MatrixContainer& value, Form, PyObject*) { return py::cast(value); }
py::object write(const std::vector<int>& value, Form, PyObject*) {
  py::list list;
  for (const int number : value) list.append(number);
  return list;
}
template <class Entry>
  requires(is_vec<Entry> || is_mat<Entry>)
py::object write(const std::vector<Entry>& value, Form, PyObject*) {
  return py::cast(EntryList<Entry>{value});
}
template <ItemKind K>
py::object write_index(ItemIndex<K> index) {
  if (is_named_reference(index.value)) return py::str(referred_name(index.value));
  return py::reinterpret_steal<py::object>(make_index(K, index.value));
}
template <ItemKind K>
py::object write(const ItemIndex<K>& value, Form, PyObject*) {
  return write_index(value);
}
template <ItemKind K>
py::object write(const std::vector<ItemIndex<K>>& value, Form, PyObject*) {
  py::list list;
  for (const ItemIndex<K> index : value) list.append(write_index(index));
  return list;
}
py::object write(OutputVariableType value, Form, PyObject*) {
  return enum_member("OutputVariableType", static_cast<std::uint64_t>(value));
}
py::object write(const std::vector<JointType>& value, Form, PyObject*) {
  py::list list;
  for (const JointType type : value) list.append(enum_member("JointType", static_cast<std::uint32_t>(type)));
  return list;
}
py::object write(std::uint32_t value, Form, PyObject*) { return py::int_(value); }
// The item's own section, whose attributes may be set, or a copy.
py::object write(const BeamSection& value, Form form, PyObject* owner) {
  if (form == Form::view)
    return py::cast(&const_cast<BeamSection&>(value), py::return_value_policy::reference_internal, py::handle(owner));
  return py::cast(value);
}
py::object write(const UserFunction& value, Form, PyObject*) {
  return value ? py::reinterpret_borrow<py::object>(function_of(value)) : py::int_(0);
}
py::object write(const Opaque& value, Form, PyObject*) {
  PyObject* object = opaque_object(value);
  return object == nullptr ? py::object(py::none()) : py::reinterpret_borrow<py::object>(object);
}

// Returns the value that an unset opaque parameter shows, in the form that users would write.
py::object empty_opaque(const Row& row) {
  if (is_function(row)) return py::int_(0);
  const char* section = section_class(row);
  if (section == nullptr) return py::list();
  return py::hasattr(core_module(), section) ? core_module().attr(section)() : py::object(py::none());
}

}  // namespace

void from_python(PyObject* value, const Row& row, void* member) {
  with_type(row.storage, [&]<class T>(TypeTag<T>) {
    if (row.check < Check::rotation) return read(value, row, *static_cast<T*>(member));
    T candidate;
    read(value, row, candidate);
    if (const Verdict verdict = judge(row, &candidate); verdict.fit == Fit::wrong)
      throw Refusal{ErrorKind::value, demand(row.check), verdict.problem + " " + advice(row.check)};
    *static_cast<T*>(member) = std::move(candidate);
  });
}

PyObject* to_python(const Row& row, const void* member, Form form, PyObject* owner) {
  if (row.storage == Storage::opaque && opaque_object(*static_cast<const Opaque*>(member)) == nullptr)
    return empty_opaque(row).release().ptr();
  if (row.named != Named::no)
    if (const int number = *static_cast<const int*>(member); is_named_reference(number))
      return py::str(referred_name(number)).release().ptr();
  return with_type(row.storage, [&]<class T>(TypeTag<T>) {
    return write(*static_cast<const T*>(member), form, owner).release().ptr();
  });
}

py::array_t<double> new_array(std::vector<py::ssize_t> shape, const double* numbers) {
  py::array_t<double> array(std::move(shape));
  std::copy_n(numbers, array.size(), array.mutable_data());
  return array;
}

Enumeration::Enumeration(const char* name)
    : name(name), type_(reinterpret_cast<PyTypeObject*>(py::object(core_module().attr(name)).release().ptr())) {}

py::object enum_member(const char* name, std::uint64_t value) { return core_module().attr(name)(value); }

py::handle core_module() { return module_handle; }
void set_core_module(py::module_& module) { module_handle = module; }

Opaque make_opaque(PyObject* object) {
  Py_INCREF(object);
  return {std::shared_ptr<void>(object, [](void* held) {
    if (Py_IsInitialized() == 0) return;
    const PyGILState_STATE gil = PyGILState_Ensure();
    Py_DECREF(static_cast<PyObject*>(held));
    PyGILState_Release(gil);
  })};
}

PyObject* opaque_object(const Opaque& value) { return static_cast<PyObject*>(value.object.get()); }

std::string member_advice(const std::string& enumeration, PyObject* value) {
  if (!PyUnicode_Check(value)) return {};
  std::string word = to_string(value);
  word = word.substr(word.rfind('.') + 1);
  std::vector<std::string> names;
  for (const py::handle name : py::list(core_module().attr(enumeration.c_str()).attr("__members__")))
    names.push_back(to_string(name.ptr()));
  const std::vector<std::string_view> known(names.begin(), names.end());
  const bool is_one = std::ranges::find(names, word) != names.end();
  const std::string meant = is_one ? word : nearest(word, known);
  return meant.empty() ? suggestion(word, known) : "Write " + enumeration + "." + meant + " without quotes.";
}

std::vector<double> read_reals(PyObject* value) { return read_vector(value, 0); }

}  // namespace dalembert
