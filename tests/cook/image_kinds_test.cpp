#include "cook/texture/image.h"

#include <gtest/gtest.h>

#include <string_view>

namespace coif::cook::image_kinds_test {

std::vector<std::uint8_t> bytes_of(std::string_view text) {
  std::vector<std::uint8_t> bytes(text.begin(), text.end());
  bytes.resize(64);
  return bytes;
}

// Two texels, red and a blue that is a quarter there, losslessly.
constexpr std::uint8_t kWebp[] = {0x52, 0x49, 0x46, 0x46, 0x20, 0x00, 0x00, 0x00, 0x57, 0x45, 0x42, 0x50, 0x56, 0x50,
                                  0x38, 0x4C, 0x13, 0x00, 0x00, 0x00, 0x2F, 0x01, 0x00, 0x00, 0x10, 0x0F, 0x10, 0xFB,
                                  0x3F, 0xFF, 0x0F, 0xFA, 0x8F, 0x0A, 0x15, 0x88, 0xE8, 0x7F, 0x00, 0x00};

TEST(ImageKinds, WebpIsReadWithItsAlpha) {
  const auto image = decode_image(kWebp);
  ASSERT_TRUE(image) << image.error();
  EXPECT_EQ(image->width, 2u);
  EXPECT_EQ(image->height, 1u);
  EXPECT_EQ(image->texels, (std::vector<std::uint8_t>{255, 0, 0, 255, 0, 0, 255, 64}));
}

TEST(ImageKinds, EveryTruncatedWebpIsRefused) {
  for (std::size_t size = 12; size < 30; ++size) {
    EXPECT_FALSE(decode_image(std::span(kWebp).first(size))) << size;
  }
}

TEST(ImageKinds, KindsThatAreNotReadAreNamedWithTheCommandThatConvertsThem) {
  const struct {
    std::string_view begin;
    const char *name, *command;
  } kinds[] = {{"\xABKTX 20\xBB\r\n", "KTX2", "ktx extract"},
               {"DDS |", "DDS", "convert hair.dds hair.png"},
               {"8BPS", "Photoshop", "convert hair.psd hair.png"},
               {std::string_view("II*\0", 4), "TIFF", "convert hair.tif hair.png"},
               {"GIF89a", "GIF", "convert hair.gif hair.png"},
               {std::string_view("\0\0\0\x1c"
                                 "ftypavif",
                                 12),
                "AVIF", "convert hair.avif"}};
  for (const auto& kind : kinds) {
    const auto image = decode_image(bytes_of(kind.begin));
    ASSERT_FALSE(image);
    EXPECT_NE(image.error().find(kind.name), std::string::npos) << image.error();
    EXPECT_NE(image.error().find(kind.command), std::string::npos) << image.error();
  }
}

}  // namespace coif::cook::image_kinds_test
