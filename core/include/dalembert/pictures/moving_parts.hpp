// Rigid parts of a scene that move with items: they are attached to frames of nodes, objects and markers, or lie
// between two markers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "dalembert/math/large_memory.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

class MovingParts {
 public:
  // Attachment of a part: rotation and position of an item; its position only; or the span from a marker to another
  // one, whose length is that of the third column.
  enum class FrameKind : std::int32_t { node, object, marker, node_place, object_place, marker_place, span };
  static constexpr std::array frame_kinds{"Node",        "Object",      "Marker", "NodePlace",
                                          "ObjectPlace", "MarkerPlace", "Span"};  // their names
  static constexpr double stretch = 2.0;  // a span that becomes longer or shorter by more than that is another one
  struct Frame {
    FrameKind kind;
    std::int32_t number, other;  // other: the second marker of a span
  };
  // Requested data of a part: its rows of rotation and position (3 x 4), its position, or the position and a constant
  // number.
  enum class Form { rows, place, place_and_number };
  static constexpr std::size_t words_of_turn =
      6;  // of 4 bytes: position (3 x f4), and the first two rows of the rotation (6 x i2, of 1 / 32000)
  static std::size_t numbers(Form form) { return form == Form::rows ? 12 : form == Form::place ? 3 : 4; }

  explicit MovingParts(std::vector<Frame> frames);

  // Finds all frames; false if there is no such item, or a span has become much longer or shorter than it was at first.
  bool find(const System& system, ConfigurationType configuration);
  std::size_t frames() const { return frames_.size(); }
  std::span<const double, 12> frame(std::size_t i) const { return std::span<const double, 12>(at_[i], 12); }

  // Parts in the frames `index` with the relative poses `local` (12 numbers each); returns the number of this group
  // of parts.
  int add(std::span<const std::int32_t> index, std::span<const double> local);
  int add(std::span<const std::int32_t> index);  // indices of their frames
  std::size_t groups() const { return groups_.size(); }
  std::size_t size(int group) const { return groups_[static_cast<std::size_t>(group)].index.size(); }
  // Current poses of the parts; false if a number is not finite, because an item has no position or orientation.
  // `numbers`: one per part, or empty.
  bool place(int group, double* rows) const;
  bool write(int group, Form form, std::span<const double> numbers, float* to) const;
  // Whether all parts are rotated without stretching or mirroring; if so, `write_turns` writes words_of_turn words
  // per part.
  bool are_turned(int group) const;
  // false if one of them is not purely rotated, or has no position
  bool write_turns(int group, std::uint32_t* to) const;

 private:
  struct Group {
    std::vector<std::int32_t> index;
    LargeVector<double> local;  // empty: all stand as their frames do
  };

  const double* row(std::size_t kind, std::int32_t number) const;
  bool point_to_rows();
  bool make(std::size_t i, double* made);
  const double* placed(const Group& group, std::size_t k, std::array<double, 12>& product) const;
  template <std::size_t First, std::size_t Step, class Take>
  bool each(const Group& group, const Take& take) const;

  std::vector<Frame> frames_;
  std::array<bool, 3> asked_{};  // requested kinds of items
  std::array<System::Poses, 3> poses_;
  std::array<std::span<const double>, 3> rows_;
  std::vector<std::size_t> made_frames_;  // frames that are not frames of items
  LargeVector<double> made_;
  std::vector<const double*> at_;
  std::vector<double> lengths_;  // initial lengths of spans
  std::vector<Group> groups_;
};

}  // namespace dalembert
