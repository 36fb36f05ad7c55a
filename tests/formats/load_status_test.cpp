// What a refusal says in words, into a buffer of any size.

#include "models/small_asset.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace coif::load_status_test {

std::string words_of(const LoadStatus& status) {
  char text[400];
  const std::size_t length = describe(status, text, sizeof text);
  EXPECT_EQ(text[length], 0);
  return {text, length};
}

TEST(LoadStatus, NamesChunkRecordAndNumbers) {
  AssetContents contents = small_asset();
  contents.indices[4] = 9;
  char text[200];
  const std::size_t length = describe(open_written(contents), text, sizeof text);
  EXPECT_EQ(std::string(text, length),
            "chunk INDX, record 4: index points outside the array it refers to (size 9, index 9)");
}

TEST(LoadStatus, DescriptionFitsTheBufferGiven) {
  char text[8] = "1234567";
  EXPECT_EQ(describe(LoadStatus{LoadCode::kHash, 0, 0, 1, 2}, text, sizeof text), 7u);
  EXPECT_STREQ(text, "the byt");
}

TEST(LoadStatus, DescriptionIsCutAtTheBuffersEndAndWritesNothingBehindIt) {
  const LoadStatus status{LoadCode::kReference, chunk::kIndices, 12, 345, 6789};
  const std::string whole = words_of(status);
  for (std::size_t size = 0; size <= whole.size() + 2; ++size) {
    std::string text(size + 4, '#');
    const std::size_t length = describe(status, text.data(), size);
    EXPECT_EQ(length, size == 0 ? 0 : std::min(size - 1, whole.size())) << size;
    EXPECT_EQ(text.substr(0, length), whole.substr(0, length)) << size;
    const std::size_t end = size == 0 ? 0 : length + 1;
    EXPECT_EQ(text.substr(end), std::string(size + 4 - end, '#')) << size;
  }
}

TEST(LoadStatus, NamesAreThoseOfChunksAndShowNoControlCharacters) {
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    const char shown = byte >= 0x20 && byte <= 0x7E ? char(byte) : '?';
    const std::string words = words_of({LoadCode::kChunkUnknown, byte << 24 | 0x434241u});
    EXPECT_NE(words.find(std::string("chunk ABC") + shown), std::string::npos) << words;
  }
}

TEST(LoadStatus, NumbersAreWhole) {
  for (const std::uint64_t number : {std::uint64_t{1}, std::uint64_t{9}, std::uint64_t{10},
                                     std::uint64_t{1'234'567'890}, std::numeric_limits<std::uint64_t>::max()}) {
    const std::string words = words_of({LoadCode::kReference, chunk::kIndices, 7, number, number});
    EXPECT_NE(words.find("size " + std::to_string(number) + ", index " + std::to_string(number)), std::string::npos)
        << words;
  }
}

}  // namespace coif::load_status_test
