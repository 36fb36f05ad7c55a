// skin_vertices() against shaders/hair.vert itself, whose outputs are captured before anything is drawn.

#include "models/absent.h"
#include "models/skinned_asset.h"
#include "models/small_asset.h"
#include "render/egl_context.h"

#include <coif/skinning.h>

#include <GLES3/gl3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

namespace coif::cpu_skinning_test {

constexpr std::uint32_t kBones = 9;
constexpr GLsizeiptr kRowBytes = 16, kPaletteRows = 1024;

std::string shader_file(const std::string& name) {
  std::ifstream file(COIF_SHADER_FOLDER "/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// One of the file's pieces, see shaders/embed.cmake.
std::string shader_piece(const std::string& file, const std::string& name) {
  const std::string all = shader_file(file), title = "\n//// " + name + "\n";
  const std::size_t begin = all.find(title) + title.size();
  return all.substr(begin, all.find("\n//// ", begin) - begin);
}

GLuint compiled(GLenum kind, const std::string& code) {
  const GLuint shader = glCreateShader(kind);
  const char* const text = code.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  char log[1024] = {};
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  EXPECT_STREQ(log, "");
  return shader;
}

/// hair.vert with `defines`, for the outputs that skin_vertices() gives.
GLuint program_with(const std::string& defines) {
  const std::string head =
      "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";
  const GLuint program = glCreateProgram();
  glAttachShader(
      program, compiled(GL_VERTEX_SHADER, head + "#define COIF_PALETTE_ROWS 1024\n" + defines +
                                              shader_piece("hair.glsl", "draw_block.glsl") + shader_file("hair.vert")));
  glAttachShader(program,
                 compiled(GL_FRAGMENT_SHADER, head + "out vec4 unused;\nvoid main() { unused = vec4(0.0); }\n"));
  const char* const outputs[] = {"position", "normal", "tangent"};
  glTransformFeedbackVaryings(program, 3, outputs, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program);
  glUniformBlockBinding(program, glGetUniformBlockIndex(program, "DrawBlock"), 0);
  glUniformBlockBinding(program, glGetUniformBlockIndex(program, "PaletteBlock"), 1);
  return program;
}

GLuint buffer_of(GLenum target, std::span<const std::byte> bytes) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(target, buffer);
  glBufferData(target, GLsizeiptr(bytes.size()), bytes.data(), GL_STATIC_DRAW);
  return buffer;
}

const void* at(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

void describe_vertices(const Asset& asset) {
  buffer_of(GL_ARRAY_BUFFER, std::as_bytes(asset.vertices()));
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(VertexRecord), at(offsetof(VertexRecord, position)));
  glVertexAttribPointer(1, 4, GL_SHORT, GL_TRUE, sizeof(VertexRecord), at(offsetof(VertexRecord, normal)));
  glVertexAttribPointer(2, 4, GL_SHORT, GL_TRUE, sizeof(VertexRecord), at(offsetof(VertexRecord, tangent)));
  for (const GLuint attribute : {0u, 1u, 2u}) glEnableVertexAttribArray(attribute);
  if (asset.skin().empty()) return;
  buffer_of(GL_ARRAY_BUFFER, std::as_bytes(asset.skin()));
  glVertexAttribIPointer(4, 4, GL_UNSIGNED_SHORT, sizeof(SkinRecord), at(offsetof(SkinRecord, bone)));
  glVertexAttribPointer(5, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(SkinRecord), at(offsetof(SkinRecord, weight)));
  for (const GLuint attribute : {4u, 5u}) glEnableVertexAttribArray(attribute);
}

/// A head at the eye, without a turn, then its bones: view space is head space.
void send_blocks(GLuint program, std::span<const Mat34> palette) {
  GLint block_bytes = 0;
  glGetActiveUniformBlockiv(program, glGetUniformBlockIndex(program, "DrawBlock"), GL_UNIFORM_BLOCK_DATA_SIZE,
                            &block_bytes);
  std::vector<float> block(std::size_t(block_bytes) / sizeof(float));
  block[23] = float(3 * (1 + palette.size()));  // ambient.w: rows of a head
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer_of(GL_UNIFORM_BUFFER, std::as_bytes(std::span(block))));
  std::vector<Mat34> rows(std::size_t(kPaletteRows / 3 + 1));
  std::copy(palette.begin(), palette.end(), rows.begin() + 1);
  const auto bytes = std::as_bytes(std::span(rows)).first(kPaletteRows * kRowBytes);
  glBindBufferBase(GL_UNIFORM_BUFFER, 1, buffer_of(GL_UNIFORM_BUFFER, bytes));
}

class CpuSkinning : public testing::Test {
 protected:
  void SetUp() override {
    auto context = render::EglContext::create();
    if (!context) COIF_FAIL_FOR_LACK_OF(context.error().message);
    context_.emplace(std::move(*context));
  }

