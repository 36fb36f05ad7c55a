#pragma once

#include "base/tool_error.h"
#include "render/egl_context.h"
#include "render/stage_renderer.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <deque>
#include <vector>

namespace coif::render {

// Things that the pictures of one OpenGL context share: with a software driver, programs and memory for a small picture
// take longer to make than the picture. They are freed with the context.

/// Stages by what is on them.
class KeptStages {
 public:
  /// The stage that shows these meshes, made if it is not among the last few. Valid until the next call. With a shadow
  /// it is always made, since its program knows the shadow's textures. Errors: those of StageRenderer::create().
  tl::expected<const StageRenderer*, ToolError> with(std::vector<SolidMesh> meshes, const HairShadow* shadow,
                                                     const BodyLook& look);

 private:
  struct Kept {
    std::vector<SolidMesh> meshes;
    BodyLook look;
    bool has_shadow = false;
    StageRenderer stage;
  };
  [[nodiscard]] const StageRenderer* find(const std::vector<SolidMesh>& meshes, const BodyLook& look) const;

  std::deque<Kept> kept_;
};

/// Framebuffers of half floats by their size.
class KeptTargets {
 public:
  /// Valid as long as this object. Holds the last picture that was drawn to it. Errors: those of
  /// OffscreenTarget::create().
  tl::expected<const OffscreenTarget*, ToolError> of_size(std::uint32_t width, std::uint32_t height,
                                                          std::uint32_t samples);

 private:
  struct Kept {
    std::uint32_t width = 0, height = 0, samples = 0;
    OffscreenTarget target;
  };

  std::deque<Kept> kept_;
};

}  // namespace coif::render
