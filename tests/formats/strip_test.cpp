// Every chunk that is not needed can be left out, alone and with others.

#include "write/asset_writer.h"
#include "write/strip_asset.h"

#include "models/small_asset.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace coif::strip_test {

using Ids = std::vector<std::uint32_t>;

std::string name_of(std::uint32_t id) { return {reinterpret_cast<const char*>(&id), sizeof id}; }

/// An open asset with its file.
struct OpenFile {
  explicit OpenFile(std::span<const std::byte> file) : memory(file) {
    status = asset.open(memory.bytes());
    if (status) status = asset.verify_draw_data();
  }

  [[nodiscard]] std::span<const std::byte> chunk(std::uint32_t id) {
    for (const ChunkEntry& entry : asset.chunks()) {
      if (entry.id == id) return memory.bytes().subspan(entry.offset, entry.bytes);
    }
    return {};
  }
  [[nodiscard]] StrippedAsset without(const Ids& chunks) { return strip_asset(asset, memory.bytes(), chunks); }

  AlignedBytes memory;
  Asset asset;
  LoadStatus status;
};

Ids optional_chunks() {
  Ids ids;
  for (const ChunkLayout& layout : kChunkLayouts) {
    if (!is_needed_chunk(layout.id)) ids.push_back(layout.id);
  }
  return ids;
}

/// The result opens, lacks what it should, and has the rest byte for byte but for what it says it changed.
void expect_stripped(OpenFile& whole, const Ids& chunks) {
  std::string trace;
  for (const std::uint32_t id : chunks) trace += name_of(id) + " ";
  SCOPED_TRACE("without " + trace);
  const StrippedAsset stripped = whole.without(chunks);
  OpenFile left(stripped.file);
  ASSERT_TRUE(left.status) << describe(left.status.code) << " in " << name_of(left.status.chunk);
  const Ids gone = with_dependents(chunks);
  for (const ChunkEntry& entry : whole.asset.chunks()) {
    const auto before = whole.chunk(entry.id), after = left.chunk(entry.id);
    const auto is_it = [&](const StrippedChunk& chunk) { return chunk.id == entry.id; };
    const auto shortened = std::ranges::find_if(stripped.shortened, is_it);
    if (std::ranges::count(gone, entry.id) > 0) {
      EXPECT_TRUE(after.empty());
      EXPECT_EQ(std::ranges::count_if(stripped.removed, is_it), 1);
    } else if (shortened != stripped.shortened.end()) {
      EXPECT_EQ(after.size() + shortened->bytes, before.size());
      const bool is_prefix = std::ranges::equal(after, before.first(after.size()));
      EXPECT_TRUE(is_prefix || entry.id == chunk::kOrders) << "each draw order is shortened";
    } else {
      EXPECT_EQ(after.size(), before.size()) << name_of(entry.id);
      const bool same = std::ranges::equal(after, before);
      EXPECT_EQ(!same, std::ranges::count(stripped.rewritten, entry.id) == 1) << name_of(entry.id);
    }
  }
}

TEST(Strip, EveryOptionalChunkCanBeLeftOutAloneAndWithAnyOther) {
  OpenFile whole(write_asset(small_asset()));
  ASSERT_TRUE(whole.status);
  ASSERT_EQ(whole.asset.chunks().size(), kChunkKinds) << "small_asset() has every chunk";
  for (const std::uint32_t one : optional_chunks()) {
    for (const std::uint32_t other : optional_chunks()) expect_stripped(whole, {one, other});
  }
}

TEST(Strip, AllTogetherLeaveASkeleton) {
  OpenFile whole(write_asset(small_asset()));
  OpenFile left(whole.without(optional_chunks()).file);
  ASSERT_TRUE(left.status);
  EXPECT_EQ(left.asset.chunks().size(), 2u);
  EXPECT_EQ(left.asset.bones().size(), whole.asset.bones().size());
}

