#include "validate/asset_issues.h"

#include "validate/doubtful_asset.h"
#include "validate/issue_codes.h"

namespace coif {
namespace {

std::vector<Doubt> all_doubts() {
  std::vector<Doubt> all(body_doubts().begin(), body_doubts().end());
  all.insert(all.end(), surface_doubts().begin(), surface_doubts().end());
  return all;
}

TEST(AssetIssues, SoundAssetHasNone) { EXPECT_EQ(codes_of(sound_asset()), std::set<std::string>{}); }

TEST(AssetIssues, EachDoubtIsSeen) {
  for (const Doubt& doubt : all_doubts()) {
    AssetContents asset = sound_asset();
    doubt.change(asset);
    EXPECT_TRUE(codes_of(asset).contains(doubt.code)) << doubt.code;
  }
}

TEST(AssetIssues, EveryCodeIsRaisedBySomeAsset) {
  std::set<std::string> raised;
  for (const Doubt& doubt : all_doubts()) raised.insert(doubt.code);
  std::size_t codes = 0;
  for (const IssueCode& row : issue_codes()) {
    if (!std::string_view(row.code).starts_with("A2")) continue;
    ++codes;
    EXPECT_TRUE(raised.contains(row.code)) << row.code;
  }
  EXPECT_EQ(codes, raised.size());
}

TEST(AssetIssues, BonesAndPatchesAreNamed) {
  AssetContents contents = sound_asset();
  contents.dynamics[3].resistance = contents.dynamics[3].stiffness = 0;
  std::copy_n(contents.vertices[3].position, 3, contents.vertices[4].position);
  AlignedBytes file(write_asset(contents));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  std::set<std::string> places;
  for (const Issue& issue : find_asset_issues(asset)) places.insert(issue.code + " " + issue.where);
  EXPECT_EQ(places, (std::set<std::string>{"A222 bone 'hair_2'", "A231 patch 1"}));
}

/// Whatever the reader lets pass, with hashes not compared, is looked at without harm.
TEST(AssetIssues, AnyChangedByteIsRefusedOrLookedAt) {
  AlignedBytes file(write_asset(sound_asset()));
  const std::span<std::byte> bytes = file.bytes();
  std::size_t opened = 0, doubted = 0;
  for (std::byte& byte : bytes) {
    for (const std::byte flip : {std::byte{0x01}, std::byte{0x40}, std::byte{0x80}, std::byte{0xFF}}) {
      byte ^= flip;
      Asset asset;
      if (asset.open(bytes, {.verify_hash = false})) {
        ++opened;
        doubted += find_asset_issues(asset).empty() ? 0 : 1;
      }
      byte ^= flip;
    }
  }
  EXPECT_GT(opened, bytes.size());
  EXPECT_GT(doubted, opened / 100);
}

TEST(AssetIssues, EveryRefusalHasItsCode) {
  const std::string_view unknown = describe(LoadCode(255));
  int code = 1;
  for (; describe(LoadCode(code)) != unknown; ++code) {
    const Issue issue = refusal_issue({.code = LoadCode(code)});
    const IssueCode* row = find_issue_code(issue.code);
    ASSERT_NE(row, nullptr) << issue.code << " for '" << describe(LoadCode(code)) << "' has no row";
    EXPECT_EQ(issue.severity, Severity::kError);
  }
  EXPECT_EQ(find_issue_code("A" + std::to_string(100 + code)), nullptr) << "a row for no load code";
}

TEST(AssetIssues, RefusalNamesChunkAndRecord) {
  const Issue issue = refusal_issue({LoadCode::kWeightSum, chunk::kSkin, 7, 255, 254});
  EXPECT_EQ(issue.code, "A127");
  EXPECT_EQ(issue.where, "chunk SKIN, record 7");
}

}  // namespace
}  // namespace coif
