#include "render/ground.h"

#include <coif/math.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace coif::render::ground_test {

using Eigen::Vector3f;

/// Its lower corner, and its size.
SolidMesh box(const Vector3f& low, const Vector3f& size) {
  SolidMesh mesh;
  for (int k = 0; k < 8; ++k) {
    const Vector3f corner(float(k & 1), float(k >> 1 & 1), float(k >> 2));
    mesh.vertices.push_back({low + size.cwiseProduct(corner), Vector3f::UnitY()});
  }
  mesh.triangles = {0, 1, 5, 0, 5, 4, 2, 7, 3, 2, 6, 7, 0, 2, 1, 1, 2, 3,
                    4, 5, 6, 5, 7, 6, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return mesh;
}

/// Two feet, a trunk and a head, of which the joint is at the origin.
std::vector<SolidMesh> person() {
  return {box({-0.16f, -1.5f, -0.1f}, {0.1f, 0.06f, 0.26f}), box({0.06f, -1.5f, -0.1f}, {0.1f, 0.06f, 0.26f}),
          box({-0.2f, -0.8f, -0.1f}, {0.4f, 0.75f, 0.2f}), box({-0.08f, 0, -0.1f}, {0.16f, 0.24f, 0.2f})};
}

int shade_at(const GroundShade& shade, float x, float z) {
  const auto texel = [&](float at) { return int((at / shade.half + 1) / 2 * float(GroundShade::kSide)); };
  const int column = texel(x - shade.middle.x()), row = texel(z - shade.middle.z());
  return shade.opacity[std::size_t(row) * GroundShade::kSide + std::size_t(column)];
}

TEST(Ground, IsDarkUnderTheFeetAndFadesAway) {
  const GroundShade shade = shade_below(person(), HeadPose{});
  ASSERT_EQ(shade.opacity.size(), std::size_t{GroundShade::kSide} * GroundShade::kSide);
  EXPECT_NEAR(shade.middle.y(), -1.5f, 1e-5f);
  const int foot = shade_at(shade, 0.11f, 0.03f), beside = shade_at(shade, 0.3f, 0.03f);
  EXPECT_GT(foot, 120);
  EXPECT_LT(beside, foot / 2);
  EXPECT_NEAR(shade_at(shade, -0.11f, 0.03f), foot, 12) << "both alike";
  for (std::uint32_t k = 0; k < GroundShade::kSide; ++k) {
    EXPECT_EQ(shade.opacity[k], 0) << "no edge is seen";
    EXPECT_EQ(shade.opacity[k * GroundShade::kSide], 0);
  }
}

TEST(Ground, TurnsBackWhatIsDrawnUnderATurnedHead) {
  const GroundShade plain = shade_below(person(), HeadPose{});
  const Eigen::Quaternionf turn(Eigen::AngleAxisf(1.1f, Vector3f(0.3f, 1, 0.2f).normalized()));
  std::vector<SolidMesh> meshes = person();
  for (SolidMesh& mesh : meshes) {
    for (SolidVertex& vertex : mesh.vertices) vertex.position = turn.conjugate() * vertex.position;
  }
  const GroundShade turned = shade_below(meshes, {.rotation = {turn.x(), turn.y(), turn.z(), turn.w()}});
  EXPECT_LT((turned.middle - plain.middle).norm(), 1e-4f);
  EXPECT_NEAR(shade_at(turned, 0.11f, 0.03f), shade_at(plain, 0.11f, 0.03f), 8);
}

TEST(Ground, IsSeenWhereThePictureShowsWhatAWholeBodyStandsOn) {
  const std::vector<Eigen::Vector3d> outline{{-0.1, -0.1, -0.1}, {0.1, 0.25, 0.1}};
  const auto camera = [&](double margin) { return frame_crowd(outline, {.margin = margin}).camera; };
  const GroundShade whole = shade_below(person(), HeadPose{});
  std::vector<SolidMesh> bust{box({-0.2f, -0.55f, -0.1f}, {0.4f, 0.5f, 0.2f}),
                              box({-0.08f, 0, -0.1f}, {0.16f, 0.2f, 0.2f})};
  const GroundShade cut = shade_below(bust, HeadPose{});
  const Eigen::Vector3d here = Eigen::Vector3d::Zero();
  EXPECT_TRUE(shows_ground(GroundChoice::kWhereSeen, whole, camera(9), here));
  EXPECT_FALSE(shows_ground(GroundChoice::kWhereSeen, whole, camera(1.1), here)) << "a portrait";
  EXPECT_FALSE(shows_ground(GroundChoice::kWhereSeen, cut, camera(9), here)) << "a bust stands on nothing";
  EXPECT_TRUE(shows_ground(GroundChoice::kAlways, cut, camera(9), here));
  EXPECT_FALSE(shows_ground(GroundChoice::kNever, whole, camera(9), here));
  EXPECT_FALSE(shows_ground(GroundChoice::kAlways, shade_below({}, HeadPose{}), camera(9), here))
      << "nothing stands there";
}

}  // namespace coif::render::ground_test
