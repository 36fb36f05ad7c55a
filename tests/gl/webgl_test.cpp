#include "gl/gl_test.h"
#include "gl/webgl_code.h"
#include "models/eac_texels.h"

#include <coif/view_cells.h>
#include <coif/webgl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace coif::webgl_test {

TEST(EacDecoder, GivesTheByteNearestToEachTexel) {
  std::mt19937 random(11);
  std::vector<std::uint8_t> blocks(16 * 4096);
  for (std::uint8_t& byte : blocks) byte = std::uint8_t(random());
  for (std::size_t i = 0; i < 512; ++i) blocks[8 * i + 1] = std::uint8_t(i);  // every table with every multiplier
  for (const std::uint32_t width : {1u, 2u, 3u, 4u, 7u, 4096u, 16384u}) {
    std::vector<std::byte> out(std::size_t{8} * width);
    decode_eac_rows(std::as_bytes(std::span(blocks)), width, out);
    for (std::uint32_t y = 0; y < 4; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        for (int channel = 0; channel < 2; ++channel) {
          const double exact = eac_rg11_value(blocks, width, x, y, channel) * 255.0 / 2047;
          const auto found = int(out[(std::size_t{y} * width + x) * 2 + std::size_t(channel)]);
          ASSERT_EQ(found, int(std::floor(exact + 0.5))) << x << ", " << y << ", " << channel << " of " << width;
        }
      }
    }
  }
}

/// What a browser has: nothing of buffers that are mapped or fences that are waited for, and no EAC.
class Browser {
 public:
  explicit Browser(const GlLoader& real) : real_(real) { current = this; }
  ~Browser() { current = nullptr; }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  GlLoader loader() { return {find, this}; }
  int compressed = 0;  ///< Uploads that were tried.
  int storage = 0;     ///< Buffers given storage.

 private:
  static void* find(const char* name, void* user) {
    const std::string asked = name;
    for (const char* absent :
         {"glMapBufferRange", "glUnmapBuffer", "glFenceSync", "glClientWaitSync", "glDeleteSync"}) {
      if (asked == absent) return nullptr;
    }
    if (asked == "glCompressedTexSubImage2D") return reinterpret_cast<void*>(compressed_upload);
    if (asked == "glBufferData") return reinterpret_cast<void*>(buffer_data);
    const GlLoader& real = static_cast<Browser*>(user)->real_;
    return real.get_proc(name, real.user);
  }
  static void compressed_upload(GLenum, GLint, GLint, GLint, GLsizei, GLsizei, GLenum, GLsizei, const void*) {
    ++current->compressed;
  }
  static void buffer_data(GLenum target, GLsizeiptr bytes, const void* data, GLenum usage) {
    ++current->storage;
    glBufferData(target, bytes, data, usage);
  }

  static inline Browser* current = nullptr;
  GlLoader real_;
};

class WebGl : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (!context_) return;
    browser_.emplace(context_->loader());
    RendererDesc desc = kSmallBlocks;
    desc.webgl = &kWebGl;
    desc.scratch = scratch();
    ASSERT_EQ(in_browser_.create(browser_->loader(), desc), Status::kOk) << in_browser_.failure();
  }
  void TearDown() override {
    in_browser_.destroy();
    GlTest::TearDown();
  }

  [[nodiscard]] std::span<std::byte> scratch() { return std::as_writable_bytes(std::span(scratch_)); }

  /// What `renderer` draws of this hair, `frames` times over.
  std::vector<std::uint8_t> picture(HairRenderer& renderer, const Asset& asset, const HeadDraw& desc, int frames = 1) {
    HairModel model;
    EXPECT_EQ(model.upload(renderer, asset), Status::kOk) << renderer.failure();
    for (int i = 0; i < frames; ++i) {
      clear();
      EXPECT_EQ(draw_head(renderer, model, desc), Status::kOk);
    }
    model.destroy();
    return read_pixels(kSize);
  }

  std::vector<std::uint32_t> scratch_ = std::vector<std::uint32_t>((1 << 18) / 4);
  std::optional<Browser> browser_;
  HairRenderer in_browser_;
};

TEST_F(WebGl, WithoutMappingIsRefusedUnlessAskedFor) {
  HairRenderer renderer;
  EXPECT_EQ(renderer.create(browser_->loader(), kSmallBlocks), Status::kDriver);
  EXPECT_NE(std::strstr(renderer.failure(), "gl"), nullptr) << renderer.failure();
}

TEST_F(WebGl, ScratchMustHoldAQuarterOfTheStream) {
  RendererDesc desc = kSmallBlocks;
  desc.webgl = &kWebGl;
  desc.scratch = scratch().first(scratch().size() - 1);
  HairRenderer renderer;
  EXPECT_EQ(renderer.create(browser_->loader(), desc), Status::kBadArgument);
}

