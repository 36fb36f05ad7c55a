#include "import/collada_arrays.h"

#include "import/model_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace coif {
namespace {

std::string document(const std::string& array, const std::string& accessor) {
  return fmt::format(
      "<?xml version=\"1.0\"?><COLLADA><source><float_array {}>1 2 3</float_array><accessor {}/></source></COLLADA>",
      array, accessor);
}

TEST(ColladaArrays, ThatAreLongEnoughAreLeftAlone) {
  EXPECT_FALSE(overrun_array(test::small_dae("1", "Y_UP")));
  EXPECT_FALSE(overrun_array(document("id='a' count='3'", "source='#a' count='1' stride='3'")));
  EXPECT_FALSE(overrun_array(document("id='a' count='3'", "source='#a' count='3'")));
  EXPECT_FALSE(overrun_array(document("id='a' count='0'", "source='#a' count='0' stride='3' offset='9'")));
  EXPECT_FALSE(overrun_array(document("id='a' count='3'", "source='#elsewhere' count='9'")));
}

TEST(ColladaArrays, ThatEndTooSoonAreFound) {
  const auto fault = overrun_array(document("id='a' count='3'", "source='#a' count='8' stride='3'"));
  ASSERT_TRUE(fault);
  EXPECT_EQ(*fault, "an accessor reads 24 numbers of the array 'a', which has 3");
  EXPECT_TRUE(overrun_array(document("id='a' count='3'", "source='#a' count='1' stride='3' offset='1'")));
  EXPECT_TRUE(overrun_array(document("id=\"a\"\n count = \"3\"", "count=\"2\" source = \"#a\" stride=\"2\"")));
  EXPECT_TRUE(overrun_array(document("id='a'", "source='#a' count='1'")));
}

TEST(ColladaArrays, AreFoundOnWhicheverSideOfTheirAccessor) {
  EXPECT_TRUE(overrun_array("<accessor source='#a' count='4'/><Name_array id='a' count='3'>x y z</Name_array>"));
  EXPECT_TRUE(overrun_array("<IDREF_array id='a' count='3'>x y z</IDREF_array><accessor source='#a' count='4'/>"));
}

TEST(ColladaArrays, OfCommentsAreNone) {
  const std::string array = "<float_array id='a' count='9'>";
  EXPECT_FALSE(overrun_array(array + "<!-- <accessor source='#a' count='10'/> > -->"));
  EXPECT_TRUE(overrun_array(array + "<!-- > --><accessor source='#a' count='10'/>"));
}

TEST(ColladaArrays, NumbersWithoutEndDoNotWrapAround) {
  for (const char* huge : {"4294967296", "6148914691236517206", "18446744073709551615", "99999999999999999999999"}) {
    for (const char* accessor : {"source='#a' count='{}' stride='3'", "source='#a' count='3' stride='{}'",
                                 "source='#a' count='3' offset='{}'"}) {
      EXPECT_TRUE(overrun_array(document("id='a' count='3'", fmt::format(fmt::runtime(accessor), huge))))
          << huge << accessor;
    }
  }
}

TEST(ColladaArrays, BrokenDocumentsAreLeftToTheImporter) {
  const std::string whole = test::small_dae("1", "Y_UP");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(overrun_array(std::string_view(whole).substr(0, size))) << size;
  }
  for (const char* text :
       {"<", "<>", "< accessor source='#' count='1'>", "<!--", "<accessor count='", "<accessor count=5>"}) {
    EXPECT_FALSE(overrun_array(text)) << text;
  }
}

}  // namespace
}  // namespace coif
