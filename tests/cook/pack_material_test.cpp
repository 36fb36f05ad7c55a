#include "cook/pack_material.h"

#include "cook/furnace_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace coif {
namespace {

MaterialRecord packed(const std::string& material_keys) {
  const auto recipe = parse_recipe("{\"material\": {" + material_keys + "}}", "r.json");
  EXPECT_TRUE(recipe) << recipe.error().message;
  return pack_material(BaseColor{}, BakedTextures{}, HairMesh{}, recipe ? *recipe : default_recipe());
}

TEST(PackMaterial, ShadesAsPublishedUnlessTold) {
  const MaterialRecord m = packed("");
  EXPECT_EQ(m.shading, ShadingModel::kThesis);
  EXPECT_EQ(m.light_cut, 0);
}

TEST(PackMaterial, TakesTheModelByItsName) {
  EXPECT_EQ(packed(R"("shading": "thesis")").shading, ShadingModel::kThesis);
  EXPECT_EQ(packed(R"("shading": "kajiya-kay")").shading, ShadingModel::kKajiyaKay);
  EXPECT_EQ(packed(R"("shading": "marschner")").shading, ShadingModel::kMarschner);
  const auto wrong = parse_recipe(R"({"material": {"shading": "marshner"}})", "r.json");
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find("material.shading"), std::string::npos) << wrong.error().message;
  EXPECT_NE(wrong.error().message.find("kajiya-kay"), std::string::npos) << "lists what there is";
}

TEST(PackMaterial, TurnsDegreesIntoRadians) {
  const MaterialRecord m = packed(R"("tilt": -4, "roughness": 9, "scatter": 0.25)");
  EXPECT_NEAR(m.tilt, -4 * std::numbers::pi / 180, 1e-6);
  EXPECT_NEAR(m.roughness, 9 * std::numbers::pi / 180, 1e-6);
  EXPECT_EQ(m.scatter, 0.25f);
}

TEST(PackMaterial, RecipesRangesFitTheFormats) {
  for (const char* end : {R"("tilt": -20, "roughness": 1.2)", R"("tilt": 20, "roughness": 57)"}) {
    const MaterialRecord m = packed(end);
    EXPECT_LE(std::abs(m.tilt), kMostTilt);
    EXPECT_GE(m.roughness, kLeastRoughness);
    EXPECT_LE(m.roughness, kMostRoughness);
  }
}

TEST(PackMaterial, BoundedLightsAreCutByTheModelsBound) {
  for (const std::string name : {"thesis", "kajiya-kay", "marschner"}) {
    const MaterialRecord m = packed("\"energy\": \"bounded\", \"shading\": \"" + name + '"');
    EXPECT_LE((1 - m.light_cut) * furnace_bound(m), 1 + 1e-6) << name;
    EXPECT_EQ(m.light_cut > 0, name != "marschner") << name;
  }
}

TEST(PackMaterial, BoundedLightsOfDarkHairAreNotCutFurther) {
  EXPECT_EQ(packed(R"("energy": "bounded", "base_color": [0.1, 0.1, 0.1, 1])").light_cut, 0);
  EXPECT_LT(packed(R"("energy": "bounded", "base_color": [0.5, 0.5, 0.5, 1])").light_cut,
            packed(R"("energy": "bounded")").light_cut);
}

}  // namespace
}  // namespace coif
