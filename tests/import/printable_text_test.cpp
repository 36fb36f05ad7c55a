#include "import/printable_text.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

TEST(PrintableText, KeepsTextInEveryScript) { EXPECT_EQ(printable_text("Zöpfe 髪 \U0001F487"), "Zöpfe 髪 \U0001F487"); }

TEST(PrintableText, ReplacesControlCharacters) { EXPECT_EQ(printable_text("a\nb\tc\x1b[0m\x7f"), "a b c?[0m?"); }

TEST(PrintableText, ReplacesBytesThatAreNotUtf8) {
  EXPECT_EQ(printable_text("\x94\xaf"), "??");            // Shift-JIS
  EXPECT_EQ(printable_text("\xC0\x80x"), "??x");          // overlong
  EXPECT_EQ(printable_text("\xED\xA0\x80"), "???");       // surrogate
  EXPECT_EQ(printable_text("\xF4\x90\x80\x80"), "????");  // beyond Unicode
  EXPECT_EQ(printable_text("x\xE9\xAB"), "x??");          // cut short
}

TEST(PrintableText, CutsBetweenCharacters) {
  EXPECT_EQ(printable_text("ab髪", 4), "ab");
  EXPECT_EQ(printable_text("ab髪", 5), "ab髪");
}

}  // namespace
}  // namespace coif
