#pragma once

#include "models/small_asset.h"
#include "validate/find_issues.h"
#include "write/asset_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace coif::validate {

/// A small asset of a head, one chain of two bones and three patches that raises no issue.
[[nodiscard]] AssetContents sound_asset();

/// Codes of all that is found in `contents`, each once; fails the test where the reader refuses it.
[[nodiscard]] std::set<std::string> codes_of(const AssetContents& contents);

[[nodiscard]] inline std::set<std::string> codes_of(const Diagnostics& issues) {
  std::set<std::string> codes;
  for (const Diagnostic& issue : issues) codes.insert(issue.code);
  return codes;
}

/// A change to sound_asset() that raises `code`.
struct Doubt {
  const char* code;
  void (*change)(AssetContents&);
};

[[nodiscard]] std::span<const Doubt> body_doubts();     ///< Skeleton, dynamics, quality.
[[nodiscard]] std::span<const Doubt> surface_doubts();  ///< Geometry, patches, orders, skin, textures.

}  // namespace coif::validate
