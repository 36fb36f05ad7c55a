#pragma once

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <string>

namespace coif {

/// Do the chunks of a cooked asset hold the bytes that they held when tests/golden/cooks.txt was written? Most of what
/// a cook decides is judgement, with thresholds that no law of nature gives and no property pins; but none of it may
/// change unseen. Where a change is meant, tests/golden/renew.sh writes the file anew. What says only where an asset
/// comes from is not compared. `name`: of the cook, one word. Errors name the chunks.
[[nodiscard]] testing::AssertionResult is_cooked_as_before(const std::string& name, const Asset& asset);

}  // namespace coif
