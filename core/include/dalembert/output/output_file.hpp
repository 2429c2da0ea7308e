// A file that is written through a buffer of its own; nothing is formatted by streams.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace dalembert {

class OutputFile {
 public:
  // Missing folders are made. Throws std::runtime_error, naming file and reason.
  void open(const std::string& name, bool append, std::string_view purpose);
  bool is_open() const { return file_ != nullptr; }
  // Append to this; `written` keeps it short.
  std::string& text() { return buffer_; }
  void written() {
    if (buffer_.size() >= buffer_limit) hand_over();
  }
  void flush();
  void close();
  const std::string& name() const { return name_; }

  OutputFile() = default;
  OutputFile(OutputFile&&) = default;
  OutputFile& operator=(OutputFile&&) = default;
  ~OutputFile() { close(); }

 private:
  static constexpr std::size_t buffer_limit = 1 << 16;
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void hand_over();

  std::string name_, buffer_;
  std::unique_ptr<std::FILE, Closer> file_;
};

// "2026-01-31,12:00:00", local time.
std::string date_and_time();

}  // namespace dalembert
