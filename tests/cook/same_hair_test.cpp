// One hairstyle from several exporters has to become one asset. The files are not part of the project: where the folder
// is absent every case skips and says so.

#include "cook/cook.h"
#include "import/import.h"
#include "models/small_asset.h"

#include <coif/asset.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

namespace coif::cook::same_hair_test {

using Eigen::Vector3f;

struct Cooked {
  CookReport report;
  std::unique_ptr<AlignedBytes> bytes;
  Asset asset;
};

class SameHair : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(COIF_TEST_ASSETS) / "same_hair";
    if (!std::filesystem::exists(folder_)) GTEST_SKIP() << folder_ << ": no corpus of artists' files here";
  }

  /// Without being told of unit or axis, but for the settings.
  std::unique_ptr<Cooked> cooked(const char* file, const importer::ImportSettings& settings = {}) {
    auto result = std::make_unique<Cooked>();
    const auto source = importer::import_model(folder_ / file, settings);
    EXPECT_TRUE(source) << (source ? "" : source.error().message);
    if (!source) return result;
    auto cooked = cook(*source, default_recipe(), {.threads = 2, .draft = true});  // tuned alike, what is alike
    EXPECT_TRUE(cooked) << (cooked ? "" : cooked.error().message);
    if (!cooked) return result;
    result->report = cooked->report;
    result->bytes = std::make_unique<AlignedBytes>(cooked->asset);
    EXPECT_TRUE(result->asset.open(result->bytes->bytes()));
    return result;
  }

  std::filesystem::path folder_;
};

Vector3f position_of(const VertexRecord& vertex) { return Eigen::Map<const Vector3f>(vertex.position); }

float size_of(const Asset& asset) {
  Eigen::AlignedBox3f box;
  for (const VertexRecord& vertex : asset.vertices()) box.extend(position_of(vertex));
  return box.diagonal().norm();
}

/// Vertices of `a` with none of `b` nearer than `allowed`.
std::size_t strays(const Asset& a, const Asset& b, float allowed) {
  std::vector<Vector3f> others;
  for (const VertexRecord& vertex : b.vertices()) others.push_back(position_of(vertex));
  const auto x = [](const Vector3f& p) { return p.x(); };
  std::ranges::sort(others, {}, x);
  return std::size_t(std::ranges::count_if(a.vertices(), [&](const VertexRecord& vertex) {
    const Vector3f p = position_of(vertex);
    const auto from = std::ranges::lower_bound(others, p.x() - allowed, {}, x);
    const auto to = std::ranges::upper_bound(others, p.x() + allowed, {}, x);
    return std::none_of(from, to, [&](const Vector3f& other) { return (other - p).norm() < allowed; });
  }));
}

void expect_same(const Cooked& a, const Cooked& b) {
  EXPECT_EQ(a.report.triangles, b.report.triangles);
  EXPECT_EQ(a.report.patches, b.report.patches);
  EXPECT_EQ(a.report.chains, b.report.chains);
  EXPECT_EQ(a.report.bones, b.report.bones);
  const float allowed = 1.0e-4f * size_of(a.asset);
  EXPECT_GT(a.asset.vertices().size(), 1000u);
  EXPECT_EQ(strays(a.asset, b.asset, allowed), 0u);
  EXPECT_EQ(strays(b.asset, a.asset, allowed), 0u);
}

/// Length of the longest chain of bones.
float longest_chain(const Asset& asset) {
  float longest = 0;
  for (const ChainRecord& chain : asset.chains()) {
    float length = 0;
    for (const BoneRecord& bone : asset.bones().subspan(chain.first_bone, chain.bone_count)) length += bone.length;
    longest = std::max(longest, length);
  }
  return longest;
}

TEST_F(SameHair, APonyTailIsTheSameFromFbxColladaGlbAndGlbWithZUp) {
  const auto first = cooked("ponytail01_blender.fbx");
  for (const char* name : {"ponytail01_blender.dae", "ponytail01_springbone.glb", "ponytail01_zup.glb"}) {
    SCOPED_TRACE(name);
    const auto hair = cooked(name);
    expect_same(*first, *hair);
    // For the last bone's end, one file has a marker, another only hair, and COLLADA a wrong marker.
    EXPECT_NEAR(longest_chain(hair->asset), longest_chain(first->asset), 0.06f * longest_chain(first->asset));
  }
}

