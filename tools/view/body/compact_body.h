#pragma once

#include "import/source_model.h"
#include "render/stage_renderer.h"
#include "view/body/page_body.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace coif::view {

/// A body that is small enough to be part of a page.
struct CompactBody {
  PageBody body;
  std::vector<std::vector<std::uint8_t>> images;  ///< WebP files.
};

inline constexpr std::size_t kMostBodyTriangles = 15'000;
inline constexpr std::uint32_t kMostBodyTexels = 1024;  ///< The longer side of an image.

/// A model with fewer triangles, where it has more than kMostBodyTriangles: as many as keep its shape to the same
/// distance everywhere. `head_bone` as BodyTurn has it. `textures`: read_body_textures().
[[nodiscard]] CompactBody compact_body(const importer::SourceModel& model, const render::BodyTextures& textures,
                                       const std::string& head_bone);

/// The body for with_body(): JSON with "meshes", base64 of body_bytes(), and "images", base64 of each.
[[nodiscard]] std::string body_json(const CompactBody& body);

}  // namespace coif::view
