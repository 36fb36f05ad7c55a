#include "gl/shader_programs.h"

#include "gl/shadow/shadow_state.h"
#include "gl/textures.h"

#include <coif/shading_models.h>

#include <hair_shaders.h>

#include <cstdio>

namespace coif {
namespace {

// highp everywhere: with mediump, exponents of some thousands leave no highlight.
constexpr char kPrecision[] = "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";

GLuint compile(const GlFunctions& gl, GLenum stage, const char* version, std::span<const char* const> pieces,
               std::span<char> log) {
  const GLchar* sources[2 + kMaxPieces] = {version, kPrecision};
  GLsizei count = 2;
  for (const char* piece : pieces.first(pieces.size() < kMaxPieces ? pieces.size() : kMaxPieces)) {
    sources[count++] = piece;
  }
  const GLuint shader = gl.CreateShader(stage);
  if (shader == 0) return 0;
  gl.ShaderSource(shader, count, sources, nullptr);
  gl.CompileShader(shader);
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled != GL_FALSE) return shader;
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteShader(shader);
  return 0;
}

GLuint link(const GlFunctions& gl, GLuint vertex, GLuint fragment, std::span<char> log) {
  const GLuint program = gl.CreateProgram();
  if (program == 0) return 0;
  gl.AttachShader(program, vertex);
  gl.AttachShader(program, fragment);
  gl.LinkProgram(program);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked != GL_FALSE) return program;
  gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteProgram(program);
  return 0;
}

struct Define {
  std::uint32_t bit;
  const char* line;
};

constexpr Define kDefines[] = {
    {variant::kFourBones, "#define COIF_FOUR_BONES\n"},
    {variant::kOneBone, "#define COIF_ONE_BONE\n"},
    {variant::kBonesInTexture, "#define COIF_BONES_IN_TEXTURE\n"},
    {variant::kBaseTexture, "#define COIF_BASE_TEXTURE\n"},
    {variant::kShiftMask, "#define COIF_SHIFT_MASK\n"},
    {variant::kNormalMap, "#define COIF_NORMAL_MAP\n"},
    {variant::kStrandMap, "#define COIF_STRAND_MAP\n"},
    {variant::kPrimary, "#define COIF_PRIMARY\n"},
    {variant::kSecondary, "#define COIF_SECONDARY\n"},
    {variant::kAlphaTest, "#define COIF_ALPHA_TEST\n"},
    {variant::kShadow, "#define COIF_SHADOW\n"},
    {variant::kMotion, "#define COIF_MOTION\n"},
    {variant::kStrandTerms, "#define COIF_STRAND_TERMS\n"},
    {variant::kVolumeNormals, "#define COIF_VOLUME_NORMALS\n"},
};

/// One shader's source: the lines of its bits, then files of shaders/.
class Source {
 public:
  explicit Source(std::uint32_t bits) {
    for (const Define& define : kDefines) {
      if ((bits & define.bit) != 0) add(define.line);
    }
  }
  Source& add(const char* piece) {
    pieces_[count_++] = piece;
    return *this;
  }
  [[nodiscard]] std::span<const char* const> pieces() const { return std::span(pieces_).first(count_); }

 private:
  const char* pieces_[kMaxPieces] = {};
  std::size_t count_ = 0;
};

Source vertex_source(std::uint32_t bits, const FragmentCode& code, const char* block_rows) {
  Source source(bits);
  source.add(code.vertex).add(block_rows).add(kShaderDrawBlockGlsl).add(kShaderHairVert).add(code.vertex_end);
  return source;
}

/// In the order of ShadingModel.
constexpr const char* kShadingPieces[] = {kShaderShadingThesisGlsl, kShaderShadingKajiyaKayGlsl,
                                          kShaderShadingMarschnerGlsl, kShaderShadingVolumeGlsl};
static_assert(sizeof kShadingPieces / sizeof kShadingPieces[0] == kShadingModelCount);
static_assert(kShadingModelCount <= variant::kModel >> variant::kModelShift);

Source fragment_source(std::uint32_t bits, const Pass& pass) {
  const FragmentCode& code = *pass.code;
  Source source(bits);
  source.add(kShaderDrawBlockGlsl).add(kShaderHairBaseGlsl).add(code.shared).add(code.keep);
  if ((bits & variant::kShadow) != 0) source.add(pass.shadow->pieces[0]).add(pass.shadow->pieces[1]);
  if (code.other != nullptr) return source.add(code.other);
  if ((bits & (variant::kShaded | variant::kDirection)) == 0) return source.add(kShaderHairDepthFrag);
  source.add(kShaderHairEncodeGlsl).add(code.output).add(kShaderHairSurfaceGlsl);
  if ((bits & variant::kShaded) != 0) {
    const char* const model = kShadingPieces[(bits & variant::kModel) >> variant::kModelShift];
    if ((bits & (variant::kNormalMap | variant::kStrandMap)) != 0) source.add(kShaderReliefGlsl);
    return source.add(kShaderShadingGlsl).add(model).add(kShaderHairFrag);
  }
  return source.add(kShaderHairDirectionFrag);
}

void bind_block(const GlFunctions& gl, GLuint program, const char* name, GLuint index) {
  const GLuint block = gl.GetUniformBlockIndex(program, name);
  if (block != GL_INVALID_INDEX) gl.UniformBlockBinding(program, block, index);
}

