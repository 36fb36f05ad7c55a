#include "files/file_bytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <new>
#include <system_error>

namespace coif {
namespace {

constexpr std::size_t kAlignment = 64;

tl::unexpected<ToolError> cannot_open(const std::filesystem::path& path, const std::error_code& why) {
  return tl::unexpected(
      ToolError{ToolError::Kind::kFileAccess, fmt::format("{}: cannot open: {}", path.string(), why.message())});
}

tl::expected<std::size_t, ToolError> readable_size(const std::filesystem::path& path) {
  std::error_code why;
  const auto status = std::filesystem::status(path, why);
  if (!std::filesystem::exists(status)) {
    return cannot_open(path, why ? why : std::make_error_code(std::errc::no_such_file_or_directory));
  }
  if (std::filesystem::is_directory(status)) return cannot_open(path, std::make_error_code(std::errc::is_a_directory));
  // A pipe has no size, and opening one would wait for a writer.
  if (!std::filesystem::is_regular_file(status)) {
    return tl::unexpected(
        ToolError{ToolError::Kind::kFileAccess, fmt::format("{}: cannot open: not a regular file", path.string())});
  }
  const std::uintmax_t size = std::filesystem::file_size(path, why);
  if (why) return cannot_open(path, why);
  if (size > FileBytes::kMaxBytes) {
    return tl::unexpected(ToolError{
        ToolError::Kind::kBadInput,
        fmt::format("{}: {} bytes are more than the {} that are accepted", path.string(), size, FileBytes::kMaxBytes)});
  }
  return static_cast<std::size_t>(size);
}

}  // namespace

FileBytes::FileBytes(std::size_t size) : size_(size) {
  bytes_.reset(static_cast<std::byte*>(std::aligned_alloc(kAlignment, (size / kAlignment + 1) * kAlignment)));
  if (!bytes_) throw std::bad_alloc();
}

FileBytes FileBytes::copy(std::span<const std::byte> bytes) {
  FileBytes result(bytes.size());
  std::ranges::copy(bytes, result.bytes_.get());
  return result;
}

tl::expected<FileBytes, ToolError> FileBytes::read(const std::filesystem::path& path) {
  const auto size = readable_size(path);
  if (!size) return tl::unexpected(size.error());
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return cannot_open(path, std::error_code(errno, std::generic_category()));

  FileBytes result(*size);
  if (std::fread(result.bytes_.get(), 1, *size, file.get()) != *size) {
    return tl::unexpected(ToolError{ToolError::Kind::kFileAccess, fmt::format("{}: cannot read", path.string())});
  }
  return result;
}

}  // namespace coif
