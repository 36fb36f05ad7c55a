// The walker of FBX records: both encodings, and files that lie.

#include "import/fbx_files.h"
#include "import/fbx_objects.h"
#include "import/fbx_walk.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace coif::importer::fbx_records_test {

using test::binary_fbx;
using test::FbxTree;

std::string text_of_value(const FbxValue& value) {
  if (value.kind == FbxValue::Kind::kNumber) return fmt::format("{}|{:g}", value.whole, value.number);
  return value.kind == FbxValue::Kind::kText ? fmt::format("'{}'", value.text)
                                             : fmt::format("array of {} bytes", value.text.size());
}

struct Walked {
  bool is_whole = false;
  std::vector<std::string> records;
};

/// In a block of the file's size, so that a sanitizer sees a byte too far. Records named `closed` are not entered.
Walked walk(const std::string& file, const std::string& closed = "") {
  const std::vector<char> block(file.begin(), file.end());
  Walked out;
  out.is_whole = walk_fbx({block.data(), block.size()}, [&](const FbxRecord& record) {
    std::string line = fmt::format("{} {}", record.depth, record.name);
    for (const FbxValue& value : record.values) line += " " + text_of_value(value);
    out.records.push_back(line);
    return record.name != closed;
  });
  return out;
}

std::vector<FbxTree> small_file() {
  return {{"Objects",
           {},
           {{"Model",
             {test::fbx_long(7000000000), test::fbx_text("Hair"), test::fbx_text("Mesh")},
             {{"Version", {test::fbx_int32(232)}, {}}}},
            {"Empty", {}, {}}}},
          {"Connections", {}, {{"C", {test::fbx_text("OO"), test::fbx_long(7000000000), test::fbx_double(0.5)}, {}}}}};
}

const char* const kSmallText = R"(; FBX 7.4.0 project file
Objects:  {
  Model: 7000000000, "Hair", "Mesh" {
    Version: 232
  }
  Empty:  {
  } ; nothing "within {
}
Connections: {C: "OO",7000000000,
  0.5}
)";

TEST(FbxRecords, BinaryFilesAndTextsOfAllVersionsGiveTheSame) {
  const std::vector<std::string> expected{"0 Objects",         "1 Model 7000000000|7e+09 'Hair' 'Mesh'",
                                          "2 Version 232|232", "1 Empty",
                                          "0 Connections",     "1 C 'OO' 7000000000|7e+09 0|0.5"};
  for (const std::string& file : {binary_fbx(7400, small_file()), binary_fbx(7500, small_file()),
                                  binary_fbx(7700, small_file()), std::string(kSmallText)}) {
    const Walked walked = walk(file);
    EXPECT_TRUE(walked.is_whole);
    EXPECT_EQ(walked.records, expected);
  }
}

TEST(FbxRecords, WhatIsNotEnteredIsPassedOver) {
  for (const std::string& file :
       {binary_fbx(7400, small_file()), binary_fbx(7500, small_file()), std::string(kSmallText)}) {
    EXPECT_EQ(walk(file, "Model").records.size(), 5u);
    EXPECT_EQ(walk(file, "Objects").records.size(), 3u);
  }
}

TEST(FbxRecords, NumbersOfEveryTypeAreRead) {
  const Walked walked =
      walk(binary_fbx(7400, {{"A",
                              {std::string("C\1", 2), std::string("Y\xff\xff", 3), test::fbx_int32(-3),
                               test::fbx_long(-4), test::fbx_double(1e300), std::string("F\0\0\x80\x3f", 5)},
                              {}}}));
  EXPECT_EQ(walked.records, std::vector<std::string>{"0 A 1|1 -1|-1 -3|-3 -4|-4 0|1e+300 1|1"});
}

TEST(FbxRecords, ArraysArePassedOverAndPlainDoublesHandedOut) {
  const Walked walked = walk(binary_fbx(
      7400,
      {{"A", {test::fbx_doubles({1, 2}), test::fbx_packed_array('d', 1u << 31, "junk"), test::fbx_int32(5)}, {}}}));
  EXPECT_TRUE(walked.is_whole);
  EXPECT_EQ(walked.records, std::vector<std::string>{"0 A array of 16 bytes array of 0 bytes 5|5"});
}

