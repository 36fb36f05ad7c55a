// A hundred heads to which anything may happen at any time: each must fare as if nothing happened to the others.

#include "sim/feature_rig.h"
#include "sim/playback.h"

#include <gtest/gtest.h>

#include <cstring>

namespace coif {
namespace {

constexpr std::uint32_t kHeads = 100;
constexpr int kFrames = 200;

/// The life of one head, drawn at random, the same for the same number.
class Life {
 public:
  explicit Life(std::uint32_t number) : random_(number * 7919 + 1) {}

  void live(Hair& hair, std::uint32_t instance) {
    const double what = random_.between(0, 1);
    if (what < 0.06) stands_ = !stands_;
    if (what > 0.9) {
      EXPECT_EQ(hair.set_detail(instance, detail()), Status::kOk);
    }
    if (!stands_) here_ = wander(now_ += 1.0 / 60);
    if (stands_) {
      EXPECT_EQ(hair.set_head(instance, here_), Status::kOk);
    } else if (what > 0.55 && what < 0.57) {
      EXPECT_EQ(hair.reset(instance, here_), Status::kOk);
    } else if (what > 0.6 && what < 0.63) {
      EXPECT_EQ(hair.teleport(instance, here_), Status::kOk);
    } else if (what > 0.15) {  // else the game forgot it for a frame
      EXPECT_EQ(hair.set_head(instance, here_), Status::kOk);
    }
  }

 private:
  Detail detail() {
    const auto level = std::uint32_t(random_.between(0, 3));
    const std::uint32_t intervals[] = {1, 2, 4};
    const std::uint32_t interval = intervals[int(random_.between(0, 3))];
    return {.level = level, .interval = interval, .simulated = random_.between(0, 1) > 0.2};
  }

  Violence random_;
  bool stands_ = true;
  double now_ = 0;
  HeadPose here_;
};

struct Seen {
  std::vector<Mat34> palette;
  bool is_asleep;
};

/// What one head does among others; `lives` says whose lives are lived.
std::vector<Seen> watch(const Solver* solver, std::uint32_t watched, bool all_live) {
  TestHair test(feature_rig(), {.instances = kHeads, .solver = solver, .longest_interval = 4});
  std::vector<Life> lives;
  for (std::uint32_t i = 0; i < kHeads; ++i) lives.emplace_back(i);
  std::vector<Seen> seen;
  for (int frame = 0; frame < kFrames; ++frame) {
    for (std::uint32_t i = 0; i < kHeads; ++i) {
      if (all_live || i == watched) lives[i].live(test.hair, i);
    }
    const StepSettings settings{.dt = frame % 3 == 0 ? 0.02f : 0.015f, .sleep_after = 0.1f, .sleep_speed = 2.0f};
    EXPECT_EQ(test.hair.step(settings), Status::kOk);
    const auto palette = test.hair.palette(watched);
    seen.push_back({{palette.begin(), palette.end()}, test.hair.is_asleep(watched)});
  }
  return seen;
}

TEST(CrowdWalk, EveryHeadFaresAsIfNothingHappenedToTheOthers) {
  int asleep = 0;
  for (const Solver* const solver : {&kCoifSolver, &kThesisSolver}) {
    for (const std::uint32_t watched : {0u, 1u, 15u, 16u, 37u, 64u, 98u, 99u}) {
      const std::vector<Seen> among = watch(solver, watched, true), alone = watch(solver, watched, false);
      for (int frame = 0; frame < kFrames; ++frame) {
        const Seen &a = among[std::size_t(frame)], &b = alone[std::size_t(frame)];
        ASSERT_EQ(std::memcmp(a.palette.data(), b.palette.data(), a.palette.size() * sizeof(Mat34)), 0)
            << "head " << watched << ", frame " << frame;
        ASSERT_EQ(a.is_asleep, b.is_asleep) << "head " << watched << ", frame " << frame;
        asleep += a.is_asleep ? 1 : 0;
      }
    }
  }
  EXPECT_GT(asleep, 100);
}

}  // namespace
}  // namespace coif
