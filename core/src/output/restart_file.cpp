#include "dalembert/output/restart_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <memory>

#include "dalembert/model/errors.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/output/replaced_file.hpp"

namespace dalembert {

namespace {

constexpr const char* title = "#dalembert restart file 5";
constexpr const char* purpose = "restart file";
constexpr const char* backup_ending = ".bck";
constexpr std::string_view checksum_word = "checksum ", solver_word = "solver ";

void append_line(std::string& text, const char* name, std::span<const double> values) {
  text += name;
  for (const double x : values) {
    text += ' ';
    append_exact(text, x);
  }
  text += '\n';
}

// FNV-1a: detects all accidental changes of a file.
std::string checksum(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  char digits[20];
  return {digits, std::to_chars(digits, digits + sizeof digits, hash, 16).ptr};
}

// Reads the text of a restart file, line by line; invalid text is rejected.
class Reader {
 public:
  explicit Reader(const std::string& name) : name_(name) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name.c_str(), "rb"), &std::fclose);
    if (!file) throw FileError(errno, purpose, "cannot be opened", name);
    std::array<char, 1 << 14> part;
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), file.get()))
      text_.append(part.data(), count);
    if (std::ferror(file.get())) throw FileError(errno, purpose, "cannot be read", name);
  }

  std::vector<double> values_of(std::string_view word) {
    std::string_view line = next_line();
    if (line.substr(0, line.find(' ')) != word) refuse_line("'" + std::string(word) + "' and its values,", line);
    line.remove_prefix(word.size());
    return numbers(line);
  }
  std::string text_of(std::string_view word) {
    const std::string_view line = next_line();
    if (!line.starts_with(word)) refuse_line("'" + std::string(word) + "' and its name,", line);
    return std::string(line.substr(word.size()));
  }
  void expect(std::string_view wanted) {
    const std::string_view line = next_line();
    if (line != wanted) refuse_line("'" + std::string(wanted) + "',", line);
  }
  void expect_checksum() {
    const std::size_t end = position_;
    const std::string_view line = next_line();
    const std::string wanted = std::string(checksum_word) + checksum(std::string_view(text_).substr(0, end));
    if (line != wanted) refuse_line("'" + wanted + "', the sum of the lines above,", line);
    if (position_ != text_.size()) refuse_line("the end of the file,", std::string_view(text_).substr(position_));
  }
  [[noreturn]] void refuse_line(const std::string& expected, std::string_view received) const {
    throw ModelError(
        ErrorKind::value,
        std::string(purpose) + " '" + name_ + "', line " + std::to_string(line_) + ": expected " + expected +
            " received '" + std::string(received.substr(0, std::min<std::size_t>(40, received.find('\n')))) +
            "'. The file is damaged or incomplete; the one before may be in '" + name_ + backup_ending + "'.");
  }

 private:
  // A line counts if it is complete.
  std::string_view next_line() {
    ++line_;
    const std::string_view rest = std::string_view(text_).substr(position_);
    const std::size_t length = rest.find('\n');
    if (length == rest.npos) refuse_line("a complete line,", rest);
    position_ += length + 1;
    return rest.substr(0, length);
  }

  std::vector<double> numbers(std::string_view line) const {
    std::vector<double> values;
    for (const char *p = line.data(), *end = p + line.size(); p != end;) {
      double x = 0;
      const auto result =
          *p == ' ' ? std::from_chars(p + 1, end, x) : std::from_chars_result{p, std::errc::invalid_argument};
      if (result.ec != std::errc()) refuse_line("numbers separated by blanks,", std::string_view(p, end));
      values.push_back(x);
      p = result.ptr;
    }
    return values;
  }

  std::string name_, text_;
  std::size_t position_ = 0;
  int line_ = 0;
};

}  // namespace

void check_restart_file(const std::string& name) {
  if (!ReplacedFile::is_written_in_place(name)) ReplacedFile(name, purpose);
}

void write_restart_file(const std::string& name, const RestartData& data) {
  ReplacedFile file(name, purpose);
  std::string& t = file.text();
  t += title;
  t += '\n';
  t += solver_word;
  t += data.solver + '\n';
  const State& state = data.state;
  append_line(t, "time", std::array{state.time, data.step_size});
  append_line(t, "run", data.run);
  append_line(t, "q", state.q);
  append_line(t, "v", state.v);
  append_line(t, "a", state.a);
  append_line(t, "algorithmic", data.algorithmic_accelerations);
  append_line(t, "y", state.y);
  append_line(t, "y_t", state.y_t);
  append_line(t, "lambda", state.lambda);
  append_line(t, "data", state.data);
  append_line(t, "events", data.events);
  append_line(t, "history", data.history);
  append_line(t, "files", data.files);
  const std::string sum = checksum(t);
  t += checksum_word;
  t += sum + '\n';
  file.commit(backup_ending);
}

RestartData read_restart_file(const std::string& name) {
  Reader file(name);
  file.expect(title);
  RestartData data;
  data.solver = file.text_of(solver_word);
  const std::vector<double> time = file.values_of("time");
  if (time.size() != 2) file.refuse_line("time and step size,", std::to_string(time.size()) + " numbers");
  data.state.time = time[0];
  data.step_size = time[1];
  data.run = file.values_of("run");
  data.state.q = file.values_of("q");
  data.state.v = file.values_of("v");
  data.state.a = file.values_of("a");
  data.algorithmic_accelerations = file.values_of("algorithmic");
  data.state.y = file.values_of("y");
  data.state.y_t = file.values_of("y_t");
  data.state.lambda = file.values_of("lambda");
  data.state.data = file.values_of("data");
  data.events = file.values_of("events");
  data.history = file.values_of("history");
  data.files = file.values_of("files");
  file.expect_checksum();
  return data;
}

void require_fitting(const RestartData& data, const State& system, const std::string& name) {
  if (std::ranges::all_of(
          std::array{&State::q, &State::v, &State::a, &State::y, &State::y_t, &State::lambda, &State::data},
          [&](const auto member) { return (data.state.*member).size() == (system.*member).size(); })) {
    return;
  }
  throw ModelError(ErrorKind::value,
                   std::string(purpose) + " '" + name + "': the numbers of coordinates are not those of this system");
}

}  // namespace dalembert
