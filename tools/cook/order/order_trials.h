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

/// The hair in the poses that orders are found for: at rest, then, where it moves, thrown to both sides and back, and
/// blown back. `solver`: by its name in a recipe. Errors: those of simulate_pose().
tl::expected<std::vector<visibility::HairPositions>, ToolError> find_order_poses(const Asset& asset,
                                                                                 std::string_view solver);

/// Alpha of the hair as it is drawn with one or another opaque threshold, for each of which mips keep their coverage
/// (mips_for_threshold()). Each is made once.
class ThresholdAlpha {
 public:
  /// `plain`: of the contents as they are. Keeps references to contents and `used`, whose texels must not change.
  ThresholdAlpha(const AssetContents& contents, std::span<const Image> used, visibility::AlphaTexture plain,
                 const platform::Threads& threads)
      : contents_(contents), used_(used), plain_(std::move(plain)), threads_(threads) {}

  /// Makes those that are missing, beside each other.
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
