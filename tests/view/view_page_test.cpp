#include "view/view_page.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

namespace coif::view::view_page_test {

constexpr std::array kThree{std::byte{0}, std::byte{0xFF}, std::byte{0x10}};

TEST(ViewPage, HoldsTheAssetAsTextAndItsName) {
  const auto page = view_page("<i name=\"@NAME@\">@ASSET@</i>", kThree, "bob.coif");
  ASSERT_TRUE(page) << page.error().message;
  EXPECT_EQ(*page, "<i name=\"bob.coif\">AP8Q</i>");
}

TEST(ViewPage, NamesCannotEndTheirAttribute) {
  const auto page = view_page("@NAME@|@ASSET@", {}, "\"><script>a&b</script>");
  ASSERT_TRUE(page);
  EXPECT_EQ(*page, "&quot;&gt;&lt;script&gt;a&amp;b&lt;/script&gt;|");
}

TEST(ViewPage, AnAssetIsPutInOnceThoughItsNameIsThePlacesOwn) {
  const auto page = view_page("@NAME@|@ASSET@", kThree, "@ASSET@");
  ASSERT_TRUE(page);
  EXPECT_EQ(*page, "@ASSET@|AP8Q");
}

TEST(ViewPage, HoldsASheetWhereThereIsOne) {
  const char* const page = "@NAME@|@ASSET@|@SHEET@!";
  EXPECT_EQ(view_page(page, {}, "a", "{\"tiles\": []}").value(), "a||{\"tiles\": []}!");
  EXPECT_EQ(view_page(page, {}, "a").value(), "a||!");
  EXPECT_EQ(view_page(page, {}, "@SHEET@", "b").value(), "@SHEET@||b!");
  const auto older = view_page("@NAME@|@ASSET@", {}, "a", "b");
  ASSERT_FALSE(older);
  EXPECT_NE(older.error().message.find("knows no galleries"), std::string::npos);
}

TEST(ViewPage, OtherFilesAreRefused) {
  for (const char* text : {"", "<html></html>", "@NAME@", "@ASSET@", "@ASSET@ @NAME@"}) {
    const auto page = view_page(text, kThree, "bob.coif");
    ASSERT_FALSE(page) << text;
    EXPECT_EQ(page.error().kind, ToolError::Kind::kBadInput);
    EXPECT_NE(page.error().message.find("view.html"), std::string::npos) << "says which file is one";
  }
}

TEST(ViewPage, OneThatIsNamedIsTakenAtItsWord) {
  const auto found = find_view_page("somewhere/own.html");
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, "somewhere/own.html");
}

TEST(ViewPage, FoundOnesAreFilesAndAMissingOneHasACure) {
  const auto found = find_view_page({});
  if (found) {
    EXPECT_TRUE(std::filesystem::is_regular_file(*found));
    return;
  }
  EXPECT_EQ(found.error().kind, ToolError::Kind::kUnsupported);
  EXPECT_NE(found.error().message.find("cmake --install"), std::string::npos) << found.error().message;
}

}  // namespace coif::view::view_page_test
