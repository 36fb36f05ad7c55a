#pragma once

#include "render/gallery.h"

namespace coif::render {

/// What stands on a patch.
struct PatchLabel {
  std::string text;        ///< ASCII.
  bool is_marked = false;  ///< In red.
};

struct PatchChartSettings {
  std::uint32_t width = 800;  ///< Of one picture, pixels, 64..1024.
  std::uint32_t height = 800;
  std::string title;
};

/// Every patch of the finest level in a colour of its own, from six sides, with its label (one each) where it is seen
/// and there is room for it. Errors: kUsage for a size out of range; those of PictureMaker.
tl::expected<GallerySheet, ToolError> render_patch_chart(const Asset& asset, std::span<const PatchLabel> labels,
                                                         const PatchChartSettings& settings,
                                                         const std::function<void(const std::string&)>& progress);

}  // namespace coif::render
