// What an artist's resistance is baked into, against the recurrence that it is defined by.

#include "cook/dynamics/bake_dynamics.h"
#include "cook/recipe/recipe.h"
#include "cook/told.h"
#include "write/pose_oscillator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace coif::cook::oscillator_test {

/// Algorithm 1 without friction, far from its constraints: the distance to the default position, step by step, under a
/// constant acceleration.
class Recurrence {
 public:
  Recurrence(double resistance, double rate, double load) : keep_(1 - resistance), push_(load / (rate * rate)) {}

  double step() {
    const double next = keep_ * (2 * now_ - before_ + push_);
    before_ = now_;
    return now_ = next;
  }

 private:
  double keep_, push_;
  double before_ = 1, now_ = 1;
};

/// Modulus and angle per step of the recurrence's roots, from what it does.
struct Roots {
  double modulus = 0;
  double angle = 0;
};

Roots roots_of(double resistance) {
  Recurrence recurrence(resistance, 60, 0);
  const double a = recurrence.step(), b = recurrence.step(), c = recurrence.step(), d = recurrence.step();
  const double square = (b * d - c * c) / (a * c - b * b);  // the product of both roots
  const double modulus = std::sqrt(square);
  return {modulus, std::acos((c + square * a) / (2 * modulus * b))};
}

TEST(PoseOscillator, SwingsDieOutAsInAlgorithmOne) {
  for (const double rate : {30.0, 60.0, 144.0}) {
    for (const double r : {0.001, 0.06, 0.35, 0.6, 0.9, 0.999}) {
      const PoseOscillator oscillator = oscillator_of(r, rate);
      EXPECT_NEAR(std::exp(-0.5 * oscillator.damping / rate), roots_of(r).modulus, 1e-9) << r << " at " << rate;
    }
  }
}

TEST(PoseOscillator, SagsAsFarAsAlgorithmOne) {
  constexpr double kLoad = 9.81;
  for (const double rate : {30.0, 60.0, 144.0}) {
    for (const double r : {0.02, 0.06, 0.35, 0.9}) {
      Recurrence recurrence(r, rate, kLoad);
      double settled = 0;
      for (int i = 0; i < 4000; ++i) settled = recurrence.step();
      EXPECT_NEAR(settled, kLoad / oscillator_of(r, rate).stiffness, 1e-9) << r << " at " << rate;
    }
  }
}

TEST(PoseOscillator, SwingsAsFastAsAlgorithmOneWhereTheResistanceIsSmall) {
  for (const double r : {0.001, 0.01, 0.06, 0.35, 0.6}) {
    const PoseOscillator oscillator = oscillator_of(r, 60);
    const double angle = std::sqrt(oscillator.stiffness - 0.25 * oscillator.damping * oscillator.damping) / 60;
    EXPECT_GT(angle / roots_of(r).angle, 1) << r;
    EXPECT_LT(angle / roots_of(r).angle, 1 + 0.5 * r) << r;
  }
}

TEST(PoseOscillator, ScalesWithTheAuthoringRate) {
  const PoseOscillator at_60 = oscillator_of(0.35, 60), at_120 = oscillator_of(0.35, 120);
  EXPECT_DOUBLE_EQ(at_120.stiffness, 4 * at_60.stiffness);
  EXPECT_DOUBLE_EQ(at_120.damping, 2 * at_60.damping);
}

TEST(PoseOscillator, IsFiniteForEveryResistance) {
  EXPECT_EQ(oscillator_of(0, 60).stiffness, 0);
  EXPECT_EQ(oscillator_of(0, 60).damping, 0);
  for (const double rate : {1.0, 60.0, 1000.0}) {
    EXPECT_TRUE(std::isfinite(oscillator_of(1, rate).stiffness));
    EXPECT_TRUE(std::isfinite(oscillator_of(1, rate).damping));
    EXPECT_GT(oscillator_of(1, rate).stiffness, 1e5 * rate * rate) << "a bone that hardly leaves its pose";
    EXPECT_EQ(oscillator_of(2, rate).stiffness, oscillator_of(1, rate).stiffness);
  }
  EXPECT_EQ(oscillator_of(-1, 60).stiffness, 0);
}

/// Two bones of 0.1 m and 0.2 m below the head.
Skeleton two_bones() {
  Skeleton skeleton;
  skeleton.bones.resize(3);
  skeleton.bones[0].kind = BoneKind::kHead;
  for (std::uint32_t b = 1; b < 3; ++b) {
    skeleton.bones[b].kind = BoneKind::kSimulated;
    skeleton.bones[b].parent = b - 1;
    skeleton.bones[b].place = 0.5 * b;
    skeleton.bones[b].tail = skeleton.bones[b].start - Eigen::Vector3d(0, 0.1 * b, 0);
  }
  skeleton.chains = {{1, 2, 0, {}}};
  return skeleton;
}

std::vector<DynamicsRecord> baked(const Recipe& recipe) {
  return bake_dynamics(importer::SourceModel(), two_bones(), recipe, {}, unheard()).records;
}

Recipe curve_recipe() {
  Recipe recipe = default_recipe();
  recipe.resistance = {{0, 0.35}, {1, 0.06}};
  return recipe;
}

Recipe undamped_recipe() {
  Recipe recipe = curve_recipe();
  recipe.damping_ratio.reset();
  return recipe;
}

