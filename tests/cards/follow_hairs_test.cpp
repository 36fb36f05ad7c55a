#include "cards/hair_source.h"

#include "cards/made_up_groom.h"

#include <gtest/gtest.h>

namespace coif::cards::follow_hairs_test {

using Eigen::Vector3f;
using test::groom_of;
using test::hanging;

TEST(FollowHairs, RunBesideTheirGuides) {
  groom::Groom guides = groom_of({hanging({0, 1, 0}, 0.3f), hanging({0.1f, 1, 0}, 0.3f)});
  guides.widths.assign(guides.points.size(), 0.001f);
  const auto all = with_follow_hairs(guides, 5, 0.004f);
  ASSERT_TRUE(all);
  EXPECT_EQ(groom::find_groom_fault(*all), "");
  ASSERT_EQ(all->strand_count(), 12u);
  EXPECT_EQ(all->widths.size(), all->points.size());
  for (std::size_t i = 0; i < all->strand_count(); ++i) {
    const auto guide = guides.strand(i / 6), strand = all->strand(i);
    const Vector3f at_root = strand.front() - guide.front(), at_tip = strand.back() - guide.back();
    EXPECT_LE(at_root.norm(), 0.0041f);
    EXPECT_NEAR(at_root.y(), 0, 1e-6f) << "across the first segment";
    EXPECT_LT((at_tip - 2 * at_root).norm(), 1e-6f);
    EXPECT_EQ(at_root.norm() == 0, i % 6 == 0) << "guides stay";
  }
  const auto again = with_follow_hairs(guides, 5, 0.004f);
  EXPECT_EQ(again->points, all->points);
}

TEST(FollowHairs, ReachAsFarAsGuidesLieApart) {
  const groom::Groom guides =
      groom_of({hanging({0, 1, 0}, 0.3f), hanging({0.02f, 1, 0}, 0.3f), hanging({0.04f, 1, 0}, 0.3f)});
  const auto all = with_follow_hairs(guides, 40, 0);
  ASSERT_TRUE(all);
  float farthest = 0;
  for (std::size_t i = 0; i < 41; ++i) farthest = std::max(farthest, (all->strand(i)[0] - guides.strand(0)[0]).norm());
  EXPECT_GT(farthest, 0.014f);
  EXPECT_LE(farthest, 0.0201f);
}

TEST(FollowHairs, NoneLeaveStrandsAsTheyAreAndTooManyAreRefused) {
  const groom::Groom guides = groom_of({hanging({0, 1, 0}, 0.3f)});
  EXPECT_EQ(with_follow_hairs(guides, 0, 1)->points, guides.points);
  std::vector<std::vector<Vector3f>> many(70000, hanging({0, 1, 0}, 0.3f, 2));
  const auto refused = with_follow_hairs(groom_of(many), 16, 0.1f);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ToolError::Kind::kOverBudget);
  EXPECT_NE(refused.error().message.find("70000 strands with 16 follow hairs each are more than 1048576 strands"),
            std::string::npos)
      << refused.error().message;
}

}  // namespace coif::cards::follow_hairs_test
