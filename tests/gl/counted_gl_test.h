#pragma once

#include "gl/counted_calls.h"
#include "gl/gl_test.h"

#include <optional>

namespace coif {

/// A GlTest whose renderer is counted.
class CountedGlTest : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (!context_) return;
    renderer_.destroy();
    calls_.emplace(context_->loader());
    ASSERT_EQ(renderer_.create(calls_->loader(), kSmallBlocks), Status::kOk) << renderer_.failure();
  }

  std::optional<CountedCalls> calls_;
};

}  // namespace coif
