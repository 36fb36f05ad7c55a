#include "cook/built_models.h"
#include "cook/pack/pack.h"
#include "cook/recipe/recipe.h"
#include "validate/doubtful_asset.h"
#include "validate/find_issues.h"

namespace coif::validate::origin_issues_test {

/// What find_origin_issues() says of an asset cooked from `then` where a cook of today would say `now`.
std::set<std::string> differences(const ProvenanceRecord& then, const ProvenanceRecord& now) {
  AssetContents contents = sound_asset();
  contents.provenance = {then};
  AlignedBytes file(write_asset(contents));
  Asset asset;
  EXPECT_TRUE(bool(asset.open(file.bytes())));
  return codes_of(find_origin_issues(asset, now));
}

Diagnostics recook(const AssetContents& then, const AssetContents& now) {
  AlignedBytes old_file(write_asset(then)), new_file(write_asset(now));
  Asset old_asset, new_asset;
  EXPECT_TRUE(bool(old_asset.open(old_file.bytes())));
  EXPECT_TRUE(bool(new_asset.open(new_file.bytes())));
  return find_recook_issues(old_asset, new_asset);
}

using Codes = std::set<std::string>;

TEST(OriginIssues, SameOriginHasNone) {
  const ProvenanceRecord record = cook::make_provenance({}, cook::recipe_hash(cook::default_recipe()), 7);
  EXPECT_EQ(differences(record, record), Codes{});
}

TEST(OriginIssues, OtherSourceAndRecipeAreNamed) {
  const ProvenanceRecord then = cook::make_provenance({}, cook::recipe_hash(cook::default_recipe()), 7);
  cook::Recipe recipe = cook::default_recipe();
  recipe.friction = 3;
  EXPECT_EQ(differences(then, cook::make_provenance({}, cook::recipe_hash(cook::default_recipe()), 8)), Codes{"R101"});
  EXPECT_EQ(differences(then, cook::make_provenance({}, cook::recipe_hash(recipe), 7)), Codes{"R102"});
  EXPECT_EQ(differences(then, cook::make_provenance({}, cook::recipe_hash(recipe), 8)), (Codes{"R101", "R102"}));
}

TEST(OriginIssues, ADraftIsNeverWhatAFullCookGives) {
  const ProvenanceRecord now = cook::make_provenance({}, cook::recipe_hash(cook::default_recipe()), 7);
  ProvenanceRecord draft = cook::make_provenance({}, cook::recipe_hash(cook::draft_of(cook::default_recipe())), 7);
  draft.flags = kProvenanceDraft;
  EXPECT_EQ(differences(draft, now), Codes{"R107"});
}

TEST(OriginIssues, VersionsMatterWhereAllElseIsEqual) {
  const ProvenanceRecord then = cook::make_provenance({}, cook::recipe_hash(cook::default_recipe()), 7);
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
  const Diagnostics issues = recook(then, now);
  ASSERT_EQ(codes_of(issues), Codes{"R106"});
  for (const char* name : {"VERT", "TUNE", "QUAL"}) EXPECT_NE(issues[0].message.find(name), std::string::npos) << name;
  EXPECT_EQ(issues[0].message.find("SKIN"), std::string::npos);
}

Codes codes_of(const importer::SourceModel& source, const cook::Recipe& recipe = cook::default_recipe()) {
  return coif::validate::codes_of(find_source_issues(source, recipe));
}

TEST(SourceIssues, WigHasNone) { EXPECT_EQ(codes_of(cook::make_wig()), Codes{}); }

TEST(SourceIssues, WarningsOfTheImportAreKept) {
  importer::SourceModel model = cook::make_wig();
  model.warnings = {{"S201", "mesh 'a': 3 triangles dropped"}, {"S216", "mesh 'b': no usable bone weight"}};
  const Diagnostics issues = find_source_issues(model, cook::default_recipe());
  ASSERT_EQ(issues.size(), 2u);
  EXPECT_EQ(issues[1].code, "S216");
  EXPECT_EQ(issues[1].message, model.warnings[1].message);
}

TEST(SourceIssues, WarningsOfTheImportAreAcknowledgedByTheirCodes) {
  importer::SourceModel model = cook::make_wig();
  model.warnings = {{"S115", "mesh 'a': the weights of 3 vertices do not add up to 1"},
                    {"S211", "mesh 'b': 2 points or lines left out"}};
  EXPECT_EQ(codes_of(model), (Codes{"S115", "S211"}));
  cook::Recipe recipe = cook::default_recipe();
  recipe.acknowledged_warnings = {"S211"};
  EXPECT_EQ(codes_of(model, recipe), Codes{"S115"});
}

TEST(SourceIssues, ACookInFullSaysWhatValidateDoes) {
  importer::SourceModel model = cook::make_wig();
  model.warnings = {{"S211", "mesh 'b': 2 points or lines left out"}};
  const auto cooked = cook::cook(model, cook::default_recipe(), {.threads = 2});
  ASSERT_TRUE(cooked) << cooked.error().message;
  Codes told;
  for (const Diagnostic& warning : cooked->report.warnings) told.insert(warning.code);
  Codes issues;
  for (const Diagnostic& issue : find_source_issues(model, cook::default_recipe(), cooked)) {
    if (issue.severity != Severity::kInfo) issues.insert(issue.code);
  }
  EXPECT_EQ(issues, told);
  EXPECT_TRUE(told.contains("S211"));
}

TEST(SourceIssues, ACookThatFailsIsAnError) {
  const Diagnostics issues =
      find_source_issues(cook::make_wig(), cook::default_recipe(),
                         tl::unexpected(ToolError{ToolError::Kind::kOverBudget, "wig.glb: too dear"}));
  EXPECT_TRUE(coif::validate::codes_of(issues).contains("S105"));
}

TEST(SourceIssues, ModelWithoutHairIsAnError) {
  cook::Recipe recipe = cook::default_recipe();
  recipe.hair_meshes = {"no such mesh"};
  EXPECT_EQ(codes_of(cook::make_wig(), recipe), Codes{"S104"});
}

TEST(SourceIssues, HairThatIsNotUnwrappedNamesItsMesh) {
  importer::SourceModel model = cook::make_wig();
  model.meshes[0].uvs.clear();
  const Diagnostics issues = find_source_issues(model, cook::default_recipe());
  ASSERT_EQ(coif::validate::codes_of(issues), Codes{"S203"});
  EXPECT_EQ(issues[0].place, "mesh '" + model.meshes[0].name + "'");
}

TEST(SourceIssues, HairWithoutBonesIsToldThatChainsAreFitted) {
  importer::SourceModel model = cook::make_wig();
  model.meshes[0].influences.clear();
  model.meshes[0].influence_begin.clear();
  EXPECT_EQ(codes_of(model), Codes{"S204"});
  cook::Recipe recipe = cook::default_recipe();
  recipe.chain_source = cook::ChainSource::kNoChains;
  EXPECT_EQ(codes_of(model, recipe), Codes{});
}

TEST(SourceIssues, HairInCentimetresIsNotOfAHeadsSize) {
  importer::SourceModel model = cook::make_wig();
  for (Eigen::Vector3f& at : model.meshes[0].positions) at *= 100;
  EXPECT_TRUE(codes_of(model).contains("S205"));
}

TEST(SourceIssues, AUnitThatLosesIsToldAndTheHairThenOfAHeadsSize) {
  importer::SourceModel model = cook::make_wig();
  for (Eigen::Vector3f& at : model.meshes[0].positions) at *= 100;
  for (importer::SourceNode& node : model.nodes) node.model_from_node.translation() *= 100;
  model.space.unit = importer::Statement::kUsual;
  const Codes codes = codes_of(model);
  EXPECT_TRUE(codes.contains("S207"));
  EXPECT_FALSE(codes.contains("S205"));
}

/// Unwrapped triangle by triangle, and told to take islands all the same.
TEST(SourceIssues, HairInFragmentsIsSeen) {
  importer::SourceModel model = cook::make_wig();
  importer::SourceMesh strip = cook::make_strip({.rows = 8});
  cook::split_vertices(strip);
  for (std::size_t i = 0; i < strip.uvs.size(); ++i) strip.uvs[i].x() += float(i / 3);
  strip.influence_begin = {};
  strip.influences = {};
  strip.node = 1;
  model.meshes = {strip};
  cook::Recipe recipe = cook::default_recipe();
  recipe.patch_connectivity = cook::Connectivity::kIsland;
  EXPECT_TRUE(codes_of(model, recipe).contains("S206"));
  EXPECT_FALSE(codes_of(model).contains("S206")) << "left to itself, the cooker joins them by place";
}

/// A head, and one mesh that nothing marks as hair.
TEST(SourceIssues, DoubtfulChoiceOfHairIsAWarning) {
  importer::SourceModel model;
  cook::add_node(model, "Head", cook::add_node(model, "root", importer::kNoIndex, {0, 0, 0}), {0, 1.6f, 0});
  cook::add_node(model, "body", 0, {0, 0, 0});
  model.meshes = {cook::make_strip({})};
  model.meshes[0].name = "body";
  model.meshes[0].node = 2;
  EXPECT_TRUE(codes_of(model).contains("S202"));
  cook::Recipe recipe = cook::default_recipe();
  recipe.hair_meshes = {"body"};
  EXPECT_FALSE(codes_of(model, recipe).contains("S202"));
}

TEST(SourceIssues, ImportErrorsTellDamageFromOtherFormats) {
  EXPECT_EQ(import_issue({ToolError::Kind::kUnsupported, "a.fbx: binary FBX 6"}).code, "S102");
  EXPECT_EQ(import_issue({ToolError::Kind::kBadInput, "a.glb: cut off"}).code, "S101");
}

}  // namespace coif::validate::origin_issues_test
