#include "render/gallery.h"
#include "render/picture.h"

#include <array>

namespace coif {

MaterialRecord shaded_material(const Asset& asset, ShadingModel model) {
  MaterialRecord material = asset.material() != nullptr ? *asset.material() : thesis_material(asset);
  if (material.shading != model) material.light_cut = 0;
  material.shading = model;
  if (material.roughness < kLeastRoughness) {  // never cooked with a recipe
    material.tilt = 0.05f;
    material.roughness = 0.14f;
    material.scatter = 0.8f;
  }
  return material;
}

std::span<const ShadowTechnique* const> shadow_techniques() {
  static constexpr std::array kAll{&kPlainShadow, &kDeepOpacityShadow};
  return kAll;
}

std::span<const TransparencyMode* const> transparency_modes() {
  static constexpr const TransparencyMode* kModes[] = {&kBlendMode,      &kOpaqueMode, &kCoverageMode,
                                                       &kScreenDoorMode, &kHashedMode, &kExactMode};
  return kModes;
}

std::uint32_t samples_for(const TransparencyMode& mode) { return &mode == &kExactMode ? 0 : 4; }

}  // namespace coif
