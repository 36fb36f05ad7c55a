#include "view/view_page.h"

#include "base/encodings.h"
#include "base/json.h"
#include "motion/head_path.h"

#include <gtest/gtest.h>

#include <array>

namespace coif::view::view_motion_test {

const std::array<motion::ClipKey, 2> kKeys{
    {{0, {0, 0, 0}, Eigen::Quaterniond::Identity()}, {0.5, {0.1, -2, 3}, Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5)}}};

TEST(ViewMotion, BuiltInOnesAreNamed) {
  const auto page = with_motion("<i>@MOTION@</i>", "nod");
  ASSERT_TRUE(page) << page.error().message;
  EXPECT_EQ(*page, "<i>{\"motion\":\"nod\"}</i>");
}

TEST(ViewMotion, ClipsAreCarriedBitForBit) {
  const auto page = with_motion("@MOTION@", "walk.glb:head", kKeys);
  ASSERT_TRUE(page) << page.error().message;
  const auto json = nlohmann::json::parse(*page);
  EXPECT_EQ(json["motion"], "walk.glb:head");
  const auto bytes = from_base64(json["keys"].get<std::string>());
  ASSERT_TRUE(bytes);
  EXPECT_EQ(*bytes, motion::clip_bytes(kKeys));
}

TEST(ViewMotion, NamesCannotEndTheirScript) {
  const auto page = with_motion("@MOTION@", "</script><b>:h", kKeys);
  ASSERT_TRUE(page);
  EXPECT_EQ(page->find('<'), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(*page)["motion"], "</script><b>:h");
}

TEST(ViewMotion, PagesWithoutAPlaceAreRefused) {
  const auto page = with_motion("<i>@ASSET@</i>", "nod");
  ASSERT_FALSE(page);
  EXPECT_EQ(page.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(page.error().message.find("view.html"), std::string::npos) << "says which file is one";
}

}  // namespace coif::view::view_motion_test
