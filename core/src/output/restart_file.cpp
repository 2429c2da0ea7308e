#include "dalembert/output/restart_file.hpp"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "dalembert/output/numbers.hpp"
#include "dalembert/output/output_file.hpp"

namespace dalembert {

namespace {

constexpr const char* title = "#dalembert restart file 1";

void append_line(std::string& text, const char* name, std::span<const double> values) {
  text += name;
  for (const double x : values) {
    text += ' ';
    append_exact(text, x);
  }
  text += '\n';
}

std::vector<double> read_numbers(const std::string& line, std::size_t begin, const std::string& where) {
  std::vector<double> numbers;
  const char *p = line.data() + begin, *end = line.data() + line.size();
  while (p != end) {
    if (*p == ' ') {
      ++p;
      continue;
    }
    double x = 0;
    const auto result = std::from_chars(p, end, x);
    if (result.ec != std::errc()) throw std::runtime_error(where + ": expected numbers separated by blanks");
    numbers.push_back(x);
    p = result.ptr;
  }
  return numbers;
}

}  // namespace

void write_restart_file(const std::string& name, const State& state, std::span<const double> algorithmic,
                        double step_size) {
  const std::string unfinished = name + ".part";
  OutputFile file;
  file.open(unfinished, false, "restart file");
  std::string& t = file.text();
  t += title;
  t += '\n';
  append_line(t, "time", std::array{state.time, step_size});
  append_line(t, "q", state.q);
  append_line(t, "v", state.v);
  append_line(t, "a", state.a);
  append_line(t, "algorithmic", algorithmic);
  append_line(t, "y", state.y);
  append_line(t, "y_t", state.y_t);
  append_line(t, "lambda", state.lambda);
  append_line(t, "data", state.data);
  file.close();
  std::filesystem::rename(unfinished, name);
}

RestartData read_restart_file(const std::string& name) {
  std::ifstream file(name);
  if (!file) throw std::runtime_error("cannot open restart file '" + name + "'");
  std::string line;
  if (!std::getline(file, line) || line != title) {
    throw std::runtime_error("restart file '" + name + "', line 1: expected '" + title + "', received '" + line + "'");
  }
  RestartData data;
  std::vector<double> time;
  const std::pair<const char*, std::vector<double>*> lines[] = {
      {"time", &time},           {"q", &data.state.q},     {"v", &data.state.v},
      {"a", &data.state.a},      {"algorithmic", &data.algorithmic_accelerations},
      {"y", &data.state.y},      {"y_t", &data.state.y_t}, {"lambda", &data.state.lambda},
      {"data", &data.state.data}};
  int number = 1;
  for (const auto& [word, values] : lines) {
    const std::string where = "restart file '" + name + "', line " + std::to_string(++number);
    std::getline(file, line);
    const std::string_view expected(word);
    if (line.substr(0, line.find(' ')) != expected) {
      throw std::runtime_error(where + ": expected '" + word + "' and its values, received '" + line.substr(0, 40) + "'");
    }
    *values = read_numbers(line, expected.size(), where);
  }
  if (time.size() != 2) throw std::runtime_error("restart file '" + name + "', line 2: expected time and step size");
  data.state.time = time[0];
  data.step_size = time[1];
  return data;
}

}  // namespace dalembert
