// Lists in error messages.
#pragma once

#include <string>
#include <vector>

namespace dalembert {

// Shortens a long list; the last line is the number of omitted lines.
void shorten(std::vector<std::string>& lines);
// Returns a shortened list with one indented line per entry.
std::string indented(std::vector<std::string> lines);

}  // namespace dalembert
