#pragma once

#include <tl/expected.hpp>

#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

namespace coif::platform {

/// Why there is no folder in a place.
struct FolderFault {
  std::filesystem::path place;
  std::error_code why;
};

/// An empty folder in the system's place for temporary files, which nobody else may read, and which goes with this
/// object, or with this process, however that ends: a small process of its own waits for that and removes it. Holds
/// files only.
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