TEST(Strip, NothingToRemoveGivesTheSameBytes) {
  const std::vector<std::byte> file = write_asset(small_asset());
  OpenFile whole(file);
  EXPECT_EQ(whole.without({}).file, file);
  const std::vector<std::byte> nameless = whole.without({chunk::kNames}).file;
  EXPECT_EQ(OpenFile(nameless).without({chunk::kNames}).file, nameless);
}

TEST(Strip, OneByOneGivesTheBytesOfAllAtOnce) {
  OpenFile whole(write_asset(small_asset()));
  const Ids ids = {chunk::kLods, chunk::kTexels, chunk::kNames, chunk::kDynamics, chunk::kColliders};
  std::vector<std::byte> step(whole.memory.bytes().begin(), whole.memory.bytes().end());
  for (const std::uint32_t id : ids) step = OpenFile(step).without({id}).file;
  EXPECT_EQ(step, whole.without(ids).file);
}

TEST(Strip, WritingWithoutAChunkGivesTheSameBytesAsStrippingIt) {
  OpenFile whole(write_asset(small_asset()));
  AssetContents contents = small_asset();
  contents.textures.clear();
  contents.texels.clear();
  contents.bone_names.clear();
  clear_group("body", contents);
  EXPECT_EQ(whole.without({chunk::kTexels, chunk::kNames}).file, write_asset(contents));
}

TEST(Strip, OnlyTheFinestLevelOfDetailIsLeft) {
  OpenFile whole(write_asset(small_asset()));
  OpenFile left(whole.without({chunk::kLods}).file);
  ASSERT_TRUE(left.status);
  EXPECT_EQ(left.asset.lod_count(), 1u);
  EXPECT_TRUE(std::ranges::equal(left.asset.indices(), whole.asset.lod_indices(0)));
  EXPECT_EQ(left.asset.patches().size(), whole.asset.lod_patches(0).size());
  EXPECT_LT(left.asset.indices().size(), whole.asset.indices().size());
  EXPECT_EQ(left.asset.order_count(), whole.asset.order_count());
  EXPECT_TRUE(std::ranges::equal(left.asset.orders(), std::vector<std::uint32_t>{1, 0, 0, 1}));
}

TEST(Strip, VerticesThatOnlyCoarserLevelsDrawGoWithThem) {
  OpenFile whole(write_asset(small_asset()));
  OpenFile left(whole.without({chunk::kLods}).file);
  ASSERT_TRUE(left.status);
  const std::size_t drawn = std::size_t(std::ranges::max(whole.asset.lod_indices(0))) + 1;
  ASSERT_LT(drawn, whole.asset.vertices().size());
  EXPECT_EQ(left.asset.vertices().size(), drawn);
  EXPECT_EQ(left.asset.skin().size(), drawn);
}

TEST(Strip, WithoutMotionEveryBoneIsRigidWhereItWas) {
  OpenFile whole(write_asset(small_asset()));
  for (const std::uint32_t id : {chunk::kDynamics, chunk::kChains}) {
    OpenFile left(whole.without({id}).file);
    ASSERT_TRUE(left.status);
    EXPECT_EQ(left.asset.skeleton().simulated_count, 0u);
    EXPECT_TRUE(left.asset.chains().empty());
    EXPECT_EQ(left.asset.tuning(), nullptr);
    for (std::uint32_t b = 0; b < left.asset.bones().size(); ++b) {
      EXPECT_EQ(left.asset.bones()[b].parent, whole.asset.bones()[b].parent);
      EXPECT_EQ(left.asset.bones()[b].joint[1], whole.asset.bones()[b].joint[1]);
      EXPECT_STREQ(left.asset.bone_name(b), whole.asset.bone_name(b));
    }
    EXPECT_EQ(left.asset.stored_lods().size(), 2u) << "rigid hair has levels of detail as well";
  }
}

TEST(Strip, WithoutMotionNothingTouchesTheBodyAndNothingIsLimited) {
  OpenFile whole(write_asset(small_asset()));
  OpenFile left(whole.without({chunk::kDynamics}).file);
  ASSERT_TRUE(left.status);
  EXPECT_TRUE(left.asset.limits().empty());
  EXPECT_TRUE(left.asset.links().empty());
  ASSERT_EQ(left.asset.body_sets().size(), left.asset.bones().size());
  for (const std::uint32_t set : left.asset.body_sets()) EXPECT_EQ(set, 0u);
}

