#pragma once
// Headless pictures of a cooked asset through EGL and the runtime's own renderer.

#include "import/source_model.h"
#include "motion/head_path.h"
#include "motion/motion.h"
#include "tool_error.h"

#include <coif/asset.h>
#include <coif/hair.h>
#include <coif/renderer.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace coif {

struct PictureSettings {
  std::uint32_t width = 1024;   ///< Pixels, 16..8192.
  std::uint32_t height = 768;
  double yaw_degrees = 30;      ///< 0: from the front (camera on +Z), positive: towards the model's left (+X).
  double pitch_degrees = 5;     ///< Positive: from above.
  std::optional<Motion> motion; ///< None: the settled pose at rest.
  std::shared_ptr<const HeadPath> clip;  ///< Instead of `motion`, unless null.
  double time = 0;              ///< Seconds into the motion.
  StepSettings step;
  Component component = Component::kAll;
  bool patches = false;         ///< Instead of shaded hair: each patch in a colour of its own, without holes.
  std::uint32_t lod = 0;        ///< Level of detail, below the asset's lod_count().
  const TransparencyMode* transparency = &kBlendMode;
  std::uint32_t heads = 1;      ///< Drawn in a grid.
  const SourceModel* body = nullptr;  ///< Drawn opaque instead of the collider: the source's meshes that are not hair.
  bool mannequin = true;        ///< Without `body`: draw the colliders that hair stays out of, as a plain head.
};

struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgba;  ///< Rows top to bottom, sRGB.
  std::string device;              ///< GL_RENDERER.
  double draw_ms = 0;              ///< Last frame, glFinish to glFinish.
};

/// Errors: kUnsupported where no EGL display with OpenGL ES 3.0 can be had, kBadInput for an asset without a mesh.
tl::expected<Picture, ToolError> render_picture(const Asset& asset, const PictureSettings& settings);

/// PNG bytes. Empty only when out of memory.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const Picture& picture);

}  // namespace coif
