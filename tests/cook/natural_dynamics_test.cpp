#include "cook/dynamics/choose_model.h"

#include "cook/built_models.h"
#include "cook/dynamics/bake_dynamics.h"
#include "cook/recipe/recipe.h"
#include "cook/told.h"
#include "lab/rig.h"
#include "lab/runtime_solver.h"
#include "models/test_rig.h"
#include "motion/head_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::cook::natural_dynamics_test {

using Eigen::Vector3d;

constexpr double kDegree = 0.017453292519943295;

/// Straight down from the back of the head, or along `direction`.
AssetContents strand(int bones, float length, const Vec3& direction = {0, -1, 0}) {
  TestRig rig;
  rig.add_strand(bones, {.joint = {0, 0.05f, -0.1f},
                         .rest_direction = direction,
                         .length = length / float(bones),
                         .friction = 0.5f,
                         .stiffness = 0,
                         .damping = 0,
                         .torsion = kShortestArc});
  return rig.contents();
}

std::vector<bool> all_of(const AssetContents& contents) {
  std::vector<bool> all;
  for (const BoneRecord& bone : contents.bones) all.push_back(bone.kind == BoneKind::kSimulated);
  return all;
}

/// As a recipe with this preset cooks it.
AssetContents with_preset(AssetContents contents, const char* preset = "natural") {
  Recipe recipe = default_recipe();
  recipe.dynamics_preset = preset;
  SaidMotion said{.records = contents.dynamics, .sources = {}, .presets = {}, .damping_ratios = {}};
  for (const bool simulated : all_of(contents)) {
    said.sources.push_back(simulated ? MotionSource::kPreset : MotionSource::kRigid);
  }
  said.presets.assign(contents.bones.size(), &preset_of(recipe));
  said.damping_ratios.assign(contents.bones.size(), preset_of(recipe).damping_ratio);
  settle_model(recipe, said, models_by_rule(recipe, said, contents), contents, unheard());
  return contents;
}

/// What the tips of hair do while the head moves, sixty times a second.
class Worn {
 public:
  explicit Worn(const AssetContents& contents)
      : opened_(contents), rig(lab::rig_of(opened_.asset())), solver_(opened_.asset(), {}, kCoifSolver, 4) {
    solver_.reset({});
  }

  void wait(double seconds, const HeadPose& pose) {
    for (int i = 0; i < seconds * 60; ++i) EXPECT_TRUE(solver_.step(pose, 1.0 / 60));
  }
  void step(const HeadPose& pose) { EXPECT_TRUE(solver_.step(pose, 1.0 / 60)); }
  [[nodiscard]] Vector3d end(std::size_t bone) const { return solver_.bone_ends()[bone]; }
  [[nodiscard]] Vector3d tip() const { return end(rig.bones.size() - 1); }

 private:
  lab::OpenedAsset opened_;

 public:
  const lab::Rig rig;

 private:
  lab::RuntimeSolver solver_;
};

std::vector<Vector3d> rest_ends(const lab::Rig& rig) {
  std::vector<Vector3d> ends;
  for (const lab::RigBone& bone : rig.bones) {
    const Vector3d start = bone.parent < 0 ? bone.joint : ends[std::size_t(bone.parent)];
    ends.push_back(start + bone.length * bone.rest_direction);
  }
  return ends;
}

/// Angle from the vertical through its root to a hanging strand's tip under a head tilted sideways, degrees.
double tilted_to(const AssetContents& contents, double tilt) {
  Worn worn(contents);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(tilt * kDegree, Vector3d::UnitZ()));
  for (int i = 1; i <= 60; ++i) {
    const Eigen::Quaterniond part = Eigen::Quaterniond::Identity().slerp(i / 60.0, turn);
    worn.step({{}, {float(part.x()), float(part.y()), float(part.z()), float(part.w())}});
  }
  worn.wait(6, {{}, {float(turn.x()), float(turn.y()), float(turn.z()), float(turn.w())}});
  const Vector3d way = turn * (worn.tip() - worn.rig.bones[0].joint);
  return std::acos(-way.normalized().y()) / kDegree;
}

TEST(RestShape, IsTheModelledOneInBothModels) {
  TestRig bent;
  bent.add({.joint = {0, 0.1f, -0.1f}, .rest_direction = {0, 0, -1}, .length = 0.08f});
  bent.add({.parent = 1, .rest_direction = {0.6f, -0.8f, 0}, .length = 0.1f});
  bent.add({.parent = 2, .rest_direction = {0, -0.8f, 0.6f}, .length = 0.12f});
  bent.add({.parent = 1, .rest_direction = {-0.6f, 0, -0.8f}, .length = 0.07f});
  for (const bool passive : {false, true}) {
    AssetContents contents = bent.contents();
    for (std::size_t b = 1; b < contents.dynamics.size(); ++b) {
      contents.dynamics[b].stiffness = b == 2 ? 5.0f : 200;
      contents.dynamics[b].damping = 12;
      contents.dynamics[b].torsion = kShortestArc;
      contents.dynamics[b].parent_share = b == 3 ? 0.5f : 1;
      contents.dynamics[b].gravity_scale = b == 4 ? 0.5f : 1;
    }
    for (ChainRecord& chain : contents.chains) chain.model = passive ? ChainModel::kPassive : ChainModel::kCascade;
    Worn sagging(contents);
    sagging.wait(6, {});
    const auto made = told([&](Findings& findings) {
      keep_rest_shape(all_of(contents), contents, findings);
      return 0;
    });
    EXPECT_EQ(made.notes.size(), 1u) << "one bone is too soft";
    Worn worn(contents);
    worn.wait(6, {});
    const std::vector<Vector3d> rest = rest_ends(worn.rig);
    for (std::size_t i = 0; i < rest.size(); ++i) {
      EXPECT_LT((worn.end(i) - rest[i]).norm(), 1e-5) << "bone " << i << (passive ? ", passive" : "");
      EXPECT_GT((sagging.end(i) - rest[i]).norm(), 1e-3) << "it would sag";
    }
  }
}

