// What a picture shows over the hair: lines where bones and colliders are, and colours of motion.

#include "models/absent.h"
#include "models/drawn_card.h"
#include "models/skinned_asset.h"
#include "models/small_asset.h"
#include "motion/head_path.h"
#include "render/egl_context.h"
#include "render/motion_colors.h"
#include "render/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace coif::render::debug_overlay_test {

class DebugOverlay : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto context = EglContext::create(); !context) COIF_FAIL_FOR_LACK_OF(context.error().message);
    settings_.width = 160;
    settings_.height = 120;
  }

  [[nodiscard]] Picture take() const { return take(*wig_); }
  [[nodiscard]] Picture take(const Asset& asset) const {
    auto picture = render_picture(asset, settings_);
    EXPECT_TRUE(picture) << picture.error().message;
    return picture ? *picture : Picture{};
  }

  /// The lines of the settled head in the picture, pixels.
  struct Segment {
    Eigen::Vector2d from, to;
  };
  [[nodiscard]] std::vector<Segment> segments() const {
    const auto pose = motion::simulate_pose(*wig_, nullptr, 0, settings_.step);
    const auto frame = frame_picture(*wig_, settings_);
    if (!pose || !frame) return {};
    const auto lines = debug_lines_of(*wig_, {.head = pose->head, .palette = pose->palette}, settings_.debug);
    if (!lines) return {};
    const auto pixel = [&](const double(&p)[3]) {
      const Eigen::Vector4f clip =
          frame->view.camera.clip_from_world * Eigen::Vector4f(float(p[0]), float(p[1]), float(p[2]), 1);
      return Eigen::Vector2d((0.5 + 0.5 * double(clip.x() / clip.w())) * settings_.width,
                             (0.5 - 0.5 * double(clip.y() / clip.w())) * settings_.height);
    };
    std::vector<Segment> all;
    for (const DebugLine& line : *lines) all.push_back({pixel(line.from), pixel(line.to)});
    return all;
  }

  DrawnAsset wig_{made_up_wig({.strips = 12, .texture_size = 32})};
  PictureSettings settings_;
};

double distance(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double share = along.squaredNorm() > 0 ? std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
  return (p - a - share * along).norm();
}

int difference(const Picture& a, const Picture& b, std::size_t pixel) {
  int most = 0;
  for (std::size_t k = 4 * pixel; k < 4 * pixel + 3; ++k) most = std::max(most, std::abs(a.rgba[k] - b.rgba[k]));
  return most;
}

TEST_F(DebugOverlay, APictureDiffersWhereLinesAreAndNowhereElse) {
  const Picture plain = take();
  for (const auto part : {&DebugView::bones, &DebugView::colliders}) {
    settings_.debug = {};
    settings_.debug.*part = true;
    const Picture lined = take();
    const auto lines = segments();
    ASSERT_GT(lines.size(), 10u);
    int on = 0, changed = 0;
    for (std::size_t i = 0; i < std::size_t{settings_.width} * settings_.height; ++i) {
      const Eigen::Vector2d middle(double(i % settings_.width) + 0.5, double(i / settings_.width) + 0.5);
      double nearest = 99;
      for (const auto& [from, to] : lines) nearest = std::min(nearest, distance(middle, from, to));
      if (nearest > 2) {
        EXPECT_EQ(difference(plain, lined, i), 0) << middle.transpose();
      }
      if (nearest > 0.3) continue;
      ++on;
      changed += difference(plain, lined, i) > 20 ? 1 : 0;
    }
    EXPECT_GT(on, 50);
    EXPECT_GT(changed, on * 9 / 10);
  }
}

TEST_F(DebugOverlay, ContactsAreRedAndLimitsGreen) {
  AssetContents contents = small_asset();
  for (DynamicsRecord& bone : contents.dynamics) bone.angle_limit = 0.4f;
  const DrawnAsset small(contents);
  const auto count = [&](std::size_t channel) {
    const Picture picture = take(*small);
    int of_it = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
      bool is_most = true;
      for (std::size_t k = 0; k < 3; ++k)
        is_most &= k == channel || picture.rgba[i + channel] > picture.rgba[i + k] + 60;
      of_it += is_most ? 1 : 0;
    }
    return of_it;
  };
  const int red = count(0), green = count(1);
  settings_.debug.contacts = true;
  EXPECT_GT(count(0), red + 10);
  EXPECT_EQ(count(1), green);
  settings_.debug = {.limits = true};
  EXPECT_GT(count(1), green + 50);
  EXPECT_EQ(count(0), red);
}

/// Counts the pixels that differ from the plain picture: those that are grey, and those with a channel far from the
/// others.
std::array<int, 2> grey_and_colored(const Picture& plain, const Picture& shown) {
  std::array<int, 2> found{};
  for (std::size_t i = 0; i < plain.rgba.size() / 4; ++i) {
    if (difference(plain, shown, i) < 8) continue;
    const auto [low, high] = std::minmax({shown.rgba[4 * i], shown.rgba[4 * i + 1], shown.rgba[4 * i + 2]});
    ++found[high - low > 40 ? 1 : 0];
  }
  return found;
}

TEST_F(DebugOverlay, HairThatStandsIsGreyAndHairThatTurnsIsColored) {
  const Picture still = take();
  settings_.debug.motion = true;
  const auto [grey, moving] = grey_and_colored(still, take());
  EXPECT_GT(grey, 500);
  EXPECT_LT(moving, grey / 20) << "but for edges, which are mixed with what is behind them";
  settings_.motion = motion::Motion::kTurn;
  settings_.time = 0.3;
  const Picture colored = take();
  settings_.debug.motion = false;
  EXPECT_GT(grey_and_colored(take(), colored)[1], 500);
}

TEST(MotionColors, TellTheWayByTheirHueAndTheSpeedByHowFullTheyAre) {
  const auto color = [](float x, float y) {
    std::array<float, 3> rgb{};
    motion_color(x, y, rgb);
    return rgb;
  };
  const auto still = color(0, 0);
  EXPECT_EQ(still[0], still[1]);
  EXPECT_EQ(still[0], still[2]);
  const auto right = color(0.02f, 0), left = color(-0.02f, 0);
  EXPECT_GT(right[0], 0.7f);
  EXPECT_LT(right[1] + right[2], 0.01f);
  EXPECT_LT(left[0], 0.01f);
  EXPECT_GT(left[1], 0.7f);
  EXPECT_GT(left[2], 0.7f);
  EXPECT_GT(color(-0.01f, 0.0173f)[1], 0.7f) << "a third of a turn further";
  EXPECT_LT(color(0.004f, 0)[0], right[0]);
  EXPECT_GT(color(0.004f, 0)[0], still[0]);
}

}  // namespace coif::render::debug_overlay_test
