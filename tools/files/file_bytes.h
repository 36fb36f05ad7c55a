#pragma once

#include "tool_error.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <span>

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

}  // namespace coif
