// Stress by the body that hair hangs over.

#include "models/test_rig.h"
#include "report/stability/measure_stability.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace coif::report::body_cases_test {

constexpr double kAllowed = 0.01;  // % of the radius

/// Two strands behind a head, of which the first alone keeps out of a shoulder that lies across both.
TestRig rig_with_shoulder(ChainModel model) {
  TestRig rig;
  rig.model = model;
  rig.add_sphere({0, 0, 0}, 0.09f);
  for (const float side : {-0.02f, 0.02f}) {
    TestBone bone{.joint = {side, 0.05f, -0.1f}, .length = 0.05f};
    bone.stiffness = 100;
    bone.damping = 10;
    bone.torsion = kShortestArc;
    rig.add_strand(6, bone);
  }
  const Quat turned{0, 0, 0.38268343f, 0.92387953f};  // a bone's own axes are not the model's
  rig.body_bones.push_back({0, {0.2f, -0.15f, -0.09f}, {turned.x, turned.y, turned.z, turned.w}});
  ColliderRecord shoulder{};
  shoulder.shape = ColliderShape::kTaperedCapsule;
  shoulder.rotation[3] = 1;
  shoulder.center[0] = -0.1f, shoulder.center[1] = -0.22f, shoulder.center[2] = -0.12f;
  shoulder.axis[0] = 0.2f;
  shoulder.radii[0] = 0.05f, shoulder.radii[1] = 0.03f;
  rig.body_colliders.push_back(shoulder);
  return rig;
}

lab::OpenedAsset hair_over_shoulder(ChainModel model, bool second_heeds = true) {
  AssetContents contents = rig_with_shoulder(model).contents();
  for (std::size_t bone = 7; bone < contents.body_sets.size() && !second_heeds; ++bone) contents.body_sets[bone] = 0;
  return lab::OpenedAsset(contents);
}

StabilityRow run(const Stress& stress, const Asset& asset) {
  return StressSubject(stress, asset, lab::sample_of(lab::rig_of(asset), kMaxBones)).run(solver_on_a_character());
}

TEST(BodyCases, LeaveNoBoneInTheBody) {
  EXPECT_GE(body_cases().size(), 6u);
  for (const ChainModel model : {ChainModel::kCascade, ChainModel::kPassive}) {
    const lab::OpenedAsset hair = hair_over_shoulder(model);
    ASSERT_TRUE(hair.asset().is_open());
    for (const Stress& stress : body_cases()) {
      const StabilityRow row = run(stress, hair.asset());
      const bool is_bad = stress.about.name.find("not a number") != std::string::npos;
      EXPECT_EQ(row.outcome, is_bad ? Outcome::kRejected : Outcome::kOk) << stress.about.name;
      EXPECT_LE(row.penetration_max_pct, kAllowed) << stress.about.name << ' ' << int(model);
      EXPECT_LT(row.stretch_max_pct, 1e-2) << stress.about.name;
    }
  }
}

TEST(BodyCases, SeeHairThatTheBodyGoesThrough) {
  const lab::OpenedAsset hair = hair_over_shoulder(ChainModel::kCascade);
  const Asset& asset = hair.asset();
  const lab::RigSample sample = lab::sample_of(lab::rig_of(asset), kMaxBones);
  StressBody body(asset, sample);
  lab::MovingMeter meter(sample.rig);
  const auto up = [](double metres) {
    return [metres](const Eigen::Vector3d&, double) { return Eigen::Isometry3d(Eigen::Translation3d(0, metres, 0)); };
  };
  body.move(up(-1), 0, {});
  meter.look(lab::resting_ends(sample.rig), body.solids(), body.sets());
  EXPECT_EQ(meter.worst(), 0);
  body.move(up(0.06), 0, {});  // across the strands at rest
  meter.look(lab::resting_ends(sample.rig), body.solids(), body.sets());
  EXPECT_GT(meter.worst(), 0.5);
}

TEST(BodyCases, LookAtThoseBonesThatKeepOutOfTheBody) {
  const lab::OpenedAsset all = hair_over_shoulder(ChainModel::kCascade);
  const lab::OpenedAsset some = hair_over_shoulder(ChainModel::kCascade, false);
  const lab::RigSample sample = lab::sample_of(lab::rig_of(some.asset()), kMaxBones);
  const StressBody heeded_by_all(all.asset(), sample), heeded_by_some(some.asset(), sample);
  for (std::size_t bone = 0; bone < 12; ++bone) {
    EXPECT_EQ(heeded_by_all.sets()[bone], 1u);
    EXPECT_EQ(heeded_by_some.sets()[bone], bone < 6 ? 1u : 0u);
  }
  for (const Stress& stress : body_cases()) EXPECT_LE(run(stress, some.asset()).penetration_max_pct, kAllowed);
}

TEST(BodyCases, TellHostsPosesThatPutCollidersThere) {
  const lab::OpenedAsset hair = hair_over_shoulder(ChainModel::kCascade);
  for (const Stress& stress : body_cases()) {
    if (stress.about.name.find("not a number") != std::string::npos) continue;
    Stress without = stress;
    without.body = nullptr;
    EXPECT_GT(std::abs(run(stress, hair.asset()).max_speed - run(without, hair.asset()).max_speed), 1e-3)
        << stress.about.name << ": the body was at work";
  }
}

TEST(BodyCases, AreForHairThatHasABody) {
  const StressAsset bodiless(StressRig{.bones_per_chain = 3});
  const lab::OpenedAsset hair = hair_over_shoulder(ChainModel::kCascade);
  const Stress stress = body_cases().front();
  const StressSubject without(stress, bodiless.asset(), lab::sample_of(lab::rig_of(bodiless.asset()), 64));
  const StressSubject with(stress, hair.asset(), lab::sample_of(lab::rig_of(hair.asset()), 64));
  EXPECT_FALSE(without.is_for(*find_measured_solver("coif")));
  EXPECT_TRUE(with.is_for(*find_measured_solver("coif")));
  EXPECT_FALSE(with.is_for(*find_measured_solver("thesis")));
}

}  // namespace coif::report::body_cases_test