TEST_F(SameHair, LongHairIsTheSameFromObjColladaFbxAndGlb) {
  // The modeller's unit is the decimetre, which none of these files says.
  importer::ImportSettings decimetres;
  decimetres.metres_per_unit = 0.1;
  const auto first = cooked("long01.obj", decimetres);
  EXPECT_GT(first->report.simulated_bones, 15u);
  EXPECT_TRUE(first->report.warnings.empty() ||
              first->report.warnings[0].message.find("metres_per_unit") == std::string::npos);
  for (const char* name : {"long01.obj", "long01_dae.dae", "long01_fbxa.fbx", "long01_glb2.glb"}) {
    SCOPED_TRACE(name);
    const auto hair = cooked(name);
    expect_same(*first, *hair);
    EXPECT_NEAR(longest_chain(hair->asset), longest_chain(first->asset), 0.02f * longest_chain(first->asset));
    EXPECT_NE(hair->report.warnings.at(0).message.find("metres_per_unit"), std::string::npos) << "it is told";
  }
}

/// Share of the vertices that have a partner on the other side, with everything mirrored.
double mirrored_share(const Asset& asset) {
  const float near = 1.0e-3f * size_of(asset);
  Eigen::AlignedBox3f box;
  for (const VertexRecord& vertex : asset.vertices()) box.extend(position_of(vertex));
  const float plane = box.center().x();
  std::size_t found = 0;
  for (const VertexRecord& vertex : asset.vertices()) {
    const auto mirrored = [](const std::int16_t(&v)[4]) -> Vector3f { return Vector3f(-v[0], v[1], v[2]) / 32767.0f; };
    const Vector3f wanted(2 * plane - vertex.position[0], vertex.position[1], vertex.position[2]);
    for (const VertexRecord& other : asset.vertices()) {
      const Vector3f normal = Vector3f(other.normal[0], other.normal[1], other.normal[2]) / 32767.0f;
      const Vector3f tangent = Vector3f(other.tangent[0], other.tangent[1], other.tangent[2]) / 32767.0f;
      if ((position_of(other) - wanted).norm() > near) continue;
      if (normal.dot(mirrored(vertex.normal)) < 0.95f || tangent.dot(mirrored(vertex.tangent)) < 0.95f) continue;
      if (std::abs(other.tangent[3] - vertex.tangent[3]) > 700) continue;  // of 32767, the place root to tip
      ++found;
      break;
    }
  }
  return double(found) / double(asset.vertices().size());
}

/// Share of the triangles that are wound as their vertices' normals look, on one side of the head.
double wound_share(const Asset& asset, float side) {
  std::size_t right = 0, all = 0;
  for (std::size_t i = 0; i < asset.indices().size(); i += 3) {
    std::array<const VertexRecord*, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) corner[k] = &asset.vertices()[asset.indices()[i + k]];
    if (corner[0]->position[0] * side <= 0) continue;
    const Vector3f a = position_of(*corner[0]);
    const Vector3f face = (position_of(*corner[1]) - a).cross(position_of(*corner[2]) - a);
    const Vector3f normal(corner[0]->normal[0], corner[0]->normal[1], corner[0]->normal[2]);
    right += face.dot(normal) > 0 ? 1 : 0;
    ++all;
  }
  return double(right) / double(std::max<std::size_t>(all, 1));
}

TEST_F(SameHair, AMirroredInstanceGivesTwoMirroredHalves) {
  for (const char* name : {"long01_negscale_instanced.glb", "long01_negscale_instanced.fbx"}) {
    SCOPED_TRACE(name);
    const auto hair = cooked(name);
    ASSERT_TRUE(hair->asset.is_open());
    EXPECT_NEAR(size_of(hair->asset), 0.78f, 0.1f) << "in decimetres, which neither file says";
    EXPECT_NEAR(longest_chain(hair->asset), 0.55f, 0.03f);
    EXPECT_EQ(hair->report.simulated_bones, 20u);
    EXPECT_EQ(hair->report.triangles, 4108u);
    EXPECT_GT(mirrored_share(hair->asset), 0.97);
    EXPECT_GT(wound_share(hair->asset, -1), 0.97);
    EXPECT_GT(wound_share(hair->asset, 1), 0.97);
  }
}

}  // namespace coif::cook::same_hair_test
