// A runner's pony tail. The head's bob up and down changes the weight that the hair feels twice per swing, which pumps
// a small sway to a large one where the hair's own period is near two steps: Mathieu's equation (Keller 2010, "Ponytail
// motion", SIAM J. Appl. Math. 70).
//
// Theory here: the chain for small angles, with the numbers that the cook gives its joints, under the bob alone.
// Floquet's multiplier of one step says by how much a sway grows; above 0 per second it grows until the angles are
// large.

#include "cook/cook.h"
#include "cook/dynamics/choose_model.h"
#include "cook/told.h"
#include "import/import.h"
#include "lab/rig.h"
#include "lab/runtime_solver.h"
#include "models/test_rig.h"
#include "motion/head_path.h"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

namespace coif::cook::ponytail_test {

using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr double kStepRate = 2.4, kBob = 0.045, kGravity = 9.81;  // of Motion::kJog: Hz, metres; m/s^2

/// Straight down from the back of the head, bones of 6 cm as chains are fitted, moved by `natural`.
AssetContents hanging_hair(double length, bool is_tied) {
  const int bones = std::max(2, int(std::lround(length / 0.06)));
  TestRig rig;
  rig.add_strand(bones, {.joint = {0, 0.05f, -0.1f}, .length = float(length) / float(bones), .torsion = kShortestArc});
  AssetContents contents = rig.contents();
  const Recipe recipe = default_recipe();
  const HairPreset& preset = preset_of(recipe);
  SaidMotion said{.records = contents.dynamics, .sources = {}, .presets = {}, .damping_ratios = {}};
  for (DynamicsRecord& record : said.records) record.friction = float(friction_of(preset, is_tied));
  contents.dynamics = said.records;
  said.sources.assign(contents.bones.size(), MotionSource::kPreset);
  said.sources[0] = MotionSource::kRigid;
  said.presets.assign(contents.bones.size(), &preset);
  said.damping_ratios.assign(contents.bones.size(), preset.damping_ratio);
  said.tied.assign(contents.bones.size(), is_tied);
  contents.skeleton.air_lag = air_lag(recipe, said);
  settle_model(recipe, said, models_by_rule(recipe, said, contents), contents, unheard());
  return contents;
}

/// A hanging chain's equation for small angles a of its bones against the vertical: M a'' + (D + friction M) a' + (K +
/// G) a = 0.
struct SmallSwings {
  MatrixXd mass, bending, weight, damping;
  double friction = 0;

  explicit SmallSwings(const AssetContents& contents) {
    const auto count = Eigen::Index(contents.dynamics.size() - 1);
    const double l = double(contents.bones[1].length), m = l;  // a kilogram a metre, at the tails
    MatrixXd places = MatrixXd::Zero(count, count);            // of tails, by angles
    MatrixXd bends = MatrixXd::Identity(count, count);         // of joints, by angles
    mass = bending = weight = damping = MatrixXd::Zero(count, count);
    Eigen::VectorXd spring(count), damper(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto below = double(count - i);
      const double inertia = m * l * l * below * (below + 1) * (2 * below + 1) / 6;
      const DynamicsRecord& bone = contents.dynamics[std::size_t(i) + 1];
      spring[i] = double(bone.stiffness) * inertia;
      damper[i] = double(bone.damping) * inertia;
      friction = double(bone.friction);
      places.row(i).head(i + 1).setConstant(l);
      weight(i, i) = kGravity * m * below * l;
      if (i > 0) bends(i, i - 1) = -1;
    }
    mass = m * places.transpose() * places;
    bending = bends.transpose() * spring.asDiagonal() * bends;
    damping = bends.transpose() * damper.asDiagonal() * bends;
  }

  /// Angles and their rates as one vector: its rate of change where weight is `share` of the usual.
  [[nodiscard]] MatrixXd rates(double share) const {
    const Eigen::Index n = mass.rows();
    const MatrixXd lighter = mass.inverse();
    MatrixXd system = MatrixXd::Zero(2 * n, 2 * n);
    system.topRightCorner(n, n).setIdentity();
    system.bottomLeftCorner(n, n) = -lighter * (bending + share * weight);
    system.bottomRightCorner(n, n) = -lighter * damping - friction * MatrixXd::Identity(n, n);
    return system;
  }

  /// The slowest swing's: imaginary part 2 pi times its rate in Hz, real part minus how fast it dies away, 1/s.
  [[nodiscard]] std::complex<double> slowest_swing() const {
    const Eigen::VectorXcd values = rates(1).eigenvalues();
    std::complex<double> slowest(0, 1e9);
    for (const std::complex<double>& value : values) {
      if (value.imag() > 1e-6 && std::abs(value) < std::abs(slowest)) slowest = value;
    }
    return slowest;
  }

