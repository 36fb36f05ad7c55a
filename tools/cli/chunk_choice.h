#pragma once
// Which parts of an asset a person means.

#include "base/tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif {

/// Chunks under a word that needs no table of the format.
struct ChunkGroup {
  const char* name;
  const char* meaning;  ///< What an asset is without them.
  std::vector<std::uint32_t> chunks;
};

[[nodiscard]] std::span<const ChunkGroup> chunk_groups();

/// The chunks that a list such as "textures,NAME" stands for, in letters of either case: groups, chunks of the format, and
/// whatever else the asset has. Errors (kUsage) say which word is none of these, with the nearest one, and which chunks no
/// asset is without.
tl::expected<std::vector<std::uint32_t>, ToolError> choose_chunks(const std::string& list, const Asset& asset);

}  // namespace coif
