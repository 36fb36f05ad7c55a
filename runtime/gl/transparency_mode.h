#pragma once

#include "gl/alpha_range.h"
#include "gl/crowd_draw.h"
#include "gl/gl_functions.h"
#include "gl/passes.h"

#include <coif/asset_records.h>
#include <coif/transparency.h>

#include <cstdint>
#include <span>

namespace coif {

/// One call of HairRenderer::draw(): everything is checked, built and bound.
struct ModeDraw {
  const GlFunctions& gl;
  CrowdDraw& crowd;
  const PassList& passes;
  // For modes with objects of their own:
  const GlLoader& loader;
  ModeMemory& memory;
  std::uint32_t storage_blocks;  ///< That a fragment shader may write to.
  std::uint32_t list_bytes;
  std::span<char> failure;  ///< Text for HairRenderer::failure().
};

struct TransparencyMode {
  const char* name;
  /// The passes that draw something of an asset whose texture's alpha lies in this range.
  PassList (*plan_passes)(const MaterialRecord& material, const AlphaRange& texture);
  /// Null: all passes, once. Leaves what it sets at OpenGL's initial values. False where the driver refuses.
  bool (*draw)(const ModeDraw& draw) = nullptr;
};

}  // namespace coif
