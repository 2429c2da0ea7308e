#include "dalembert/output/replaced_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace dalembert {
namespace {

constexpr int most_links = 40, most_leftovers = 1000;

// Status of a name, without following a link; nullopt if it does not exist.
std::optional<struct stat> status_of(const std::string& name) {
  struct stat status{};
  if (::lstat(name.c_str(), &status) != 0) return std::nullopt;
  return status;
}

// The name at the end of a chain of links, whether there is a file of that name or not; "": a chain without end.
std::string end_of_links(const std::string& name) {
  std::filesystem::path end = name;
  for (int i = 0; i < most_links; ++i) {
    std::error_code none;
    if (!std::filesystem::is_symlink(std::filesystem::symlink_status(end, none))) return end.string();
    end = end.parent_path() / std::filesystem::read_symlink(end, none);
  }
  return "";
}

// Endings are unique: a file that is removed later must not belong to another thread or process.
std::string unused_ending() {
  static std::atomic<std::uint64_t> given = 0;
  return ".part" + std::to_string(::getpid()) + "-" + std::to_string(given++);
}

// Calls `create` with names that begin as `target` does until one is free; false: see errno.
template <class Create>
bool create_free(const std::string& target, std::string& name, Create&& create) {
  for (int i = 0; i < most_leftovers; ++i) {
    name = target + unused_ending();
    if (create(name)) return true;
    if (errno != EEXIST && !(errno == ENOENT && status_of(target)))
      break;  // no file, as another thread was replacing it just then
  }
  name.clear();  // does not change errno
  return false;
}

}  // namespace

ReplacedFile::ReplacedFile(const std::string& name, std::string_view purpose)
    : purpose_(purpose), target_(end_of_links(name)) {
  if (target_.empty()) fail(ELOOP, "cannot be opened", name);
  const auto before = status_of(target_);
  if (before && !S_ISREG(before->st_mode)) {
    file_.open(target_, false, purpose);
    return;
  }
  replaces_one_ = before.has_value();
  if (replaces_one_ && ::access(target_.c_str(), W_OK) != 0) fail(errno, "cannot be opened", target_);
  const int descriptor = create_beside();
  file_.adopt(descriptor, target_, purpose_);
  if (before && ::fchmod(descriptor, before->st_mode & 07777) != 0)
    fail(errno, "cannot get the permissions of the one before", target_);
}

int ReplacedFile::create_beside() {
  make_folder_of(target_);
  int descriptor = -1;
  const bool created = create_free(target_, unfinished_.name, [&descriptor](const std::string& free) {
    descriptor = ::open(free.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    return descriptor >= 0;
  });
  if (!created) fail(errno, "cannot be opened", target_);
  return descriptor;
}

ReplacedFile::Unfinished::~Unfinished() {
  if (!name.empty()) ::unlink(name.c_str());
}

void ReplacedFile::commit(std::string_view backup_ending) {
  file_.sync();
  file_.close();
  if (unfinished_.name.empty()) return;
  if (replaces_one_) keep_as(target_ + std::string(backup_ending));
  if (std::rename(unfinished_.name.c_str(), target_.c_str()) != 0) fail(errno, "cannot be replaced", target_);
  unfinished_.name.clear();
  sync_folder();
}

// There is a file under one of both names at any moment, and where links between names are possible under `target_`.
void ReplacedFile::keep_as(const std::string& backup) {
  const auto before = status_of(backup);
  if (before && !S_ISREG(before->st_mode))
    fail(EEXIST, "cannot be kept under a name that is no regular file's", backup);
  std::string second_name;
  const bool linked = create_free(
      target_, second_name, [this](const std::string& free) { return ::link(target_.c_str(), free.c_str()) == 0; });
  if (std::rename((linked ? second_name : target_).c_str(), backup.c_str()) != 0) {
    const int code = errno;
    if (linked) ::unlink(second_name.c_str());
    fail(code, "cannot be kept", backup);
  }
  if (linked) ::unlink(second_name.c_str());  // still there if both names were those of one file
}

void ReplacedFile::sync_folder() {
  const auto folder = std::filesystem::path(target_).parent_path();
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // a folder that can be written to but not read
  const int code = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (code != 0 && code != EINVAL) fail(code, "cannot be written to the disk", target_);
}

void ReplacedFile::fail(int code, std::string_view problem, const std::string& file) const {
  throw FileError(code, purpose_, problem, file);
}

bool ReplacedFile::is_written_in_place(const std::string& name) {
  const auto status = status_of(end_of_links(name));
  return status && !S_ISREG(status->st_mode) && !S_ISDIR(status->st_mode);
}

}  // namespace dalembert
