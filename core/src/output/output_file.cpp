#include "dalembert/output/output_file.hpp"

#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <stdexcept>

namespace dalembert {

void OutputFile::open(const std::string& name, bool append, std::string_view purpose) {
  close();
  name_ = name;
  const auto folder = std::filesystem::path(name).parent_path();
  std::error_code ignored;
  if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
  file_.reset(std::fopen(name.c_str(), append ? "ab" : "wb"));
  if (!file_) {
    throw std::runtime_error("cannot open " + std::string(purpose) + " '" + name + "': " + std::strerror(errno) +
                             "; check folder and permissions, or choose another name");
  }
}

void OutputFile::hand_over() {
  if (file_) std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get());
  buffer_.clear();
}

void OutputFile::flush() {
  hand_over();
  if (file_) std::fflush(file_.get());
}

void OutputFile::close() {
  if (!file_) return;
  hand_over();
  file_.reset();
}

std::string date_and_time() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[32];
  const auto length = std::strftime(text, sizeof text, "%Y-%m-%d,%H:%M:%S", &local);
  return {text, length};
}

}  // namespace dalembert
