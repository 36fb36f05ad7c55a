#include "platform/files.h"

#include "platform/descriptor.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

namespace coif::platform {
namespace {

namespace fs = std::filesystem;

std::optional<struct stat> status_of(const fs::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? std::optional(status) : std::nullopt;
}

std::chrono::nanoseconds duration_of(const timespec& time) {
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

std::error_code write_into(int file, std::span<const std::byte> bytes, Durability durability) {
  if (std::error_code why = write_all(file, bytes)) return why;
  return durability == Durability::kNow && ::fsync(file) != 0 ? last_error() : std::error_code{};
}

std::error_code write_opened(const fs::path& path, int flags, std::span<const std::byte> bytes, Durability durability) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666));
  if (!file.is_open()) return last_error();
  const std::error_code why = write_into(file.get(), bytes, durability);
  const std::error_code late = file.close();
  return why ? why : late;
}

/// Returns std::errc::not_supported, and has done nothing, if the file system has no files without a name, or if there
/// is no /proc.
std::error_code write_unnamed(const fs::path& path, std::span<const std::byte> bytes, Durability durability) {
  const auto cannot = std::make_error_code(std::errc::not_supported);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  Descriptor file(::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666));
  if (!file.is_open()) return cannot;
  std::error_code why = write_into(file.get(), bytes, durability);
  const std::string self = "/proc/self/fd/" + std::to_string(file.get());
  if (!why && ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) != 0) why = cannot;
  const std::error_code late = file.close();
  return why ? why : late;
}

}  // namespace

std::optional<std::string> file_number(const fs::path& path) {
  const auto status = status_of(path);
  if (!status) return std::nullopt;
  return std::to_string(status->st_dev) + ":" + std::to_string(status->st_ino);
}

std::optional<std::chrono::nanoseconds> file_change_time(const fs::path& path) {
  const auto status = status_of(path);
  return status ? std::optional(duration_of(status->st_ctim)) : std::nullopt;
}

std::chrono::nanoseconds file_clock_now() {
  timespec now{};
  clock_gettime(CLOCK_REALTIME_COARSE, &now);
  return duration_of(now);
}

std::error_code write_new_file(const fs::path& path, std::span<const std::byte> bytes, Durability durability) {
  const std::error_code why = write_unnamed(path, bytes, durability);
  if (why != std::errc::not_supported) return why;
  return write_opened(path, O_CREAT | O_EXCL | O_NOFOLLOW, bytes, durability);
}

std::error_code write_device(const fs::path& path, std::span<const std::byte> bytes) {
  return write_opened(path, 0, bytes, Durability::kSoon);
}

std::error_code sync_folder(const fs::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!opened.is_open()) return last_error();
  // A file system that keeps no folders on a disk refuses this.
  const bool is_done = ::fsync(opened.get()) == 0 || errno == EINVAL;
  return is_done ? std::error_code{} : last_error();
}

}  // namespace coif::platform
