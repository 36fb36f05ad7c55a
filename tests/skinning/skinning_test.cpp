#include <coif/skinning.h>

#include "models/skinned_asset.h"
#include "models/small_asset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

namespace coif::skinning_test {

constexpr std::uint32_t kBones = 9;

/// Every number of bones from one to four, weights in no order of size.
std::vector<SkinRecord> mixed_skin(std::size_t count) {
  std::vector<SkinRecord> skin;
  for (std::size_t i = 0; i < count; ++i) {
    const auto bone = [i](std::size_t k) { return std::uint16_t((i * 3 + k * 2) % kBones); };
    SkinRecord record{{bone(0), bone(1), bone(2), bone(3)}, {255, 0, 0, 0}};
    const std::uint8_t weights[4][4] = {{255, 0, 0, 0}, {55, 200, 0, 0}, {90, 15, 150, 0}, {51, 51, 51, 102}};
    std::memcpy(record.weight, weights[i % 4], 4);
    skin.push_back(record);
  }
  return skin;
}

class Skinning : public testing::Test {
 protected:
  explicit Skinning(const AssetContents& contents = skinned_contents(kBones, mixed_skin(99)))
      : bytes_(write_asset(contents)) {
    const LoadStatus status = asset_.open(bytes_.bytes());
    EXPECT_TRUE(status) << describe(status.code);
  }

  [[nodiscard]] std::vector<SkinnedVertex> all(std::span<const Mat34> palette) const {
    std::vector<SkinnedVertex> out(asset_.vertices().size());
    EXPECT_EQ(skin_vertices(asset_, palette, 0, out), Status::kOk);
    return out;
  }

