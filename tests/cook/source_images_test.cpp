#include "cook/texture/source_images.h"
#include "cook/image_files.h"
#include "cook/texture/bake_textures.h"
#include "cook/texture/image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace coif::cook::source_images_test {

/// Thin opaque strands, one texel in four, on a transparent black ground.
Image strands(std::uint32_t size) {
  Image image{size, size, 4, std::vector<std::uint8_t>(std::size_t(size) * size * 4, 0)};
  for (std::size_t i = 0; i < image.texel_count(); ++i) {
    if (i % 4 != 0) continue;
    const std::uint8_t texel[4] = {200, 100, 50, 255};
    std::copy_n(texel, 4, &image.texels[4 * i]);
  }
  return image;
}

TEST(Mips, GoDownToOneTexelAndFitTheLimit) {
  Image image = strands(64);
  image.height = 32;
  image.texels.resize(64 * 32 * 4);
  const auto mips = make_mips(image, 16, TexelMeaning::kSrgbColorAlpha);
  ASSERT_EQ(mips.size(), 5u);
  EXPECT_EQ(mips[0].width, 16u);
  EXPECT_EQ(mips[0].height, 8u);
  EXPECT_EQ(mips[4].width, 1u);
  EXPECT_EQ(mips[4].height, 1u);
}

TEST(Mips, ColorIsWeightedByAlpha) {
  const auto mips = make_mips(strands(32), 32, TexelMeaning::kSrgbColorAlpha);
  // Averaging without weights would give half of the light; the strands' own colour must stay.
  EXPECT_NEAR(mips[1].texels[0], 200, 2);
  EXPECT_NEAR(mips[1].texels[3], 128, 2);
}

TEST(ShiftMask, IsTheSameForTheSameSeedAndAnotherForAnother) {
  EXPECT_EQ(generate_shift_mask(1, false).texels, generate_shift_mask(1, false).texels);
  EXPECT_NE(generate_shift_mask(1, false).texels, generate_shift_mask(2, false).texels);
}

/// Mean absolute difference of the shift between neighbours: {to the right, downwards}.
std::pair<double, double> roughness(const Image& image) {
  double right = 0, down = 0;
  for (std::uint32_t y = 0; y + 1 < image.height; ++y) {
    for (std::uint32_t x = 0; x + 1 < image.width; ++x) {
      const auto at = [&](std::uint32_t i, std::uint32_t j) {
        return double(image.texels[2 * (std::size_t(j) * image.width + i)]);
      };
      right += std::abs(at(x + 1, y) - at(x, y));
      down += std::abs(at(x, y + 1) - at(x, y));
    }
  }
  return {right, down};
}

TEST(ShiftMask, VariesAcrossStrandsMoreThanAlongThem) {
  const auto [right, down] = roughness(generate_shift_mask(5, false));
  EXPECT_GT(right, 5 * down);
  const auto [right_u, down_u] = roughness(generate_shift_mask(5, true));
  EXPECT_GT(down_u, 5 * right_u);
}

TEST(ShiftMask, ShiftIsAroundOneHalf) {
  const Image image = generate_shift_mask(9, false);
  double sum = 0;
  for (std::size_t i = 0; i < image.texels.size(); i += 2) sum += image.texels[i];
  EXPECT_NEAR(sum / double(image.texel_count()), 127.5, 6);
}

TEST(ShiftMask, TakesTheArtistsChannels) {
  const Image shift{2, 1, 4, {10, 0, 0, 255, 20, 0, 0, 255}};
  const Image combined = combine_shift_mask(&shift, nullptr, 1, false);
  ASSERT_EQ(combined.width, generate_shift_mask(1, false).width);
  EXPECT_EQ(combined.texels[0], 10);
  EXPECT_EQ(combined.texels[2 * (combined.width - 1)], 20);
  EXPECT_EQ(combined.texels[1], generate_shift_mask(1, false).texels[1]);
}

namespace fs = std::filesystem;

