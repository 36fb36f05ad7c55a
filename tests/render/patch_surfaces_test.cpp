#include "render/patch_surfaces.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

TEST(MarkPatch, OneIsRedAndAllOthersAreAlike) {
  std::vector<SolidMesh> patches(4);
  mark_patch(2, patches);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Eigen::Vector3f& color = patches[i].color;
    if (i == 2) {
      EXPECT_GT(color.x(), 4 * color.y());
      EXPECT_GT(color.x(), 4 * color.z());
    } else {
      EXPECT_EQ(color, patches[0].color);
      EXPECT_EQ(color.x(), color.y());
    }
  }
}

}  // namespace
}  // namespace coif
