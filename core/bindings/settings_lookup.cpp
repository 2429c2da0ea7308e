// Lookup of settings by name, resolution of earlier names, and suggestion of the nearest name.
#include <algorithm>
#include <array>
#include <vector>

#include "dalembert/model/errors.hpp"
#include "settings.hpp"

namespace dalembert {
namespace {

SettingsField field_in(const SettingsView& view, std::string_view name) {
  const auto row = std::ranges::find(view.group->rows, name, &Row::name);
  if (row != view.group->rows.end()) return {view, &*row, nullptr};
  const auto child = std::ranges::find(view.group->children, name, &SettingsChild::name);
  if (child != view.group->children.end()) return {view, nullptr, &*child};
  for (const Row& each : view.group->rows)
    if (std::ranges::find(each.aliases, name) != each.aliases.end()) return {view, &each, nullptr};
  return {};
}

SettingsView root_of(const SettingsView& view) { return {view.tree, view.tree->group, view.root, view.root.get(), ""}; }

// The field at a dotted path from the root.
SettingsField follow(SettingsView view, std::string_view path) {
  for (;;) {
    const std::size_t dot = path.find('.');
    const SettingsField field = field_in(view, path.substr(0, dot));
    if (dot == std::string_view::npos || field.child == nullptr) return field;
    view = view.child(*field.child);
    path.remove_prefix(dot + 1);
  }
}

// Paths of all rows and groups with that name.
void paths_of(const SettingsGroup& group, const std::string& path, std::string_view name,
              std::vector<std::string>& found) {
  for (const Row& row : group.rows)
    if (row.name == name) found.push_back(path + std::string(name));
  for (const SettingsChild& child : group.children) {
    if (child.name == name) found.push_back(path + std::string(name));
    paths_of(*child.group, path + std::string(child.name) + ".", name, found);
  }
}

}  // namespace

std::string SettingsView::title() const {
  const std::string root(tree->group->name);
  return path.empty() ? root : root + "." + path;
}

std::string SettingsView::path_to(std::string_view name) const {
  return path.empty() ? std::string(name) : path + "." + std::string(name);
}

SettingsView SettingsView::child(const SettingsChild& child) const {
  return {tree, child.group, root, static_cast<char*>(data) + child.offset, path_to(child.name)};
}

const SettingsGroup& names_group() {
  static constexpr SettingsGroup group{"SettingsNames", {}, {}};
  return group;
}

SettingsField find_field(const SettingsView& view, std::string_view name) {
  if (SettingsField field = field_in(view, name)) return field;
  const std::string path = view.path_to(name);
  for (const SettingsAlias& alias : view.tree->aliases) {
    if (!alias.path.starts_with(path)) continue;
    if (alias.path.size() == path.size()) {
      if (!alias.target.empty()) return follow(root_of(view), alias.target);
      return {.view = view, .without_effect = true};
    }
    if (alias.path[path.size()] == '.')
      return {.view = {view.tree, &names_group(), view.root, view.root.get(), path}, .only_names = true};
  }
  return {};
}

namespace {

// Names of step sizes, which users look for although the setting is a number of steps.
bool is_step_size(std::string_view name) {
  constexpr std::array<std::string_view, 6> words{"stepSize", "stepsize", "step_size", "timeStep", "timestep", "dt"};
  return std::ranges::find(words, name) != words.end();
}

}  // namespace

void refuse_unknown(const SettingsView& view, std::string_view name) {
  const std::string problem = view.title() + " has no parameter " + in_quotes(name);
  std::vector<std::string_view> known;
  for (const SettingsChild& child : view.group->children) known.push_back(child.name);
  for (const Row& row : view.group->rows) known.push_back(row.name);
  const std::string begin = view.path.empty() ? "" : view.path + ".";
  if (known.empty())
    for (const SettingsAlias& alias : view.tree->aliases)
      if (alias.path.starts_with(begin)) known.push_back(alias.path.substr(begin.size()));
  std::vector<std::string> elsewhere;
  paths_of(*view.tree->group, "", name, elsewhere);
  const bool near = !nearest(name, known).empty();
  std::string advice = suggestion(name, known);
  if (!near && !elsewhere.empty()) {
    advice = "Did you mean ";
    for (const std::string& path : elsewhere)
      advice += (&path == &elsewhere.front() ? "" : " or ") + dalembert::in_quotes(path);
    advice += "?";
  }
  if (is_step_size(name) && std::ranges::find(known, "numberOfSteps") != known.end())
    advice = "The size of steps follows from their number: numberOfSteps = int(round((endTime - startTime)/stepSize)).";
  refuse(ErrorKind::name, {.problem = problem, .advice = advice});
}

}  // namespace dalembert
