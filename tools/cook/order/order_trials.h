#pragma once

#include "base/tool_error.h"
#include "cook/texture/image.h"
#include "platform/stop.h"
#include "visibility/fragment_view.h"
#include "visibility/hair_surface.h"
#include "write/asset_writer.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <map>
#include <span>
#include <string_view>
#include <vector>

namespace coif::cook {

/// The poses for which orders are found: at rest and, for hair that moves, thrown to both sides and back, and blown
/// back. `solver`: its name in a recipe. Errors: those of simulate_pose().
tl::expected<std::vector<visibility::HairPositions>, ToolError> find_order_poses(const Asset& asset,
                                                                                 std::string_view solver);

/// Alpha of the hair for different opaque thresholds. For each, mips keep their coverage (mips_for_threshold()). Each
/// is made once.
class ThresholdAlpha {
 public:
  /// `plain`: alpha of the present contents. Keeps references to contents and `used`, whose texels must not change.
  ThresholdAlpha(const AssetContents& contents, std::span<const Image> used, visibility::AlphaTexture plain,
                 const platform::Threads& threads)
      : contents_(contents), used_(used), plain_(std::move(plain)), threads_(threads) {}

  /// Makes the missing ones in parallel.
  void prepare(std::span<const float> thresholds);

  [[nodiscard]] const visibility::AlphaTexture& at(float threshold);

 private:
  const AssetContents& contents_;
  std::span<const Image> used_;
  visibility::AlphaTexture plain_;
  platform::Threads threads_;
  std::map<float, visibility::AlphaTexture> made_;
};

}  // namespace coif::cook
