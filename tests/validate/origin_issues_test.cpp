#include "cook/built_models.h"
#include "cook/pack/pack.h"
#include "cook/recipe/recipe.h"
#include "validate/doubtful_asset.h"
#include "validate/find_issues.h"

namespace coif::origin_issues_test {

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
  const ProvenanceRecord record = make_provenance({}, recipe_hash(default_recipe()), 7);
  EXPECT_EQ(differences(record, record), Codes{});
}

TEST(OriginIssues, OtherSourceAndRecipeAreNamed) {
  const ProvenanceRecord then = make_provenance({}, recipe_hash(default_recipe()), 7);
  Recipe recipe = default_recipe();
  recipe.friction = 3;
  EXPECT_EQ(differences(then, make_provenance({}, recipe_hash(default_recipe()), 8)), Codes{"R101"});
  EXPECT_EQ(differences(then, make_provenance({}, recipe_hash(recipe), 7)), Codes{"R102"});
  EXPECT_EQ(differences(then, make_provenance({}, recipe_hash(recipe), 8)), (Codes{"R101", "R102"}));
}

TEST(OriginIssues, ADraftIsNeverWhatAFullCookGives) {
  const ProvenanceRecord now = make_provenance({}, recipe_hash(default_recipe()), 7);
  ProvenanceRecord draft = make_provenance({}, recipe_hash(draft_of(default_recipe())), 7);
  draft.flags = kProvenanceDraft;
  EXPECT_EQ(differences(draft, now), Codes{"R107"});
}

