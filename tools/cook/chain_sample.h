#pragma once
// Parts of a skeleton as assets of their own, so that passes can run through the runtime what a game will run.

#include "write/asset_writer.h"

#include <coif/asset.h>

#include <memory>
#include <span>

namespace coif {

/// An opened asset and the bytes it lives in.
class OpenedAsset {
 public:
  /// `contents` must be valid: an asset that does not open is this program's mistake and leaves asset() closed.
  explicit OpenedAsset(const AssetContents& contents);

  [[nodiscard]] const Asset& asset() const { return asset_; }

 private:
  struct FreeMemory {
    void operator()(std::byte* bytes) const;
  };
  std::unique_ptr<std::byte[], FreeMemory> memory_;
  Asset asset_;
};

/// The rigid bones, colliders and these chains of a skeleton (indices into contents.chains, ascending), without names and
/// surface. Chains do not act on each other, so each moves as it does among all.
[[nodiscard]] AssetContents chains_alone(const AssetContents& contents, std::span<const std::uint32_t> chains);

}  // namespace coif
