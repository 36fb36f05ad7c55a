#pragma once

#include "formats/aligned_bytes.h"
#include "formats/small_asset.h"
#include "write/asset_writer.h"

#include <coif/asset.h>

namespace coif {

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

}  // namespace coif