  AlignedBytes bytes_;
  Asset asset_;
};

bool same_bits(std::span<const SkinnedVertex> a, std::span<const SkinnedVertex> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

TEST_F(Skinning, StaysNearDoublePrecisionForAnyNumberOfBones) {
  const auto palette = bent_palette(kBones);
  const auto out = all(palette);
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    EXPECT_LT(difference(out[i], exactly_skinned(asset_, palette, i)), 1e-6) << i;
  }
}

TEST_F(Skinning, PaletteOfIdentitiesGivesTheRestPose) {
  const auto out = all(std::vector<Mat34>(kBones));
  for (std::size_t i = 0; i < out.size(); ++i) {
    const VertexRecord& rest = asset_.vertices()[i];
    EXPECT_NEAR(out[i].position.x, rest.position[0], 1e-7f);
    EXPECT_NEAR(out[i].normal.y, float(rest.normal[1]) / 32767, 1e-6f);
    EXPECT_NEAR(out[i].tangent.z, float(rest.tangent[2]) / 32767, 1e-6f);
  }
}

TEST_F(Skinning, PartsEqualTheWholeToTheBit) {
  const auto palette = bent_palette(kBones);
  const auto whole = all(palette);
  for (const std::size_t part : {1u, 7u, 50u}) {
    std::vector<SkinnedVertex> out(whole.size());
    for (std::size_t first = 0; first < out.size(); first += part) {
      const std::size_t count = std::min(part, out.size() - first);
      ASSERT_EQ(skin_vertices(asset_, palette, std::uint32_t(first), std::span(out).subspan(first, count)),
                Status::kOk);
    }
    EXPECT_TRUE(same_bits(out, whole)) << part;
  }
}

TEST_F(Skinning, ThreadsShareOneAsset) {
  const auto palette = bent_palette(kBones);
  const auto whole = all(palette);
  std::vector<SkinnedVertex> out(whole.size());
  const std::size_t half = out.size() / 2;
  Status other = Status::kNotCreated;
  std::thread thread([&] { other = skin_vertices(asset_, palette, 0, std::span(out).first(half)); });
  const Status own = skin_vertices(asset_, palette, std::uint32_t(half), std::span(out).subspan(half));
  thread.join();
  EXPECT_EQ(own, Status::kOk);
  EXPECT_EQ(other, Status::kOk);
  EXPECT_TRUE(same_bits(out, whole));
}

TEST_F(Skinning, NothingIsSkinnedWithoutComplaint) {
  const auto palette = bent_palette(kBones);
  EXPECT_EQ(skin_vertices(asset_, palette, 0, {}), Status::kOk);
  EXPECT_EQ(skin_vertices(asset_, palette, std::uint32_t(asset_.vertices().size()), {}), Status::kOk);
}

TEST_F(Skinning, ErrorsLeaveTheOutputUntouched) {
  const auto palette = bent_palette(kBones + 1);
  const auto fitting = std::span(palette).first(kBones);
  const auto count = std::uint32_t(asset_.vertices().size());
  constexpr std::uint32_t kLargest = std::numeric_limits<std::uint32_t>::max();
  std::vector<SkinnedVertex> out(4, SkinnedVertex{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
  const auto before = out;
  EXPECT_EQ(skin_vertices({}, fitting, 0, out), Status::kAssetLacksData);
  for (const std::uint32_t first : {count - 3, count, count + 1, kLargest - 3, kLargest}) {
    EXPECT_EQ(skin_vertices(asset_, fitting, first, out), Status::kBadIndex) << first;
  }
  for (const std::size_t bones : {std::size_t{0}, std::size_t{kBones - 1}, std::size_t{kBones + 1}}) {
    EXPECT_EQ(skin_vertices(asset_, std::span(palette).first(bones), 0, out), Status::kSizeMismatch) << bones;
  }
  EXPECT_TRUE(same_bits(out, before));
}

/// All weight on one bone, named in a different place by each vertex.
class OneBone : public Skinning {
 protected:
  static constexpr SkinRecord kSkin[] = {{{5, 0, 0, 0}, {255, 0, 0, 0}},
                                         {{0, 5, 0, 0}, {0, 255, 0, 0}},
                                         {{1, 2, 3, 5}, {0, 0, 0, 255}},
                                         {{5, 5, 5, 5}, {60, 60, 60, 75}}};
  static AssetContents contents() {
    AssetContents contents = skinned_contents(kBones, kSkin);
    contents.vertices.assign(std::size(kSkin), contents.vertices[1]);
    return contents;
  }
  OneBone() : Skinning(contents()) {}
};

TEST_F(OneBone, IsTheSameWhereverItIsNamed) {
  const auto palette = bent_palette(kBones);
  const auto out = all(palette);
  for (const SkinnedVertex& vertex : out) EXPECT_LT(difference(vertex, exactly_skinned(asset_, palette, 0)), 1e-6);
  EXPECT_TRUE(same_bits(std::span(out).subspan(1, 1), std::span(out).first(1)));
  EXPECT_TRUE(same_bits(std::span(out).subspan(2, 1), std::span(out).first(1)));
}

class RigidHair : public Skinning {
 protected:
  static AssetContents contents() {
    AssetContents contents = skinned_contents(kBones, mixed_skin(6));
    contents.skin.clear();
    for (const std::size_t vertex : {2u, 3u}) contents.vertices[vertex].normal[1] = 0;
    contents.vertices[2].normal[0] = -32768;
    contents.vertices[3].normal[0] = -32767;
    return contents;
  }
  RigidHair() : Skinning(contents()) {}
};

TEST_F(RigidHair, KeepsItsRestPoseWithAndWithoutAPalette) {
  const auto out = all({});
  EXPECT_TRUE(same_bits(all(bent_palette(kBones)), out));
  for (std::size_t i = 0; i < out.size(); ++i) {
    EXPECT_EQ(std::memcmp(&out[i].position, asset_.vertices()[i].position, sizeof(Vec3)), 0) << i;
  }
}

TEST_F(RigidHair, RefusesAPaletteOfAnotherAsset) {
  std::vector<SkinnedVertex> out(1);
  EXPECT_EQ(skin_vertices(asset_, bent_palette(kBones - 1), 0, out), Status::kSizeMismatch);
}

TEST_F(RigidHair, BothCodesOfMinusOneMeanIt) {
  const auto out = all({});
  EXPECT_EQ(out[2].normal.x, -1.0f);
  EXPECT_EQ(out[3].normal.x, -1.0f);
}

}  // namespace coif::skinning_test
