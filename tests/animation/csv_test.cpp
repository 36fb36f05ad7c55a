#include "animation/open_asset.h"
#include "animation/recording.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace coif {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

Recording one_frame(const Asset& asset, const HeadPose& head, const Vec3& end) {
  Recording recording;
  recording.frames.push_back(
      {0.25, head, std::vector<Mat34>(asset.bones().size()), std::vector<Vec3>(asset.bones().size(), end)});
  return recording;
}

TEST(Csv, HasOneRowPerFrameAndBone) {
  const OpenAsset file(small_asset());
  ASSERT_TRUE(file.asset().is_open());
  const auto recording = record(file.asset(), {.motion = Motion::kRun, .fps = 30, .seconds = 1});
  ASSERT_TRUE(recording);
  const auto lines = lines_of(to_csv(file.asset(), *recording));
  ASSERT_EQ(lines.size(), 1 + 31 * file.asset().bones().size());
  EXPECT_EQ(lines[0], "frame,seconds,bone,name,x,y,z,world_x,world_y,world_z");
  for (std::size_t i = 1; i < lines.size(); ++i) EXPECT_EQ(fields_of(lines[i]).size(), 10u) << lines[i];
}

TEST(Csv, GivesWorldPositionsUnderTheHeadsPose) {
  const OpenAsset file(small_asset());
  ASSERT_TRUE(file.asset().is_open());
  HeadPose head;  // a half turn about Y, then moved: (1, 2, 3) -> (-1, 2, -3) -> (9, 2, -3)
  head.position[0] = 10;
  head.rotation = {0, 1, 0, 0};
  const auto lines = lines_of(to_csv(file.asset(), one_frame(file.asset(), head, {1, 2, 3})));
  ASSERT_GT(lines.size(), 3u);
  EXPECT_EQ(lines[3], "0,0.250000,2,hair_1,1.000000,2.000000,3.000000,9.000000,2.000000,-3.000000");
}

TEST(Csv, QuotesNamesThatWouldBreakARow) {
  AssetContents contents = small_asset();
  contents.bone_names[2] = "left, \"long\"";
  const OpenAsset file(contents);
  ASSERT_TRUE(file.asset().is_open());
  const std::string text = to_csv(file.asset(), one_frame(file.asset(), {}, {}));
  EXPECT_NE(text.find(",2,\"left, \"\"long\"\"\",0.0"), std::string::npos) << text;
}

}  // namespace
}  // namespace coif
