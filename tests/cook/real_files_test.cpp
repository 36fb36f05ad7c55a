// Artists' files, cooked without a recipe. They are not part of the project: where the folder is absent every case
// skips and says so.

#include "cook/cook.h"
#include "cook/select/head.h"
#include "cook/select/select_hair.h"
#include "cook/size/settle_size.h"
#include "cook/texture/base_color.h"
#include "cook/told.h"
#include "import/import.h"
#include "models/small_asset.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

namespace coif::cook::real_files_test {

struct RealFile {
  const char* path;  ///< Below the corpus' folder "hair".
  const char* name;
  std::uint32_t triangles;       ///< The hair's, counted by hand from the file's lists.
  std::uint32_t merged;          ///< Those that are backs or copies of others.
  std::uint32_t strips;          ///< At least so many patches: the modeller's strips, counted by eye.
  std::uint32_t chains;          ///< At least so many.
  std::uint32_t artists_chains;  ///< Chains of the hierarchy below the head bone; 0: chains are fitted.
  bool hangs = true;             ///< False for hair that is tied up in buns.
};

const RealFile kFiles[] = {
    {"mh_ponytail01/ponytail01_skinned.glb", "ponytail01_skinned", 5352, 8, 28, 1, 1},
    {"mh_ponytail01/ponytail01.obj", "ponytail01_obj", 5352, 8, 28, 1, 0},
    {"mh_braid01/braid01.obj", "braid01", 5518, 0, 80, 1, 0},
    {"mh2013_long2/long2.obj", "long2", 3596, 0, 57, 5, 0},
    {"unitychan/UnityChan.fbx", "unitychan", 1168 + 530 + 227 + 658, 0, 80, 6, 6},
    {"seedsan/new_seedsan_betterfbx.fbx", "seedsan", 238 + 7820, 0, 50, 12, 12},
    {"godette/Godette_vrm_v4.vrm", "godette", 3 * 80 + 139, 0, 4, 7, 7, false},
    {"churro/ChurroChurro.vrm", "churro", 2 * 51 + 82, 0, 3, 4, 4},
    {"quaternius_witch/Witch.glb", "witch", 2316, 4, 20, 2, 0},
    {"rocketbox_Female_Adult_03/Female_Adult_03.fbx", "rocketbox", 728 - 58, 360 - 29, 10, 1, 0},
    {"moz_french-braids-double/hair_french-braids-double-brown.glb", "moz_braids", 1237 - 2, 0, 5, 2, 0},
    {"mh2013_curly/curly.obj", "curly", 10584 + 720, 0, 60, 5, 0},
    {"mh_bob01/bob01.obj", "bob01", 8474, 313, 35, 1, 0},
    {"moz_pigtails-1/hair_pigtails-1-red.glb", "pigtails", 1792, 0, 8, 2, 0, false},
    {"rocketbox_Business_Female_04/Export/Business_Female_04.fbx", "ponytail_strips", 624, 174, 10, 1, 0},
};

/// Without the search for draw orders, which takes most of a cook's time and changes none of what most tests look at.
Recipe in_head_order() {
  Recipe recipe = default_recipe();
  recipe.order_method = OrderMethod::kHead;
  return recipe;
}

struct CookedFile {
  importer::SourceModel source;
  CookResult result;
};

CookResult cook_model(const importer::SourceModel& source, const Recipe& recipe, unsigned threads) {
  auto result = cook(source, recipe, {.threads = threads, .recipe_directory = {}});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return result ? *std::move(result) : CookResult{};
}

/// Every test of this program that looks at a file looks at the same cook of it, on two threads.
const CookedFile& cook_once(const std::filesystem::path& path) {
  static std::map<std::filesystem::path, CookedFile> cooked;
  const auto [at, is_new] = cooked.try_emplace(path);
  if (!is_new) return at->second;
  auto source = importer::import_model(path);
  EXPECT_TRUE(source) << (source ? "" : source.error().message);
  if (source) at->second.source = *std::move(source);
  at->second.result = cook_model(at->second.source, in_head_order(), 2);
  return at->second;
}

class RealFiles : public testing::TestWithParam<RealFile> {
 protected:
  void SetUp() override {
    path_ = std::filesystem::path(COIF_TEST_ASSETS) / "hair" / GetParam().path;
    if (!std::filesystem::exists(path_)) GTEST_SKIP() << path_ << ": no corpus of artists' files here";
  }

  const CookResult& cooked() { return cook_once(path_).result; }