TEST(RestShape, HairThatStandsIsMadeStiffEnoughToStand) {
  const AssetContents up = with_preset(strand(4, 0.3f, {0, 1, 0}));
  Worn worn(up);
  const Vector3d rest = rest_ends(worn.rig).back();
  worn.wait(1, {});
  for (const double lean : {0.1, 0.0}) {  // nudged, and let go
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(lean, Vector3d::UnitX()));
    worn.wait(lean > 0 ? 0.3 : 8, {{}, {float(turn.x()), float(turn.y()), float(turn.z()), float(turn.w())}});
  }
  EXPECT_LT((worn.tip() - rest).norm(), 0.003);
}

TEST(NaturalHair, IsStifferInShortBonesAndSofterWhereMoreHangs) {
  const AssetContents one = with_preset(strand(1, 0.1f));
  // rho g b^3 / (l / 2) over the inertia rho l^3 of a bone of the length l alone
  EXPECT_NEAR(one.dynamics[1].stiffness, 9.81 * std::pow(0.08, 3) / 0.05 / 0.001, 0.1);
  EXPECT_EQ(one.chains[0].model, ChainModel::kPassive);
  const AssetContents six = with_preset(strand(6, 0.6f));
  for (std::size_t b = 2; b < six.dynamics.size(); ++b) {
    EXPECT_GT(six.dynamics[b].stiffness, b > 2 ? six.dynamics[b - 1].stiffness : 0) << b;
    EXPECT_LT(six.dynamics[b].stiffness, one.dynamics[1].stiffness) << b;
  }
}

TEST(NaturalHair, LongHairHangsAndShortHairStands) {
  EXPECT_LT(tilted_to(with_preset(strand(6, 0.5f)), 45), 8);
  EXPECT_LT(tilted_to(with_preset(strand(12, 1.0f)), 45), 5);
  EXPECT_GT(tilted_to(with_preset(strand(1, 0.04f)), 45), 38);
  const AssetContents middle = strand(2, 0.12f);
  const double heavy = tilted_to(with_preset(middle, "heavy"), 45), natural = tilted_to(with_preset(middle), 45);
  EXPECT_LT(heavy, natural - 2);
  EXPECT_LT(natural, tilted_to(with_preset(middle, "stiff"), 45) - 2);
}

/// After the head has got to 8 m/s within 0.3 s: how far hair swings past its rest, of how far it swung first, and how
/// long it is before it stays within a twentieth of that, seconds.
struct Swing {
  double overshoot = 0, settles = 0;
};

Swing swing_after_charge(const AssetContents& contents) {
  Worn worn(contents);
  const auto path = motion::path_of(motion::Motion::kCharge);
  const Vector3d rest = rest_ends(worn.rig).back();
  std::vector<Vector3d> offsets;
  for (int frame = 1; frame <= 60 * 8; ++frame) {
    worn.step(path->pose(frame / 60.0));
    offsets.push_back(worn.tip() - rest);
  }
  // Backwards, where it flies first: an end that swings up high goes up on both sides.
  const auto far = std::max_element(offsets.begin(), offsets.begin() + 60,
                                    [](const Vector3d& a, const Vector3d& b) { return -a.z() < -b.z(); });
  Swing swing;
  for (auto at = far; at != offsets.end(); ++at) {
    swing.overshoot = std::max(swing.overshoot, at->z() / -far->z());
    if (at->norm() > 0.05 * far->norm()) swing.settles = double(at - offsets.begin()) / 60 - 0.3;
  }
  return swing;
}

TEST(NaturalHair, SwingsPastItsRestAndSettles) {
  for (const auto& [bones, length] : {std::pair{2, 0.1f}, {3, 0.2f}, {6, 0.4f}, {8, 0.8f}}) {
    const Swing swing = swing_after_charge(with_preset(strand(bones, length)));
    EXPECT_GT(swing.overshoot, 0.08) << length << " m";
    EXPECT_LT(swing.overshoot, 0.75) << length << " m";
    EXPECT_GT(swing.settles, 0.3) << length << " m";
    EXPECT_LT(swing.settles, 3) << length << " m";
  }
  const AssetContents middle = strand(4, 0.25f);
  EXPECT_GT(swing_after_charge(with_preset(middle, "bouncy")).overshoot,
            swing_after_charge(with_preset(middle)).overshoot);
  EXPECT_LT(swing_after_charge(with_preset(middle, "wet")).overshoot,
            swing_after_charge(with_preset(middle)).overshoot);
}

}  // namespace coif::cook::natural_dynamics_test
