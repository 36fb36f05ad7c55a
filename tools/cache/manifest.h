#pragma once

#include "base/tool_error.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::cache {

/// One cook of many.
struct CookRequest {
  std::string source;
  std::optional<std::string> recipe;  ///< None: the source's own, where there is one.
  std::string output;
};

/// The K-th of N batches, which together hold every request once.
struct Share {
  std::size_t index = 1;  ///< 1 .. count.
  std::size_t count = 1;
};

/// Reads a list of assets, as many machines read the same one:
///   {"assets": ["heads/bob.fbx", {"source": "braid.glb", "recipe": "braids.json", "output": "hair/braid.coif"}]}
/// Sources and recipes start at the manifest's folder. Outputs start at `output_folder` and stay in it; without one of
/// its own, an asset lies there as its source lies in the manifest's folder. Errors (kFileAccess, kBadInput):
/// unreadable, not of this form, an unknown key, or two assets with one output.
tl::expected<std::vector<CookRequest>, ToolError> read_manifest(const std::filesystem::path& manifest,
                                                                const std::filesystem::path& output_folder);

/// Every count-th request from the index-th on: neighbours, which are often of a size, go to different batches.
[[nodiscard]] std::vector<CookRequest> share_of(const std::vector<CookRequest>& all, Share share);

/// What a build tool reads to know when `target` is out of date: one rule in the syntax of Make that Ninja reads too,
/// each input once. Inputs that are absent are left out, since Ninja would take the target for outdated for ever. Error
/// (kUsage): a path with a line break, which that syntax cannot say.
tl::expected<std::string, ToolError> depfile_text(const std::filesystem::path& target,
                                                  std::span<const std::filesystem::path> inputs);

}  // namespace coif::cache
