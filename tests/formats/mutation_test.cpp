// Every truncation and every single-byte change of a cooked file is refused with its reason, or harmless.

#include <coif/asset.h>

#include "models/small_asset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

namespace coif::mutation_test {

TEST(Mutation, OpenRefusesEveryTruncation) {
  const std::vector<std::byte> good = write_asset(small_asset());
  for (bool verify_hash : {true, false}) {
    for (std::size_t n = 0; n < good.size(); ++n) {
      AlignedBytes cut({good.data(), n});
      EXPECT_FALSE(Asset{}.open(cut.bytes(), {verify_hash})) << n << " of " << good.size() << " bytes";
    }
  }
}

TEST(Mutation, OpenRefusesAddedBytes) {
  std::vector<std::byte> longer = write_asset(small_asset());
  longer.push_back(std::byte{0});
  AlignedBytes file(longer);
  EXPECT_EQ(Asset{}.open(file.bytes()).code, LoadCode::kSize);
}

/// Where the chunk lies in a file that opens; empty where it has none.
std::span<const std::byte> bytes_of(std::span<const std::byte> file, std::uint32_t id) {
  Asset asset;
  EXPECT_TRUE(asset.open(file));
  for (const ChunkEntry& entry : asset.chunks()) {
    if (entry.id == id) return file.subspan(entry.offset, entry.bytes);
  }
  return {};
}

TEST(Mutation, HashesNameTheChunkThatWasChanged) {
  AlignedBytes file(write_asset(small_asset()));
  const std::span<std::byte> bytes = file.bytes();
  for (const std::uint32_t id : {chunk::kBones, chunk::kNames, chunk::kDynamics, chunk::kMaterial, chunk::kQuality}) {
    const std::size_t at = std::size_t(bytes_of(bytes, id).data() - bytes.data()) + 3;
    bytes[at] ^= std::byte{1};
    const LoadStatus status = Asset{}.open(bytes);
    EXPECT_EQ(status.code, LoadCode::kHash);
    EXPECT_EQ(status.chunk, id);
    bytes[at] ^= std::byte{1};
  }
}

TEST(Mutation, ChangedDrawDataOpensUntilItIsVerified) {
  AlignedBytes file(write_asset(small_asset()));
  const std::span<std::byte> bytes = file.bytes();
  for (const std::uint32_t id : {chunk::kVertices, chunk::kSkin, chunk::kTexels}) {
    const std::size_t at = std::size_t(bytes_of(bytes, id).data() - bytes.data());
    bytes[at] ^= std::byte{1};  // the last bit of a coordinate, another bone, another shade
    Asset asset;
    EXPECT_TRUE(asset.open(bytes));
    const LoadStatus status = asset.verify_draw_data();
    EXPECT_EQ(status.code, LoadCode::kHash);
    EXPECT_EQ(status.chunk, id);
    bytes[at] ^= std::byte{1};
    EXPECT_TRUE(asset.open(bytes) && asset.verify_draw_data());
  }
}

TEST(Mutation, BytesBetweenChunksAreZeroAndNoneFollowTheLast) {
  std::vector<std::byte> bytes = write_asset(small_asset());
  AlignedBytes file(bytes);
  const std::span<const std::byte> counts = bytes_of(file.bytes(), chunk::kLodBones);
  ASSERT_NE(counts.size() % 16, 0u) << "so that a gap follows";
  file.bytes()[std::size_t(counts.data() + counts.size() - file.bytes().data())] = std::byte{1};
  EXPECT_EQ(Asset{}.open(file.bytes(), {.verify_hash = false}).code, LoadCode::kReserved);

  bytes.resize(bytes.size() + 16);
  const std::uint64_t size = bytes.size();
  std::memcpy(bytes.data() + offsetof(FileHeader, total_bytes), &size, sizeof size);
  AlignedBytes longer(bytes);
  EXPECT_EQ(Asset{}.open(longer.bytes(), {.verify_hash = false}).code, LoadCode::kSize);
}

TEST(Mutation, HashesRefuseEverySingleByteChange) {
  AlignedBytes file(write_asset(small_asset()));
  const std::span<std::byte> bytes = file.bytes();
  const auto is_refused = [&] {
    Asset asset;
    return !asset.open(bytes) || !asset.verify_draw_data();
  };
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const std::byte original = bytes[at];
    for (unsigned flip = 1; flip < 256; ++flip) {
      bytes[at] = original ^ std::byte(flip);
      ASSERT_TRUE(is_refused()) << "byte " << at << " xor " << flip;
    }
    bytes[at] = original;
  }
  EXPECT_FALSE(is_refused()) << "the unchanged file opens";
}

TEST(Mutation, WithoutTheHashEverySingleByteChangeIsRefusedOrHarmless) {
  AlignedBytes file(write_asset(small_asset()));
  const std::span<std::byte> bytes = file.bytes();
  std::size_t refused = 0, harmless = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const std::byte original = bytes[at];
    for (unsigned flip = 1; flip < 256; ++flip) {
      bytes[at] = original ^ std::byte(flip);
      Asset asset;
      if (!asset.open(bytes, {.verify_hash = false})) {
        ++refused;
        continue;
      }
      ++harmless;
      ASSERT_TRUE(std::isfinite(touch_asset(asset))) << "byte " << at << " xor " << flip;
    }
    bytes[at] = original;
  }
  RecordProperty("refused", int(refused));
  RecordProperty("harmless", int(harmless));
  EXPECT_GT(refused, harmless) << "the structural checks see most changes";
}

}  // namespace coif::mutation_test
