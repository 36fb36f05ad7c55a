// Skinning of the cooked sample in motion.
#include <coif/hair.h>
#include <coif/skinning.h>

#include "models/skinned_asset.h"
#include "models/small_asset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <vector>

namespace coif::cooked_hair_test {

std::vector<std::byte> sample_bytes() {
  std::ifstream file(COIF_COOKED_SAMPLE, std::ios::binary);
  const std::vector<char> chars{std::istreambuf_iterator<char>(file), {}};
  const auto bytes = std::as_bytes(std::span(chars));
  return {bytes.begin(), bytes.end()};
}

/// Half a second of a head that shakes.
void shake(Hair& hair) {
  for (int frame = 1; frame <= 30; ++frame) {
    const double angle = std::sin(0.2 * frame);
    HeadPose pose;
    pose.rotation = {0, float(std::sin(angle / 2)), 0, float(std::cos(angle / 2))};
    ASSERT_EQ(hair.set_head(0, pose), Status::kOk);
    ASSERT_EQ(hair.step({}), Status::kOk);
  }
}

TEST(SkinningOfCookedHair, IsWithinAMicrometreOfDoublePrecision) {
  AlignedBytes bytes(sample_bytes());
  Asset asset;
  ASSERT_TRUE(asset.open(bytes.bytes())) << COIF_COOKED_SAMPLE;
  AlignedBytes memory(std::vector<std::byte>(Hair::memory_need(asset, {}).bytes));
  Hair hair;
  ASSERT_EQ(hair.create(asset, {}, memory.bytes()), Status::kOk);
  shake(hair);

  std::vector<SkinnedVertex> out(asset.vertices().size());
  ASSERT_EQ(skin_vertices(asset, hair.palette(0), 0, out), Status::kOk);
  double largest_error = 0, largest_move = 0;
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    const Vec3& now = out[i].position;
    const float* const rest = asset.vertices()[i].position;
    largest_error = std::max(largest_error, difference(out[i], exactly_skinned(asset, hair.palette(0), i)));
    largest_move = std::max(largest_move, double(std::hypot(now.x - rest[0], now.y - rest[1], now.z - rest[2])));
  }
  EXPECT_LT(largest_error, 1e-6);
  EXPECT_GT(largest_move, 0.005) << "the hair hardly moved: little was tested";
}

}  // namespace coif::cooked_hair_test
