#include "import/readable_file.h"

#include "import/file_error.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace coif {
namespace fs = std::filesystem;

tl::expected<void, ToolError> check_readable(const fs::path& path, std::uint64_t max_bytes) {
  using Kind = ToolError::Kind;
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) {
    return tl::unexpected(
        file_error(Kind::kFileAccess, path, "cannot open: {}; check the path", code ? code.message() : "no such file"));
  }
  if (fs::is_directory(status)) {
    return tl::unexpected(file_error(Kind::kFileAccess, path, "is a folder; name the model file in it"));
  }
  if (!fs::is_regular_file(status)) return tl::unexpected(file_error(Kind::kFileAccess, path, "is not a regular file"));
  if (!std::ifstream(path, std::ios::binary)) {
    return tl::unexpected(
        file_error(Kind::kFileAccess, path, "cannot open: {}; check its permissions", std::strerror(errno)));
  }
  const std::uintmax_t size = fs::file_size(path, code);
  if (code) return tl::unexpected(file_error(Kind::kFileAccess, path, "cannot open: {}", code.message()));
  if (size == 0) return tl::unexpected(file_error(Kind::kBadInput, path, "the file is empty; {}", kReexport));
  if (size > max_bytes) {
    return tl::unexpected(
        file_error(Kind::kBadInput, path, "{} bytes, and the limit is {}; {}", size, max_bytes, kReduce));
  }
  return {};
}

}  // namespace coif
