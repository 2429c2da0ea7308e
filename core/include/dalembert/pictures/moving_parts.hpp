// What keeps its shape and moves with items: parts of a scene that stand in frames of nodes, objects and markers, or between two markers.
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
  // Of an item, its rotation and position; its position alone; or what reaches from a marker to another one, whose length is that of the
  // third column.
  enum class FrameKind : std::int32_t { node, object, marker, node_place, object_place, marker_place, span };
  static constexpr std::array frame_kinds{"Node", "Object", "Marker", "NodePlace", "ObjectPlace", "MarkerPlace", "Span"};  // their names
  static constexpr double stretch = 2.0;  // a span that becomes longer or shorter by more than that is another one
  struct Frame {
    FrameKind kind;
    std::int32_t number, other;  // other: the second marker of a span
  };
  // What is asked for of a part: its rows of rotation and position (3 x 4), its position, or that and a number which stays.
  enum class Form { rows, place, place_and_number };
  static constexpr std::size_t words_of_turn = 6;  // of 4 bytes: position (3 x f4), and the first two rows of the rotation (6 x i2, of 1 / 32000)
  static std::size_t numbers(Form form) { return form == Form::rows ? 12 : form == Form::place ? 3 : 4; }

  explicit MovingParts(std::vector<Frame> frames);

  // Finds all frames; false if there is no such item, or a span has become much longer or shorter than it was at first.
  bool find(const System& system, ConfigurationType configuration);
  std::size_t frames() const { return frames_.size(); }
  std::span<const double, 12> frame(std::size_t i) const { return std::span<const double, 12>(at_[i], 12); }

  // Parts that stand in the frames `index` where the rows `local` (12 numbers each) say; returns the number of this group of parts.
  int add(std::span<const std::int32_t> index, std::span<const double> local);
  int add(std::span<const std::int32_t> index);  // as their frames
  std::size_t groups() const { return groups_.size(); }
  std::size_t size(int group) const { return groups_[static_cast<std::size_t>(group)].index.size(); }
  // Where the parts are now; false if a number is not finite, as an item has no place, or no orientation. `numbers`: one for each part, or none.
  bool place(int group, double* rows) const;
  bool write(int group, Form form, std::span<const double> numbers, float* to) const;
  // Whether all parts are turned, and neither stretched nor mirrored; as long as they are, `write_turns` has words_of_turn words for each of them.
  bool are_turned(int group) const;
  bool write_turns(int group, std::uint32_t* to) const;  // false: one of them is not, or is nowhere

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
  std::array<bool, 3> asked_{};  // which kinds of items are asked for
  std::array<System::Poses, 3> poses_;
  std::array<std::span<const double>, 3> rows_;
  std::vector<std::size_t> made_frames_;  // those that are not frames of items as they are
  LargeVector<double> made_;
  std::vector<const double*> at_;
  std::vector<double> lengths_;  // of spans, at first
  std::vector<Group> groups_;
};

}  // namespace dalembert
