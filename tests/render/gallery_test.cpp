#include "render/gallery.h"

#include "formats/without_mesh.h"
#include "gl/card_asset.h"
#include "gl/made_up_wig.h"
#include "render/egl_context.h"
#include "render/gallery_material.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

namespace coif {
namespace {

class GalleryTest : public testing::Test {
 protected:
  static bool has_device() { return EglContext::create().has_value(); }

  [[nodiscard]] tl::expected<GallerySheet, ToolError> render(std::uint32_t only) {
    return render_gallery(*wig_, {.width = 64, .height = 64, .only = only},
                          [this](const std::string& text) { heard_.push_back(text); });
  }

  [[nodiscard]] std::vector<Gallery> galleries(std::uint32_t only = 0) const {
    return thesis_galleries(*wig_, {.only = only});
  }

  OpenedAsset wig_{made_up_wig({.strips = 12, .texture_size = 32})};
  std::vector<std::string> heard_;
};

TEST_F(GalleryTest, AllFiveFillTheirRows) {
  std::set<std::uint32_t> numbers;
  for (const Gallery& gallery : galleries()) {
    numbers.insert(gallery.number);
    EXPECT_EQ(gallery.pictures.size() % kGalleryColumns, 0u) << gallery.title;
    EXPECT_FALSE(gallery.pictures.empty()) << gallery.title;
  }
  EXPECT_EQ(numbers, (std::set<std::uint32_t>{1, 2, 3, 4, 5}));
}

TEST_F(GalleryTest, CaptionsTellPicturesOfAGalleryApart) {
  for (const Gallery& gallery : galleries()) {
    std::set<std::string> captions;
    for (const GalleryPicture& picture : gallery.pictures) captions.insert(picture.caption);
    EXPECT_EQ(captions.size(), gallery.pictures.size()) << gallery.title;
  }
}

TEST_F(GalleryTest, OneNumberGivesThatGalleryAlone) {
  for (std::uint32_t number = 1; number <= kGalleries; ++number) {
    const auto chosen = galleries(number);
    EXPECT_FALSE(chosen.empty()) << number;
    for (const Gallery& gallery : chosen) EXPECT_EQ(gallery.number, number);
  }
}

TEST_F(GalleryTest, ShiftsAndExponentsAreTheThesiss) {
  std::set<std::pair<float, float>> shifts, exponents;
  for (const GalleryPicture& picture : galleries(2).front().pictures) {
    shifts.emplace(picture.settings.material->primary_shift, picture.settings.material->secondary_shift);
  }
  for (const GalleryPicture& picture : galleries(3).front().pictures) {
    exponents.emplace(picture.settings.material->primary_exponent, picture.settings.material->secondary_exponent);
  }
  EXPECT_EQ(shifts, (std::set<std::pair<float, float>>{{0.5f, 0.7f}, {0.7f, 0.5f}, {0.9f, 0.3f}}));
  EXPECT_EQ(exponents, (std::set<std::pair<float, float>>{{150, 30}, {1000, 70}, {5000, 100}}));
}

TEST_F(GalleryTest, ShadingIsTheThesissWhateverTheAssetsIs) {
  AssetContents contents = card_contents(std::array{Card{}});
  contents.material.front().shading = ShadingModel::kMarschner;
  contents.material.front().roughness = 0.3f;
  const OpenedAsset fibres(contents);
  for (std::uint32_t number = 1; number <= 4; ++number) {
    for (const Gallery& gallery : thesis_galleries(*fibres, {.only = number})) {
      for (const GalleryPicture& picture : gallery.pictures) {
        ASSERT_TRUE(picture.settings.material) << gallery.title;
        EXPECT_EQ(picture.settings.material->shading, ShadingModel::kThesis) << gallery.title;
      }
    }
  }
}

TEST_F(GalleryTest, MotionGoesOnFromPictureToPicture) {
  for (const Gallery& gallery : galleries(5)) {
    EXPECT_TRUE(std::ranges::is_sorted(gallery.pictures, std::ranges::less_equal{}, [](const GalleryPicture& picture) {
      return picture.settings.time;
    })) << gallery.title;
    const auto& last = gallery.pictures.back().settings;
    ASSERT_NE(last.clip, nullptr);
    const HeadPose begin = last.clip->pose(0), end = last.clip->pose(last.time);
    const bool turned = begin.rotation.w != end.rotation.w, moved = begin.position[2] != end.position[2];
    EXPECT_TRUE(turned || moved) << gallery.title;
  }
}

TEST_F(GalleryTest, DyedHairIsOnAverageOfTheColorAskedFor) {
  const Eigen::Vector3d green(0.04, 0.13, 0.03);
  const MaterialRecord dyed = dyed_material(*wig_, green);
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(mean_base_color(*wig_)[channel] * double(dyed.base_color[channel]), green[channel], 1e-5);
  }
  EXPECT_EQ(dyed.base_color[3], (*wig_).material()->base_color[3]);
}

TEST_F(GalleryTest, MaterialsAreSuchAsTheFormatAllows) {
  for (const Gallery& gallery : galleries()) {
    for (const GalleryPicture& picture : gallery.pictures) {
      if (!picture.settings.material) continue;
      AssetContents contents = card_contents(std::array{Card{}});
      contents.material = {*picture.settings.material};
      const OpenedAsset opened(contents);  // fails this test where the reader refuses it
      EXPECT_TRUE((*opened).is_open()) << gallery.title << ", " << picture.caption;
    }
  }
}

TEST_F(GalleryTest, SettingsOutOfRangeAreRefusedByName) {
  const auto refusal = [this](const GallerySettings& settings) {
    const auto sheet = render_gallery(*wig_, settings, [](const std::string&) {});
    return sheet ? std::string() : sheet.error().message;
  };
  EXPECT_NE(refusal({.width = 63}).find("64 to 1024 pixels each way, not 63 x 320"), std::string::npos);
  EXPECT_NE(refusal({.height = 1025}).find("not 320 x 1025"), std::string::npos);
  EXPECT_NE(refusal({.only = 6}).find("no gallery 6"), std::string::npos);
}

TEST_F(GalleryTest, SameSheetTwice) {
  if (!has_device()) GTEST_SKIP() << "no EGL device with OpenGL ES 3.0";
  const auto first = render(4), second = render(4);
  ASSERT_TRUE(first) << first.error().message;
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ(first->pictures, 6u);
  EXPECT_TRUE(first->sheet.rgba == second->sheet.rgba);
  EXPECT_EQ(heard_.size(), 12u);
  EXPECT_EQ(heard_.front(), "Gallery 4: colours, brown");
}

TEST_F(GalleryTest, PicturesOfOneGalleryDiffer) {
  if (!has_device()) GTEST_SKIP() << "no EGL device with OpenGL ES 3.0";
  auto maker = PictureMaker::create(*wig_);
  ASSERT_TRUE(maker) << maker.error().message;
  for (const Gallery& gallery : thesis_galleries(*wig_, {.width = 64, .height = 64})) {
    std::set<std::vector<std::uint8_t>> seen;
    for (const GalleryPicture& picture : gallery.pictures) {
      const auto taken = maker->take(picture.settings);
      ASSERT_TRUE(taken) << taken.error().message;
      seen.insert(taken->rgba);
    }
    EXPECT_EQ(seen.size(), gallery.pictures.size()) << gallery.title;
  }
}

TEST_F(GalleryTest, HairWithoutAMeshIsRefused) {
  const OpenedAsset bald(without_mesh(card_contents(std::array{Card{}})));
  const auto sheet = render_gallery(*bald, {}, [](const std::string&) {});
  ASSERT_FALSE(sheet);
  EXPECT_EQ(sheet.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(sheet.error().message.find("no mesh to draw"), std::string::npos);
}

}  // namespace
}  // namespace coif
