#include "base/asset_refusal.h"

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

std::string describe_text(const LoadStatus& status) {
  if (status.code == LoadCode::kMagic) return describe(status.code);  // The first byte of a text file helps nobody.
  char text[256];
  return std::string(text, describe(status, text, sizeof text));
}

ToolError refusal_of(const LoadStatus& status) {
  return {error_kind(status.code), describe_text(status) + "; " + cure(status.code)};
}

}  // namespace coif
