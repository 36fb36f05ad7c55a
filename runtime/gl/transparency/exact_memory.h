#pragma once

#include "gl/gl_functions.h"
#include "gl/transparency_mode.h"

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

struct ExactFunctions {
#define COIF_GL_MEMBER(name) decltype(&gl##name) name = nullptr;
  COIF_EXACT_FUNCTIONS(COIF_GL_MEMBER)
#undef COIF_GL_MEMBER
  decltype(&glMemoryBarrier) MemoryBarrier = nullptr;  ///< OpenGL ES 3.1; null where the host does not find it.
};

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
  ListMemory lists;
  PeelMemory peel;
};

/// With all functions but those of OpenGL ES 3.1. Null, with the reason in draw.failure, where the host lacks one.
[[nodiscard]] ExactMemory* exact_memory(const ModeDraw& draw);

void release(const GlFunctions& gl, ListMemory& lists);
void release(const GlFunctions& gl, const ExactFunctions& functions, PeelMemory& peel);

}  // namespace coif
