#pragma once

#include "base/tool_error.h"
#include "platform/files.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace coif {

/// A whole file in memory that starts at a multiple of 64, as an asset with textures wants it.
class FileBytes {
 public:
  static constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 30;

  /// Errors: kFileAccess where the file is absent, not a regular file or not readable, kBadInput above kMaxBytes.
  static tl::expected<FileBytes, ToolError> read(const std::filesystem::path& path);

  /// Bytes that were never in a file, placed as one's are.
  static FileBytes copy(std::span<const std::byte> bytes);

  [[nodiscard]] std::span<const std::byte> span() const { return {bytes_.get(), size_}; }

 private:
  struct Free {
    void operator()(std::byte* bytes) const { std::free(bytes); }
  };

  explicit FileBytes(std::size_t size);

  std::unique_ptr<std::byte, Free> bytes_;
  std::size_t size_ = 0;
};

/// True for the few lines that Git LFS leaves in place of a file whose content was not fetched.
[[nodiscard]] bool is_lfs_pointer(std::string_view bytes);
inline constexpr const char* kLfsPointer = "Git LFS has not fetched what is in this file; run 'git lfs pull'";

/// Folders in which the files that a source names may lie, without links: the folder of its path; its real folder where
/// the source is a link (build systems and big stores hand out links); and the folders of `roots`, which the caller has
/// declared. Absent folders are left out; empty where the source's own folder is absent.
[[nodiscard]] std::vector<std::filesystem::path> folders_of_source(const std::filesystem::path& source,
                                                                   std::span<const std::filesystem::path> roots);

/// Whether an existing file really lies in or below one of these folders, wherever links on its path lead. `folders` is
/// from folders_of_source(). False for an absent file.
[[nodiscard]] bool lies_in(const std::filesystem::path& file, std::span<const std::filesystem::path> folders);

/// Equal for two paths that lead to one file: the same file on the disk through any links and hard links, or the same
/// place where there is no file yet. Empty for an empty path.
[[nodiscard]] std::string file_identity(const std::filesystem::path& path);

/// Finds out before the long work whether its result could be written: the folder exists, the path is no folder and not
/// "-", and leads to none of `inputs` (file_identity(); empty paths do not count). Errors: kFileAccess, kUsage.
tl::expected<void, ToolError> check_output(const std::filesystem::path& output,
                                           std::span<const std::filesystem::path> inputs);
tl::expected<void, ToolError> check_output(const std::filesystem::path& output,
                                           std::initializer_list<std::filesystem::path> inputs);

/// An output of a command, with its name on the command line.
struct NamedOutput {
  const char* option;
  std::filesystem::path path;  ///< Empty: not requested.
};

/// Calls check_output() for each, and checks that no two are the same file. Errors: those of check_output().
tl::expected<void, ToolError> check_outputs(std::span<const NamedOutput> outputs,
                                            std::span<const std::filesystem::path> inputs);

/// The output's suffix in lower case, with its dot, when it is one of `allowed`. Error (kUsage): lists them.
tl::expected<std::string, ToolError> choose_suffix(const std::filesystem::path& output,
                                                   std::initializer_list<std::string_view> allowed);

/// Writes the whole file or nothing: into a temporary file in the same folder, which then takes the name. An existing
/// file is whole at every moment and survives a failure. Devices and pipes are written directly. Errors: kFileAccess.
tl::expected<void, ToolError> write_output(const std::filesystem::path& output, std::span<const std::byte> bytes,
                                           platform::Durability durability = platform::Durability::kSoon);

}  // namespace coif
