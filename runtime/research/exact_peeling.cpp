#include "research/exact.h"

#include "gl/textures.h"

#include <hair_shaders.h>

#include <cstdint>
#include <cstdio>

namespace coif {
namespace {

constexpr GLuint kBehindAll[4] = {0xFFFFFFFF, 0xFFFFFFFF, 0, 0};  // All texels are left to be peeled.
constexpr GLuint kBeforeAll[4] = {0, 0xFFFFFFFF, 0, 0};           // No texel is left.
constexpr int kMostLayers = 4096;  // More than there ever are. Stops a driver that always finds one more.

GLuint host_framebuffer(const GlFunctions& gl) {
  GLint name = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name);
  return static_cast<GLuint>(name);
}

bool make_framebuffers(const ExactFunctions& functions, PeelMemory& peel) {
  functions.GenFramebuffers(PeelMemory::kFramebuffers, peel.framebuffers);
  bool is_whole = true;
  for (std::uint32_t i = 0; i < PeelMemory::kFramebuffers; ++i) {
    functions.BindFramebuffer(GL_DRAW_FRAMEBUFFER, peel.framebuffers[i]);
    functions.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D,
                                   peel.textures[PeelMemory::kDepth], 0);
    functions.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, peel.textures[i + 1], 0);
    is_whole = is_whole && functions.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
  return is_whole;
}

bool make_textures(const GlFunctions& gl, PeelMemory& peel) {
  constexpr GLenum kFormats[PeelMemory::kTextures] = {GL_DEPTH_COMPONENT32F, GL_R32UI, GL_RG32UI, GL_RG32UI};
  gl.ActiveTexture(GL_TEXTURE0 + kPeeledUnit);
  clear_errors(gl);
  for (std::uint32_t i = 0; i < PeelMemory::kTextures; ++i) {
    peel.textures[i] = make_texture(gl, kFormats[i], peel.width, peel.height);
  }
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return gl.GetError() == GL_NO_ERROR;
}

/// Peels one draw call of the crowd.
class Peeling {
 public:
  Peeling(const ModeDraw& draw, const PeelPasses& passes, const ExactMemory& memory)
      : gl_(draw.renderer.gl),
        crowd_(draw.crowd),
        passes_(passes),
        functions_(memory.functions),
        peel_(memory.peel),
        host_(host_framebuffer(draw.renderer.gl)) {}

  bool run() {
    allow_writes();
    clear_layer(PeelMemory::kFindOdd, kBehindAll);
    bool is_good = true, is_found = true;
    for (int layer = 0; layer < kMostLayers && is_good && is_found; ++layer) {
      is_good = find_depth(layer, is_found);
      if (is_good && is_found) is_good = find_key(layer) && draw_found(layer);
    }
    functions_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, host_);
    unbind_texture(gl_, kPeeledUnit);
    unbind_texture(gl_, kFoundUnit);
    return is_good;
  }

 private:
  [[nodiscard]] static PeelMemory::Framebuffer target_of(int layer) {
    return layer % 2 == 0 ? PeelMemory::kFindEven : PeelMemory::kFindOdd;
  }
  [[nodiscard]] GLuint texture_of(int layer) const { return peel_.textures[target_of(layer) + 1]; }

  /// Clearing obeys both masks.
  void allow_writes() const {
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.DepthMask(GL_TRUE);
  }

  void clear_layer(PeelMemory::Framebuffer target, const GLuint (&color)[4]) const {
    functions_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, peel_.framebuffers[target]);
    functions_.ClearBufferuiv(GL_COLOR, 0, color);
  }

  void clear_depth(GLfloat depth) const { functions_.ClearBufferfv(GL_DEPTH, 0, &depth); }

  bool find_depth(int layer, bool& is_found) const {
    allow_writes();
    clear_layer(PeelMemory::kFindDepth, kBeforeAll);
    clear_depth(0);
    gl_.DepthFunc(GL_GEQUAL);
    bind_texture(gl_, kPeeledUnit, texture_of(layer + 1));
    functions_.BeginQuery(GL_ANY_SAMPLES_PASSED, peel_.query);
    const bool is_drawn = crowd_.draw(passes_.find_depth);
    functions_.EndQuery(GL_ANY_SAMPLES_PASSED);
    GLuint passed = GL_FALSE;
    functions_.GetQueryObjectuiv(peel_.query, GL_QUERY_RESULT, &passed);
    is_found = passed != GL_FALSE;
    return is_drawn;
  }

  bool find_key(int layer) const {
    allow_writes();
    clear_layer(target_of(layer), kBeforeAll);
    clear_depth(1);
    gl_.DepthFunc(GL_LESS);
    bind_texture(gl_, kFoundUnit, peel_.textures[PeelMemory::kFoundDepth]);
    return crowd_.draw(passes_.find_key);
  }

  bool draw_found(int layer) const {
    functions_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, host_);
    gl_.DepthFunc(GL_LEQUAL);
    bind_texture(gl_, kPeeledUnit, texture_of(layer));
    return crowd_.draw(passes_.draw_found);
  }

  const GlFunctions& gl_;
  CrowdDraw& crowd_;
  const PeelPasses& passes_;
  const ExactFunctions& functions_;
  const PeelMemory& peel_;
  GLuint host_;
};

}  // namespace

