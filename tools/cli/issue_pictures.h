#pragma once

#include "validate/issue.h"

#include <coif/asset.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif {

struct IssuePicture {
  std::uint32_t patch = 0;
  std::vector<std::uint8_t> png;
};

struct IssuePictures {
  std::vector<IssuePicture> pictures;  ///< One of each patch that has an issue; of the first dozen.
  std::string why_none;                ///< Set where nothing can be drawn here.
};

/// Every patch that `issues` name, red among grey ones, seen from its own side.
[[nodiscard]] IssuePictures picture_issues(const Asset& asset, std::span<const Issue> issues);

}  // namespace coif
