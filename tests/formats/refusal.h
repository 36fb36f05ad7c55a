#pragma once

#include "formats/aligned_bytes.h"
#include "formats/small_asset.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

namespace coif {

inline LoadStatus open_written(const AssetContents& contents) {
  AlignedBytes file(write_asset(contents));
  Asset asset;
  const LoadStatus status = asset.open(file.bytes());
  EXPECT_EQ(asset.is_open(), bool(status)) << "a refused asset must leave the view empty";
  return status;
}

/// What open() says of small_asset() after a change; kOk where the change is allowed.
template <typename Change>
LoadCode refusal(Change change) {
  AssetContents contents = small_asset();
  change(contents);
  return open_written(contents).code;
}

}  // namespace coif
