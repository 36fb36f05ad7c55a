#include "cli/asset_file.h"

#include "validate/asset_issues.h"

#include <fmt/format.h>

#include <utility>

namespace coif {
namespace {

ToolError::Kind error_kind(LoadCode code) {
  const bool newer = code == LoadCode::kMajorVersion || code == LoadCode::kChunkUnknown;
  return newer ? ToolError::Kind::kUnsupported : ToolError::Kind::kBadInput;
}

const char* cure(LoadCode code) {
  return code == LoadCode::kMagic ? "give a file written by 'coif cook'" : "cook its source again";
}

}  // namespace

LoadStatus open_whole(std::span<const std::byte> bytes, Asset& asset) {
  LoadStatus status = asset.open(bytes);
  if (status) status = asset.verify_draw_data();
  if (!status) asset = Asset{};
  return status;
}

tl::expected<AssetFile, ToolError> AssetFile::open(const std::filesystem::path& path) {
  auto bytes = FileBytes::read(path);
  if (!bytes) return tl::unexpected(bytes.error());
  AssetFile file(std::move(*bytes));
  const LoadStatus status = open_whole(file.bytes_.span(), file.asset_);
  if (!status) {
    return tl::unexpected(ToolError{
        error_kind(status.code), fmt::format("{}: {}; {}", path.string(), describe_text(status), cure(status.code))});
  }
  return file;
}

}  // namespace coif