void bind_shadow_textures(const GlFunctions& gl, GLuint program, const ShadowLookup& shadow) {
  GLint unit = kShadowUnit;
  for (const char* const name : shadow.samplers) {
    if (name != nullptr) gl.Uniform1i(gl.GetUniformLocation(program, name), unit);
    ++unit;
  }
}

void bind_textures_and_blocks(const GlFunctions& gl, GLuint program, const Pass& pass) {
  gl.UseProgram(program);  // A texture that the program does not use has location -1, which is ignored.
  gl.Uniform1i(gl.GetUniformLocation(program, "base_texture"), kBaseUnit);
  gl.Uniform1i(gl.GetUniformLocation(program, "shift_mask_texture"), kShiftMaskUnit);
  gl.Uniform1i(gl.GetUniformLocation(program, "normal_texture"), kNormalUnit);
  gl.Uniform1i(gl.GetUniformLocation(program, "strand_texture"), kStrandUnit);
  gl.Uniform1i(gl.GetUniformLocation(program, "palette_texture"), kPaletteUnit);
  if (pass.shadow != nullptr) bind_shadow_textures(gl, program, *pass.shadow);
  for (const FragmentCode::Sampler& sampler : pass.code->samplers) {
    if (sampler.name != nullptr) gl.Uniform1i(gl.GetUniformLocation(program, sampler.name), sampler.unit);
  }
  gl.UseProgram(0);
  bind_block(gl, program, "DrawBlock", kDrawIndex);
  bind_block(gl, program, "PaletteBlock", kPaletteIndex);
}

const char* version_of(const FragmentCode& code) {
  if (code.sample_mask == FragmentCode::SampleMask::kWritten) return kGlsl320;
  return code.storage_blocks > 0 ? kGlsl310 : kGlsl300;
}

bool is_black(const float (&color)[3]) { return color[0] == 0.0f && color[1] == 0.0f && color[2] == 0.0f; }

std::uint32_t canonical(std::uint32_t bits, bool writes_other) {
  using namespace variant;
  if ((bits & (kFourBones | kOneBone)) == 0) bits &= ~kBonesInTexture;
  if ((bits & kShaded) == 0)
    bits &= ~(kPrimary | kSecondary | kModel | kNormalMap | kStrandMap | kStrandTerms | kVolumeNormals);
  if ((bits & (kPrimary | kSecondary | kStrandTerms)) == 0) bits &= ~kShiftMask;
  if ((bits & kShaded) == 0 && !writes_other) bits &= ~kShadow;
  if ((bits & (kShaded | kDirection | kAlphaTest)) == 0 && !writes_other)
    bits &= ~kBaseTexture;  // Depth of whole triangles needs no texture.
  return bits;
}

/// The bits of the model, and of the highlights that it has with this material.
std::uint32_t shading_bits(const MaterialRecord& material) {
  const auto model = static_cast<std::uint32_t>(material.shading);
  const ShadingTraits& traits = kShadingModels[model];
  const bool is_any = !traits.has_colored_highlights;
  const bool primary = traits.has_primary && (is_any || !is_black(material.primary_color));
  const bool secondary = traits.has_secondary && (is_any || !is_black(material.secondary_color));
  return model << variant::kModelShift | (primary ? variant::kPrimary : 0) | (secondary ? variant::kSecondary : 0);
}

}  // namespace

GLuint build_program(const GlFunctions& gl, const char* version, std::span<const char* const> vertex,
                     std::span<const char* const> fragment, std::span<char> log) {
  const GLuint vertex_shader = compile(gl, GL_VERTEX_SHADER, version, vertex, log);
  if (vertex_shader == 0) return 0;
  const GLuint fragment_shader = compile(gl, GL_FRAGMENT_SHADER, version, fragment, log);
  const GLuint program = fragment_shader == 0 ? 0 : link(gl, vertex_shader, fragment_shader, log);
  // Deleting only marks shaders; a linked program keeps what it needs.
  gl.DeleteShader(vertex_shader);
  gl.DeleteShader(fragment_shader);
  return program;
}

std::uint32_t variant_of(const Pass& pass, std::uint32_t needs, const MaterialRecord& material, Component component) {
  std::uint32_t bits = needs;
  if (pass.tests_alpha) bits |= variant::kAlphaTest;
  if (pass.shaded) bits |= component == Component::kDirection ? variant::kDirection : variant::kShaded;
  bits |= shading_bits(material);
  if (has_strand_terms(material)) bits |= variant::kStrandTerms;
  if ((material.flags & kMaterialVolumeNormals) != 0) bits |= variant::kVolumeNormals;
  if (pass.shadow != nullptr) bits |= pass.shadow->id << variant::kShadowShift;
  return canonical(bits, pass.code->other != nullptr) | pass.code->id << variant::kCodeShift;
}

GLuint build_variant(const GlFunctions& gl, std::uint32_t bits, const Pass& pass, std::uint32_t block_rows,
                     std::span<char> log) {
  char rows[48];
  std::snprintf(rows, sizeof rows, "#define COIF_PALETTE_ROWS %u\n", unsigned{block_rows});
  const GLuint program = build_program(gl, version_of(*pass.code), vertex_source(bits, *pass.code, rows).pieces(),
                                       fragment_source(bits, pass).pieces(), log);
  if (program != 0) bind_textures_and_blocks(gl, program, pass);
  return program;
}

}  // namespace coif