TEST(TextureFolder, FindsAnImageHoweverItsPathIsWritten) {
  const ImageFolder files;
  const fs::path image = files.write_flat("My Hair.png");
  const TextureFolder folder(files.source());
  for (const char* written : {"My Hair.png", "my hair.PNG", "./My Hair.png", "My%20Hair.png",
                              "D:\\work\\art\\My Hair.png", "\\\\nas\\My Hair.png", "/Users/artist/My Hair.png",
                              "file:///c:/art/My%20Hair.png", "..\\..\\scenes\\my%20hair.png", "lost/My Hair.png"}) {
    EXPECT_EQ(folder.find(written), image) << written;
  }
  for (const char* other : {"", "/", ".", "..", "Hair.png", "My%2Hair.png", "My Hair.png/"}) {
    EXPECT_EQ(folder.find(other), std::nullopt) << other;
  }
}

TEST(TextureFolder, LooksIntoTheCustomaryFoldersAlone) {
  const ImageFolder files;
  const fs::path image = files.write_flat("Textures/hair.png");
  files.write_flat("backup/old.png");
  const TextureFolder folder(files.source());
  EXPECT_EQ(folder.find("C:\\art\\hair.png"), image);
  EXPECT_EQ(folder.short_name(image), "Textures/hair.png");
  EXPECT_EQ(folder.find("old.png"), std::nullopt);
  EXPECT_EQ(folder.images().size(), 1u);
}

TEST(TextureFolder, LooksIntoTheCustomaryFoldersBesideTheSourcesAfterItsOwn) {
  const ImageFolder files;
  const fs::path beside = files.write_flat("../Textures/hair.png");
  files.write_flat("../backup/old.png");
  fs::create_directory_symlink(files.path().parent_path() / "backup", files.path().parent_path() / "maps");
  EXPECT_TRUE(fs::equivalent(TextureFolder(files.source()).find("D:\\work\\hair.tga").value(), beside));
  EXPECT_EQ(TextureFolder(files.source()).find("old.png"), std::nullopt) << "a link that leads elsewhere";
  const fs::path own = files.write_flat("hair.png");
  EXPECT_EQ(TextureFolder(files.source()).find("hair.png"), own);
}

TEST(TextureFolder, TakesThePathAsItIsWrittenBeforeOthersOfThatName) {
  const ImageFolder files;
  files.write_flat("hair.png");
  const fs::path deeper = files.write_flat("Looks/red/hair.png");
  EXPECT_EQ(TextureFolder(files.source()).find("looks\\Red\\hair.png"), deeper);
}

TEST(TextureFolder, TakesAnotherFormatOfTheSameName) {
  const ImageFolder files;
  const fs::path image = files.write_flat("hair.01.png");
  const TextureFolder folder(files.source());
  EXPECT_EQ(folder.find("hair.01.psd"), image);
  EXPECT_EQ(folder.find("hair.01"), image);
  EXPECT_EQ(folder.find("hair.psd"), std::nullopt);
}

TEST(TextureFolder, NeverLeavesTheFolderOfTheSource) {
  const ImageFolder files;
  const fs::path secret = files.write_flat("../secret.png");
  files.write_flat("../elsewhere/deep.png");
  const fs::path root = files.path();
  fs::create_symlink(secret, root / "link.png");
  fs::create_directory_symlink(root.parent_path() / "elsewhere", root / "textures");
  fs::create_directory(root / "inner");
  const TextureFolder folder(files.source());
  for (const std::string& written :
       {std::string("../secret.png"), std::string("inner/../../secret.png"), std::string("..\\secret.png"),
        std::string("%2e%2e%2fsecret.png"), secret.string(), "file://" + secret.string(), std::string("link.png"),
        std::string("textures/deep.png"), std::string("deep.png"), std::string("link.png\0.png", 13)}) {
    EXPECT_EQ(folder.find(written), std::nullopt) << written;
  }
  EXPECT_TRUE(folder.images().empty());
  EXPECT_TRUE(folder.colors_of(std::vector<std::string>{"secret", "link", "deep"}).empty());
}

