// Parts of scenes that move with items, and messages with their poses for viewers.
#include "dalembert/pictures/moving_parts.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "colored_parts.hpp"
#include "conversion.hpp"
#include "dalembert/pictures/frame_along.hpp"
#include "item_arguments.hpp"
#include "main_system.hpp"
#include "picture_arrays.hpp"
#include "system_container.hpp"

namespace dalembert {
namespace {

using Form = MovingParts::Form;

std::vector<MovingParts::Frame> frames_of_parts(const Numbers<std::int32_t>& rows) {
  std::vector<MovingParts::Frame> frames(static_cast<std::size_t>(rows.size()) / 3);
  const std::int32_t* row = rows.data();
  for (auto& [kind, number, other] : frames) {
    if (*row < 0 || *row > static_cast<std::int32_t>(MovingParts::FrameKind::span))
      throw py::value_error("_MovingParts: frames: there is no such kind");
    kind = static_cast<MovingParts::FrameKind>(*row++);
    number = *row++;
    other = *row++;
  }
  return frames;
}

// Text and numbers of a message, one after the other.
class MessageBytes {
 public:
  explicit MessageBytes(std::size_t size)
      : object_(py::reinterpret_steal<py::bytes>(PyBytes_FromStringAndSize(nullptr, static_cast<py::ssize_t>(size)))) {
    if (!object_) throw py::error_already_set();
    next_ = PyBytes_AS_STRING(object_.ptr());
  }
  void add(std::string_view text) { next_ = std::ranges::copy(text, next_).out; }
  template <class T>
  T* add_numbers(std::size_t count) {  // begin and end are multiples of 4 bytes
    auto* const first = reinterpret_cast<T*>(next_);
    next_ += count * sizeof(T);
    return first;
  }
  py::bytes take() { return std::move(object_); }

 private:
  py::bytes object_;
  char* next_ = nullptr;
};

// An array of a message.
struct SentArray {
  enum class Kind { stays, moves, points, shades };

  Kind kind = Kind::stays;
  int group = -1;
  Form form{};
  std::size_t part = 0;  // parts whose shape or colors change, if it is one of their arrays
  std::size_t count = 0;     // numbers
  Numbers<double> numbers{};  // one per part
  Numbers<float> first{};  // the values that viewers have with the whole scene
  std::optional<bool> turned = false;  // all parts: they are sent in fewer words

