#include "grow/body_field.h"
#include "grow/body_surface.h"
#include "grow/head_frame.h"
#include "grow/round_bodies.h"
#include "mannequin/head_shape.h"

#include <gtest/gtest.h>

namespace coif::grow::body_test {

using Eigen::Vector3f;
using grow::BodyField;
using grow::BodySurface;
using test::append;
using test::ellipsoid;
using test::MadeUpMesh;

BodySurface surface_of(MadeUpMesh mesh) { return {std::move(mesh.positions), std::move(mesh.triangles)}; }

TEST(BodySurface, KnowsHowFarItIsAndOnWhichSide) {
  const BodySurface ball = surface_of(ellipsoid(Vector3f::Zero(), Vector3f::Constant(0.1f)));
  for (const float away : {0.02f, 0.09f, 0.11f, 0.3f, 2.0f}) {
    const Vector3f point = away * Vector3f(0.3f, -0.5f, 0.81f).normalized();
    EXPECT_NEAR(ball.distance(point, 100), std::abs(away - 0.1f), 0.001f);
    EXPECT_EQ(ball.is_inside(point), away < 0.1f);
  }
  EXPECT_EQ(ball.distance({5, 0, 0}, 0.5f), 0.5f);
}

TEST(BodySurface, HolesAndPartsWithinDoNotConfuseIt) {
  MadeUpMesh head = ellipsoid(Vector3f::Zero(), Vector3f::Constant(0.1f), 0, 0.8f);  // open below, as at a neck
  append(ellipsoid({0, 0.02f, 0.07f}, Vector3f::Constant(0.012f)), head);            // an eye
  const BodySurface body = surface_of(std::move(head));
  EXPECT_TRUE(body.is_inside({0, 0, 0}));
  EXPECT_TRUE(body.is_inside({0, 0.02f, 0.07f}));
  EXPECT_TRUE(body.is_inside({0.06f, 0.03f, 0}));
  EXPECT_FALSE(body.is_inside({0, 0.12f, 0}));
  EXPECT_FALSE(body.is_inside({0.2f, -0.1f, 0.1f}));
}

TEST(BodyField, SamplesTheSameOnAnyNumberOfThreads) {
  const BodySurface ball = surface_of(ellipsoid(Vector3f::Zero(), Vector3f(0.1f, 0.12f, 0.1f)));
  const Eigen::AlignedBox3f box(Vector3f::Constant(-0.16f), Vector3f::Constant(0.16f));
  const BodyField one(ball, box, 0.01f, 1), two(ball, box, 0.01f, 2);
  for (int i = 0; i < 200; ++i) {
    const float around = 0.7f * float(i), away = 0.03f + 0.0006f * float(i);
    const Vector3f point(away * std::sin(around), away * std::cos(3 * around), away * std::cos(around));
    EXPECT_EQ(one.distance(point), two.distance(point));
    const float exact = ball.distance(point, 10) * (ball.is_inside(point) ? -1.0f : 1.0f);
    EXPECT_NEAR(one.distance(point), exact, std::abs(exact) < 0.05f ? 0.002f : 0.02f) << point.transpose();
  }
  EXPECT_NEAR(one.distance({1, 0, 0}), 0.9f, 0.02f) << "beyond the samples";
}

TEST(BodyField, TakesWhatIsInTheSkinOutOfIt) {
  const BodySurface ball = surface_of(ellipsoid(Vector3f::Zero(), Vector3f::Constant(0.1f)));
  const BodyField field(ball, {Vector3f::Constant(-0.15f), Vector3f::Constant(0.15f)}, 0.01f, 2);
  EXPECT_NEAR(field.kept_off({0.06f, 0.02f, 0}, 0.004f).norm(), 0.104f, 0.001f);
  EXPECT_EQ(field.kept_off({0.2f, 0, 0}, 0.004f), Vector3f(0.2f, 0, 0));
}

TEST(HeadFrame, IsTheSkullOfABust) {
  const mannequin::SurfaceMesh bust = mannequin::make_bust();
  std::vector<Vector3f> positions;
  for (const Eigen::Vector3d& p : bust.positions) positions.push_back(p.cast<float>());
  const auto head = grow::find_head(positions, bust.triangles);
  ASSERT_TRUE(head);
  EXPECT_LT((head->center.cast<double>() - mannequin::kCraniumCenter).norm(), 0.01);
  EXPECT_LT((head->radii.cast<double>() - mannequin::kCraniumRadii).norm(), 0.01);
  EXPECT_NEAR(head->scale(), 1, 0.03f);
}

TEST(HeadFrame, IsAtTheTopOfAWholeBodyOfAnySize) {
  MadeUpMesh body = ellipsoid({0, 1.62f, 0.01f}, {0.075f, 0.12f, 0.09f});
  append(ellipsoid({0, 1.2f, 0}, {0.22f, 0.35f, 0.12f}), body);
  append(ellipsoid({0, 1.4f, 0}, {0.8f, 0.05f, 0.05f}), body);  // arms held out
  for (const float size : {1.0f, 0.01f, 100.0f}) {
    std::vector<Vector3f> positions;
    for (const Vector3f& p : body.positions) positions.emplace_back(size * p);
    const auto head = grow::find_head(positions, body.triangles);
    ASSERT_TRUE(head);
    EXPECT_NEAR(head->center.y() / size, 1.64f, 0.03f);
    EXPECT_NEAR(head->radii.x() / size, 0.075f, 0.006f);
    EXPECT_NEAR(head->radii.z() / size, 0.09f, 0.006f);
  }
}

TEST(HeadFrame, IsNoneWhereThereIsNoSkull) {
  EXPECT_FALSE(grow::find_head({}, {}));
  const MadeUpMesh plank = ellipsoid(Vector3f::Zero(), {1, 0.05f, 0.01f});
  EXPECT_FALSE(grow::find_head(plank.positions, plank.triangles));
}

}  // namespace coif::grow::body_test
