#include "validate/origin_issues.h"

#include "cook/provenance.h"
#include "validate/doubtful_asset.h"

namespace coif {
namespace {

/// What find_origin_issues() says of an asset cooked from `then` where a cook of today would say `now`.
std::set<std::string> differences(const ProvenanceRecord& then, const ProvenanceRecord& now) {
  AssetContents contents = sound_asset();
  contents.provenance = {then};
  AlignedBytes file(write_asset(contents));
  Asset asset;
  EXPECT_TRUE(bool(asset.open(file.bytes())));
  return codes_of(find_origin_issues(asset, now));
}

std::vector<Issue> recook(const AssetContents& then, const AssetContents& now) {
  AlignedBytes old_file(write_asset(then)), new_file(write_asset(now));
  Asset old_asset, new_asset;
  EXPECT_TRUE(bool(old_asset.open(old_file.bytes())));
  EXPECT_TRUE(bool(new_asset.open(new_file.bytes())));
  return find_recook_issues(old_asset, new_asset);
}

using Codes = std::set<std::string>;

TEST(OriginIssues, SameOriginHasNone) {
  const ProvenanceRecord record = make_provenance({}, default_recipe(), 7);
  EXPECT_EQ(differences(record, record), Codes{});
}

TEST(OriginIssues, OtherSourceAndRecipeAreNamed) {
  const ProvenanceRecord then = make_provenance({}, default_recipe(), 7);
  Recipe recipe = default_recipe();
  recipe.friction += 1;
  EXPECT_EQ(differences(then, make_provenance({}, default_recipe(), 8)), Codes{"R101"});
  EXPECT_EQ(differences(then, make_provenance({}, recipe, 7)), Codes{"R102"});
  EXPECT_EQ(differences(then, make_provenance({}, recipe, 8)), (Codes{"R101", "R102"}));
}

TEST(OriginIssues, VersionsMatterWhereAllElseIsEqual) {
  const ProvenanceRecord then = make_provenance({}, default_recipe(), 7);
  ProvenanceRecord now = then;
  ++now.tool_version[1];
  EXPECT_EQ(differences(then, now), Codes{"R103"});
  ++now.importer_version[2];
  EXPECT_EQ(differences(then, now), (Codes{"R103", "R104"}));
  ++now.source_hash;
  EXPECT_EQ(differences(then, now), Codes{"R101"});
}

TEST(OriginIssues, AssetsWithoutOriginSaySo) {
  AssetContents contents = sound_asset();
  contents.provenance.clear();
  AlignedBytes file(write_asset(contents));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_EQ(codes_of(find_origin_issues(asset, {})), Codes{"R105"});
}

TEST(OriginIssues, NewCookIsComparedChunkByChunk) {
  const AssetContents then = sound_asset();
  AssetContents now = then;
  ++now.provenance[0].tool_version[2];
  EXPECT_TRUE(recook(then, now).empty()) << "the tool's version alone is no difference";
  now.vertices[0].position[0] += 0.001f;
  now.tuning.clear();
  now.quality.clear();
  const std::vector<Issue> issues = recook(then, now);
  ASSERT_EQ(codes_of(issues), Codes{"R106"});
  for (const char* name : {"VERT", "TUNE", "QUAL"}) EXPECT_NE(issues[0].message.find(name), std::string::npos) << name;
  EXPECT_EQ(issues[0].message.find("SKIN"), std::string::npos);
}

}  // namespace
}  // namespace coif
