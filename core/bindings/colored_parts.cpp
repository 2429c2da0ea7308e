#include "colored_parts.hpp"

#include <algorithm>
#include <cmath>

namespace dalembert {
namespace {

constexpr auto shown = ConfigurationType::Visualization;

NumberRange both(const NumberRange& a, const NumberRange& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace

std::size_t ColoredParts::add_mesh(int object) {
  const ModalMesh* const mesh = meshes_->find(*main_, object);
  parts_.push_back({object, -1, -1, mesh == nullptr ? 0 : mesh->nodes(), {}, {}, {}});
  return parts_.size() - 1;
}

std::size_t ColoredParts::add_ball(int node, int group, std::span<const double> local) {
  parts_.push_back({-1, node, group, local.size() / 3, {local.begin(), local.end()}, {}, {}});
  return parts_.size() - 1;
}

bool ColoredParts::find(const MovingParts& moving) {
  std::optional<NumberRange> range;
  for (Part& part : parts_) {
    if (!(part.object >= 0 ? find_mesh(part) : find_ball(part, moving))) return false;
    if (part.numbers.empty()) continue;
    const std::optional<NumberRange> own = range_of(part.numbers);
    if (!own) return false;
    range = range ? both(*range, *own) : *own;
  }
  NumberRange now = rule_.automatic && range ? *range : rule_.limits;
  if (rule_.automatic && now.high - now.low <= round_off * std::max(std::abs(now.low), std::abs(now.high)))
    now.high = now.low;
  rule_.shown = rule_.grows ? both(now, rule_.shown) : now;
  return true;
}

bool ColoredParts::find_mesh(Part& part) {
  ModalMesh* const mesh = meshes_->find(*main_, part.object);
  if (mesh == nullptr || mesh->nodes() != part.points) return false;
  part.rows = main_->system.pose(part.object, shown, values_);
  if (!std::ranges::all_of(part.rows, [](double number) { return std::isfinite(number); })) return false;
  if (part.numbers.empty()) return true;
  if (!mesh->has(rule_.variable)) return false;
  mesh->numbers(*main_, rule_.variable, rule_.component, part.numbers.data());
  return true;
}

// False also for a node that moves in a floating frame: the output that is shown is not its own.
bool ColoredParts::find_ball(Part& part, const MovingParts& moving) {
  if (!moving.place(part.group, part.rows.data())) return false;
  System& system = main_->system;
  system.node_output(part.node, OutputVariableType::Position, shown, values_);
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (values_[i] != part.rows[4 * i + 3]) return false;
  system.node_output(part.node, rule_.variable, shown, values_);
  double number = 0;
  if (!values_.empty()) contour_numbers(values_, values_.size(), rule_.component, &number);
  std::ranges::fill(part.numbers, number);
  return true;
}

void ColoredParts::write_points(std::size_t number, float* to) {
  const Part& part = parts_[number];
  if (part.object >= 0) return meshes_->find(*main_, part.object)->points(*main_, part.rows, to);
  for (std::size_t k = 0; k < part.local.size(); ++k)
    to[k] = static_cast<float>(part.local[k] + part.rows[4 * (k % 3) + 3]);
}

void ColoredParts::write_shades(std::size_t part, std::uint8_t* to) const {
  contour_shades(parts_[part].numbers, rule_.shown.low, rule_.shown.high, rule_.table, to);
}

}  // namespace dalembert