TEST(Strip, TheBodyGoesWithAnyPartOfItAndWithItsNames) {
  OpenFile whole(write_asset(small_asset()));
  for (const std::uint32_t id : {chunk::kNames, chunk::kBodyBones, chunk::kBodyColliders, chunk::kBodySets}) {
    OpenFile left(whole.without({id}).file);
    ASSERT_TRUE(left.status);
    EXPECT_TRUE(left.asset.body_bones().empty() && left.asset.body_colliders().empty() &&
                left.asset.body_sets().empty());
    EXPECT_STREQ(left.asset.body_bone_name(0), "");
    EXPECT_EQ(left.asset.colliders().size(), whole.asset.colliders().size()) << "the head keeps its own";
  }
}

TEST(Strip, ContentsWithoutNamesKeepThoseOfTheBody) {
  AssetContents contents = small_asset();
  EXPECT_EQ(clear_group("names", contents), sizeof "Head" + sizeof "scalp" + 2 * sizeof "hair_1" + sizeof "fringe");
  OpenFile left(write_asset(contents));
  ASSERT_TRUE(left.status);
  EXPECT_STREQ(left.asset.bone_name(2), "");
  EXPECT_STREQ(left.asset.body_bone_name(1), "Chest");
}

/// small_asset() as a later minor version might write it: a chunk after each of its own that nobody here knows.
std::vector<std::byte> with_unknown_chunks(std::uint16_t minor, std::span<const std::byte> content) {
  OpenFile whole(write_asset(small_asset()));
  std::vector<PendingChunk> chunks;
  for (const ChunkEntry& entry : whole.asset.chunks()) {
    const std::size_t alignment = chunk_alignment(entry.id);
    chunks.push_back({entry.id, entry.flags, whole.chunk(entry.id), alignment});
    if (entry.id == chunk::kNames) chunks.push_back({chunk_id("ZEBR"), 0, content, 16});
    if (entry.id == chunk::kQuality) chunks.push_back({chunk_id("WIDE"), 0, content, 64});
  }
  return write_chunks(chunks, minor);
}

TEST(Strip, CarriesOverWhatALaterVersionWrote) {
  const std::vector<std::byte> content(40, std::byte{7});
  OpenFile whole(with_unknown_chunks(3, content));
  ASSERT_TRUE(whole.status);
  for (const std::uint32_t id : optional_chunks()) {
    OpenFile left(whole.without({id}).file);
    ASSERT_TRUE(left.status);
    EXPECT_EQ(left.asset.minor(), 3);
    EXPECT_TRUE(std::ranges::equal(left.chunk(chunk_id("ZEBR")), content));
    EXPECT_TRUE(std::ranges::equal(left.chunk(chunk_id("WIDE")), content));
    EXPECT_EQ((left.chunk(chunk_id("WIDE")).data() - left.memory.bytes().data()) % 64, 0) << "as it was";
  }
  OpenFile left(whole.without({chunk_id("ZEBR")}).file);
  ASSERT_TRUE(left.status);
  EXPECT_TRUE(left.chunk(chunk_id("ZEBR")).empty());
  EXPECT_EQ(left.asset.chunks().size(), whole.asset.chunks().size() - 1);
}

TEST(Strip, BonesThatAreNeededAreKeptNamelessAndTouchNothing) {
  OpenFile whole(write_asset(small_asset()));
  OpenFile left(whole.without({chunk::kNames, chunk::kColliders}).file);
  ASSERT_TRUE(left.status);
  for (std::uint32_t b = 0; b < left.asset.bones().size(); ++b) {
    EXPECT_STREQ(left.asset.bone_name(b), "");
    EXPECT_EQ(left.asset.bones()[b].colliders, 0u);
    EXPECT_EQ(left.asset.bones()[b].length, whole.asset.bones()[b].length);
  }
}

}  // namespace coif::strip_test
