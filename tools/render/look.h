#pragma once

#include "render/gallery.h"

namespace coif::render {

struct LookSettings {
  std::uint32_t width = 280;  ///< Of one picture, pixels, 64..1024.
  std::uint32_t height = 280;
  std::string title;  ///< Above all pictures.
  std::vector<std::string>
      told;  ///< What the cook had to say, a paragraph each, below them; other bytes than ASCII are replaced.
};

/// One sheet that shows whether a cook came out right: the hair from all sides, its patches and the direction of its
/// strands, the colliders through the hair, moments of three motions, the base texture and its alpha, and what the cook
/// said. Errors: kUsage for a size out of range; those of PictureMaker.
tl::expected<GallerySheet, ToolError> render_look(const Asset& asset, const LookSettings& settings,
                                                  const std::function<void(const std::string&)>& progress);

}  // namespace coif::render