TEST(BakeDynamics, WithoutADampingRatioEachBoneHasItsResistancesOwn) {
  const auto records = baked(undamped_recipe());
  ASSERT_EQ(records.size(), 3u);
  for (std::size_t b = 1; b < 3; ++b) {
    const PoseOscillator oscillator = oscillator_of(records[b].resistance, records[b].authoring_rate);
    EXPECT_FLOAT_EQ(records[b].stiffness, float(oscillator.stiffness));
    EXPECT_FLOAT_EQ(records[b].damping, float(oscillator.damping));
  }
  EXPECT_GT(records[1].stiffness, records[2].stiffness) << "the curve falls from root to tip";
}

TEST(BakeDynamics, TheDampingRatioCountsThePendulumAndTheFriction) {
  Recipe recipe = curve_recipe();
  recipe.damping_ratio = 0.8;
  const auto records = baked(recipe);
  const auto pure = baked(undamped_recipe());
  for (std::size_t b = 1; b < 3; ++b) {
    const double length = 0.1 * double(b);
    const double stiffness = records[b].stiffness + 2 * 9.81 / length;
    EXPECT_NEAR(records[b].damping + records[b].friction, 2 * 0.8 * std::sqrt(stiffness), 1e-3);
    EXPECT_EQ(records[b].stiffness, pure[b].stiffness) << "damping does not stiffen";
  }
  recipe.gravity_scale = 0;
  for (std::size_t b = 1; b < 3; ++b) {
    const DynamicsRecord weightless = baked(recipe)[b];
    EXPECT_NEAR(weightless.damping + weightless.friction, 1.6 * std::sqrt(weightless.stiffness), 1e-3);
  }
}

TEST(BakeDynamics, TheDampingRatioMeansWhatItSaysAboveAndBelowTheResistancesOwn) {
  double before = -1;
  for (const double ratio : {0.1, 0.3, 0.5, 1.0, 2.0}) {
    Recipe recipe = curve_recipe();
    recipe.damping_ratio = ratio;
    const DynamicsRecord tip = baked(recipe)[2];
    EXPECT_GT(tip.damping, before) << ratio;
    EXPECT_NEAR(tip.damping + tip.friction, 2 * ratio * std::sqrt(tip.stiffness + 2 * 9.81 / 0.2), 1e-3);
    before = double(tip.damping);
  }
  EXPECT_LT(baked(undamped_recipe())[2].damping, before);
}

TEST(BakeDynamics, ADampingCurveIsTakenAtEachBonesMiddle) {
  Recipe recipe = curve_recipe();
  recipe.damping_ratio = std::vector<CurvePoint>{{0, 0.9}, {1, 0.3}};
  const auto by_curve = baked(recipe);
  const Skeleton skeleton = two_bones();
  for (std::size_t b = 1; b < 3; ++b) {
    const double middle = 0.5 * (skeleton.bones[skeleton.bones[b].parent].place + skeleton.bones[b].place);
    recipe.damping_ratio = 0.9 - 0.6 * middle;
    EXPECT_FLOAT_EQ(by_curve[b].damping, baked(recipe)[b].damping);
  }
  recipe.damping_ratio = std::vector<CurvePoint>{{0.5, 0.4}};
  const auto flat = baked(recipe);
  recipe.damping_ratio = 0.4;
  for (std::size_t b = 1; b < 3; ++b) EXPECT_EQ(flat[b].damping, baked(recipe)[b].damping);
}

TEST(BakeDynamics, FrictionAloneMayBeMoreThanTheDampingRatio) {
  Recipe recipe = curve_recipe();
  recipe.damping_ratio = 0.01;
  recipe.friction = 100;
  for (std::size_t b = 1; b < 3; ++b) EXPECT_EQ(baked(recipe)[b].damping, 0);
}

TEST(BakeDynamics, LivelinessIsWhatTheDampingRatioLeaves) {
  Recipe by_ratio = curve_recipe(), by_liveliness = by_ratio;
  by_ratio.damping_ratio = 0.3;
  by_liveliness.liveliness = 0.7;
  for (std::size_t b = 1; b < 3; ++b) EXPECT_FLOAT_EQ(baked(by_ratio)[b].damping, baked(by_liveliness)[b].damping);
}

TEST(BakeDynamics, FullResistanceLooksRigidAndCanBeResolved) {
  Recipe recipe = default_recipe();
  recipe.resistance = {{0, 1}};
  for (const double rate : {60.0, 1000.0}) {
    for (const double ratio : {0.0, 1.0, 10.0}) {
      recipe.authoring_rate = rate;
      recipe.damping_ratio = ratio;
      for (std::size_t b = 1; b < 3; ++b) {
        const DynamicsRecord record = baked(recipe)[b];
        EXPECT_LT(9.81 / record.stiffness, 1e-5) << "metres of sag";
        EXPECT_LE(record.stiffness, 1e7);
        EXPECT_LE(record.damping, 1e4);
      }
    }
  }
}

TEST(BakeDynamics, AngleLimitsAreWrittenInRadians) {
  Recipe recipe = default_recipe();
  EXPECT_EQ(baked(recipe)[1].angle_limit, kNoAngleLimit) << "180 degrees are none";
  recipe.angle_limit = 60;
  EXPECT_FLOAT_EQ(baked(recipe)[1].angle_limit, float(std::numbers::pi / 3));
  recipe.angle_limit = 0;
  EXPECT_EQ(baked(recipe)[2].angle_limit, 0.0f);
}

TEST(BakeDynamics, TorsionAndParentShareAreTheRecipes) {
  Recipe recipe = default_recipe();
  recipe.torsion = 7;
  recipe.parent_share = 0.25;
  for (std::size_t b = 1; b < 3; ++b) {
    EXPECT_EQ(baked(recipe)[b].torsion, 7.0f);
    EXPECT_EQ(baked(recipe)[b].parent_share, 0.25f);
  }
}

}  // namespace coif::cook::oscillator_test