  std::filesystem::path path_;
};

TEST_P(RealFiles, GiveAllOfTheirHairAndNothingElse) {
  const CookReport& report = cooked().report;
  EXPECT_EQ(report.triangles, GetParam().triangles - GetParam().merged);
}

TEST_P(RealFiles, AreSeenAsStripsThatCanBeSorted) {
  const CookReport& report = cooked().report;
  EXPECT_GE(report.patches, GetParam().strips);
  EXPECT_GE(report.triangles, 8 * report.patches) << "shattered";
}

TEST_P(RealFiles, HaveTheArtistsChainsOrFittedOnes) {
  const CookReport& report = cooked().report;
  EXPECT_GE(report.chains, GetParam().chains);
  if (GetParam().artists_chains > 0) {
    EXPECT_EQ(report.chains, GetParam().artists_chains);
  }
  EXPECT_GE(report.simulated_bones, report.chains);
}

TEST_P(RealFiles, GiveTheSameBytesOnOneAndTwoThreads) {
  EXPECT_EQ(cook_model(cook_once(path_).source, in_head_order(), 1).asset, cooked().asset);
  // Two of the quick ones with the search; others would take minutes, and OrderSearch sees to its threads.
  if (GetParam().triangles > 500) return;
  const Recipe searched = default_recipe();
  EXPECT_EQ(cook_model(cook_once(path_).source, searched, 1).asset,
            cook_model(cook_once(path_).source, searched, 2).asset);
}

TEST_P(RealFiles, AreOfAHeadsSizeInMetres) {
  AlignedBytes file(cooked().asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  float low = 1, high = -1, reach = 0;
  for (const VertexRecord& vertex : asset.vertices()) {
    low = std::min(low, vertex.position[1]);
    high = std::max(high, vertex.position[1]);
    reach = std::max(reach, std::hypot(vertex.position[0], vertex.position[1], vertex.position[2]));
  }
  EXPECT_GT(high - low, 0.15f);
  EXPECT_LT(high - low, 1.5f);
  EXPECT_LT(high, 0.6f) << "head space starts at the head's joint";
  EXPECT_LT(reach, 1.6f);
}

TEST_P(RealFiles, HaveHardlyAnyHairInTheirHeadsAndHeadsOfAHeadsSize) {
  // In metres, as the cook sees it.
  Findings said;
  const importer::SourceModel& imported = cook_once(path_).source;
  const std::optional<importer::SourceModel> settled = settle_size(imported, default_recipe(), said).model;
  const importer::SourceModel& source = settled ? *settled : imported;
  const auto hair = select_hair(source, default_recipe(), unheard());
  ASSERT_TRUE(hair);
  const auto bone = find_head_bone(source, *hair, "");
  ASSERT_TRUE(bone);
  const FittedHead head = fit_head(source, *hair, *bone, default_recipe(), unheard());
  const HairInside inside = hair_inside(*hair, head);
  EXPECT_LE(inside.area, 0.03);
  EXPECT_LE(inside.vertices, 0.035);
  // One direction of some 160 in which there is hair.
  EXPECT_LE(inside.pokes, 0.0065) << "the head comes out through the hair";
  EXPECT_GT(head.radii.minCoeff(), 0.055);
  EXPECT_LT(head.radii.maxCoeff(), 0.23) << "Mozilla's are for avatars with large heads";
}

TEST_P(RealFiles, HaveStrandsThatMostlyHang) {
  if (!GetParam().hangs) GTEST_SKIP() << "this hair is tied up";
  AlignedBytes file(cooked().asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  double down = 0;
  for (const VertexRecord& vertex : asset.vertices()) down -= vertex.tangent[1] / 32767.0;
  EXPECT_GT(down / double(asset.vertices().size()), 0.2) << "roots and tips are mixed up";
}

INSTANTIATE_TEST_SUITE_P(Corpus, RealFiles, testing::ValuesIn(kFiles),
                         [](const auto& tested) { return tested.param.name; });

// Which textures artists' files get without a recipe, and what is said of their tips. The files are not part of the
// project: where the folder is absent every case skips and says so.

namespace fs = std::filesystem;

struct TexturedFile {
  const char* path;  ///< Below the corpus.
  const char* name;
  const char* file;  ///< The image beside it that is taken; "embedded", or "" for none.
  bool ends_hard;    ///< On a look at its picture.
};

const TexturedFile kTexturedFiles[] = {
    {"hair/mh_ponytail01/ponytail01.obj", "ponytail01", "", false},
    {"hair/mh_braid01/braid01.obj", "braid01", "", false},
    {"hair/mh2013_long2/long2.obj", "long2", "long2_texture.png", false},
    {"hair/unitychan/UnityChan.fbx", "unitychan", "hair_01.tga", false},
    {"hair/seedsan/new_seedsan_betterfbx.fbx", "seedsan", "hair.png", false},
    {"hair/godette/Godette_vrm_v4.vrm", "godette", "embedded", false},
    {"hair/churro/ChurroChurro.vrm", "churro", "embedded", false},
    {"hair/quaternius_witch/Witch.glb", "witch", "", false},
    {"hair/rocketbox_Female_Adult_03/Female_Adult_03.fbx", "rocketbox", "", false},
    {"hair/moz_french-braids-double/hair_french-braids-double-brown.glb", "moz_braids", "embedded", true},
    {"same_hair/long01.obj", "long01_obj", "", true},
    {"same_hair/long01_glb2.glb", "long01_glb", "", true},
};

class RealTextures : public testing::TestWithParam<TexturedFile> {
 protected:
  void SetUp() override {
    const fs::path path = fs::path(COIF_TEST_ASSETS) / GetParam().path;
    if (!fs::exists(path)) GTEST_SKIP() << path << ": no corpus of artists' files here";
    cooked_ = &cook_once(path);
  }

  const CookedFile* cooked_ = nullptr;
};

TEST_P(RealTextures, AreFoundWhereTheArtistLeftThem) {
  auto hair = select_hair(cooked_->source, default_recipe(), unheard());
  ASSERT_TRUE(hair) << hair.error().message;
  const auto color = find_base_color(cooked_->source, *hair, default_recipe(), {}, unheard());
  ASSERT_TRUE(color) << color.error().message;
  const std::string wanted = GetParam().file;
  EXPECT_EQ(color->image.has_value(), !wanted.empty());
  const bool beside = !wanted.empty() && wanted != "embedded";
  ASSERT_EQ(color->files.size(), beside ? 1u : 0u);
  if (beside) {
    EXPECT_EQ(color->files[0].filename(), wanted);
  }
}

TEST_P(RealTextures, EndHardWhereOneSeesIt) {
  const bool warned = std::ranges::any_of(cooked_->result.report.warnings, [](const Diagnostic& w) {
    return w.message.find("end hard") != std::string::npos;
  });
  EXPECT_EQ(warned, GetParam().ends_hard);
}

INSTANTIATE_TEST_SUITE_P(Corpus, RealTextures, testing::ValuesIn(kTexturedFiles),
                         [](const auto& tested) { return tested.param.name; });

// Which artists' files have strips that hang on two chains.

struct SharedFile {
  const char* path;  ///< Below the corpus.
  const char* name;
  bool shares;
};

const SharedFile kSharedFiles[] = {
    {"hair/mh2013_long2/long2.obj", "long2", true},
    {"hair/mh2013_curly/curly.obj", "curly", true},
    {"hair/quaternius_witch/Witch.glb", "witch", true},
    {"hair/unitychan/UnityChan.fbx", "unitychan", false},  // two strips over the head end in both tails
    {"hair/seedsan/new_seedsan_betterfbx.fbx", "seedsan", false},
    {"hair/moz_french-braids-double/hair_french-braids-double-brown.glb", "moz_braids", false},
};

class RealLinks : public testing::TestWithParam<SharedFile> {
 protected:
  void SetUp() override {
    path_ = fs::path(COIF_TEST_ASSETS) / GetParam().path;
    if (!fs::exists(path_)) GTEST_SKIP() << path_ << ": no corpus of artists' files here";
  }

  fs::path path_;
};

TEST_P(RealLinks, AreSuggestedWhereStripsHangOnTwoChains) {
  const auto& notes = cook_once(path_).result.report.notes;
  const bool suggested =
      std::ranges::any_of(notes, [](const std::string& n) { return n.find("\"shared_strips\" keeps them") != n.npos; });
  EXPECT_EQ(suggested, GetParam().shares);
}

TEST_P(RealLinks, HoldChainsAsTheyWereModelled) {
  Recipe recipe = default_recipe();
  recipe.links.word = "shared_strips";
  const auto result = cook(cook_once(path_).source, recipe, {.threads = 2, .draft = true});
  ASSERT_TRUE(result) << result.error().message;
  AlignedBytes file(result->asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_EQ(asset.links().empty(), !GetParam().shares);
  for (const LinkRecord& link : asset.links()) {
    double squares = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = [&](const BoneRecord& bone) { return bone.joint[k] + bone.length * bone.rest_direction[k]; };
      squares += std::pow(double(at(asset.bones()[link.bone]) - at(asset.bones()[link.to])), 2);
    }
    EXPECT_NEAR(link.longest, 1.1 * std::sqrt(squares), 1.0e-5);
    EXPECT_NEAR(link.shortest, 0.5 * std::sqrt(squares), 1.0e-5);
    EXPECT_LT(link.longest, 0.3) << "no sheet is that wide";
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, RealLinks, testing::ValuesIn(kSharedFiles),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace coif::cook::real_files_test
