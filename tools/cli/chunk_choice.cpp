#include "cli/chunk_choice.h"

#include "base/text.h"
#include "write/chunk_file.h"
#include "write/strip_asset.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace coif {
namespace {

using Ids = std::vector<std::uint32_t>;

std::string in_case(std::string text, int (*letter)(int)) {
  for (char& c : text) c = char(letter(static_cast<unsigned char>(c)));
  return text;
}

/// Chunks of the format and those that only this asset has.
Ids nameable_chunks(const Asset& asset) {
  Ids ids(std::begin(kKnownChunks), std::end(kKnownChunks));
  for (const ChunkEntry& entry : asset.chunks()) {
    if (std::ranges::find(ids, entry.id) == ids.end()) ids.push_back(entry.id);
  }
  return ids;
}

tl::unexpected<ToolError> unknown_word(const std::string& word, const Ids& chunks) {
  std::vector<std::string> words, groups;
  for (const ChunkGroup& group : chunk_groups()) groups.emplace_back(group.name);
  words = groups;
  for (const std::uint32_t id : chunks) words.push_back(in_case(chunk_name(id), std::tolower));
  const std::string nearest = nearest_word(in_case(word, std::tolower), words);
  const bool is_group = std::ranges::find(groups, nearest) != groups.end();
  const std::string cure =
      nearest.empty() ? fmt::format("use {}, or a chunk's name as 'coif info' prints it", fmt::join(groups, ", "))
                      : fmt::format("did you mean '{}'?", is_group ? nearest : in_case(nearest, std::toupper));
  return usage(fmt::format("--without: '{}' is no part of an asset; {}", word, cure));
}

tl::expected<Ids, ToolError> chunks_of(const std::string& word, const Ids& chunks) {
  for (const ChunkGroup& group : chunk_groups()) {
    if (in_case(word, std::tolower) == group.name) return group.chunks;
  }
  for (const std::uint32_t id : chunks) {
    if (in_case(word, std::toupper) != in_case(chunk_name(id), std::toupper)) continue;
    if (!is_needed_chunk(id)) return Ids{id};
    return usage(
        fmt::format("--without: no asset is without {}: SKEL and BONE are the skeleton that all else refers to; "
                    "leave it off the list",
                    chunk_name(id)));
  }
  return unknown_word(word, chunks);
}

}  // namespace

std::span<const ChunkGroup> chunk_groups() {
  using namespace chunk;
  static const std::vector<ChunkGroup> kGroups = {
      {"names", "bones cannot be found by name", {kNames}},
      {"provenance", "nothing says what it was made from", {kProvenance}},
      {"quality", "nothing says what other settings would cost", {kQuality}},
      {"tuning", "it is simulated with the host's sub-steps", {kTuning, kQuality}},
      {"colliders", "hair passes through the head", {kColliders}},
      {"motion", "hair is rigid with the head", {kChains, kDynamics, kColliders, kTuning, kQuality}},
      {"lods", "the finest level of detail alone", {kLods, kLodBones}},
      {"orders", "one draw order for all directions", {kOrders, kOrderViews}},
      {"textures", "strips in one colour, without alpha", {kTextures, kTexels}},
      {"material", "drawn as the host says", {kMaterial}},
      {"mesh",
       "simulated, not drawn",
       {kVertices, kSkin, kIndices, kPatches, kLods, kLodBones, kOrders, kOrderViews, kMaterial, kTextures, kTexels}},
  };
  return kGroups;
}

tl::expected<std::vector<std::uint32_t>, ToolError> choose_chunks(const std::string& list, const Asset& asset) {
  const Ids nameable = nameable_chunks(asset);
  Ids chosen;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const auto chunks = chunks_of(word, nameable);
    if (!chunks) return chunks;
    for (const std::uint32_t id : *chunks) {
      if (std::ranges::find(chosen, id) == chosen.end()) chosen.push_back(id);
    }
  }
  return chosen;
}

}  // namespace coif
