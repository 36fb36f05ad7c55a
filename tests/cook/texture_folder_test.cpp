#include "cook/texture_folder.h"

#include "cook/image_files.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

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

}  // namespace
}  // namespace coif
