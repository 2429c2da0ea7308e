// Lists in texts about failures.
#pragma once

#include <string>
#include <vector>

namespace dalembert {

// Long lists end with how many more there are.
void shorten(std::vector<std::string>& lines);
// One below the other, with `shorten`.
std::string indented(std::vector<std::string> lines);

}  // namespace dalembert