TEST(FbxRecords, ValuesBeyondTheFirstEightArePassedOver) {
  std::string text = "A: 0";
  std::vector<std::string> values;
  for (int i = 0; i < 100; ++i) {
    if (i > 0) text += fmt::format(",{}", i);
    values.push_back(test::fbx_int32(i));
  }
  const std::vector<std::string> expected{"0 A 0|0 1|1 2|2 3|3 4|4 5|5 6|6 7|7", "0 B"};
  EXPECT_EQ(walk(text + "\nB: \n").records, expected);
  EXPECT_EQ(walk(binary_fbx(7400, {{"A", values, {}}, {"B", {}, {}}})).records, expected);
}

TEST(FbxRecords, EveryTruncationEndsAndInventsNothing) {
  for (const std::string& good :
       {binary_fbx(7400, small_file()), binary_fbx(7500, small_file()), std::string(kSmallText)}) {
    const std::size_t whole_count = walk(good).records.size();
    std::size_t refused = 0;
    for (std::size_t size = 0; size < good.size(); ++size) {
      const Walked walked = walk(good.substr(0, size));
      EXPECT_LE(walked.records.size(), whole_count) << size;
      refused += walked.is_whole ? 0 : 1;
    }
    EXPECT_GT(refused, good.size() / 3);
  }
}

TEST(FbxRecords, RandomDamageNeverHangsOrReadsBeyondTheFile) {
  std::mt19937 random(5);
  std::size_t refused = 0;
  for (const std::string& good :
       {binary_fbx(7400, small_file()), binary_fbx(7500, small_file()), std::string(kSmallText)}) {
    for (int round = 0; round < 20000; ++round) {
      std::string bad = good;
      for (int i = 0; i < 1 + round % 4; ++i) bad[random() % bad.size()] = char(random());
      const Walked walked = walk(bad);
      EXPECT_LE(walked.records.size(), bad.size());
      refused += walked.is_whole ? 0 : 1;
      const std::vector<char> block(bad.begin(), bad.end());
      (void)FbxObjects::read({block.data(), block.size()});
    }
  }
  EXPECT_GT(refused, 1000u);
}

TEST(FbxRecords, SizesBeyondTheFileAreRefused) {
  const std::string good = binary_fbx(7500, small_file());
  for (const std::size_t field : {27u, 35u, 43u}) {  // where the record ends, how many values it has and their size
    for (const std::uint64_t number : {std::uint64_t{1} << 40, ~std::uint64_t{0}, std::uint64_t(good.size() + 1)}) {
      std::string bad = good;
      std::memcpy(&bad[field], &number, sizeof number);
      EXPECT_FALSE(walk(bad).is_whole) << field << " " << number;
    }
  }
}

TEST(FbxRecords, DepthIsLimitedInBothEncodings) {
  FbxTree nested{"A", {}, {}};
  std::string text = "A: ";
  for (int i = 0; i < 62; ++i) {
    nested = {"A", {}, {nested}};
    text = "A: {" + text + "}";
  }
  EXPECT_TRUE(walk(binary_fbx(7400, {nested})).is_whole);
  EXPECT_TRUE(walk(text).is_whole);
  for (int i = 0; i < 100; ++i) {
    nested = {"A", {}, {nested}};
    text = "A: {" + text + "}";
  }
  EXPECT_FALSE(walk(binary_fbx(7400, {nested})).is_whole);
  EXPECT_FALSE(walk(text).is_whole);
}

TEST(FbxRecords, WhatIsNoFbxIsRefused) {
  for (const char* const text :
       {"", "hello", "{", "}", "A: {", "A: }", "A: \"open", "1, 2", ": 3", "{\"asset\": {}}"}) {
    EXPECT_FALSE(walk(text).is_whole) << text;
  }
}

}  // namespace coif::importer::fbx_records_test