TEST(TextureFolder, FollowsLinksThatStayInside) {
  const ImageFolder files;
  files.write_flat("store/a1.png");
  fs::create_symlink("store/a1.png", files.path() / "hair.png");
  EXPECT_EQ(TextureFolder(files.source()).find("hair.png"), files.path() / "hair.png");
}

TEST(TextureFolder, FollowsLinksToWhereALinkedSourceLies) {
  // As a build's sandbox has it: every file by itself a link into the tree.
  const ImageFolder tree, sandbox;
  tree.write_flat("hair.png");
  std::ofstream(tree.source()) << "model";
  fs::create_symlink(tree.source(), sandbox.source());
  fs::create_symlink(tree.path() / "hair.png", sandbox.path() / "hair.png");
  EXPECT_EQ(TextureFolder(sandbox.source()).find("hair.png"), sandbox.path() / "hair.png");
  fs::create_symlink("/etc/hostname", sandbox.path() / "skin.png");
  EXPECT_EQ(TextureFolder(sandbox.source()).find("skin.png"), std::nullopt) << "it lies in neither";
}

TEST(TextureFolder, FollowsLinksAndPathsIntoDeclaredRootsAlone) {
  // As git-annex and Nix have it: each file in a folder of its own, somewhere else.
  const ImageFolder files, store;
  const fs::path kept = store.write_flat("a1/hair.png");
  fs::create_symlink(kept, files.path() / "hair.png");
  const fs::path secret = files.write_flat("../secret.png");
  EXPECT_EQ(TextureFolder(files.source()).find("hair.png"), std::nullopt);
  EXPECT_EQ(TextureFolder(files.source()).find_outside("maps\\hair.png"), fs::canonical(kept));

  const std::vector<fs::path> roots{store.path()};
  const TextureFolder folder(files.source(), roots);
  EXPECT_EQ(folder.find("hair.png"), files.path() / "hair.png");
  EXPECT_EQ(folder.find_outside("hair.png"), std::nullopt);
  EXPECT_EQ(folder.find(kept.string()), kept) << "an absolute path into a root";
  const std::string up = kept.lexically_relative(files.path()).string();
  ASSERT_TRUE(up.starts_with(".."));
  EXPECT_TRUE(folder.find(up)) << up;
  EXPECT_EQ(folder.find("../secret.png"), std::nullopt);
  EXPECT_EQ(folder.find(secret.string()), std::nullopt);
}

TEST(TextureFolder, AFolderThatIsNotThereIsEmpty) {
  const ImageFolder files;
  const TextureFolder folder(files.path() / "gone" / "wig.fbx");
  EXPECT_TRUE(folder.images().empty());
  EXPECT_EQ(folder.find("hair.png"), std::nullopt);
}

TEST(TextureFolder, TellsColorsFromOtherMapsByTheirNames) {
  const ImageFolder files;
  for (const char* other : {"hair_n.png", "HairNormal.png", "mask_hair.png", "hair-roughness.tga", "Hair_AO.png",
                            "hair_alpha.png", "skin.png", "Material.png", "hair.txt"}) {
    files.write_flat(other);
  }
  const fs::path hair = files.write_flat("hair_01.tga");
  const fs::path by_name = files.write_flat("long2_texture.png");
  const TextureFolder folder(files.source());
  const std::vector<std::string> none, names{"long2", "Material.001", "x"};
  EXPECT_EQ(folder.colors_of(none), std::vector{hair});
  EXPECT_EQ(folder.colors_of(names), (std::vector{hair, by_name}));
}

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
  const auto wide = decode_image(png_header(kMaxImageSide + 1, 1));
  ASSERT_FALSE(wide);
  EXPECT_NE(wide.error().find("16385 x 1 texels; an image has 1 to 16384 a side"), std::string::npos) << wide.error();
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

}  // namespace coif::cook::source_images_test
