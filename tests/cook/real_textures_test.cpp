// Which textures artists' files get without a recipe, and what is said of their tips. The files are not part of the
// project: where the folder is absent every case skips and says so.

#include "cook/base_color.h"
#include "cook/select_hair.h"
#include "import/import.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace coif {
namespace {

namespace fs = std::filesystem;

struct TexturedFile {
  const char* path;  ///< Below the corpus.
  const char* name;
  const char* file;  ///< The image beside it that is taken; "embedded", or "" for none.
  bool ends_hard;    ///< On a look at its picture.
};

const TexturedFile kFiles[] = {
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
    auto source = import_model(path);
    ASSERT_TRUE(source) << source.error().message;
    source_ = std::move(*source);
  }

  SourceModel source_;
};

TEST_P(RealTextures, AreFoundWhereTheArtistLeftThem) {
  auto hair = select_hair(source_, default_recipe());
  ASSERT_TRUE(hair) << hair.error().message;
  const auto color = find_base_color(source_, hair->mesh, default_recipe(), {});
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
  Recipe recipe = default_recipe();
  recipe.order_method = "head";  // spares the search for orders, which says nothing of ends
  const auto result = cook(source_, recipe, {.threads = 2, .recipe_directory = {}});
  ASSERT_TRUE(result) << result.error().message;
  const bool warned = std::ranges::any_of(result->report.warnings,
                                          [](const std::string& w) { return w.find("end hard") != std::string::npos; });
  EXPECT_EQ(warned, GetParam().ends_hard);
}

INSTANTIATE_TEST_SUITE_P(Corpus, RealTextures, testing::ValuesIn(kFiles),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace coif
