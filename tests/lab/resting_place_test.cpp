// Where hair rests that lies on a head: it does not depend on the step.

#include "base/hair_runtime.h"
#include "models/test_rig.h"
#include "motion/head_path.h"

#include <coif/asset.h>
#include <coif/hair.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

namespace coif::lab::resting_place_test {

constexpr float kLength = 0.36f;  ///< How long each strand is, metres.

/// Strands from many places of a head, that grow stiffer to their tips, as thinner bones do.
TestRig rig_of(int seed) {
  std::minstd_rand random(seed * 7919u + 11u);
  const auto draw = [&](double low, double high) {
    return float(low + (high - low) * double(random() % 10007) / 10006);
  };
  TestRig rig;
  rig.model = ChainModel::kPassive;
  rig.add_ellipsoid({0, 0, 0}, {0.08f, 0.12f, 0.1f}, {});
  for (int chain = 0; chain < 8; ++chain) {
    const int bones = 2 + int(random() % 5);
    const Eigen::Vector3f out = Eigen::Vector3f(draw(-1, 1), draw(-0.7, 1), draw(-1, 0.3)).normalized();
    const Eigen::Vector3f way = (out + Eigen::Vector3f(draw(-1, 1), draw(-1, 0.5), draw(-1, 1))).normalized();
    TestBone bone;
    bone.length = kLength / float(bones);
    bone.joint = {out.x() * 0.09f, out.y() * 0.13f, out.z() * 0.11f};
    bone.rest_direction = {way.x(), way.y(), way.z()};
    bone.friction = draw(0.5, 2.5);
    bone.torsion = kShortestArc;
    float stiffness = draw(15, 120);
    for (int i = 0; i < bones; ++i) {
      bone.stiffness = stiffness;
      bone.damping = std::sqrt(stiffness);
      const std::uint32_t index = rig.add(bone);
      bone.parent = index;
      bone.joint = {};
      stiffness *= 1.4f;
    }
  }
  return rig;
}

/// Heads in 26 attitudes, which wear one hair.
class Crowd {
 public:
  explicit Crowd(const TestRig& rig) : opened_(rig.contents()), heads_(motion::held_attitudes()) {
    const HairDesc desc{.instances = std::uint32_t(heads_.size())};
    const MemoryNeed need = Hair::memory_need(opened_.asset(), desc);
    memory_ = allocate(need);
    EXPECT_EQ(hair_.create(opened_.asset(), desc, {memory_.get(), need.bytes}), Status::kOk);
    for (std::uint32_t i = 0; i < heads_.size(); ++i) EXPECT_EQ(hair_.reset(i, heads_[i].path->pose(0)), Status::kOk);
  }

  void run(double seconds, double rate, std::uint32_t substeps) {
    const StepSettings settings{.dt = float(1 / rate), .substeps = substeps, .sleep_after = HUGE_VALF};
    for (const double end = now_ + seconds; now_ < end; now_ += 1 / rate) {
      for (std::uint32_t i = 0; i < heads_.size(); ++i) {
        EXPECT_EQ(hair_.set_head(i, heads_[i].path->pose(now_ + 1 / rate)), Status::kOk);
      }
      EXPECT_EQ(hair_.step(settings), Status::kOk);
    }
  }

  /// Head space, of all heads one after the other.
  [[nodiscard]] std::vector<Vec3> ends() const {
    std::vector<Vec3> all, ends(hair_.bone_count());
    for (std::uint32_t i = 0; i < heads_.size(); ++i) {
      EXPECT_EQ(hair_.bone_ends(i, ends), Status::kOk);
      all.insert(all.end(), ends.begin(), ends.end());
    }
    return all;
  }

 private:
  OpenedAsset opened_;
  std::vector<motion::HeldAttitude> heads_;
  HairMemory memory_{nullptr, &std::free};
  Hair hair_;
  double now_ = 0;
};

/// Hair that rests after one long step a frame stays there in short ones: nothing has stopped it on its way. (Strands
/// that nearly balance, one in two thousand, may: Newton's method leaves a force of 1/300 of their weight undone.)
TEST(RestingPlace, IsAnEquilibriumOfShorterStepsToo) {
  constexpr int kSeeds[] = {0, 5, 9, 19, 32, 39};
  for (const int seed : kSeeds) {
    Crowd crowd(rig_of(seed));
    crowd.run(13, 30, 1);
    const std::vector<Vec3> rested = crowd.ends();
    crowd.run(4, 60, 8);
    const std::vector<Vec3> later = crowd.ends();
    double farthest = 0;
    for (std::size_t i = 0; i < rested.size(); ++i)
      farthest = std::max(farthest, double(distance(rested[i], later[i])));
    EXPECT_LT(farthest, 0.03 * kLength) << "seed " << seed;
  }
}

}  // namespace coif::lab::resting_place_test
