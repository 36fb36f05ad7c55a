// The list of chunks (coif/chunks.h) against what is written by hand beside it.

#include "write/strip_asset.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace coif::chunk_table_test {

std::string text_of(const std::string& path) {
  std::ifstream file(std::string(COIF_SHADER_FOLDER) + "/../" + path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// As the specification says it: "bytes" for what has no type, "u32" for numbers.
std::string record_word(const std::string& type) {
  if (type == "char" || type == "std::byte") return "bytes";
  return std::regex_replace(type, std::regex("std::uint([0-9]+)_t"), "u$1");
}

/// "| `BONE` | BoneRecord | 48 |", in the file's order.
std::vector<std::string> rows_of_the_list() {
  std::vector<std::string> rows, draw_data;
#define COIF_LINE(constant, id, Record, ...)                                                                        \
  (is_draw_data(chunk::constant) ? draw_data : rows)                                                                \
      .push_back(std::string("| `") + id + "` | " + record_word(#Record) + " | " + std::to_string(sizeof(Record)) + \
                 " |");
  COIF_CHUNKS(COIF_LINE)
#undef COIF_LINE
  rows.insert(rows.end(), draw_data.begin(), draw_data.end());
  return rows;
}

TEST(ChunkTable, IsThatOfTheSpecification) {
  const std::string page = text_of("formats/SPECIFICATION.md");
  std::vector<std::string> written;
  const std::regex row("\\| `[A-Z]{4}` \\| [A-Za-z0-9]+ \\| [0-9]+ \\|");
  for (std::sregex_iterator at(page.begin(), page.end(), row), end; at != end; ++at) written.push_back(at->str());
  EXPECT_EQ(written, rows_of_the_list());
}

TEST(ChunkTable, SpecificationDescribesEveryChunkAndWhatLacksWithoutIt) {
  const std::string page = text_of("formats/SPECIFICATION.md");
  const std::size_t absent = page.find("## Leaving chunks out");
  ASSERT_NE(absent, std::string::npos);
  for (const ChunkLayout& layout : kChunkLayouts) {
    const std::string name = chunk_name(layout.id);
    EXPECT_NE(page.find("| `" + name + "`"), std::string::npos) << name;
    EXPECT_NE(page.find('`' + name + '`', absent), std::string::npos) << name << " is in no row of what may be absent";
  }
}

/// Numbers that files may rely on are written in two places.
TEST(ChunkTable, SpecificationHasTheLimitsOfTheReader) {
  const std::string page = text_of("formats/SPECIFICATION.md");
  const auto says = [&](const std::string& before, std::uint32_t number, const std::string& after) {
    EXPECT_NE(page.find(before + std::to_string(number) + after), std::string::npos) << before << number << after;
  };
  says("chunk count, at most ", kMaxChunks, " ");
  says("| 1 to ", kMaxBones, " bones");
  says("| ColliderRecord | 80 | at most ", kMaxColliders, ": what hair stays out of");
  says("| ColliderRecord | 80 | at most ", kMaxBodyColliders, ": body colliders");
  says("| LodRecord | 16 | at most ", kMaxLods, " levels of detail");
  says("holds the others, at most ", kMaxOrders - 1, ", each");
  says("At no place more than ", kMaxOpenBones, " bones of a chain are open");
  EXPECT_EQ(kNoAngleLimit, float(3.14159274)) << "half a turn";
  EXPECT_NE(page.find("| 2 hinge | d.x = 0, and at most the angle from +Y | 0..3.14159274, 0 |"), std::string::npos);
  EXPECT_TRUE(kMostTilt == 0.35f && kLeastRoughness == 0.02f && kMostRoughness == 1 && kMostGlow == 8);
  for (const char* const text : {"`tilt` is within 0.35 radians", "with shading 2 at least 0.02", "`glow` is 0..8"}) {
    EXPECT_NE(page.find(text), std::string::npos) << text;
  }
}

TEST(ChunkTable, FuzzersKnowEveryChunk) {
  const std::string words = text_of("tests/fuzz/dictionaries/asset.dict");
  for (const ChunkLayout& layout : kChunkLayouts) {
    EXPECT_NE(words.find('"' + chunk_name(layout.id) + '"'), std::string::npos) << chunk_name(layout.id);
  }
}

TEST(ChunkTable, NeedsAndPlacesAreSound) {
  std::set<std::uint32_t> ids;
  for (const ChunkLayout& layout : kChunkLayouts) {
    const std::string name = chunk_name(layout.id);
    EXPECT_TRUE(ids.insert(layout.id).second) << name << " twice";
    EXPECT_TRUE(layout.alignment == 16 || layout.alignment == 64) << name;
    for (const std::uint32_t id : layout.needs.ids) {
      EXPECT_TRUE(id == 0 || (chunk_row(id) < kChunkKinds && id != layout.id)) << name;
    }
  }
  EXPECT_EQ(chunk_row(chunk_id("ZEBR")), kChunkKinds);
  EXPECT_EQ(chunk_alignment(chunk_id("ZEBR")), 16u);
  EXPECT_FALSE(is_draw_data(chunk_id("ZEBR")) || is_needed_chunk(chunk_id("ZEBR")));
}

/// What a terminal can print is from the blank to the tilde.
TEST(ChunkTable, NamesShowAllThatCanBePrintedAndNothingElse) {
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    const char shown = byte >= 0x20 && byte <= 0x7E ? char(byte) : '?';
    EXPECT_EQ(chunk_name(byte << 24 | 0x434241), std::string("ABC") + shown) << byte;
  }
}

TEST(ChunkTable, ToolsAloneReadWhatItDoesNotKnow) {
  for (const ChunkLayout& layout : kChunkLayouts) {
    EXPECT_EQ(chunk_use(layout.id), layout.use) << chunk_name(layout.id);
    EXPECT_EQ(is_draw_data(layout.id), layout.use == ChunkUse::kDrawData) << chunk_name(layout.id);
  }
  EXPECT_EQ(chunk_use(chunk_id("ZEBR")), ChunkUse::kTools);
}

TEST(ChunkTable, EveryGroupHasChunksAndEveryWordIsAGroup) {
  std::set<std::string> words;
#define COIF_WORDS(constant, id, Record, count, name, alignment, use, needs, groups, contents)     \
  {                                                                                                \
    std::istringstream list(groups);                                                               \
    for (std::string word; list >> word;) EXPECT_TRUE(is_in_group(chunk::constant, word)) << word; \
    std::istringstream again(groups);                                                              \
    for (std::string word; again >> word;) words.insert(word);                                     \
    EXPECT_STREQ(chunk_contents(chunk::constant), contents);                                       \
  }
  COIF_CHUNKS(COIF_WORDS)
#undef COIF_WORDS
  std::set<std::string> groups;
  for (const ChunkGroup& group : chunk_groups()) {
    groups.insert(group.name);
    const std::vector<std::uint32_t> chunks = chunks_of_group(group.name);
    EXPECT_FALSE(chunks.empty()) << group.name;
    EXPECT_TRUE(std::ranges::none_of(chunks, is_needed_chunk)) << group.name;
  }
  EXPECT_EQ(words, groups);
  EXPECT_FALSE(is_in_group(chunk::kLods, "lod") || is_in_group(chunk::kLods, ""));
  EXPECT_STREQ(chunk_contents(chunk_id("ZEBR")), "");
}

}  // namespace coif::chunk_table_test
