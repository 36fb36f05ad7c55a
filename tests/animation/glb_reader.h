#pragma once

// Reads back what a test needs of a binary glTF, without the code under test.

#include "models/small_asset.h"
#include "write/asset_writer.h"

#include <coif/asset.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::animation {

class GlbReader {
 public:
  /// False where the container's header, chunks and sizes do not fit each other.
  bool read(std::span<const std::byte> file);

  [[nodiscard]] const nlohmann::json& document() const { return document_; }
  [[nodiscard]] std::span<const std::byte> view(std::size_t index) const;
  [[nodiscard]] std::vector<float> floats(std::size_t accessor) const;
  [[nodiscard]] std::vector<std::uint8_t> bytes(std::size_t accessor) const;

  /// World transform of a node at the key `frame` of animation 0, by the rules of the specification, 3.6 and 3.11.
  [[nodiscard]] Eigen::Affine3d world_from_node(std::size_t node, std::size_t frame) const;

 private:
  [[nodiscard]] Eigen::Affine3d local(std::size_t node, std::size_t frame) const;
  [[nodiscard]] std::vector<float> key(std::size_t node, const char* path, std::size_t frame, std::size_t width) const;

  nlohmann::json document_;
  std::vector<std::byte> binary_;
};

/// Written contents, opened; is_open() tells whether the reader took them.
class OpenAsset {
 public:
  explicit OpenAsset(const AssetContents& contents) : bytes_(write_asset(contents)) {
    if (!asset_.open(bytes_.bytes())) asset_ = Asset{};
  }
  [[nodiscard]] const Asset& asset() const { return asset_; }

 private:
  AlignedBytes bytes_;
  Asset asset_;
};

}  // namespace coif::animation