  /// 1/s: how fast the sway that grows fastest does, under the bob.
  [[nodiscard]] double growth() const {
    constexpr int kParts = 800;
    constexpr double kDt = 1 / kStepRate / kParts, kTurn = 2 * std::numbers::pi * kStepRate;
    const MatrixXd one = MatrixXd::Identity(2 * mass.rows(), 2 * mass.rows());
    MatrixXd all = one;
    for (int part = 0; part < kParts; ++part) {
      const double share = 1 - kBob * kTurn * kTurn / kGravity * std::sin(kTurn * (part + 0.5) * kDt);
      const MatrixXd half = kDt / 2 * rates(share);
      all = (one - half).partialPivLu().solve((one + half) * all);
    }
    return std::log(all.eigenvalues().cwiseAbs().maxCoeff()) * kStepRate;
  }
};

std::vector<Vector3d> tip_during(const AssetContents& contents, motion::Motion motion, double seconds) {
  const lab::OpenedAsset opened(contents);
  lab::RuntimeSolver solver(opened.asset(), {}, kCoifSolver, 2);
  const auto path = motion::path_of(motion);
  solver.reset(path->pose(0));
  std::vector<Vector3d> tip{solver.bone_ends().back()};
  for (int frame = 1; frame <= seconds * 60; ++frame) {
    EXPECT_TRUE(solver.step(path->pose(frame / 60.0), 1.0 / 60));
    tip.push_back(solver.bone_ends().back());
  }
  return tip;
}

/// Metres to each side, in the last four of ten seconds.
double sway_in_jog(const AssetContents& contents) {
  const auto tip = tip_during(contents, motion::Motion::kJog, 10);
  const auto [least, most] = std::minmax_element(tip.end() - 240, tip.end(),
                                                 [](const Vector3d& a, const Vector3d& b) { return a.x() < b.x(); });
  return (most->x() - least->x()) / 2;
}

TEST(Ponytail, SwaysWhereTheoryLetsItGrowAndNowhereElse) {
  std::printf("  length   hair   swings   dies away   grows   sway\n");
  for (const bool is_tied : {true, false}) {
    for (int cm = 10; cm <= 70; cm += 5) {
      const AssetContents hair = hanging_hair(cm / 100.0, is_tied);
      const SmallSwings theory(hair);
      const double growth = theory.growth(), sway = sway_in_jog(hair);
      const std::complex<double> swing = theory.slowest_swing();
      std::printf("  %3d cm   %-5s  %.2f Hz  %5.2f 1/s  %+5.2f 1/s  %5.1f cm\n", cm, is_tied ? "tied" : "loose",
                  swing.imag() / 2 / std::numbers::pi, -swing.real(), growth, 100 * sway);
      if (cm >= 25 && cm <= 35 && is_tied) EXPECT_GT(growth, 0.2) << cm << " cm";
      if (growth > 0.2) EXPECT_TRUE(sway > 0.05 && sway < 0.3) << cm << " cm sways by " << sway;
      if (growth < -0.05) EXPECT_LT(sway, 0.04) << cm << " cm";
      if (!is_tied) EXPECT_LT(growth, -0.5) << cm << " cm: loose hair bobs";
    }
  }
}

/// Metres to each side, of the end of a bone that sways most, in the last four of ten seconds.
double widest_sway_in_jog(const Asset& asset) {
  lab::RuntimeSolver solver(asset, {}, kCoifSolver, 2);
  const auto path = motion::path_of(motion::Motion::kJog);
  solver.reset(path->pose(0));
  std::vector<double> least(solver.bone_ends().size(), 1e9), most(least.size(), -1e9);
  for (int frame = 1; frame <= 600; ++frame) {
    EXPECT_TRUE(solver.step(path->pose(frame / 60.0), 1.0 / 60));
    if (frame <= 360) continue;
    for (std::size_t i = 0; i < least.size(); ++i) {
      least[i] = std::min(least[i], solver.bone_ends()[i].x());
      most[i] = std::max(most[i], solver.bone_ends()[i].x());
    }
  }
  double widest = 0;
  for (std::size_t i = 0; i < least.size(); ++i) widest = std::max(widest, (most[i] - least[i]) / 2);
  return widest;
}

struct Worn {
  const char* path;  ///< Below the corpus' folder "hair".
  bool is_tied;
};

class ArtistsPonytails : public testing::TestWithParam<Worn> {};

TEST_P(ArtistsPonytails, SwayInJogWhereTheyAreTied) {
  const auto path = std::filesystem::path(COIF_TEST_ASSETS) / "hair" / GetParam().path;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << ": no corpus of artists' files here";
  const auto source = importer::import_model(path);
  ASSERT_TRUE(source) << source.error().message;
  const auto cooked = cook(*source, default_recipe(), {.threads = 2, .recipe_directory = {}, .draft = true});
  ASSERT_TRUE(cooked) << cooked.error().message;
  const auto says_tied = [](const std::string& note) { return note.find(" tied hair, ") != std::string::npos; };
  EXPECT_EQ(std::ranges::any_of(cooked->report.notes, says_tied), GetParam().is_tied);
  const lab::OpenedAsset opened(cooked->asset);
  const double sway = widest_sway_in_jog(opened.asset());
  if (GetParam().is_tied) {
    EXPECT_TRUE(sway > 0.05 && sway < 0.3) << sway;
  } else {
    EXPECT_LT(sway, 0.03);
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, ArtistsPonytails,
                         testing::Values(Worn{"mh_ponytail01/ponytail01.obj", true},
                                         Worn{"moz_pigtails-1/hair_pigtails-1-red.glb", true},
                                         Worn{"mh_braid01/braid01.obj", true},
                                         Worn{"moz_french-braids-double/hair_french-braids-double-brown.glb", true},
                                         Worn{"mh2013_long2/long2.obj", false}, Worn{"mh2013_curly/curly.obj", false},
                                         Worn{"unitychan/UnityChan.fbx", false}));

}  // namespace coif::cook::ponytail_test
