#include "cook/cook.h"

#include "cook/built_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <string>

namespace coif::cook::result_bytes_test {

CookResult cooked_wig() {
  CookSettings settings;
  settings.list_patches = true;
  settings.draft = true;
  auto result = cook(make_wig(), default_recipe(), settings);
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return result ? std::move(*result) : CookResult{};
}

TEST(ResultBytes, AResultComesBackAsItWas) {
  CookResult result = cooked_wig();
  ASSERT_FALSE(result.asset.empty());
  ASSERT_FALSE(result.patches.patches.empty());
  result.report.warn("C144", "a name that is no UTF-8: \xff");
  result.report.leave_out({"a mesh", "the rule", 12, 40, 1.75});
  result.inputs.source_files = {"folder/a.bin", "b.png"};
  result.inputs.named_files = {"c.png"};
  result.inputs.questions = {{TextureQuestion::Kind::kColors, {"hair"}, {"a.png", "b.png"}}};
  const std::vector<std::uint8_t> bytes = encode_result(result);
  const CookResult back = decode_result(bytes);
  EXPECT_EQ(encode_result(back), bytes);
  EXPECT_EQ(back.asset, result.asset);
  EXPECT_EQ(back.report.warnings.back().code, "C144");
  EXPECT_EQ(back.report.warnings.back(), result.report.warnings.back());
  EXPECT_EQ(back.report.left_out.back().text(), result.report.left_out.back().text());
  EXPECT_EQ(back.report.notes, result.report.notes);
  EXPECT_EQ(back.report.triangles, result.report.triangles);
  EXPECT_EQ(back.report.passes.size(), result.report.passes.size());
  EXPECT_EQ(back.inputs.source_files, result.inputs.source_files);
  EXPECT_EQ(back.inputs.questions[0].answer, result.inputs.questions[0].answer);
  const PatchListing &listed = result.patches.patches.back(), &told = back.patches.patches.back();
  EXPECT_EQ(told.number, listed.number);
  EXPECT_EQ(told.middle, listed.middle);
  EXPECT_EQ(told.size, listed.size);
  EXPECT_EQ(told.chain, listed.chain);
  EXPECT_EQ(back.patches.number_of_place, result.patches.number_of_place);
}

TEST(ResultBytes, OtherBytesAreRefused) {
  const std::vector<std::uint8_t> bytes = encode_result(cooked_wig());
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, std::size_t{100}, bytes.size() - 1})
    EXPECT_THROW((void)decode_result(std::span(bytes).first(size)), std::exception) << size;
}

}  // namespace coif::cook::result_bytes_test
