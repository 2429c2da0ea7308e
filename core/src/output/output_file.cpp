#include "dalembert/output/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <exception>
#include <filesystem>
#include <system_error>

#include "dalembert/model/errors.hpp"

namespace dalembert {

FileError::FileError(int code, std::string_view purpose, std::string_view problem, std::string file)
    : runtime_error(std::string(purpose) + " '" + file + "' " + std::string(problem) + ": " +
                    std::generic_category().message(code)),
      code_(code),
      reason_(std::string(purpose) + " " + std::string(problem) + ": " + std::generic_category().message(code)),
      file_(std::move(file)) {}

FileIdentity identity_of(const std::string& name) {
  struct stat status{};
  if (::stat(name.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
  return {status.st_dev, status.st_ino};
}

std::string& output_directory() {
  static std::string directory;
  return directory;
}

std::string output_path(const std::string& name) {
  const std::string& directory = output_directory();
  if (directory.empty() || name.empty()) return name;
  if (std::filesystem::path(name).is_absolute())
    refuse(ErrorKind::value, {.item = "exu.config",
                              .parameter = "outputDirectory",
                              .problem = "is '" + directory + "', but the name of a file is absolute",
                              .received = name,
                              .expected = "a relative name",
                              .advice = "Set exu.config.outputDirectory = ''."});
  return (std::filesystem::path(directory) / name).string();
}

void make_folder_of(const std::string& name) {
  const auto folder = std::filesystem::path(name).parent_path();
  std::error_code ignored;
  if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
}

void OutputFile::open(const std::string& name, bool append, std::string_view purpose) {
  close();
  make_folder_of(name);
  const int flags = O_WRONLY | O_CREAT | O_CLOEXEC | O_NOCTTY | (append ? O_APPEND : O_TRUNC);
  const int descriptor = ::open(name.c_str(), flags, 0666);
  if (descriptor < 0) throw FileError(errno, purpose, "cannot be opened", name);
  adopt(descriptor, name, purpose);
}

void OutputFile::resume(const std::string& name, double length, std::string_view purpose) {
  if (length < 0) return open(name, false, purpose);
  open(name, true, purpose);
  struct stat status{};
  if (::fstat(descriptor_, &status) != 0) fail(errno, "cannot be read");
  if (!S_ISREG(status.st_mode)) return;
  const auto wanted = static_cast<off_t>(length);
  if (status.st_size < wanted) {
    throw ModelError(ErrorKind::value,
                     std::string(purpose) + " '" + name + "': expected at least " + std::to_string(wanted) +
                         " bytes, as there were when the restart file was written; received " +
                         std::to_string(status.st_size) + ". Restore the file, or write to one with another name");
  }
  if (::ftruncate(descriptor_, wanted) != 0) fail(errno, "cannot be shortened");
}

double OutputFile::length() {
  if (!is_open()) return -1;
  sync();
  struct stat status{};
  return ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode) ? static_cast<double>(status.st_size) : -1;
}

void OutputFile::adopt(int descriptor, const std::string& name, std::string_view purpose) {
  descriptor_ = descriptor;
  name_ = name;
  purpose_ = purpose;
  buffer_.clear();
  failure_ = 0;
}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  if (this == &other) return *this;
  close_quietly();
  name_ = std::move(other.name_);
  purpose_ = std::move(other.purpose_);
  buffer_ = std::move(other.buffer_);
  descriptor_ = std::exchange(other.descriptor_, -1);
  failure_ = other.failure_;
  return *this;
}

void OutputFile::fail(int code, std::string_view problem) {
  failure_ = code;
  buffer_.clear();
  throw FileError(code, purpose_, problem, name_);
}

void OutputFile::flush() {
  if (!is_open()) return buffer_.clear();
  if (failure_ != 0) fail(failure_, "cannot be written");
  for (std::string_view rest = buffer_; !rest.empty();) {
    const auto count = ::write(descriptor_, rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(errno, "cannot be written");
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  buffer_.clear();
}

void OutputFile::sync() {
  flush();
  const bool synchronized = !is_open() || ::fsync(descriptor_) == 0 || errno == EINVAL;  // EINVAL: a device or pipe
  if (!synchronized) fail(errno, "cannot be written to the disk");
}

void OutputFile::close() {
  if (!is_open()) return;
  if (failure_ == 0) flush();
  const int closed = ::close(std::exchange(descriptor_, -1));
  if (closed != 0 && errno != EINTR && failure_ == 0) fail(errno, "cannot be closed");
}

void OutputFile::close_quietly() noexcept {
  try {
    close();
  } catch (const FileError&) {
    if (is_open()) ::close(std::exchange(descriptor_, -1));
  }
}

void close_all(std::span<OutputFile> files) {
  std::exception_ptr first;
  for (OutputFile& file : files) {
    try {
      file.close();
    } catch (const FileError&) {
      if (!first) first = std::current_exception();
    }
  }
  if (first) std::rethrow_exception(first);
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
