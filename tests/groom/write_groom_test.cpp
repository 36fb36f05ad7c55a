#include "groom/read_groom.h"

#include "groom/groom_files.h"
#include "groom/strand_files.h"

#include <gtest/gtest.h>

namespace coif::groom::write_groom_test {

/// Back in the axes that readers leave alone: the writer has Z up.
Eigen::Vector3f from_z_up(const Eigen::Vector3f& p) { return {p.x(), p.z(), -p.y()}; }

Groom read_back(const std::vector<std::byte>& bytes) {
  const auto groom = read_hair_file(bytes);
  EXPECT_TRUE(groom) << (groom ? "" : groom.error());
  return groom.value_or(Groom{});
}

TEST(WriteGroom, HairComesBackWithAllThatItHas) {
  for (const std::uint32_t arrays : {31u, 3u, 7u, 19u}) {
    const Groom before = *read_hair_file(test::small_hair(arrays).span());
    const auto bytes = hair_file_of(before);
    ASSERT_TRUE(bytes);
    const Groom after = read_back(*bytes);
    EXPECT_EQ(after.begin, before.begin);
    EXPECT_EQ(after.widths, before.widths);
    EXPECT_EQ(after.opacities, before.opacities);
    EXPECT_EQ(after.colors, before.colors);
    ASSERT_EQ(after.points.size(), before.points.size());
    for (std::size_t i = 0; i < after.points.size(); ++i) EXPECT_EQ(from_z_up(after.points[i]), before.points[i]);
  }
}

TEST(WriteGroom, LinesComeBackGroupByGroup) {
  const Groom before =
      *read_obj_lines("v 0 0 0\nv 0 1 0\nv 0 2.5 0\nv 1 0 0\nv 1 1 0.25\no left\nl 1 2 3\no right\nl 4 5\n");
  const auto after = read_obj_lines(obj_lines_of(before));
  ASSERT_TRUE(after) << after.error();
  EXPECT_EQ(after->points, before.points);
  EXPECT_EQ(after->begin, before.begin);
  ASSERT_EQ(after->groups.size(), 2u);
  EXPECT_EQ(after->groups[1].name, "right");
}

TEST(WriteGroom, RefusesWhatTheFormatCannotHold) {
  Groom groom;
  groom.root_first = true;
  GroomBuilder builder(groom);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 70000; ++i) points.emplace_back(0, float(i), 0);
  builder.add(points);
  ASSERT_EQ(builder.finish(), "");
  const auto bytes = encode_strands(groom, "a.hair");
  ASSERT_FALSE(bytes);
  EXPECT_EQ(bytes.error().message, "a.hair: strand 0 has more than 65535 segments");
  EXPECT_TRUE(encode_strands(groom, "a.obj"));
  const auto other = encode_strands(groom, "a.abc");
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().kind, ToolError::Kind::kUsage);
}

}  // namespace coif::groom::write_groom_test