const FragmentCode kPeelDepthCode = {.id = 5,
                                     .keep = kShaderKeepRangeGlsl,
                                     .output = nullptr,
                                     .other = kShaderPeelDepthFrag,
                                     .shared = kShaderPeelPlaceGlsl,
                                     .vertex = "#define COIF_CORNER\n",
                                     .samplers = {{"peeled_layer", kPeeledUnit}, {}}};

const FragmentCode kPeelKeyCode = {.id = 6,
                                   .keep = kShaderKeepRangeGlsl,
                                   .output = nullptr,
                                   .other = kShaderPeelKeyFrag,
                                   .shared = kShaderPeelPlaceGlsl,
                                   .vertex = "#define COIF_CORNER\n",
                                   .samplers = {{"peeled_layer", kPeeledUnit}, {"found_layer", kFoundUnit}}};

const FragmentCode kPeeledCode = {.id = 7,
                                  .keep = kShaderKeepPeeledGlsl,
                                  .output = kShaderHairOutputGlsl,
                                  .shared = kShaderPeelPlaceGlsl,
                                  .vertex = "#define COIF_CORNER\n",
                                  .samplers = {{"peeled_layer", kPeeledUnit}, {}}};

bool make_peel_targets(const ModeDraw& draw, const PixelArea& area, ExactMemory& memory) {
  PeelMemory& peel = memory.peel;
  // Texels keep their places in the host's framebuffer.
  const GLsizei width = area.left + area.width, height = area.bottom + area.height;
  if (peel.query != 0 && width <= peel.width && height <= peel.height) return true;
  release(draw.renderer.gl, memory.functions, peel);
  peel.width = width;
  peel.height = height;
  const GLuint host = host_framebuffer(draw.renderer.gl);
  const bool is_made = make_textures(draw.renderer.gl, peel) && make_framebuffers(memory.functions, peel);
  memory.functions.BindFramebuffer(GL_DRAW_FRAMEBUFFER, host);
  memory.functions.GenQueries(1, &peel.query);
  if (is_made) return true;
  release(draw.renderer.gl, memory.functions, peel);
  std::snprintf(draw.renderer.failure, sizeof draw.renderer.failure, "no memory for layers of %d x %d pixels",
                int{width}, int{height});
  return false;
}

// The depth of a texel must be the same to the bit when it is found and when it is drawn, for every format of the
// host's depth buffer. Polygon offset depends on the format.
bool draw_peeled(const ModeDraw& draw, const PeelPasses& passes, ExactMemory& memory) {
  const bool has_offset = memory.functions.IsEnabled(GL_POLYGON_OFFSET_FILL) != GL_FALSE;
  if (has_offset) draw.renderer.gl.Disable(GL_POLYGON_OFFSET_FILL);
  const bool is_drawn = Peeling(draw, passes, memory).run();
  if (has_offset) draw.renderer.gl.Enable(GL_POLYGON_OFFSET_FILL);
  return is_drawn;
}

void release(const GlFunctions& gl, const ExactFunctions& functions, PeelMemory& peel) {
  functions.DeleteFramebuffers(PeelMemory::kFramebuffers, peel.framebuffers);
  gl.DeleteTextures(PeelMemory::kTextures, peel.textures);
  functions.DeleteQueries(1, &peel.query);
  peel = {};
}

}  // namespace coif
