#include "groom/strand_files.h"

#include "groom/groom_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace coif::groom::strand_files_test {

using test::Bytes;
using test::small_hair;
using test::small_tfx_3;
using test::small_tfx_3_with_widths;
using test::small_tfx_4;

void expect_whole(const Groom& groom) { EXPECT_EQ(find_groom_fault(groom), ""); }

template <class Read>
std::string fault_of(const Read& groom) {
  return groom ? "" : groom.error();
}

TEST(HairFile, HasStrandsWithWhatTheyHave) {
  const auto groom = read_hair_file(small_hair().span());
  ASSERT_TRUE(groom) << groom.error();
  expect_whole(*groom);
  ASSERT_EQ(groom->strand_count(), 2u);
  EXPECT_EQ(groom->strand(0).size(), 3u);
  EXPECT_EQ(groom->strand(0)[2], Eigen::Vector3f(0, 0, 2));
  EXPECT_EQ(groom->strand(1)[1], Eigen::Vector3f(5, 1, 0));
  EXPECT_EQ(groom->widths, (std::vector<float>{0.1f, 0.2f, 0.3f, 0.4f, 0.5f}));
  EXPECT_EQ(groom->opacities, (std::vector<float>{1, 0.75f, 0.5f, 0.25f, 0}));
  EXPECT_EQ(groom->colors[4], Eigen::Vector3f(0, 1, 1));
  EXPECT_TRUE(groom->root_first);
}

TEST(HairFile, TakesTheHeadersNumbersWhereArraysAreAbsent) {
  Bytes file = small_hair(2);
  file.set(8, 4u).bytes.resize(128 + 4 * 12);  // two strands of one segment each
  const auto groom = read_hair_file(file.span());
  ASSERT_TRUE(groom) << groom.error();
  expect_whole(*groom);
  EXPECT_EQ(groom->begin, (std::vector<std::uint32_t>{0, 2, 4}));
  EXPECT_EQ(groom->widths, std::vector<float>(4, 0.5f));
  EXPECT_EQ(groom->opacities, std::vector<float>(4, 0.75f));
  EXPECT_TRUE(groom->colors.empty());
}

TEST(HairFile, SaysWhatIsWrongAndWhere) {
  const auto refused = [](Bytes file) { return fault_of(read_hair_file(file.span())); };
  Bytes file = small_hair();
  EXPECT_EQ(refused(small_hair().set(0, 'h')), "does not begin with 'HAIR'");
  EXPECT_EQ(refused(small_hair(1)), "has no points");
  EXPECT_EQ(refused(small_hair().set<std::uint16_t>(128, 9)), "strand 0 of 2 ends at point 10, and the file has 5");
  EXPECT_EQ(refused(small_hair().set<std::uint16_t>(128, 1)), "the 2 strands have 4 points, and the file 5");
  file.bytes.resize(100);
  EXPECT_EQ(refused(file), "cut off in the header: 100 of 128 bytes");
  file = small_hair();
  file.bytes.pop_back();
  EXPECT_EQ(refused(file), "cut off in the colours: 59 of 60 bytes from byte 232 on");
  EXPECT_EQ(refused(small_hair().set(4, 0xFFFFFFFFu)),
            "cut off in the segments: 164 of 8589934590 bytes from byte 128 on");
  EXPECT_EQ(refused(small_hair().set(8, 0xFFFFFFFFu)),
            "cut off in the points: 160 of 51539607540 bytes from byte 132 on");
  EXPECT_NE(refused(small_hair(30).set(16, 0xFFFFFFFFu)), "");
}

TEST(HairFile, SetsWhatIsOutOfRangeToItsEndAndSaysSo) {
  Bytes file = small_hair();
  file.set(132 + 60, -1.0f).set(132 + 80 + 4, 7.0f);
  const auto groom = read_hair_file(file.span());
  ASSERT_TRUE(groom) << groom.error();
  expect_whole(*groom);
  EXPECT_EQ(groom->widths[0], 0);
  EXPECT_EQ(groom->opacities[1], 0);
  ASSERT_EQ(groom->warnings.size(), 1u);
  EXPECT_TRUE(groom->warnings[0].message.starts_with("2 thicknesses")) << groom->warnings[0].message;
}

