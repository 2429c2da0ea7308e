#include "dalembert/pictures/moving_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include "dalembert/math/inline.hpp"
#include "dalembert/math/wide_registers.hpp"
#include "dalembert/pictures/four.hpp"
#include "dalembert/pictures/frame_along.hpp"

namespace dalembert {
namespace {

constexpr double standing = 1e-12;  // tolerance of an identity frame
constexpr std::size_t markers = 2;

bool is_made(MovingParts::FrameKind kind) { return kind >= MovingParts::FrameKind::node_place; }
std::size_t items_of(MovingParts::FrameKind kind) {
  return kind == MovingParts::FrameKind::span ? markers : static_cast<std::size_t>(kind) % (markers + 1);
}

constexpr std::array<double, 12> unturned{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

void at_place(const double* item, double* frame) {
  std::ranges::copy(unturned, frame);
  for (std::size_t i = 3; i < 12; i += 4) frame[i] = item[i];
}

// Frame from one position to another: the third column is the vector between them. Returns the length.
double along(const double* begin, const double* end, double* frame) {
  const Vec3<double> from{begin[3], begin[7], begin[11]}, axis = Vec3<double>{end[3], end[7], end[11]} - from;
  const auto [x, y, z] = frame_along(axis);
  for (int i = 0; i < 3; ++i) {
    double* row = frame + 4 * i;
    row[0] = x[i], row[1] = y[i], row[2] = axis[i], row[3] = from[i];
  }
  return std::sqrt(dot(axis, axis));
}

void multiply(const double* a, const double* b, double* result) {
  for (std::size_t i = 0; i < 12; i += 4)
    for (std::size_t j = 0; j < 4; ++j)
      result[i + j] = a[i] * b[j] + a[i + 1] * b[4 + j] + a[i + 2] * b[8 + j] + (j == 3 ? a[i + 3] : 0.0);
}

constexpr double turned = 1e-4;  // tolerance of rotations: three units of their bytes
constexpr float units = 32000;

// Converts three numbers from -1 to 1, with a margin, and a fourth one, to units: in the lower halves of words.
DALEMBERT_INLINE inline FourWhole in_units(Four x) {
  constexpr float most = 1.02f, above = 65536;  // makes them positive, so that they are rounded to the nearest
  return whole(four(units) * smaller(larger(x, four(-most)), four(most)) + four(above + 0.5f));
}

DALEMBERT_INLINE inline Four row_of(const double* row) {
  using Doubles [[gnu::vector_size(32)]] = double;
  return __builtin_convertvector(load<Doubles>(row), Four);
}

}  // namespace

MovingParts::MovingParts(std::vector<Frame> frames)
    : frames_(std::move(frames)), at_(frames_.size()), lengths_(frames_.size(), -1) {
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    asked_[items_of(frames_[i].kind)] = true;
    if (is_made(frames_[i].kind)) made_frames_.push_back(i);
  }
  made_.resize(12 * made_frames_.size());
}

bool MovingParts::find(const System& system, ConfigurationType configuration) {
  constexpr std::array kinds{ItemKind::node, ItemKind::object, ItemKind::marker};
  bool moved = false;  // in memory
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (!asked_[k]) continue;
    system.poses(kinds[k], configuration, poses_[k]);
    const std::span<const double> rows = poses_[k].rows;
    moved = moved || rows.data() != rows_[k].data() || rows.size() != rows_[k].size();
    rows_[k] = rows;
  }
  if (moved && !point_to_rows()) {
    rows_ = {};
    return false;
  }
  for (std::size_t k = 0; k < made_frames_.size(); ++k)
    if (!make(made_frames_[k], made_.data() + 12 * k)) return false;
  return true;
}

const double* MovingParts::row(std::size_t kind, std::int32_t number) const {
  const std::size_t at = 12 * static_cast<std::size_t>(number);
  return number >= 0 && at < rows_[kind].size() ? rows_[kind].data() + at : nullptr;
}

// False: there is no such item.
bool MovingParts::point_to_rows() {
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const Frame& frame = frames_[i];
    at_[i] = row(items_of(frame.kind), frame.number);
    if (at_[i] == nullptr || (frame.kind == FrameKind::span && row(markers, frame.other) == nullptr)) return false;
  }
  for (std::size_t k = 0; k < made_frames_.size(); ++k) at_[made_frames_[k]] = made_.data() + 12 * k;
  return true;
}

// False: a span has become another one.
bool MovingParts::make(std::size_t i, double* made) {
  const Frame& frame = frames_[i];
  const double* item = row(items_of(frame.kind), frame.number);
  if (frame.kind != FrameKind::span) {
    at_place(item, made);
    return true;
  }
  const double length = along(item, row(markers, frame.other), made);
  if (lengths_[i] < 0) lengths_[i] = length;
  return length < stretch * lengths_[i] && length > lengths_[i] / stretch;
}

int MovingParts::add(std::span<const std::int32_t> index, std::span<const double> local) {
  if (local.size() != 12 * index.size()) throw std::invalid_argument("local: expected 12 numbers for each index");
  const int number = add(index);
  double difference = 0;
  for (std::size_t k = 0; k < local.size(); ++k)
    difference = std::max(difference, std::abs(local[k] - unturned[k % 12]));
  if (!(difference < standing)) groups_.back().local.assign(local.begin(), local.end());
  return number;
}

