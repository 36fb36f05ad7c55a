// What open() demands of the links between chains. small_asset() has hair_1 (bone 2) and hair_2 below it in one chain,
// the fringe (bone 4) in another, and a link of the fringe to hair_1.

#include "models/small_asset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coif::open_links_test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Two chains more, of two bones each, beside the fringe.
AssetContents four_chains() {
  AssetContents asset = small_asset();
  for (std::uint32_t chain = 2; chain < 4; ++chain) {
    const auto first = std::uint32_t(asset.bones.size());
    asset.chains.push_back({first, 2, 0, {}});
    for (std::uint32_t i = 0; i < 2; ++i) {
      BoneRecord bone = asset.bones[4];
      bone.chain = chain;
      if (i == 1) {
        bone.parent = first;
        bone.joint[1] -= bone.length;
      }
      asset.bones.push_back(bone);
      asset.bone_names.push_back("more");
      asset.dynamics.push_back(asset.dynamics[4]);
      asset.asked.push_back(asset.asked[4]);
      asset.limits.push_back(asset.limits[0]);
      asset.body_sets.push_back(0);
      asset.lod_bones.push_back(1);
    }
  }
  asset.links.clear();
  return asset;
}

LoadCode with(std::vector<LinkRecord> links) {
  AssetContents asset = four_chains();
  asset.links = std::move(links);
  return open_written(asset).code;
}

TEST(OpenLinks, NoneIsAsGoodAsSome) {
  EXPECT_EQ(with({}), LoadCode::kOk);
  EXPECT_EQ(with({{4, 2, 0, 1}}), LoadCode::kOk);
  EXPECT_EQ(with({{4, 2, 0, 1}, {5, 4, 0, 1}, {7, 4, 0, 1}, {6, 3, 0, 1}, {8, 6, 0, 1}}), LoadCode::kOk);
  EXPECT_EQ(with({{4, 2, 0, 1}, {7, 5, 0, 1}}), LoadCode::kOk) << "two sheets";
}

TEST(OpenLinks, NameBonesThatMoveInTwoChains) {
  EXPECT_EQ(with({{9, 2, 0, 1}}), LoadCode::kReference);
  EXPECT_EQ(with({{4, kNone, 0, 1}}), LoadCode::kReference);
  EXPECT_EQ(with({{1, 2, 0, 1}}), LoadCode::kLinkOrder);
  EXPECT_EQ(with({{2, 0, 0, 1}}), LoadCode::kLinkOrder);
  EXPECT_EQ(with({{4, 4, 0, 1}}), LoadCode::kLinkOrder);
  EXPECT_EQ(with({{3, 2, 0, 1}}), LoadCode::kLinkOrder) << "one chain";
}

TEST(OpenLinks, AreBetweenBonesOfEqualDepthWhichDoesNotFall) {
  EXPECT_EQ(with({{6, 4, 0, 1}}), LoadCode::kLinkOrder);
  EXPECT_EQ(with({{6, 3, 0, 1}, {4, 2, 0, 1}}), LoadCode::kLinkOrder);
}

TEST(OpenLinks, AreTreesWhoseRootsComeFirst) {
  EXPECT_EQ(with({{4, 2, 0, 1}, {4, 5, 0, 1}}), LoadCode::kLinkOrder) << "hangs on two";
  EXPECT_EQ(with({{4, 2, 0, 1}, {2, 5, 0, 1}}), LoadCode::kLinkOrder) << "something hangs on it already";
  EXPECT_EQ(with({{4, 2, 0, 1}, {2, 4, 0, 1}}), LoadCode::kLinkOrder) << "a circle";
}

TEST(OpenLinks, HaveLengthsThatLeaveRoom) {
  EXPECT_EQ(with({{4, 2, 1, 1}}), LoadCode::kOk);
  for (const float longest : {0.0f, -1.0f, 2.0e5f, kNan, std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(with({{4, 2, 0, longest}}), LoadCode::kNotFinite) << longest;
  }
  for (const float shortest : {-0.1f, std::nextafter(1.0f, 2.0f), kNan}) {
    EXPECT_EQ(with({{4, 2, shortest, 1}}), LoadCode::kNotFinite) << shortest;
  }
}

TEST(OpenLinks, ARefusalNamesTheLink) {
  AssetContents asset = four_chains();
  asset.links = {{4, 2, 0, 1}, {5, 99, 0, 1}};
  const LoadStatus status = open_written(asset);
  EXPECT_EQ(status.chunk, chunk::kLinks);
  EXPECT_EQ(status.item, 1u);
  EXPECT_EQ(status.found, 99u);
}

}  // namespace
}  // namespace coif::open_links_test