TEST(TressFx, VersionsThreeAndFourHaveTheSameStrands) {
  const auto three = read_tressfx(small_tfx_3().span()), four = read_tressfx(small_tfx_4().span());
  ASSERT_TRUE(three) << three.error();
  ASSERT_TRUE(four) << four.error();
  expect_whole(*three);
  expect_whole(*four);
  EXPECT_EQ(three->points, four->points);
  EXPECT_EQ(three->begin, (std::vector<std::uint32_t>{0, 3, 6}));
  EXPECT_EQ(three->follow_hairs, 4u);
  EXPECT_EQ(three->format, "TressFX 3.0");
  EXPECT_EQ(four->widths, (std::vector<float>{0.01f, 0.01f, 0.01f, 0.02f, 0.02f, 0.02f}));
  EXPECT_EQ(four->colors[5], Eigen::Vector3f(0.5f, 0.5f, 1));
}

TEST(TressFx, VersionThreeHasWidthsAndColoursAsFourHas) {
  const auto three = read_tressfx(small_tfx_3_with_widths().span()), four = read_tressfx(small_tfx_4().span());
  ASSERT_TRUE(three) << three.error();
  expect_whole(*three);
  EXPECT_EQ(three->points, read_tressfx(small_tfx_3().span())->points);
  EXPECT_EQ(three->widths, (std::vector<float>{0.01f, 0.01f, 0.01f, 0.02f, 0.02f, 0.02f}));
  EXPECT_EQ(three->widths, four->widths);
  EXPECT_EQ(three->colors, four->colors);
  EXPECT_TRUE(read_tressfx(small_tfx_3().span())->widths.empty());
}

TEST(TressFx, TakesNoWidthThatIsNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float none : {-1.0f, nan, 1e30f}) {
    const auto groom = read_tressfx(small_tfx_3_with_widths().set(368, none).span());
    ASSERT_TRUE(groom) << groom.error();
    expect_whole(*groom);
    EXPECT_EQ(groom->widths, (std::vector<float>{0, 0, 0, 0.02f, 0.02f, 0.02f})) << none;
  }
}

TEST(TressFx, SaysWhatIsWrongAndWhere) {
  const auto refused = [](Bytes file) { return fault_of(read_tressfx(file.span())); };
  EXPECT_EQ(refused(small_tfx_3().set(0, 2.0f)), "is of version 2; 3 and 4 can be read");
  EXPECT_EQ(refused(small_tfx_3().set(4, 0u)), "has no strand");
  EXPECT_EQ(refused(small_tfx_3().set(8, 1u)), "says that a strand has 1 points; it has 2 to 4096");
  EXPECT_EQ(refused(small_tfx_3().set(4, 3u)), "cut off in the points: 72 of 108 bytes from byte 296 on");
  EXPECT_EQ(refused(small_tfx_4().set(24, 0xFFFFFFFFu)),
            "cut off in the thickness: 0 of 8 bytes from byte 4294967295 on");
  EXPECT_EQ(refused(small_tfx_3_with_widths().set(148, 472u)),
            "cut off in the thickness: 0 of 8 bytes from byte 472 on");
  EXPECT_EQ(refused(small_tfx_3_with_widths().set(156, 380u)),
            "cut off in the colours: 92 of 96 bytes from byte 380 on");
  EXPECT_EQ(refused(small_tfx_4().set(4, 0xFFFFFFFFu).set(8, 4096u)).substr(0, 21), "cut off in the points");
  Bytes file = small_tfx_3();
  file.bytes.resize(159);
  EXPECT_EQ(refused(file), "cut off in the header: 159 of 160 bytes");
}

TEST(TressFx, LeavesOutStrandsThatCannotBeUsed) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto groom = read_tressfx(small_tfx_3().set(296, nan).span());
  ASSERT_TRUE(groom) << groom.error();
  expect_whole(*groom);
  EXPECT_EQ(groom->strand_count(), 1u);
  ASSERT_EQ(groom->warnings.size(), 1u);
  EXPECT_TRUE(groom->warnings[0].message.starts_with("1 strand left out: points that are no numbers"))
      << groom->warnings[0].message;
}

