#include "cook/image.h"

#include "cook/image_files.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coif {
namespace {

constexpr Rgba kUpper{200, 40, 40, 255};
constexpr Rgba kLower{40, 40, 200, 96};

/// Red above, translucent blue below: shows turned rows, swapped channels and lost alpha.
Image flag() {
  return painted(32, 16, [](auto, std::uint32_t y) { return y < 8 ? kUpper : kLower; });
}

TEST(Image, EveryFormatDecodesWithItsRowsFromTheTop) {
  for (const FileFormat format : {FileFormat::kPng, FileFormat::kTga, FileFormat::kJpeg, FileFormat::kBmp}) {
    const auto image = decode_image(encoded(flag(), format));
    ASSERT_TRUE(image) << int(format) << ": " << image.error();
    ASSERT_EQ(image->width, 32u);
    ASSERT_EQ(image->height, 16u);
    const bool lossy = format == FileFormat::kJpeg;
    const Rgba lower{kLower[0], kLower[1], kLower[2], lossy ? std::uint8_t{255} : kLower[3]};
    EXPECT_LE(difference(texel_at(*image, {0.3f, 0.2f}), kUpper), lossy ? 4 : 0) << int(format);
    EXPECT_LE(difference(texel_at(*image, {0.3f, 0.8f}), lower), lossy ? 4 : 0) << int(format);
  }
}

TEST(Image, ReadsAFile) {
  const ImageFolder folder;
  const auto image = read_image(folder.write("hair.tga", encoded(flag(), FileFormat::kTga)));
  ASSERT_TRUE(image);
  EXPECT_EQ(image->texels, flag().texels);
}

TEST(Image, EveryTruncationIsAnErrorOrAWholeImage) {
  for (const FileFormat format : {FileFormat::kPng, FileFormat::kTga, FileFormat::kJpeg, FileFormat::kBmp}) {
    const auto whole = encoded(flag(), format);
    for (std::size_t n = 0; n < whole.size(); ++n) {
      const std::vector<std::uint8_t> cut(whole.begin(), whole.begin() + std::ptrdiff_t(n));
      const auto image = decode_image(cut);
      // Decoders of some formats fill up what is missing; never is there less than the size says.
      if (image) {
        EXPECT_EQ(image->texels.size(), std::size_t{32} * 16 * 4) << int(format) << ", " << n << " bytes";
      } else {
        EXPECT_NE(image.error().find("cannot read the image"), std::string::npos);
      }
    }
    EXPECT_FALSE(decode_image(std::span(whole).first(8))) << int(format);
  }
}

// stb_image counts on at most 256 codes of a Huffman table, and writes as many as the file says.
TEST(Image, ATableThatOverrunsTheDecoderCostsNoMoreThanTheImage) {
  auto jpeg = encoded(flag(), FileFormat::kJpeg);
  std::size_t tables = 0;
  for (std::size_t at = 2; at + 21 < jpeg.size(); ++at) {
    if (jpeg[at] != 0xFF || jpeg[at + 1] != 0xC4) continue;
    std::fill_n(jpeg.begin() + std::ptrdiff_t(at) + 5, 16, std::uint8_t{255});
    ++tables;
  }
  ASSERT_GT(tables, 0u);
  EXPECT_FALSE(decode_image(jpeg));
  EXPECT_TRUE(decode_image(encoded(flag(), FileFormat::kJpeg)));
}

/// The beginning of a PNG that claims a size, and nothing behind it.
std::vector<std::uint8_t> png_header(std::uint32_t width, std::uint32_t height) {
  std::vector<std::uint8_t> bytes{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n', 0, 0, 0, 13, 'I', 'H', 'D', 'R'};
  for (const std::uint32_t side : {width, height}) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(std::uint8_t(side >> shift));
  }
  for (const int byte : {8, 6, 0, 0, 0, 0, 0, 0, 0}) bytes.push_back(std::uint8_t(byte));
  return bytes;
}

TEST(Image, AHugeSizeIsRefusedFromTheHeaderAlone) {
  const auto many_texels = decode_image(png_header(16384, 16384));
  ASSERT_FALSE(many_texels);
  EXPECT_NE(many_texels.error().find("16384 x 16384 texels"), std::string::npos) << many_texels.error();
  EXPECT_FALSE(decode_image(png_header(kMaxImageSide + 1, 1)));
  EXPECT_FALSE(decode_image(png_header(0, 4)));
}

TEST(Image, AFileThatIsTooLargeIsNotRead) {
  const ImageFolder folder;
  const auto path = folder.write_flat("hair.png");
  std::filesystem::resize_file(path, kMaxImageBytes + 1);  // Takes no room on the disk.
  const auto image = read_image(path);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error(), "larger than 256 MiB; reduce it");
}

TEST(Image, AFolderIsNoFile) {
  const ImageFolder folder;
  EXPECT_FALSE(read_image(folder.path()));
  EXPECT_FALSE(read_image(folder.path() / "absent.png"));
}

TEST(Image, WhatIsNotAnImageIsRefusedWithACure) {
  const std::vector<std::uint8_t> text{'h', 'e', 'l', 'l', 'o'};
  const auto image = decode_image(text);
  ASSERT_FALSE(image);
  EXPECT_NE(image.error().find("save it as PNG"), std::string::npos);
}

}  // namespace
}  // namespace coif
