// A file that takes the place of the one before when it is complete and on the disk, and not at all if that fails.
#pragma once

#include <string>
#include <string_view>

#include "dalembert/output/output_file.hpp"

namespace dalembert {

// A file that is written under a temporary name in the same folder, with the permissions of the previous file.
// Symbolic links are kept, and their target is replaced. Devices, pipes and similar files are written directly. All
// functions throw FileError.
class ReplacedFile {
 public:
  ReplacedFile(const std::string& name, std::string_view purpose);
  ReplacedFile(const ReplacedFile&) = delete;
  ReplacedFile& operator=(const ReplacedFile&) = delete;

  std::string& text() { return file_.text(); }
  // The previous file is kept with `backup_ending`. Nothing changes without commit.
  void commit(std::string_view backup_ending);

  // Whether the name is that of a device, pipe or the like.
  static bool is_written_in_place(const std::string& name);

 private:
  struct Unfinished {
    std::string name;  // "": there is none
    ~Unfinished();
  };
  int create_beside();
  void keep_as(const std::string& backup);
  void sync_folder();
  [[noreturn]] void fail(int code, std::string_view problem, const std::string& file) const;

  std::string purpose_, target_;
  Unfinished unfinished_;
  bool replaces_one_ = false;
  OutputFile file_;
};

}  // namespace dalembert
