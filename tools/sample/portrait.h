#pragma once

#include "sample/gltf_document.h"
#include "sample/surface_mesh.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif::sample {

/// How finely the portrait is made.
struct PortraitDetail {
  double spacing = 1;          ///< Of vertices, in the sample's.
  std::uint32_t texels = 768;  ///< Of the skin's image, across.
  bool has_shoulders = true;   ///< Without them head and neck alone, for hair that would hang into them.
};

/// What has one material.
struct PortraitPart {
  std::string name;
  SurfaceMesh mesh;  ///< Without weights; portrait_head.h has its measures.
  GltfMaterial material;
  std::optional<PaintedImage> image;  ///< Of the material.
};

/// A head with a face to show hair on: skin, eyes, lashes, and a shirt where there are shoulders.
[[nodiscard]] std::vector<PortraitPart> make_portrait_parts(const PortraitDetail& detail = {});

/// The same on root > neck > Head, as the bytes of sample_assets/portrait/portrait.glb: the same on every run.
[[nodiscard]] std::vector<std::byte> make_portrait();

}  // namespace coif::sample