TEST_F(WebGl, DrawsTheSamePictureWithoutMappedBuffers) {
  // Bones in a block, and in a texture; each frame takes its own part of the stream, round and round.
  for (const std::uint32_t bones : {3u, kMostInBlock + 1}) {
    std::vector<Mat34> palette(bones);
    palette[bones - 1].m[0][3] = 0.25f;
    DrawnCard moved;
    moved.skin = {{std::uint16_t(bones - 1), 0, 0, 0}, {255, 0, 0, 0}};
    moved.rgba = {250, 120, 40, 128};
    const DrawnAsset asset(card_contents(std::array{DrawnCard{{-0.5f, 0, 0}}, moved}, bones));
    HeadDraw desc = at_rest(bones);
    desc.palette = palette;
    const auto expected = picture(renderer_, *asset, desc);
    EXPECT_GT(count_covered(expected), 100);
    EXPECT_EQ(picture(in_browser_, *asset, desc, 100), expected) << bones;
  }
}

TEST_F(WebGl, FramesGiveNoBufferStorage) {
  const DrawnAsset asset(card_contents(std::array{DrawnCard{}}));
  HairModel model;
  ASSERT_EQ(model.upload(in_browser_, *asset), Status::kOk);
  const int before = browser_->storage;
  for (int i = 0; i < 50; ++i) ASSERT_EQ(draw_head(in_browser_, model, at_rest()), Status::kOk);
  EXPECT_EQ(browser_->storage, before);
  model.destroy();
}

/// Red and blue cards in one place in turns, half transparent: what is drawn last shows most. Stored, that is blue;
/// from behind it is red. Indices of two orders take more room than the scratch has.
AssetContents many_orders(std::uint32_t cards, bool has_many_vertices) {
  AssetContents contents =
      card_contents(std::array{DrawnCard{.rgba = {255, 0, 0, 128}}, DrawnCard{.rgba = {0, 0, 255, 128}}});
  const std::vector<VertexRecord> vertices = contents.vertices;
  for (std::uint32_t i = 2; i < cards; ++i) {
    const auto first = std::uint32_t(contents.indices.size());
    const std::uint32_t vertex = has_many_vertices ? std::uint32_t(contents.vertices.size()) : i % 2 * 4;
    for (std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) contents.indices.push_back(vertex + corner);
    contents.patches.push_back({first, 6, 0, 0, i});
    if (!has_many_vertices) continue;
    const auto card = vertices.begin() + i % 2 * 4;
    contents.vertices.insert(contents.vertices.end(), card, card + 4);
    contents.skin.insert(contents.skin.end(), 4, contents.skin.front());
  }
  for (std::uint32_t i = cards; i > 0; --i) contents.orders.insert(contents.orders.end(), {2 * i - 2, 2 * i - 1});
  contents.order_views = second_from_behind();
  return contents;
}

TEST_F(WebGl, CookedOrdersArriveThoughScratchHoldsAPartOfThem) {
  for (const bool has_many_vertices : {false, true}) {
    const DrawnAsset asset(many_orders(18'000, has_many_vertices));
    HeadDraw desc = at_rest();
    const auto front = picture(in_browser_, *asset, desc);
    EXPECT_EQ(front, picture(renderer_, *asset, desc));
    EXPECT_GT(middle_pixel()[2], middle_pixel()[0] + 20);
    desc.head.rotation = {0, 1, 0, 0};
    EXPECT_EQ(picture(in_browser_, *asset, desc), picture(renderer_, *asset, desc));
    EXPECT_GT(middle_pixel()[0], middle_pixel()[2] + 20);
  }
}

TEST_F(WebGl, RefusesOrdersOfEachHead) {
  const DrawnAsset asset(card_contents(std::array{DrawnCard{}}));
  BoneOrder order;
  HairModel model;
  ASSERT_EQ(model.upload(in_browser_, *asset), Status::kOk);
  HeadDraw desc = at_rest();
  desc.order = &order;
  EXPECT_EQ(draw_head(in_browser_, model, desc), Status::kBadArgument);
  model.destroy();
}

TEST_F(WebGl, CompressedTexturesAreDecoded) {
  // As passes_test's compressed texture, of random blocks: what the driver decodes itself is the same within a byte's
  // step.
  AssetContents contents = card_contents(std::array{DrawnCard{.rgba = {200, 180, 160, 255}}});
  for (float& color : contents.material[0].secondary_color) color = 1;
  contents.material[0].secondary_exponent = 4;
  TextureRecord& record = contents.textures[1];
  record.format = TexelFormat::kRg11Eac;
  record.width = record.height = 6;
  record.mip_count = 3;
  record.bytes = 64 + 16 + 16;
  contents.texels.resize(std::size_t(record.offset));
  std::mt19937 random(3);
  for (int i = 0; i < 96; ++i) contents.texels.push_back(std::byte(random()));
  const DrawnAsset asset(contents);
  HeadDraw desc = at_rest();
  const std::array lights{Light{Light::Kind::kDirectional, {0.3f, 0.8f, 0.5f}, {0.5f, 0.5f, 0.5f}}};
  desc.lights = lights;
  EXPECT_LE(worst_difference(picture(in_browser_, *asset, desc), picture(renderer_, *asset, desc)), 2);
  EXPECT_EQ(browser_->compressed, 0);
}

}  // namespace coif::webgl_test
