// How alive hair is, of tips whose swing is known in closed form.

#include "report/accuracy/swing.h"

#include "lab/rig.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::report::swing_test {

using Eigen::Vector3d;

constexpr double kDt = 1.0 / 60;

/// A tip let go `thrown` behind its rest: a damped oscillator of 1 Hz.
std::vector<Vector3d> let_go(double ratio, double thrown, double seconds, const Vector3d& rest) {
  const double rate = 2 * std::numbers::pi, damped = rate * std::sqrt(1 - ratio * ratio);
  std::vector<Vector3d> tips;
  for (double t = 0; t < seconds; t += kDt) {
    const double phase = damped * t;
    const double at = std::exp(-ratio * rate * t) * (std::cos(phase) + ratio * rate / damped * std::sin(phase));
    tips.push_back(rest + Vector3d(0, 0, -thrown * at));
  }
  return tips;
}

TEST(Swing, OvershootsAndSettlesAsItsDampingSays) {
  const Vector3d rest(0.1, -0.3, 0.2);
  for (const double ratio : {0.1, 0.2, 0.4}) {
    const Swing swing = swing_of(let_go(ratio, 0.25, 20, rest), rest, kDt);
    EXPECT_NEAR(swing.thrown, 0.25, 1e-9);
    EXPECT_NEAR(swing.overshoot, std::exp(-ratio * std::numbers::pi / std::sqrt(1 - ratio * ratio)), 2e-3) << ratio;
    // The envelope reaches a twentieth at ln(20) / (ratio rate); the swing itself up to half a period sooner.
    const double envelope = std::log(20) / (ratio * 2 * std::numbers::pi);
    EXPECT_LT(swing.settling_s, envelope + 0.05);
    EXPECT_GT(swing.settling_s, envelope - 0.55);
  }
}

TEST(Swing, ThatDoesNotEndHasNoSettlingTime) {
  const Swing swing = swing_of(let_go(0, 0.25, 5, Vector3d::Zero()), Vector3d::Zero(), kDt);
  EXPECT_NEAR(swing.overshoot, 1, 2e-3);
  EXPECT_TRUE(std::isnan(swing.settling_s));
}

TEST(Swing, OfATipAtRestIsNone) {
  const std::vector<Vector3d> still(60, Vector3d(1, 2, 3));
  const Swing swing = swing_of(still, {1, 2, 3}, kDt);
  EXPECT_EQ(swing.thrown, 0);
  EXPECT_EQ(swing.overshoot, 0);
  EXPECT_EQ(swing_of({}, Vector3d::Zero(), kDt).thrown, 0);
}

TEST(Swings, OfSoftHairAreWiderAndLongerThanOfDampedHair) {
  const auto row_of = [](float damping) {
    TestRig rig;
    std::uint32_t parent = 0;
    for (int i = 0; i < 3; ++i) {
      parent = rig.add({.parent = parent,
                        .joint = {0, 0, -0.3f},
                        .length = 0.1f,
                        .friction = 1,
                        .stiffness = 60,
                        .damping = damping,
                        .torsion = kShortestArc});
    }
    const lab::OpenedAsset opened(rig.contents());
    const Swings swings = measure_swings(opened.asset());
    const std::vector<SwingRow>& rows = swings.rows;
    EXPECT_GT(std::ranges::max(swings.longest.behind_m), 0.05) << "a head that charges forward leaves its hair behind";
    EXPECT_EQ(rows.size(), 1u);
    return rows.empty() ? SwingRow{} : rows[0];
  };
  const SwingRow soft = row_of(3), damped = row_of(40);
  EXPECT_NEAR(soft.length_mm, 300, 0.01);
  EXPECT_GT(soft.overshoot_pct, damped.overshoot_pct + 10);
  EXPECT_GT(soft.thrown_pct, 20);
  EXPECT_TRUE(std::isfinite(soft.settling_s));
}

}  // namespace coif::report::swing_test
