// What makes a picture show the hair: tone, samples, frame, wind, solver, and a body that stays where it is.
#include "models/drawn_card.h"
#include "models/skinned_asset.h"
#include "render/camera.h"
#include "render/picture.h"
#include "render/picture_scene.h"
#include "render/stage_renderer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace coif::render::preview_test {

std::array<float, 3> toned(std::array<float, 3> radiance) {
  apply_tone_curve(radiance);
  return radiance;
}

TEST(ToneCurve, LeavesWhatIsNotBrightAsItIs) {
  EXPECT_EQ(toned({0, 0.3f, 0.75f}), (std::array<float, 3>{0, 0.3f, 0.75f}));
}

TEST(ToneCurve, KeepsTheHueAndNeverReachesWhite) {
  float before = 0.75f;
  for (const float light : {0.8f, 1.0f, 1.5f, 2.5f}) {
    const auto shown = toned({light, light / 2, light / 4});
    EXPECT_GT(shown[0], before) << "what is brighter looks brighter";
    EXPECT_LT(shown[0], 1);
    EXPECT_NEAR(shown[1] / shown[0], 0.5f, 1e-6f);
    EXPECT_NEAR(shown[2] / shown[0], 0.25f, 1e-6f);
    before = shown[0];
  }
  EXPECT_NEAR((toned({0.751f, 0, 0})[0] - 0.75f) / 0.001f, 1, 0.01f) << "without a kink";
}

TEST(Develop, AveragesLightAndNotNumbers) {
  // Half of the pixel is black, half is white paper: the mean light is 0.5, which is 188 in sRGB.
  const float half = 0.5f;
  const std::vector<float> samples{0, 0, 0, 1, half, half, half, 1, half, half, half, 1, 0, 0, 0, 1};
  const auto pixel = develop(samples, 1, 1, 2);
  EXPECT_EQ(pixel, (std::vector<std::uint8_t>{137, 137, 137, 255})) << "0.25 in sRGB";
  EXPECT_EQ(develop(samples, 2, 2, 1)[4], 188);
}

TEST(Develop, SurvivesWhatIsNoLight) {
  const float nan = std::nanf(""), infinite = INFINITY;
  const auto pixel = develop(std::vector<float>{infinite, -1, 0.1f, 2}, 1, 1, 1);
  EXPECT_EQ(pixel[0], 255);
  EXPECT_EQ(pixel[1], 0);
  EXPECT_EQ(pixel[3], 255);
  EXPECT_EQ(develop(std::vector<float>{nan, nan, nan, nan}, 1, 1, 1).size(), 4u);
}

/// Largest distance from the head's joint, sideways and to the front and back.
double reach(const std::vector<Eigen::Vector3d>& points) {
  double most = 0;
  for (const Eigen::Vector3d& p : points) most = std::max(most, std::hypot(p.x(), p.z()));
  return most;
}

class PreviewOfAWig : public testing::Test {
 protected:
  DrawnAsset wig_{made_up_wig({.strips = 6, .bones_per_chain = 4, .texture_size = 32})};
};

TEST_F(PreviewOfAWig, TheFrameHoldsTheWholeMotionAndIsTheSameAtEveryMoment) {
  const auto path = motion::path_of(motion::Motion::kTurn);
  const auto early = points_in_motion(*wig_, path.get(), 0.1, {}, &kCoifSolver);
  const auto late = points_in_motion(*wig_, path.get(), 1.5, {}, &kCoifSolver);
  const auto rest = points_in_motion(*wig_, nullptr, 0, {}, &kCoifSolver);
  ASSERT_TRUE(early && late && rest);
  EXPECT_EQ(early->size(), late->size());
  EXPECT_NEAR(reach(*early), reach(*late), 1e-6);
  EXPECT_GT(reach(*early), reach(*rest)) << "hair that is thrown goes further out";
  for (const double time : {0.2, 0.45, 0.8}) {
    const auto pose = motion::simulate_pose(*wig_, path.get(), time, {});
    ASSERT_TRUE(pose);
    for (const SolidMesh& patch : patch_surfaces(*wig_, pose->palette, 0)) {
      for (const SolidVertex& v : patch.vertices) {
        EXPECT_LE(std::hypot(v.position.x(), v.position.z()), 1.05 * reach(*early));
      }
    }
  }
}

TEST_F(PreviewOfAWig, TheFrameFollowsTheHeadsTurningAndNotItsWay) {
  const auto path = motion::path_of(motion::Motion::kRun);  // metres away after a second
  const auto points = points_in_motion(*wig_, path.get(), 2, {}, &kCoifSolver);
  ASSERT_TRUE(points);
  EXPECT_LT(reach(*points), 2);
}

TEST_F(PreviewOfAWig, WindAndSolverAreTheCallers) {
  StepSettings windy;
  windy.environment.wind = {20, 0, 0};
  const auto still = motion::simulate_pose(*wig_, nullptr, 0, {}),
             blown = motion::simulate_pose(*wig_, nullptr, 0, windy);
  const auto path = motion::path_of(motion::Motion::kTurn);
  const auto ours = motion::simulate_pose(*wig_, path.get(), 0.4, {}),
             thesis = motion::simulate_pose(*wig_, path.get(), 0.4, {}, &kThesisSolver);
  ASSERT_TRUE(still && blown && ours && thesis);
  const auto mean_x = [&](const motion::HairPose& pose) {
    double sum = 0, count = 0;
    for (const SolidMesh& patch : patch_surfaces(*wig_, pose.palette, 0)) {
      for (const SolidVertex& v : patch.vertices) sum += double(v.position.x()), ++count;
    }
    return sum / count;
  };
  EXPECT_GT(mean_x(*blown), mean_x(*still) + 0.001);
  EXPECT_GT(std::abs(mean_x(*ours) - mean_x(*thesis)), 1e-5);
}

