#pragma once

#include "write/asset_writer.h"

#include <coif/asset.h>

#include <cstddef>
#include <memory>

namespace coif {

/// An asset made in memory, and the bytes it lives in: what is to be measured is run as a game would run it.
class OpenedAsset {
 public:
  /// Contents that the format does not allow leave asset() closed.
  explicit OpenedAsset(const AssetContents& contents);

  [[nodiscard]] const Asset& asset() const { return asset_; }

 private:
  struct FreeMemory {
    void operator()(std::byte* bytes) const;
  };

  std::unique_ptr<std::byte[], FreeMemory> bytes_;
  Asset asset_;
};

}  // namespace coif
