#include "base/color_texels.h"
#include "gl/gl_test.h"
#include "gl/webgl_code.h"
#include "models/random_blocks.h"
#include "render/gl_program.h"

#include <coif/texel_blocks.h>

#include <GLES3/gl3.h>

#include <array>
#include <cstring>
#include <vector>

namespace coif::color_blocks_test {

constexpr int kSide = 256;
constexpr std::size_t kBlocks = std::size_t(kSide / 4) * (kSide / 4);

std::vector<std::byte> decoded_blocks() {
  const auto blocks = random_blocks(kBlocks);
  return decode_color_blocks(reinterpret_cast<const std::byte*>(blocks.data()), kSide, kSide);
}

using ColorBlocks = GlTest;

TEST_F(ColorBlocks, AreDecodedAsByTheDriver) {
  const auto blocks = random_blocks(kBlocks);
  constexpr char kVertex[] = R"(#version 300 es
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(corner, 0.0, 1.0);
})";
  const char* const fragment = R"(#version 300 es
precision highp float;
uniform highp sampler2D base;
out vec4 color;
void main() { color = texelFetch(base, ivec2(gl_FragCoord.xy), 0); })";
  const auto program = render::build_gl_program(kVertex, {&fragment, 1});
  ASSERT_TRUE(program);
  GLuint texture = 0, target = 0, buffer = 0, array = 0;
  glGenTextures(1, &texture);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_COMPRESSED_RGBA8_ETC2_EAC, kSide, kSide);
  glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSide, kSide, GL_COMPRESSED_RGBA8_ETC2_EAC, GLsizei(blocks.size()),
                            blocks.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glGenFramebuffers(1, &target);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kSide, kSide);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer);
  glViewport(0, 0, kSide, kSide);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glUseProgram(*program);
  glUniform1i(glGetUniformLocation(*program, "base"), 0);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  const std::vector<std::uint8_t> drawn = read_pixels(kSide);
  ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR));

  const std::vector<std::byte> decoded = decoded_blocks();
  ASSERT_EQ(drawn.size(), decoded.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const std::size_t x = i / 4 % kSide, y = i / 4 / kSide;
    ASSERT_EQ(int(drawn[i]), int(decoded[i])) << x << ", " << y << ", channel " << i % 4;
  }
}

TEST(ColorBlocksOfAllModes, HaveTheHashThatTheWebKnows) { EXPECT_EQ(fnv(decoded_blocks()), kRandomColors); }

TEST(ColorRows, AreThoseOfTheBlocks) {
  const auto blocks = random_blocks(kBlocks);
  const std::vector<std::byte> whole = decoded_blocks();
  for (const std::uint32_t width : {1u, 3u, 4u, 6u, 256u}) {
    std::vector<std::byte> rows(std::size_t{16} * width);
    decode_color_rows(std::as_bytes(std::span(blocks)), width, rows);
    for (std::size_t y = 0; y < 4; ++y) {
      EXPECT_EQ(std::memcmp(&rows[4 * y * width], &whole[4 * y * kSide], std::size_t{4} * width), 0) << width;
    }
  }
}

/// A card with a base colour in one block, whose texels have the alphas 255, or also less.
AssetContents carded(bool is_opaque) {
  AssetContents contents = card_contents(std::array{DrawnCard{.rgba = {200, 180, 160, 255}}});
  TextureRecord& record = contents.textures[0];
  record.format = TexelFormat::kSrgb8Alpha8Etc2;
  record.width = record.height = 4;
  record.bytes = kColorBlockBytes;
  const std::uint8_t alpha[8] = {255, 0x1d, 0x92, 0x49, 0x24, 0x92, 0x49, std::uint8_t(is_opaque ? 0x24 : 0x23)};
  const std::uint8_t color[8] = {0x88, 0x44, 0x22, 0, 0, 0, 0, 0};
  std::vector<std::byte> texels(kColorBlockBytes);
  std::memcpy(texels.data(), alpha, 8);
  std::memcpy(&texels[8], color, 8);
  const std::vector<std::byte> others(contents.texels.begin() + std::ptrdiff_t(contents.textures[1].offset),
                                      contents.texels.end());
  texels.resize(64);
  record.offset = 0;
  contents.textures[1].offset = texels.size();
  texels.insert(texels.end(), others.begin(), others.end());
  contents.texels = texels;
  return contents;
}

TEST_F(ColorBlocks, ShadeAsTheColoursThatTheyStandFor) {
  clear();
  draw(carded(true));
  const Pixel found = middle_pixel();
  clear();
  // Eight of fifteen steps are 136; the first table's smaller step lightens by two.
  draw_cards(std::array{DrawnCard{.rgba = {138, 70, 36, 255}}});
  EXPECT_EQ(found, middle_pixel());
  EXPECT_GT(found[0], found[1]);
}

TEST(AlphaRangeOfBlocks, IsThatOfTheirTexels) {
  const DrawnAsset opaque(carded(true));
  EXPECT_EQ(alpha_range_of(*opaque).lowest, 1);
  EXPECT_EQ(alpha_range_of(*opaque).highest, 1);
  const DrawnAsset soft(carded(false));
  EXPECT_FLOAT_EQ(alpha_range_of(*soft).lowest, 245.0f / 255) << "the last texel is ten below";
}

}  // namespace coif::color_blocks_test