TEST(ObjLines, LinesAndSegmentsAreTheSameStrands) {
  const std::string vertices = "o first\nv 0 0 0\nv 0 1 0\nv 0 2 0\nv 0 3 0\no second\nv 1 0 0\nv 1 1 0 0.5 0.5 0.5\n";
  const auto whole = read_obj_lines(vertices + "g a\nl 1 2 3 4\ng b\nl 5/1 6/2\n");
  const auto segments = read_obj_lines(vertices + "g a\nl 1 2\nl 2 3\nl 3 4\ng b\nl -2 -1\n");
  ASSERT_TRUE(whole) << whole.error();
  ASSERT_TRUE(segments) << segments.error();
  expect_whole(*whole);
  EXPECT_EQ(whole->points, segments->points);
  EXPECT_EQ(whole->begin, segments->begin);
  EXPECT_EQ(whole->begin, (std::vector<std::uint32_t>{0, 4, 6}));
  ASSERT_EQ(whole->groups.size(), 2u);
  EXPECT_EQ(whole->groups[0].name, "a");
  EXPECT_EQ(whole->groups[1].first_strand, 1u);
  EXPECT_FALSE(whole->root_first);
}

TEST(ObjLines, TakesLineEndsOfAllSystemsAndContinuedLines) {
  const auto groom = read_obj_lines("# hair\r\nv 0 0 0\r\nv 0 1 0\r\nv +1e0 2 0\r\nl 1 \\\r\n 2 \\\n 3\r\nf 1 2 3\n");
  ASSERT_TRUE(groom) << groom.error();
  EXPECT_EQ(groom->points, (std::vector<Eigen::Vector3f>{{0, 0, 0}, {0, 1, 0}, {1, 2, 0}}));
}

TEST(ObjLines, SaysWhatIsWrongAndWhere) {
  const auto refused = [](const char* text) { return fault_of(read_obj_lines(text)); };
  EXPECT_EQ(refused("v 0 0\nl 1 2\n"), "line 1: a vertex needs three numbers, not ''");
  EXPECT_EQ(refused("v 0 0 x\n"), "line 1: a vertex needs three numbers, not 'x'");
  EXPECT_EQ(refused("v 0 0 0\nv 0 1 0\n\nl 1 3\n"), "line 4: '3' is none of the 2 vertices so far");
  EXPECT_EQ(refused("v 0 0 0\nv 0 1 0\nl 1 0\n"), "line 3: '0' is none of the 2 vertices so far");
  EXPECT_EQ(refused("v 0 0 0\nl 1\n"), "line 2: a line needs two vertices");
  EXPECT_EQ(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
            "no strand that could be used; export curves as polylines");
  EXPECT_EQ(refused(""), "no strand that could be used; export curves as polylines");
}

/// Damage anywhere gives a groom that keeps its promises, or a message.
template <class Damage, class Read>
void damage_everywhere(const std::string& whole, Damage damage, Read read) {
  std::mt19937 random(1);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string bytes = whole;
    damage(bytes, at, random);
    const auto groom = read(bytes);
    if (groom)
      expect_whole(*groom);
    else
      EXPECT_FALSE(groom.error().empty());
  }
}

TEST(StrandFiles, DamageAnywhereIsRefusedOrRepaired) {
  const auto flip = [](std::string& bytes, std::size_t at, std::mt19937& random) { bytes[at] = char(random() & 255); };
  const auto cut = [](std::string& bytes, std::size_t at, std::mt19937&) { bytes.resize(at); };
  const auto hair = [](const std::string& bytes) { return read_hair_file(std::as_bytes(std::span(bytes))); };
  const auto tfx = [](const std::string& bytes) { return read_tressfx(std::as_bytes(std::span(bytes))); };
  const auto obj = [](const std::string& bytes) { return read_obj_lines(bytes); };
  for (const std::string& file : {small_hair().bytes, small_hair(2).bytes}) {
    damage_everywhere(file, flip, hair);
    damage_everywhere(file, cut, hair);
  }
  for (const std::string& file : {small_tfx_3().bytes, small_tfx_3_with_widths().bytes, small_tfx_4().bytes}) {
    damage_everywhere(file, flip, tfx);
    damage_everywhere(file, cut, tfx);
  }
  const std::string lines = "o hair\nv 0 0 0\nv 0 1 0\nv 0 2 0.5\nl 1 2 3\nl 1 3\n";
  damage_everywhere(lines, flip, obj);
  damage_everywhere(lines, cut, obj);
}

}  // namespace coif::groom::strand_files_test
