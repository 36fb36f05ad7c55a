#include "report/report_heading.h"

#include "animation/open_asset.h"
#include "report/page/report_frame.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

TEST(ReportHeading, MeasuresChainsFromTheRigidBoneToTheirFurthestTip) {
  const OpenAsset file(small_asset());  // a chain of two bones and one of one bone, 0.1 m each
  ASSERT_TRUE(file.asset().is_open());
  const ReportHeading heading = heading_of(file.asset(), "small.coif");
  EXPECT_EQ(heading.asset, "small.coif");
  EXPECT_EQ(heading.bones, 5u);
  EXPECT_EQ(heading.simulated_bones, 3u);
  EXPECT_EQ(heading.chains, 2u);
  EXPECT_NEAR(heading.shortest_chain, 0.1, 1.0e-6);
  EXPECT_NEAR(heading.longest_chain, 0.2, 1.0e-6);
}

TEST(ReportHeading, IsOneLineEvenWhereTheMachineIsNotKnown) {
  ReportHeading heading;
  heading.asset = "a.coif";
  heading.chains = 1;
  EXPECT_EQ(heading_text(heading),
            "a.coif: 0 bones, 0 of them simulated, in 1 chain of 0 to 0 m (median 0); measured in 0.0 s");
  heading.machine = "processor";
  EXPECT_TRUE(heading_text(heading).ends_with(" s on processor"));
}

}  // namespace
}  // namespace coif
