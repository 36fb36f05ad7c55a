#pragma once

#include "files/file_bytes.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace coif {

/// An open asset together with the memory it looks into. Moving it leaves the asset's spans valid.
class AssetFile {
 public:
  /// Errors: those of FileBytes::read(), and kBadInput or kUnsupported (another format version) for what the reader
  /// refuses, with its evidence.
  static tl::expected<AssetFile, ToolError> open(const std::filesystem::path& path);

  [[nodiscard]] const Asset& asset() const { return asset_; }
  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_.span(); }

 private:
  explicit AssetFile(FileBytes bytes) : bytes_(std::move(bytes)) {}

  FileBytes bytes_;
  Asset asset_;
};

/// open() with every hash compared: a tool's files are looked at by people, who want to know.
LoadStatus open_whole(std::span<const std::byte> bytes, Asset& asset);

}  // namespace coif
