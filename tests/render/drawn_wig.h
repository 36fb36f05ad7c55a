#pragma once

#include "models/absent.h"
#include "models/drawn_card.h"
#include "models/skinned_asset.h"
#include "render/crowd_stage.h"

#include <gtest/gtest.h>

#include <vector>

namespace coif::render {

/// A small wig at rest; counts what a measurement does with its crowds. Skips where there is nothing to draw with.
class DrawnWigTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!EglContext::create()) COIF_FAIL_FOR_LACK_OF("no EGL device with OpenGL ES 3.0");
  }

  MakeCrowd maker() {
    return [this](std::uint32_t heads) -> tl::expected<DrawnCrowd, ToolError> {
      made_.push_back(heads);
      return DrawnCrowd{[this] { ++steps_; }, [this](std::uint32_t) { return std::span<const Mat34>(palette_); }};
    };
  }

  static tl::expected<DrawnCrowd, ToolError> nobody(std::uint32_t) {
    return tl::unexpected(ToolError{ToolError::Kind::kInternal, "nobody came"});
  }

  DrawnAsset wig_{made_up_wig({.strips = 6, .bones_per_chain = 2, .texture_size = 32})};
  std::vector<Mat34> palette_ = std::vector<Mat34>((*wig_).bones().size());
  std::vector<std::uint32_t> made_;
  unsigned steps_ = 0;
};

}  // namespace coif::render