  std::size_t words() const {
    return turned == true ? count / MovingParts::numbers(form) * MovingParts::words_of_turn : count;
  }
  std::size_t bytes() const {
    return kind == Kind::shades ? (count + 3) / 4 * 4 : sizeof(float) * words();
  }  // a multiple of 4
  std::string told() const {
    return (kind == Kind::shades ? R"(["u1",)"
            : turned == true     ? R"(["r6",)"
                                 : R"(["f4",)") +
           std::to_string(words()) + ']';
  }
};

// Forms of the arrays of moving parts.
constexpr std::array<std::pair<std::string_view, Form>, 4> forms_of_moving{
    {{"rows", Form::rows},
     {"turns", Form::rows},
     {"place", Form::place},
     {"place and number", Form::place_and_number}}};

// A number as JSON has it.
void append_number(std::string& text, double number) {
  std::array<char, 32> digits;
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

// Writes the number like Python, with a decimal point if there is no exponent.
void append_decimal(std::string& text, double number) {
  const std::size_t before = text.size();
  append_number(text, number);
  if (text.find_first_of(".e", before) == std::string::npos) text += ".0";
}

// Output variable and component; flags: automatic range, growing range; the fixed range and the previous range;
// colors.
using RuleTuple =
    std::tuple<py::object, int, bool, bool, std::array<double, 2>, std::array<double, 2>, Numbers<std::uint8_t>>;

ColoredParts::Rule rule_of(const RuleTuple& tuple) {
  const auto& [variable, component, automatic, grows, limits, shown, table] = tuple;
  const auto rows = all(table);
  return {static_cast<OutputVariableType>(Enumeration::number(variable.ptr())),
          component,
          automatic,
          grows,
          {limits[0], limits[1]},
          {shown[0], shown[1]},
          {rows.begin(), rows.end()}};
}

// Asks one system; all of it needs the lock of the interpreter.
class PartsOfSystem {
 public:
  PartsOfSystem(std::shared_ptr<MainSystem> main, const Numbers<std::int32_t>& frames)
      : main_(std::move(main)), parts_(frames_of_parts(frames)) {}

  bool find(const py::object& value) {
    const ConfigurationType configuration =
        configuration_argument(value, [] { return std::string("_MovingParts.find(...)"); });
    if (!main_->consistent()) return false;
    if (configuration == ConfigurationType::Visualization) main_->look_wanted = true;
    return parts_.find(main_->system, configuration);
  }
  py::array frames() const {
    py::array_t<double> result({static_cast<py::ssize_t>(parts_.frames()), py::ssize_t{3}, py::ssize_t{4}});
    for (std::size_t i = 0; i < parts_.frames(); ++i)
      std::ranges::copy(parts_.frame(i), result.mutable_data() + 12 * i);
    return result;
  }
  int add(const Numbers<std::int32_t>& index, const std::optional<Numbers<double>>& local) {
    return local ? parts_.add(all(index), all(*local)) : parts_.add(all(index));
  }
  py::object placed(int group) const {
    py::array_t<double> result({static_cast<py::ssize_t>(parts_.size(checked(group))), py::ssize_t{3}, py::ssize_t{4}});
    if (!parts_.place(group, result.mutable_data())) return py::none();
    return result;
  }

  // Entries: form, group of moving parts or -1, item whose output is shown or -1, numbers, and the array as pages have it.
  void keep(const py::iterable& entries, const RuleTuple& rule, std::shared_ptr<ModalMeshes> meshes) {
    entries_.clear();
    colored_.emplace(main_, std::move(meshes), rule_of(rule));
    for (const auto& handle : entries) {
      const auto [form, group, item, numbers, first] =
          handle.cast<std::tuple<std::string, int, int, Numbers<double>, Numbers<float>>>();
      const bool is_colored = form == "mesh" || form == "ball" || form == "shades";
      SentArray entry = form.empty() ? SentArray{}
                        : is_colored ? colored(form, group, item, numbers)
                                     : moving(form, group, numbers);
      if (entry.kind != SentArray::Kind::stays) each("_MovingParts.keep(...)", first, entry.count, 1, "first");
      entry.first = first;
      entries_.push_back(std::move(entry));
    }
  }
  // Range of the numbers that the last message shows as colors.
  std::pair<double, double> range() const { return {colored_->range().low, colored_->range().high}; }

  // Returns None if some item cannot be followed by its parts.
  py::object message(std::string_view words, py::set& moved) {
    System& system = main_->system;
    const double time = main_->consistent() ? system.state(ConfigurationType::Visualization).time : NAN;
    if (!colored_ || !std::isfinite(time) || !parts_.find(system, ConfigurationType::Visualization) ||
        !colored_->find(parts_))
      return py::none();
    main_->look_wanted = true;
    std::size_t size = 0;
    std::string head = head_of(time, words);
    std::vector<std::pair<SentArray*, LargeVector<float>>> sent;  // their values, if they are known already
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      SentArray& entry = entries_[i];
      if (i > 0) head += ',';
      const std::optional<bool> has_moved = asked(i, moved);
      if (!has_moved) return py::none();
      if (*has_moved) {
        sent.emplace_back(&entry, std::move(now_));
        now_.clear();
        if (!entry.turned) entry.turned = parts_.are_turned(entry.group);
        size += entry.bytes();
        head += entry.told();
      } else {
        head += "null";
      }
    }
    head += "]}";
    head.append((8 - (head.size() + 4) % 8) % 8, ' ');
    MessageBytes bytes(4 + head.size() + size);
    const auto length = static_cast<std::uint32_t>(head.size());
    std::array<char, 4> first;
    for (std::size_t i = 0; i < 4; ++i) first[i] = static_cast<char>(length >> (8 * i) & 255);
    bytes.add({first.data(), first.size()});
    bytes.add(head);
    for (const auto& [entry, values] : sent) {
      if (entry->kind == SentArray::Kind::shades) {
        add_shades(*entry, bytes);
      } else if (*entry->turned) {
        if (parts_.write_turns(entry->group, bytes.add_numbers<std::uint32_t>(entry->words()))) continue;
        entry->turned = false;
        return message(words, moved);
      } else if (float* const to = bytes.add_numbers<float>(entry->count); !values.empty()) {
        std::ranges::copy(values, to);
      } else if (!write(*entry, to)) {
        return py::none();
      }
    }
    return bytes.take();
  }

 private:
  int checked(int group) const {
    if (group < 0 || static_cast<std::size_t>(group) >= parts_.groups())
      throw py::index_error("_MovingParts: there is no such group");
    return group;
  }
  SentArray moving(std::string_view form, int group, const Numbers<double>& numbers) const {
    const auto* const known = std::ranges::find(forms_of_moving, form, &std::pair<std::string_view, Form>::first);
    if (known == forms_of_moving.end())
      throw py::value_error("_MovingParts.keep(...): there is no form " + std::string(form));
    SentArray entry{.kind = SentArray::Kind::moves, .group = checked(group), .form = known->second, .numbers = numbers};
    const std::size_t count = parts_.size(group);
    entry.count = count * MovingParts::numbers(entry.form);
    if (entry.form == Form::place_and_number) each("_MovingParts.keep(...)", numbers, count, 1, "numbers");
    if (form == "turns") entry.turned.reset();
    return entry;
  }
  // Shades are those of the points before them.
  SentArray colored(std::string_view form, int group, int item, const Numbers<double>& numbers) {
    if (form == "shades") {
      if (entries_.empty() || entries_.back().kind != SentArray::Kind::points)
        throw py::value_error("_MovingParts.keep(...): shades of no points");
      colored_->color(entries_.back().part);
      return {.kind = SentArray::Kind::shades, .part = entries_.back().part, .count = entries_.back().count};
    }
    const std::size_t part =
        form == "mesh" ? colored_->add_mesh(item) : colored_->add_ball(item, checked(group), all(numbers));
    return {.kind = SentArray::Kind::points, .part = part, .count = 3 * colored_->points(part)};
  }
  std::string head_of(double time, std::string_view words) const {
    std::string head = R"({"kind":"frame","time":)";
    append_number(head, time);
    head += R"(,"range":[)";
    append_decimal(head, colored_->range().low);
    head += ", ";
    append_decimal(head, colored_->range().high);
    head += ']';
    return head.append(words) + R"(,"arrays":[)";
  }
  void add_shades(const SentArray& entry, MessageBytes& bytes) const {
    auto* const to = bytes.add_numbers<std::uint8_t>(entry.bytes());
    std::fill(to + entry.count, to + entry.bytes(), std::uint8_t{0});
    colored_->write_shades(entry.part, to);
  }
  // False: a part has no place.
  bool write(const SentArray& entry, float* to) {
    if (entry.kind == SentArray::Kind::moves) return parts_.write(entry.group, entry.form, all(entry.numbers), to);
    colored_->write_points(entry.part, to);
    return true;
  }
  bool has_other_shades(const SentArray& entry) {
    shades_.resize(entry.count);
    colored_->write_shades(entry.part, shades_.data());
    return !std::ranges::equal(shades_, all(entry.first),
                               [](std::uint8_t now, float before) { return static_cast<float>(now) == before; });
  }
  // Returns whether an array has moved; nullopt if this is unknown. Arrays that have moved once are always sent,
  // because viewers may have missed the motion and the return. If an array moves for the first time, now_ has its
  // values.
  std::optional<bool> asked(std::size_t i, py::set& moved) {
    const SentArray& entry = entries_[i];
    if (entry.count == 0) return false;
    if (moved.contains(i)) return true;
    if (entry.kind == SentArray::Kind::shades) {
      const bool other = has_other_shades(entry);
      if (other) moved.add(py::int_(i));
      return other;
    }
    now_.resize(entry.count);
    if (!write(entry, now_.data())) return std::nullopt;
    if (!std::ranges::equal(now_, all(entry.first))) {
      moved.add(py::int_(i));
      return true;
    }
    now_.clear();
    return false;
  }

  const std::shared_ptr<MainSystem> main_;
  MovingParts parts_;
  std::vector<SentArray> entries_;
  std::optional<ColoredParts> colored_;  // updated together with the entries
  LargeVector<float> now_;
  LargeVector<std::uint8_t> shades_;
};

}  // namespace

void register_moving_parts(py::module_& module) {
  py::class_<PartsOfSystem> parts(module, "_MovingParts", "Parts of a scene that move with items of a system.");
  parts.attr("kinds") = py::cast(MovingParts::frame_kinds);  // kinds of frames, in the numbering of __init__
  parts.attr("stretch") = MovingParts::stretch;
  module.def(
      "_frame_along",
      [](const std::array<double, 3>& axis, const std::optional<std::array<double, 3>>& across) {
        const auto vector = [](const std::array<double, 3>& v) { return Vec3<double>{v[0], v[1], v[2]}; };
        const auto columns = frame_along(vector(axis), across ? std::optional(vector(*across)) : std::nullopt);
        py::array_t<double> result({3, 3});
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) result.mutable_at(i, j) = columns[static_cast<std::size_t>(j)][i];
        return result;
      },
      py::arg("axis"), py::arg("across") = py::none(),
      "A rotation matrix whose third column is along an axis; its first one is near `across`, if given.");
  parts.def(py::init<std::shared_ptr<MainSystem>, const Numbers<std::int32_t>&>(), py::arg("mbs"), py::arg("frames"))
      .def(
          "find", &PartsOfSystem::find, py::arg("configuration"),
          "Find all frames; False if there is no such item, or a span has become much longer or shorter than at first.")
      .def("frames", &PartsOfSystem::frames,
           "Rotation and position (n x 3 x 4) of all frames, as they were found last.")
      .def("add", &PartsOfSystem::add, py::arg("index"), py::arg("local") = py::none(),
           "Add parts that stand in frames, as these do without `local`; returns the number of their group.")
      .def("placed", &PartsOfSystem::placed, py::arg("group"),
           "Where the parts of a group are (n x 3 x 4); None if one is nowhere.")
      .def("keep", &PartsOfSystem::keep, py::arg("entries"), py::arg("rule"), py::arg("meshes"),
           "Keep what messages tell, array by array: form (empty: nothing that moves; turns: rows in fewer words as "
           "long as they are turned), group, item, numbers, and values in the whole scene; and which numbers have "
           "which colors.")
      .def_property_readonly("range", &PartsOfSystem::range, "Of the numbers that the last message shows as colors.")
      .def("message", &PartsOfSystem::message, py::arg("words"), py::arg("moved"),
           "The message of a frame, in which `words` follow the time; `moved`: which arrays have ever moved.");
}

}  // namespace dalembert
