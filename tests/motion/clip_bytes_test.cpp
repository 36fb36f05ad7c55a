#include "motion/head_path.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

namespace coif::motion::clip_bytes_test {

const std::array<ClipKey, 3> kKeys{{{0.25, {1, 2, 3}, Eigen::Quaterniond(1, 0, 0, 0)},
                                    {1.0 / 3, {-1e-3, 0.1, 7e3}, Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5)},
                                    {2, {0, 0, 0}, Eigen::Quaterniond(0, 0, 0, -2)}}};

TEST(ClipBytes, GiveTheSameKeysBack) {
  const std::vector<ClipKey> keys = clip_keys(clip_bytes(kKeys));
  ASSERT_EQ(keys.size(), kKeys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    EXPECT_EQ(keys[i].seconds, kKeys[i].seconds);
    EXPECT_EQ(keys[i].position, kKeys[i].position);
    EXPECT_EQ(keys[i].rotation.coeffs(), kKeys[i].rotation.coeffs());
  }
}

TEST(ClipBytes, OfNoClipAreNone) {
  std::vector<std::byte> bytes = clip_bytes(kKeys);
  EXPECT_TRUE(clip_keys({}).empty());
  EXPECT_TRUE(clip_keys(std::span(bytes).first(bytes.size() - 1)).empty()) << "cut off";
  std::memset(bytes.data() + 64, 0xFF, 8);
  EXPECT_TRUE(clip_keys(bytes).empty()) << "a time that is no number";
  EXPECT_TRUE(clip_keys(clip_bytes(std::array{kKeys[2], kKeys[0]})).empty()) << "times that descend";
}

}  // namespace coif::motion::clip_bytes_test
