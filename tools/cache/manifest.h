#pragma once

#include "base/tool_error.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::cache {

/// One cook of a batch.
struct CookRequest {
  std::string source;
  std::optional<std::string> recipe;  ///< None: the source's own recipe, if there is one.
  std::string output;
};

/// The K-th of N batches, which together hold every request once.
struct Share {
  std::size_t index = 1;  ///< 1 .. count.
  std::size_t count = 1;
};

/// Reads a list of assets:
/// {"assets": ["heads/bob.fbx", {"source": "braid.glb", "recipe": "braids.json", "output": "hair/braid.coif"}]}
/// Paths of sources and recipes are relative to the manifest's folder. Outputs are relative to `output_folder` and stay
/// in it; by default an asset's path there is its source's path in the manifest's folder. Errors (kFileAccess,
/// kBadInput): unreadable, not of this form, an unknown key, or two assets with one output.
tl::expected<std::vector<CookRequest>, ToolError> read_manifest(const std::filesystem::path& manifest,
                                                                const std::filesystem::path& output_folder);

/// Every count-th request from the index-th on: neighbours, which are often of similar size, go to different batches.
[[nodiscard]] std::vector<CookRequest> share_of(const std::vector<CookRequest>& all, Share share);

/// A rule for build tools that need to know when `target` is out of date, in the syntax that Make and Ninja share, each
/// input once. Absent inputs are left out, since Ninja would rebuild the target for ever. Error (kUsage): a path with a
/// line break, which that syntax cannot express.
tl::expected<std::string, ToolError> depfile_text(const std::filesystem::path& target,
                                                  std::span<const std::filesystem::path> inputs);

}  // namespace coif::cache
