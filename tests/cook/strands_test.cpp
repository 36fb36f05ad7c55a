#include "cook/extract_patches.h"
#include "cook/smooth_normals.h"
#include "cook/strand_direction.h"

#include "cook/built_models.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

StrandField strands_of(HairMesh mesh) {
  complete_normals(mesh, 1.0e-5);
  FittedHead head;
  head.center = {0, 1.6, 0};
  head.radii = Eigen::Vector3d::Constant(0.09);
  return find_strand_direction(mesh, extract_patches(mesh, {"index", 1.0e-5}).patches, head, 1);
}

class StrandConventions : public testing::TestWithParam<std::tuple<bool, bool, bool>> {};

// However the artist laid the texture, tangents run from root to tip.
TEST_P(StrandConventions, TangentsRunFromRootToTip) {
  const auto [v_upwards, uv_sideways, without_uv] = GetParam();
  HairMesh mesh = hair_from(make_strip({.v_upwards = v_upwards, .uv_sideways = uv_sideways}));
  if (without_uv) mesh.uvs.clear();
  const StrandField field = strands_of(mesh);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_LT(field.tangent[v].y(), -0.99f) << "vertex " << v;
    EXPECT_NEAR(field.place[v], (1.6f - mesh.positions[v].y()) / 0.3f, 1.0e-5);
  }
  EXPECT_EQ(field.along_u, uv_sideways && !without_uv);
}
INSTANTIATE_TEST_SUITE_P(AllLayouts, StrandConventions,
                         testing::Combine(testing::Bool(), testing::Bool(), testing::Bool()));

TEST(StrandDirection, TheRootIsTheEndAtTheHeadEvenWhenItIsBelow) {
  // A spike that stands up from the crown.
  const HairMesh mesh = hair_from(make_strip({.root = {0, 1.69f, 0}, .along = {0, 0.3f, 0}}));
  for (const Eigen::Vector3f& tangent : strands_of(mesh).tangent) EXPECT_GT(tangent.y(), 0.99f);
}

TEST(StrandDirection, TangentsAreUnitAndPerpendicularToNormals) {
  SourceMesh strip = make_strip({.along = {0.1f, -0.2f, -0.1f}, .rows = 8});
  for (std::size_t v = 0; v < strip.positions.size(); ++v) strip.positions[v].z() += 0.02f * float(v % 5);
  HairMesh mesh = hair_from(strip);
  complete_normals(mesh, 1.0e-5);
  const StrandField field = strands_of(mesh);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_NEAR(field.tangent[v].norm(), 1.0f, 1.0e-5);
    EXPECT_NEAR(field.tangent[v].dot(mesh.normals[v]), 0.0f, 1.0e-4);
  }
}

TEST(SmoothNormals, AStripsTwoSidesKeepOppositeNormals) {
  HairMesh mesh = hair_from(make_strip({}));
  const auto half = std::uint32_t(mesh.positions.size());
  const std::size_t triangles = mesh.triangles.size();
  for (std::uint32_t v = 0; v < half; ++v) {
    mesh.positions.push_back(mesh.positions[v]);
    mesh.uvs.push_back(mesh.uvs[v]);
  }
  for (std::size_t i = 0; i < triangles; i += 3) {
    for (std::size_t k : {0u, 2u, 1u}) mesh.triangles.push_back(half + mesh.triangles[i + k]);
  }
  EXPECT_EQ(complete_normals(mesh, 1.0e-5), mesh.positions.size());
  for (std::uint32_t v = 0; v < half; ++v) {
    EXPECT_NEAR(mesh.normals[v].norm(), 1.0f, 1.0e-5);
    EXPECT_NEAR(mesh.normals[v].dot(mesh.normals[half + v]), -1.0f, 1.0e-5);
  }
}

TEST(SmoothNormals, GivenNormalsAreKept) {
  HairMesh mesh = hair_from(make_strip({}));
  mesh.normals.assign(mesh.positions.size(), Eigen::Vector3f::UnitX());
  mesh.normals[3] = Eigen::Vector3f::Zero();
  EXPECT_EQ(complete_normals(mesh, 1.0e-5), 1u);
  EXPECT_EQ(mesh.normals[2], Eigen::Vector3f::UnitX());
  EXPECT_NEAR(std::abs(mesh.normals[3].z()), 1.0f, 1.0e-5);
}

}  // namespace
}  // namespace coif
