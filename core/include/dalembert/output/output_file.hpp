// A file that is written through a buffer of its own; nothing is formatted by streams, and nothing is lost unseen.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "dalembert/output/file_error.hpp"

namespace dalembert {

// Identity of a file, independent of its name; {0, 0} for devices, pipes and missing files.
using FileIdentity = std::pair<unsigned long long, unsigned long long>;
FileIdentity identity_of(const std::string& name);

// All functions throw FileError when the operating system refuses.
class OutputFile {
 public:
  // Missing folders are made.
  void open(const std::string& name, bool append, std::string_view purpose);
  // Continues a file at this length; the rest is truncated. A negative length makes a new file.
  void resume(const std::string& name, double length, std::string_view purpose);
  // Length on the disk; negative if the file has no length, or is not open.
  double length();
  // Takes over an open file; `name` is that of messages.
  void adopt(int descriptor, const std::string& name, std::string_view purpose);
  bool is_open() const { return descriptor_ >= 0; }
  // Append to this; `written` keeps it short.
  std::string& text() { return buffer_; }
  void written() {
    if (buffer_.size() >= buffer_limit) flush();
  }
  void flush();
  void sync();  // onto the disk
  void close();
  const std::string& name() const { return name_; }

  OutputFile() = default;
  OutputFile(OutputFile&& other) noexcept { *this = std::move(other); }
  OutputFile& operator=(OutputFile&& other) noexcept;
  ~OutputFile() { close_quietly(); }

 private:
  static constexpr std::size_t buffer_limit = 1 << 16;
  [[noreturn]] void fail(int code, std::string_view problem);
  void close_quietly() noexcept;

  std::string name_, purpose_, buffer_;
  int descriptor_ = -1;
  int failure_ = 0;  // nothing is written after the first error, so that the file has no gaps
};

// All are closed, then the first error is thrown.
void close_all(std::span<OutputFile> files);

// The folder of files of solvers, sensors and exu.SetWriteToFile; empty: the names are used as they are.
std::string& output_directory();
// The name of such a file in that folder; an absolute name is refused if there is one.
std::string output_path(const std::string& name);
// Makes the folder of a file; errors appear when the file is opened.
void make_folder_of(const std::string& name);

// "2026-01-31,12:00:00", local time.
std::string date_and_time();

}  // namespace dalembert
