#include "formats/refusal.h"

#include <limits>

namespace coif {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A change of the small asset's material.
template <typename Change>
LoadCode material_refusal(Change change) {
  return refusal([&](AssetContents& contents) { change(contents.material[0]); });
}

TEST(OpenMaterial, KnowsThreeShadingModels) {
  for (std::uint32_t model = 0; model <= 2; ++model) {
    EXPECT_EQ(material_refusal([&](auto& m) {
                m.shading = ShadingModel(model);
                m.roughness = 0.14f;
              }),
              LoadCode::kOk);
  }
  EXPECT_EQ(material_refusal([](auto& m) { m.shading = ShadingModel(3); }), LoadCode::kEnumerator);
}

TEST(OpenMaterial, KeepsEveryNumberOfTheShadingInItsRange) {
  struct Range {
    float MaterialRecord::*field;
    float low, high;
  };
  for (const auto& [field, low, high] : {Range{&MaterialRecord::tilt, -kMostTilt, kMostTilt},
                                         {&MaterialRecord::roughness, 0, kMostRoughness},
                                         {&MaterialRecord::scatter, 0, 1},
                                         {&MaterialRecord::light_cut, 0, 1}}) {
    for (const float good : {low, high}) EXPECT_EQ(material_refusal([&](auto& m) { m.*field = good; }), LoadCode::kOk);
    for (const float bad : {low - 0.01f, high + 0.01f, kNan}) {
      EXPECT_EQ(material_refusal([&](auto& m) { m.*field = bad; }), LoadCode::kNotFinite) << bad;
    }
  }
}

TEST(OpenMaterial, AsksForAWidthOnlyWhereTheModelHasOne) {
  const auto with = [](ShadingModel model, float roughness) {
    return material_refusal([&](auto& m) {
      m.shading = model;
      m.roughness = roughness;
    });
  };
  EXPECT_EQ(with(ShadingModel::kKajiyaKay, 0), LoadCode::kOk);
  EXPECT_EQ(with(ShadingModel::kMarschner, 0), LoadCode::kNotFinite);
  EXPECT_EQ(with(ShadingModel::kMarschner, kLeastRoughness), LoadCode::kOk);
}

TEST(OpenMaterial, RefusesReservedWordsThatAreNotZero) {
  for (const int word : {0, 1, 2}) {
    EXPECT_EQ(material_refusal([&](auto& m) { m.reserved[word] = 1; }), LoadCode::kReserved);
  }
}

}  // namespace
}  // namespace coif
