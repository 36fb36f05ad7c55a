#include "write/strip_asset.h"

namespace coif {
namespace {

struct ChunkWords {
  const char* groups;  ///< Separated by blanks.
  const char* contents;
};

constexpr ChunkWords kWords[] = {
#define COIF_WORDS(constant, id, Record, count, name, alignment, use, needs, groups, contents) {groups, contents},
    COIF_CHUNKS(COIF_WORDS)
#undef COIF_WORDS
};

constexpr ChunkGroup kGroups[] = {
    {"names", "bones cannot be found by name, nor those of the body, so that hair passes through it"},
    {"provenance", "nothing says what it was made from"},
    {"quality", "nothing says what other settings would cost"},
    {"asked", "Algorithm 1 reads the friction that chains were given so that they have one motion"},
    {"tuning", "it is simulated with the host's sub-steps"},
    {"limits", "bones swing as far as they are pulled"},
    {"links", "strips that hang on two chains are torn apart"},
    {"body", "hair passes through the body"},
    {"colliders", "hair passes through the head and the body"},
    {"motion", "hair is rigid with the head"},
    {"lods", "the finest level of detail alone"},
    {"orders", "one draw order for all directions"},
    {"relief", "lit by the strips' own form"},
    {"textures", "strips in one colour, without alpha"},
    {"material", "drawn as the host says"},
    {"mesh", "simulated, not drawn"},
};

}  // namespace

std::string chunk_name(std::uint32_t id) {
  std::string name;
  for (unsigned shift = 0; shift < 32; shift += 8) {
    const char c = static_cast<char>(id >> shift & 0xFF);
    name += c >= 0x20 && c < 0x7F ? c : '?';
  }
  return name;
}

const char* chunk_contents(std::uint32_t id) {
  const std::size_t row = chunk_row(id);
  return row < kChunkKinds ? kWords[row].contents : "";
}

ChunkUse chunk_use(std::uint32_t id) {
  const std::size_t row = chunk_row(id);
  return row < kChunkKinds ? kChunkLayouts[row].use : ChunkUse::kTools;
}

std::span<const ChunkGroup> chunk_groups() { return kGroups; }

bool is_in_group(std::uint32_t id, std::string_view group) {
  const std::size_t row = chunk_row(id);
  std::string_view words = row < kChunkKinds ? kWords[row].groups : "";
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (words.substr(0, end) == group) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

std::vector<std::uint32_t> chunks_of_group(std::string_view group) {
  std::vector<std::uint32_t> ids;
  for (const ChunkLayout& layout : kChunkLayouts) {
    if (is_in_group(layout.id, group)) ids.push_back(layout.id);
  }
  return ids;
}

}  // namespace coif
