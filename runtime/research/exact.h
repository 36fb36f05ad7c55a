#pragma once
// kExactMode: lists of soft texels, or layers that are peeled.

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

/// Where the host draws, in pixels of its framebuffer.
struct PixelArea {
  GLint left, bottom, width, height;
};

struct ListMemory {
  GLuint program = 0;  ///< Blends the lists into the framebuffer.
  GLuint heads = 0;    ///< Buffers.
  GLuint nodes = 0;
  std::uint32_t pixels = 0;
  std::uint32_t capacity = 0;  ///< Nodes.
};

struct PeelMemory {
  enum Texture : std::uint8_t { kDepth, kFoundDepth, kEvenLayer, kOddLayer, kTextures };
  /// Each draws into the texture of its number + 1, with kDepth for depth.
  enum Framebuffer : std::uint8_t { kFindDepth, kFindEven, kFindOdd, kFramebuffers };

  GLuint textures[kTextures] = {};
  GLuint framebuffers[kFramebuffers] = {};
  GLuint query = 0;
  GLsizei width = 0;
  GLsizei height = 0;
};

/// What kExactMode keeps in a renderer's ModeMemory.
struct ExactMemory {
  ExactFunctions functions;
  decltype(&glMemoryBarrier) memory_barrier = nullptr;  ///< OpenGL ES 3.1; null where the host does not find it.
  ListMemory lists;
  PeelMemory peel;
};

void release(const GlFunctions& gl, ListMemory& lists);
void release(const GlFunctions& gl, const ExactFunctions& functions, PeelMemory& peel);

/// Of soft texels, which it stores with their depths instead of drawing them.
extern const FragmentCode kListCode;

/// Whether the driver can do it at all. With OpenGL ES 3.0 alone it cannot.
[[nodiscard]] bool has_lists(const ModeDraw& draw, const ExactMemory& memory);

/// Makes what is missing for this area. False where the driver refuses, with the reason in the renderer's failure.
[[nodiscard]] bool make_lists(const ModeDraw& draw, const PixelArea& area, ListMemory& lists);

enum class Listed : std::uint8_t { kDrawn, kOverflow, kDriver };

/// Draws the crowd's soft texels through lists, over what is in the framebuffer. Draws nothing after an overflow. Waits
/// for the GPU. Leaves depth test and colour mask as it likes, and no storage buffer bound.
[[nodiscard]] Listed draw_lists(const ModeDraw& draw, const PassList& listed, const PixelArea& area,
                                ExactMemory& memory);

/// Find, in each pixel, the furthest soft texel that is not yet drawn: first its depth, then which one it is.
extern const FragmentCode kPeelDepthCode;
extern const FragmentCode kPeelKeyCode;
/// Draws the one that was found.
extern const FragmentCode kPeeledCode;

/// Makes what is missing for this area. False where the driver refuses, with the reason in the renderer's failure.
/// Leaves the host's framebuffer bound.
[[nodiscard]] bool make_peel_targets(const ModeDraw& draw, const PixelArea& area, ExactMemory& memory);

struct PeelPasses {
  PassList find_depth;
  PassList find_key;
  PassList draw_found;
};

/// Draws the crowd's soft texels layer by layer, from the furthest on, over what is in the framebuffer. Waits for the
/// GPU after each. False where the driver refuses. Restores the host's framebuffer and polygon offset; leaves the depth
/// function as it likes, and no texture bound.
[[nodiscard]] bool draw_peeled(const ModeDraw& draw, const PeelPasses& passes, ExactMemory& memory);

}  // namespace coif
