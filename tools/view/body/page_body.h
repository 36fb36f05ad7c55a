#pragma once

#include "render/stage_renderer.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace coif::view {

/// A mesh of a body beneath the hair. Model space, metres.
struct PageBodyMesh {
  render::SolidMesh mesh;              ///< Its texture is not part of the bytes.
  std::vector<float> turning;          ///< render::turning_shares().
  std::optional<std::uint32_t> image;  ///< Number of the image that is its texture.
};

/// A body as the page of `coif view` has it. Its images, which a browser decodes, are files beside its bytes.
struct PageBody {
  std::vector<PageBodyMesh> meshes;
};

/// Some 27 bytes per vertex: places to a 65536th of the mesh's box, normals to a hundredth of a degree, places in the
/// image to a 65536th of their range. Meshes have at most 65536 vertices.
[[nodiscard]] std::vector<std::byte> body_bytes(const PageBody& body);

/// The body of such bytes; none where they are damaged.
[[nodiscard]] std::optional<PageBody> page_body(std::span<const std::byte> bytes);

}  // namespace coif::view