  static std::vector<SkinnedVertex> by_shader(const Asset& asset, std::span<const Mat34> palette,
                                              const std::string& defines) {
    const GLuint program = program_with(defines);
    describe_vertices(asset);
    send_blocks(program, palette);
    std::vector<SkinnedVertex> out(asset.vertices().size());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0,
                     buffer_of(GL_TRANSFORM_FEEDBACK_BUFFER, std::as_bytes(std::span(out))));
    glUseProgram(program);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, GLsizei(out.size()));
    glEndTransformFeedback();
    const auto bytes = GLsizeiptr(out.size() * sizeof(SkinnedVertex));
    const void* const captured = glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT);
    if (captured != nullptr) std::copy_n(static_cast<const SkinnedVertex*>(captured), out.size(), out.begin());
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    return out;
  }

  std::optional<render::EglContext> context_;
};

double apart(const Vec3& a, const Vec3& b) {
  return double(std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)}));
}

void expect_agreement(const std::vector<SkinnedVertex>& cpu, const std::vector<SkinnedVertex>& shader) {
  constexpr double kRounding = 3e-7;  // of numbers up to 2: a driver may fuse and reorder sums
  ASSERT_EQ(cpu.size(), shader.size());
  for (std::size_t i = 0; i < cpu.size(); ++i) {
    EXPECT_LT(apart(cpu[i].position, shader[i].position), kRounding) << i;
    EXPECT_LT(apart(cpu[i].normal, shader[i].normal), kRounding) << i;
    EXPECT_LT(apart(cpu[i].tangent, shader[i].tangent), kRounding) << i;
  }
}

TEST_F(CpuSkinning, AgreesWithTheShader) {
  struct Case {
    SkinRecord skin;
    bool is_rigid;
    const char* defines;
  };
  constexpr Case kCases[] = {{{{7, 2, 5, 3}, {40, 90, 25, 100}}, false, "#define COIF_FOUR_BONES\n"},
                             {{{6, 0, 0, 0}, {255, 0, 0, 0}}, false, "#define COIF_FOUR_BONES\n"},
                             {{{6, 0, 0, 0}, {255, 0, 0, 0}}, false, "#define COIF_ONE_BONE\n"},
                             {{{6, 0, 0, 0}, {255, 0, 0, 0}}, true, ""}};
  for (const auto& [skin, is_rigid, defines] : kCases) {
    SCOPED_TRACE(defines);
    AssetContents contents = skinned_contents(kBones, std::vector<SkinRecord>(30, skin));
    if (is_rigid) contents.skin.clear();
    AlignedBytes bytes(write_asset(contents));
    Asset asset;
    ASSERT_TRUE(asset.open(bytes.bytes()));
    const auto palette = bent_palette(kBones);
    std::vector<SkinnedVertex> cpu(asset.vertices().size());
    ASSERT_EQ(skin_vertices(asset, palette, 0, cpu), Status::kOk);
    expect_agreement(cpu, by_shader(asset, palette, defines));
  }
}

}  // namespace coif::cpu_skinning_test
