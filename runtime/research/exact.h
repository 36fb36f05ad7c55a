#pragma once
// kExactMode: lists of soft texels, or peeling by layers.

#include "gl/crowd_draw.h"

#include <coif/research.h>

#include <GLES3/gl31.h>

#include <cstdint>

// The OpenGL ES 3.0 functions that only kExactMode needs, so that no other program asks its host for them.
#define COIF_EXACT_FUNCTIONS(X) \
  X(BeginQuery)                 \
  X(BindFramebuffer)            \
  X(CheckFramebufferStatus)     \
  X(ClearBufferfv)              \
  X(ClearBufferuiv)             \
  X(DeleteFramebuffers)         \
  X(DeleteQueries)              \
  X(DrawArrays)                 \
  X(EndQuery)                   \
  X(FramebufferTexture2D)       \
  X(GenFramebuffers)            \
  X(GenQueries)                 \
  X(GetQueryObjectuiv)          \
  X(IsEnabled)

namespace coif {

COIF_GL_TABLE(ExactFunctions, COIF_EXACT_FUNCTIONS);

/// The host's viewport, in pixels of its framebuffer.
struct PixelArea {
  GLint left, bottom, width, height;
};

struct ListMemory {
  GLuint program = 0;  ///< Blends the lists into the framebuffer.
  GLuint heads = 0;    ///< Buffer objects.
  GLuint nodes = 0;
  std::uint32_t pixels = 0;
  std::uint32_t capacity = 0;  ///< Number of nodes.
};

struct PeelMemory {
  enum Texture : std::uint8_t { kDepth, kFoundDepth, kEvenLayer, kOddLayer, kTextures };
  /// Each draws into the texture of its number + 1; kDepth is the depth buffer.
  enum Framebuffer : std::uint8_t { kFindDepth, kFindEven, kFindOdd, kFramebuffers };

  GLuint textures[kTextures] = {};
  GLuint framebuffers[kFramebuffers] = {};
  GLuint query = 0;
  GLsizei width = 0;
  GLsizei height = 0;
};

/// The contents of a renderer's ModeMemory with kExactMode.
struct ExactMemory {
  ExactFunctions functions;
  decltype(&glMemoryBarrier) memory_barrier = nullptr;  ///< OpenGL ES 3.1; null where the host does not find it.
  ListMemory lists;
  PeelMemory peel;
};

void release(const GlFunctions& gl, ListMemory& lists);
void release(const GlFunctions& gl, const ExactFunctions& functions, PeelMemory& peel);

/// Stores soft texels with their depths instead of drawing them.
extern const FragmentCode kListCode;

/// Whether the driver supports lists. OpenGL ES 3.0 alone does not.
[[nodiscard]] bool has_lists(const ModeDraw& draw, const ExactMemory& memory);

/// Makes what is missing for this area. False where the driver refuses, with the reason in the renderer's failure.
[[nodiscard]] bool make_lists(const ModeDraw& draw, const PixelArea& area, ListMemory& lists);

enum class Listed : std::uint8_t { kDrawn, kOverflow, kDriver };

/// Draws the crowd's soft texels through lists, over the contents of the framebuffer. Draws nothing after an overflow.
/// Waits for the GPU. Leaves depth test and colour mask undefined, and no storage buffer bound.
[[nodiscard]] Listed draw_lists(const ModeDraw& draw, const PassList& listed, const PixelArea& area,
                                ExactMemory& memory);

/// These two find in each pixel the furthest soft texel that is not yet drawn: first its depth, then its number.
extern const FragmentCode kPeelDepthCode;
extern const FragmentCode kPeelKeyCode;
/// Draws the texel that was found.
extern const FragmentCode kPeeledCode;

/// Makes what is missing for this area. False where the driver refuses, with the reason in the renderer's failure.
/// Leaves the host's framebuffer bound.
[[nodiscard]] bool make_peel_targets(const ModeDraw& draw, const PixelArea& area, ExactMemory& memory);

struct PeelPasses {
  PassList find_depth;
  PassList find_key;
  PassList draw_found;
};

/// Draws the crowd's soft texels layer by layer, the furthest first, over the contents of the framebuffer. Waits for
/// the GPU after each layer. False where the driver refuses. Restores the host's framebuffer and polygon offset; leaves
/// the depth function undefined, and no texture bound.
[[nodiscard]] bool draw_peeled(const ModeDraw& draw, const PeelPasses& passes, ExactMemory& memory);

}  // namespace coif
