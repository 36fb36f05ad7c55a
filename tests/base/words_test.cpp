#include "base/words.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace coif::words_test {

using Words = std::vector<std::string>;

bool has(std::string_view name, std::initializer_list<std::string_view> patterns) {
  return has_word(name, {patterns.begin(), patterns.size()});
}

TEST(Words, EndWhereModellersEndThem) {
  EXPECT_EQ(words_of("mixamorig:LeftEye_01"), (Words{"mixamorig", "left", "eye"}));
  EXPECT_EQ(words_of("REye"), (Words{"r", "eye"}));
  EXPECT_EQ(words_of("HAIR.001"), (Words{"hair"}));
  EXPECT_EQ(words_of("Bip01 L Foot"), (Words{"bip", "l", "foot"}));
  EXPECT_EQ(words_of("HairB2C"), (Words{"hair", "b", "c"}));
  EXPECT_EQ(words_of("\u9aea\u306e\u6bdb01"), (Words{"\u9aea\u306e\u6bdb"}));
  EXPECT_EQ(words_of("_01-"), Words{});
  EXPECT_EQ(words_of(""), Words{});
}

TEST(Words, AreFoundWholeOrRunTogether) {
  for (const char* name : {"ponytail", "pony_tail", "PonyTail", "Ponytail02", "my pony.tail"}) {
    EXPECT_TRUE(has(name, {"ponytail"})) << name;
  }
  EXPECT_FALSE(has("Hair_Brown", {"brow"}));
  EXPECT_FALSE(has("solid", {"lid", "lid*"}));
  EXPECT_FALSE(has("tailpony", {"ponytail"}));
}

TEST(Words, StarsStandForMoreOfOneWord) {
  EXPECT_TRUE(has("armchair", {"*chair"}));
  EXPECT_FALSE(has("basic_hair", {"*chair"})) << "that is two words";
  EXPECT_TRUE(has("c_hair", {"*chair"})) << "run together, it is the pattern itself";
  EXPECT_TRUE(has("toes", {"toe*"}));
  EXPECT_FALSE(has("potatoes", {"toe*"}));
}

}  // namespace coif::words_test