TEST_F(PreviewOfAWig, MomentsOnOneWayAreWhatEachIsAlone) {
  const auto path = motion::path_of(motion::Motion::kNod);
  const std::array<double, 3> moments{0, 0.3, 0.7};
  const auto together = motion::simulate_poses(*wig_, path.get(), moments, {});
  ASSERT_TRUE(together);
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const auto alone = motion::simulate_pose(*wig_, path.get(), moments[i], {});
    ASSERT_TRUE(alone);
    for (std::size_t b = 0; b < alone->palette.size(); ++b) {
      EXPECT_TRUE(std::ranges::equal(std::span(reinterpret_cast<const float*>(&alone->palette[b]), 12),
                                     std::span(reinterpret_cast<const float*>(&(*together)[i].palette[b]), 12)));
    }
  }
}

TEST(TurnedRound, GoesWhereTheFaceLooks) {
  for (const motion::Motion motion :
       {motion::Motion::kNod, motion::Motion::kTurn, motion::Motion::kCharge, motion::Motion::kTumble}) {
    const auto path = motion::path_of(motion), turned = motion::turned_round(motion::path_of(motion));
    const Eigen::Quaterniond round(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitY()));
    for (const double time : {0.0, 0.2, 0.55, 1.3}) {
      const motion::HeadState a = path->at(time), b = turned->at(time);
      EXPECT_LT((round * a.position - b.position).norm(), 1e-9);
      EXPECT_LT((round * a.velocity - b.velocity).norm(), 1e-9);
      EXPECT_LT((round * a.angular_velocity - b.angular_velocity).norm(), 1e-9);
      // The face, along +Z of one head and -Z of the other, looks into turned directions.
      const Eigen::Vector3d ahead = round * (a.rotation * Eigen::Vector3d::UnitZ());
      EXPECT_LT((ahead - b.rotation * -Eigen::Vector3d::UnitZ()).norm(), 1e-9) << time;
    }
  }
}

/// Chest > neck > head, and a mesh of three vertices that follow one of them each.
importer::SourceModel bust() {
  importer::SourceModel model;
  for (const char* name : {"Chest", "Neck", "Head"}) {
    const auto parent = model.nodes.empty() ? importer::kNoIndex : std::uint32_t(model.nodes.size() - 1);
    model.nodes.push_back({name, parent, Eigen::Affine3d::Identity()});
  }
  importer::SourceMesh& mesh = model.meshes.emplace_back();
  mesh.positions.assign(3, {0, 0, 1});
  mesh.normals.assign(3, {0, 0, 1});
  mesh.influence_begin = {0, 1, 2, 3};
  mesh.influences = {{0, 1}, {1, 1}, {2, 1}};
  mesh.triangles = {0, 1, 2};
  return model;
}

TEST(BodyMesh, StaysWhereItIsWhileTheHeadTurns) {
  const importer::SourceModel model = bust();
  const Eigen::Quaternionf turn(Eigen::AngleAxisf(float(std::numbers::pi) / 2, Eigen::Vector3f::UnitY()));
  BodyTurn pose{"Head", {turn.x(), turn.y(), turn.z(), turn.w()}};
  const SolidMesh body = body_mesh(model, model.meshes[0], Eigen::Vector3f::Zero(), pose);
  const auto drawn = [&](std::size_t v) { return Eigen::Vector3f(turn * body.vertices[v].position); };
  EXPECT_LT((drawn(0) - Eigen::Vector3f(0, 0, 1)).norm(), 1e-6f) << "the chest";
  EXPECT_LT((drawn(1) - Eigen::Vector3f(1, 0, 1).normalized()).norm(), 1e-6f) << "the neck, half as far";
  EXPECT_LT((drawn(2) - Eigen::Vector3f(1, 0, 0)).norm(), 1e-6f) << "the head";
  EXPECT_LT((turn * body.vertices[0].normal - Eigen::Vector3f(0, 0, 1)).norm(), 1e-6f);
}

TEST(BodyMesh, WithoutAHeadBoneAllOfItTurns) {
  importer::SourceModel model = bust();
  const BodyTurn pose{"Kopf", {0, 1, 0, 0}};
  for (const SolidVertex& v : body_mesh(model, model.meshes[0], Eigen::Vector3f::Zero(), pose).vertices) {
    EXPECT_EQ(v.position.z(), 1) << "as the head's pose will turn it";
  }
}

TEST_F(PreviewOfAWig, MoreSamplesMakeAPictureOfTheSameSizeWithSmootherEdges) {
  PictureSettings settings;
  settings.width = 96;
  settings.height = 72;
  settings.warm_up = false;
  settings.transparency = &kOpaqueMode;
  const auto changes = [](const Picture& picture) {  // between neighbours in a row
    double sum = 0;
    for (std::size_t i = 4; i < picture.rgba.size(); ++i)
      sum += std::pow(double(picture.rgba[i]) - double(picture.rgba[i - 4]), 2);
    return sum;
  };
  const auto coarse = render_picture(*wig_, settings);
  settings.oversampling = 4;
  const auto fine = render_picture(*wig_, settings);
  ASSERT_TRUE(coarse) << coarse.error().message;
  ASSERT_TRUE(fine) << fine.error().message;
  EXPECT_EQ(fine->rgba.size(), coarse->rgba.size());
  EXPECT_LT(changes(*fine), changes(*coarse));
  settings.oversampling = 5;
  EXPECT_FALSE(render_picture(*wig_, settings));
  settings.oversampling = 4;
  settings.width = 2049;
  EXPECT_FALSE(render_picture(*wig_, settings)) << "8196 samples";
}

}  // namespace coif::render::preview_test
