// A file that cannot be written or read: its name, and the reason of the operating system.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace dalembert {

class FileError : public std::runtime_error {
 public:
  // `code`: errno. `purpose`, `problem`: "solution file", "cannot be opened".
  FileError(int code, std::string_view purpose, std::string_view problem, std::string file);

  int code() const { return code_; }
  const std::string& file() const { return file_; }
  const std::string& reason() const { return reason_; }  // excludes the name of the file

 private:
  int code_;
  std::string reason_, file_;
};

}  // namespace dalembert
