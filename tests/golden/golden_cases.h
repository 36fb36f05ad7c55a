#pragma once
// The pictures of the sample that are kept in this folder.

#include "render/picture.h"
#include "report/opened_asset.h"

#include <coif/asset.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace coif {

struct GoldenCase {
  std::string name;  ///< Of the PNG, without suffix.
  PictureSettings settings;
};

/// Every side, a movement, and ways to draw whose pixels do not hang on a pattern.
[[nodiscard]] std::vector<GoldenCase> golden_cases();

/// A file's asset and the memory that it lives in.
class LoadedAsset {
 public:
  explicit LoadedAsset(const std::string& path);  ///< asset() stays closed where there is no such asset.
  [[nodiscard]] const Asset& asset() const { return asset_; }

 private:
  std::unique_ptr<std::byte, decltype(&std::free)> bytes_{nullptr, &std::free};
  Asset asset_;
};

}  // namespace coif
