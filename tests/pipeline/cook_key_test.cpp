#include "pipeline/cook_key.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <vector>

namespace coif {
namespace {

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

TEST(CookKey, ChangesWithEachPartOfTheIdentity) {
  const std::vector<std::byte> bytes = bytes_of("model"), others = bytes_of("Model");
  const CookIdentity identity{"coif 1", "assimp 5", "/a/wig.obj", bytes, "{}"};
  const std::function<void(CookIdentity&)> changes[] = {
      [](CookIdentity&) {},
      [](CookIdentity& i) { i.tool = "coif 2"; },
      [](CookIdentity& i) { i.importer = "assimp 6"; },
      [](CookIdentity& i) { i.source = "/a/wig.dae"; },
      [&](CookIdentity& i) { i.source_bytes = others; },
      [&](CookIdentity& i) { i.source_bytes = std::span(bytes).first(4); },
      [](CookIdentity& i) { i.recipe = "{ }"; },
  };
  std::set<std::string> keys;
  for (const auto& change : changes) {
    CookIdentity changed = identity;
    change(changed);
    EXPECT_TRUE(keys.insert(cook_key(changed)).second);
  }
}

TEST(CookKey, DoesNotTellFoldersApart) {
  EXPECT_EQ(cook_key({"coif", "assimp", "/here/wig.obj", {}, "{}"}), cook_key({"coif", "assimp", "wig.obj", {}, "{}"}));
}

TEST(CookKey, KnowsWhereOnePartEndsAndTheNextBegins) {
  EXPECT_NE(cook_key({"ab", "c", "wig.obj", {}, ""}), cook_key({"a", "bc", "wig.obj", {}, ""}));
}

TEST(CookKey, IsAFileNameOf32Digits) {
  const std::string key = cook_key({"coif", "assimp", "wig.obj", {}, "{}"});
  EXPECT_EQ(key.size(), 32u);
  EXPECT_EQ(key.find_first_not_of("0123456789abcdef"), std::string::npos);
}

}  // namespace
}  // namespace coif
