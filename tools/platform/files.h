#pragma once

#include <tl/expected.hpp>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>

namespace coif::platform {

/// When written data must be on the disk.
enum class Durability {
  kSoon,  ///< When the system finds time. After a loss of power the file may be empty.
  kNow,   ///< Before the name is taken, which is on the disk as well when the call returns.
};

/// Equal for two paths that lead to one file on the disk, through any links and hard links. None where no file exists.
[[nodiscard]] std::optional<std::string> file_number(const std::filesystem::path& path);

/// When a file's content, name or rights last changed, as file_clock_now() counts. Nothing where no file is there.
[[nodiscard]] std::optional<std::chrono::nanoseconds> file_change_time(const std::filesystem::path& path);

/// A moment as file systems stamp it, which is coarser than the clock. Since 1970.
[[nodiscard]] std::chrono::nanoseconds file_clock_now();

/// Writes a file that is not there yet. Where the file system can do that, the file has no name before it is whole, so
/// that a killed process leaves nothing behind. Returns why it could not, else nothing.
[[nodiscard]] std::error_code write_new_file(const std::filesystem::path& path, std::span<const std::byte> bytes,
                                             Durability durability);

/// Writes to a device or a pipe that is there. Returns why it could not, else nothing.
[[nodiscard]] std::error_code write_device(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Brings the names that were changed in a folder to the disk. Returns why it could not, else nothing.
[[nodiscard]] std::error_code sync_folder(const std::filesystem::path& folder);

/// The reason why a folder cannot be used.
struct FolderFault {
  std::filesystem::path place;
  std::error_code why;
};

/// An empty folder in the system's place for temporary files, which nobody else may read. It is removed with this
/// object, or with this process, however that ends: a small process waits for that and removes it. Holds files only.
class ScratchFolder {
 public:
  static tl::expected<ScratchFolder, FolderFault> create();
  ~ScratchFolder();
  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  class Keeper;
  ScratchFolder(std::filesystem::path path, std::unique_ptr<Keeper> keeper);

  std::filesystem::path path_;
  std::unique_ptr<Keeper> keeper_;
};

}  // namespace coif::platform
