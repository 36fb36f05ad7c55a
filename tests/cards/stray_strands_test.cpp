#include "cards/made_up_groom.h"
#include "cards/make_cards.h"
#include "groom/groom.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace coif::cards::stray_strands_test {

using Strands = std::vector<std::vector<Eigen::Vector3f>>;

groom::Groom read(const Strands& strands) {
  groom::Groom groom = test::groom_of(strands);
  groom::leave_out_strays(groom);
  return groom;
}

TEST(StrayStrands, AreNamedAndLeftOut) {
  const Strands head = test::strands_of_a_head(400);
  for (const bool is_far : {true, false}) {
    Strands strands = head;
    auto& stray = strands[123];
    for (Eigen::Vector3f& point : stray)
      point = is_far ? (point + Eigen::Vector3f(0, 1, 0)).eval() : (8 * point).eval();
    const groom::Groom groom = read(strands);
    EXPECT_EQ(groom.strand_count(), 399u);
    EXPECT_EQ(groom::find_groom_fault(groom), "");
    ASSERT_EQ(groom.warnings.size(), 1u);
    EXPECT_NE(groom.warnings[0].message.find("1 strand left out"), std::string::npos) << groom.warnings[0].message;
    EXPECT_NE(groom.warnings[0].message.find("123 of 400"), std::string::npos) << groom.warnings[0].message;
    const GroomShape with = shape_of(groom, 0), clean = shape_of(test::groom_of(head), 0);
    EXPECT_NEAR(with.strands.width, clean.strands.width, 0.02f * clean.strands.width);
    EXPECT_NEAR(scalp_radius_of(with.strands), 0.1, 0.005);
  }
}

TEST(StrayStrands, AreNotThoseOfALongTail) {
  Strands strands = test::strands_of_a_head(400);
  for (std::size_t i = 0; i < 8; ++i) {
    for (Eigen::Vector3f& point : strands[50 * i]) point *= 6;
  }
  const groom::Groom groom = read(strands);
  EXPECT_EQ(groom.strand_count(), 400u) << "one of fifty is a part of the style";
  EXPECT_TRUE(groom.warnings.empty());
}

TEST(StrayStrands, KeepTheOrderAndValuesOfOthers) {
  Strands strands = test::strands_of_a_head(60);
  for (Eigen::Vector3f& point : strands[0]) point += Eigen::Vector3f(3, 0, 0);
  const groom::Groom all = test::groom_of(strands), kept = read(strands);
  ASSERT_EQ(kept.strand_count(), 59u);
  for (std::size_t i = 0; i < 59; ++i) EXPECT_EQ(kept.strand(i).back(), all.strand(i + 1).back());
}

}  // namespace coif::cards::stray_strands_test