TEST(OriginIssues, VersionsMatterWhereAllElseIsEqual) {
  const ProvenanceRecord then = make_provenance({}, recipe_hash(default_recipe()), 7);
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

Codes codes_of(const SourceModel& source, const Recipe& recipe = default_recipe()) {
  return coif::codes_of(find_source_issues(source, recipe));
}

TEST(SourceIssues, WigHasNone) { EXPECT_EQ(codes_of(make_wig()), Codes{}); }

TEST(SourceIssues, WarningsOfTheImportAreKept) {
  SourceModel model = make_wig();
  model.warnings = {{"S201", "mesh 'a': 3 triangles dropped"}, {"S216", "mesh 'b': no usable bone weight"}};
  const std::vector<Issue> issues = find_source_issues(model, default_recipe());
  ASSERT_EQ(issues.size(), 2u);
  EXPECT_EQ(issues[1].code, "S216");
  EXPECT_EQ(issues[1].message, model.warnings[1]);
}

TEST(SourceIssues, WarningsOfTheImportAreAcknowledgedByTheirCodes) {
  SourceModel model = make_wig();
  model.warnings = {{"S115", "mesh 'a': the weights of 3 vertices do not add up to 1"},
                    {"S211", "mesh 'b': 2 points or lines left out"}};
  EXPECT_EQ(codes_of(model), (Codes{"S115", "S211"}));
  Recipe recipe = default_recipe();
  recipe.acknowledged_warnings = {"S211"};
  EXPECT_EQ(codes_of(model, recipe), Codes{"S115"});
}

TEST(SourceIssues, ACookInFullSaysWhatValidateDoes) {
  SourceModel model = make_wig();
  model.warnings = {{"S211", "mesh 'b': 2 points or lines left out"}};
  const auto cooked = cook(model, default_recipe(), {.threads = 2});
  ASSERT_TRUE(cooked) << cooked.error().message;
  Codes told;
  for (const Warning& warning : cooked->report.warnings) told.insert(warning.code);
  Codes issues;
  for (const Issue& issue : find_source_issues(model, default_recipe(), cooked)) {
    if (issue.severity != Severity::kInfo) issues.insert(issue.code);
  }
  EXPECT_EQ(issues, told);
  EXPECT_TRUE(told.contains("S211"));
}

TEST(SourceIssues, ACookThatFailsIsAnError) {
  const Issues issues = find_source_issues(
      make_wig(), default_recipe(), tl::unexpected(ToolError{ToolError::Kind::kOverBudget, "wig.glb: too dear"}));
  EXPECT_TRUE(coif::codes_of(issues).contains("S105"));
}

TEST(SourceIssues, ModelWithoutHairIsAnError) {
  Recipe recipe = default_recipe();
  recipe.hair_meshes = {"no such mesh"};
  EXPECT_EQ(codes_of(make_wig(), recipe), Codes{"S104"});
}

TEST(SourceIssues, HairThatIsNotUnwrappedNamesItsMesh) {
  SourceModel model = make_wig();
  model.meshes[0].uvs.clear();
  const std::vector<Issue> issues = find_source_issues(model, default_recipe());
  ASSERT_EQ(coif::codes_of(issues), Codes{"S203"});
  EXPECT_EQ(issues[0].where, "mesh '" + model.meshes[0].name + "'");
}

TEST(SourceIssues, HairWithoutBonesIsToldThatChainsAreFitted) {
  SourceModel model = make_wig();
  model.meshes[0].influences.clear();
  model.meshes[0].influence_begin.clear();
  EXPECT_EQ(codes_of(model), Codes{"S204"});
  Recipe recipe = default_recipe();
  recipe.chain_source = ChainSource::kNoChains;
  EXPECT_EQ(codes_of(model, recipe), Codes{});
}

TEST(SourceIssues, HairInCentimetresIsNotOfAHeadsSize) {
  SourceModel model = make_wig();
  for (Eigen::Vector3f& at : model.meshes[0].positions) at *= 100;
  EXPECT_TRUE(codes_of(model).contains("S205"));
}

TEST(SourceIssues, AUnitThatLosesIsToldAndTheHairThenOfAHeadsSize) {
  SourceModel model = make_wig();
  for (Eigen::Vector3f& at : model.meshes[0].positions) at *= 100;
  for (SourceNode& node : model.nodes) node.model_from_node.translation() *= 100;
  model.space.unit = Statement::kUsual;
  const Codes codes = codes_of(model);
  EXPECT_TRUE(codes.contains("S207"));
  EXPECT_FALSE(codes.contains("S205"));
}

/// Unwrapped triangle by triangle, and told to take islands all the same.
TEST(SourceIssues, HairInFragmentsIsSeen) {
  SourceModel model = make_wig();
  SourceMesh strip = make_strip({.rows = 8});
  split_vertices(strip);
  for (std::size_t i = 0; i < strip.uvs.size(); ++i) strip.uvs[i].x() += float(i / 3);
  strip.influence_begin = {};
  strip.influences = {};
  strip.node = 1;
  model.meshes = {strip};
  Recipe recipe = default_recipe();
  recipe.patch_connectivity = Connectivity::kIsland;
  EXPECT_TRUE(codes_of(model, recipe).contains("S206"));
  EXPECT_FALSE(codes_of(model).contains("S206")) << "left to itself, the cooker joins them by place";
}

/// A head, and one mesh that nothing marks as hair.
TEST(SourceIssues, DoubtfulChoiceOfHairIsAWarning) {
  SourceModel model;
  add_node(model, "Head", add_node(model, "root", kNoIndex, {0, 0, 0}), {0, 1.6f, 0});
  add_node(model, "body", 0, {0, 0, 0});
  model.meshes = {make_strip({})};
  model.meshes[0].name = "body";
  model.meshes[0].node = 2;
  EXPECT_TRUE(codes_of(model).contains("S202"));
  Recipe recipe = default_recipe();
  recipe.hair_meshes = {"body"};
  EXPECT_FALSE(codes_of(model, recipe).contains("S202"));
}

TEST(SourceIssues, ImportErrorsTellDamageFromOtherFormats) {
  EXPECT_EQ(import_issue({ToolError::Kind::kUnsupported, "a.fbx: binary FBX 6"}).code, "S102");
  EXPECT_EQ(import_issue({ToolError::Kind::kBadInput, "a.glb: cut off"}).code, "S101");
}

}  // namespace coif::origin_issues_test