int MovingParts::add(std::span<const std::int32_t> index) {
  for (const std::int32_t i : index)
    if (i < 0 || static_cast<std::size_t>(i) >= frames_.size())
      throw std::out_of_range("index: there is no frame " + std::to_string(i));
  groups_.push_back({{index.begin(), index.end()}, {}});
  return static_cast<int>(groups_.size()) - 1;
}

// Pose of a part: computed in `product`, unless it equals its frame.
DALEMBERT_INLINE inline const double* MovingParts::placed(const Group& group, std::size_t k,
                                                          std::array<double, 12>& product) const {
  const double* const frame = at_[static_cast<std::size_t>(group.index[k])];
  if (group.local.empty()) return frame;
  multiply(frame, group.local.data() + 12 * k, product.data());
  return product.data();
}

// take(part, rows) for all parts; false if one of the numbers that are taken, each Step-th from the First one on, is not finite.
template <std::size_t First, std::size_t Step, class Take>
bool MovingParts::each(const Group& group, const Take& take) const {
  std::array<double, 12> product;
  std::array<double, 12 / Step> sums{};  // nan, as soon as a number is not finite
  for (std::size_t k = 0; k < group.index.size(); ++k) {
    const double* const rows = placed(group, k, product);
    for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += 0 * rows[First + Step * j];
    take(k, rows);
  }
  return std::ranges::all_of(sums, [](double sum) { return sum == 0; });
}

bool MovingParts::place(int group, double* rows) const {
  return each<0, 1>(groups_[static_cast<std::size_t>(group)],
                    [rows](std::size_t k, const double* from) { std::copy_n(from, 12, rows + 12 * k); });
}

bool MovingParts::are_turned(int group) const {
  const Group& parts = groups_[static_cast<std::size_t>(group)];
  const bool are_rigid = std::ranges::all_of(
      parts.index, [&](std::int32_t i) { return frames_[static_cast<std::size_t>(i)].kind != FrameKind::span; });
  double off = 0;
  const bool finite = each<0, 1>(parts, [&off](std::size_t, const double* row) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;  // columns: each of the three is normal to the other two
      for (std::size_t r = 0; r < 3; ++r) {
        const std::size_t s = 4 * ((r + 1) % 3), t = 4 * ((r + 2) % 3);
        off = std::max(off, std::abs(row[s + j] * row[t + k] - row[t + j] * row[s + k] - row[4 * r + i]));
      }
    }
  });
  return are_rigid && finite && off < turned;
}

// Columns of rotations may lose their unit length: Euler parameters may not be normalized.
bool MovingParts::write_turns(int group, std::uint32_t* to) const {
  const Group& parts = groups_[static_cast<std::size_t>(group)];
  Four least = four(1.0f), most = least;  // squares of the lengths of columns
  Four sum{};                             // nan, as soon as a number is not finite
  in_registers_of_four([&, this] {
    std::array<double, 12> product;
    for (std::size_t k = 0; k < parts.index.size(); ++k) {
      const double* const row = placed(parts, k, product);
      const Four a = row_of(row), b = row_of(row + 4), c = row_of(row + 8), squares = a * a + b * b + c * c;
      least = smaller(least, squares), most = larger(most, squares), sum += four(0.0f) * squares;
      const Four place{a[3], b[3], c[3], 0};
      const FourWhole x = in_units(a), y = in_units(b);
      const FourWhole lower = __builtin_shufflevector(x, y, 0, 2, 5, 7),
                      upper = __builtin_shufflevector(x, y, 1, 4, 6, 7);
      const FourWhole turn = (lower & four(0xffff)) | (upper << 16);
      std::uint32_t* const words = to + words_of_turn * k;
      std::memcpy(words, &place, words_of_turn / 2 * sizeof *words);
      std::memcpy(words + words_of_turn / 2, &turn, words_of_turn / 2 * sizeof *words);
    }
  });
  const Four off = larger(four(1.0f) - least, most - four(1.0f));
  return bits(sum == four(0.0f)) == 15 && std::max({off[0], off[1], off[2]}) < static_cast<float>(turned);
}

bool MovingParts::write(int group, Form form, std::span<const double> numbers, float* to) const {
  const Group& parts = groups_[static_cast<std::size_t>(group)];
  if (form == Form::rows)
    return each<0, 1>(parts, [to](std::size_t k, const double* from) {
      for (std::size_t j = 0; j < 12; ++j) to[12 * k + j] = static_cast<float>(from[j]);
    });
  const std::size_t step = MovingParts::numbers(form);
  return each<3, 4>(parts, [&](std::size_t k, const double* from) {
    float* const place = to + step * k;
    for (std::size_t j = 0; j < 3; ++j) place[j] = static_cast<float>(from[4 * j + 3]);
    if (form == Form::place_and_number) place[3] = static_cast<float>(numbers[k]);
  });
}

}  // namespace dalembert
