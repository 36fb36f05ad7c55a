#include "render/gallery.h"
#include "render/picture.h"

#include <coif/research.h>

#include <array>

namespace coif::render {

std::span<const ShadowTechnique* const> shadow_techniques() {
  static constexpr std::array kAll{&kPlainShadow, &kOpacityShadow, &kDeepOpacityShadow, &kDeepShadow};
  return kAll;
}

std::span<const TransparencyMode* const> transparency_modes() {
  static constexpr const TransparencyMode* kModes[] = {
      &kBlendMode,      &kOpaqueMode,       &kCoverageMode, &kProportionalMode, &kJitteredMode,
      &kScreenDoorMode, &kCheckerboardMode, &kBayerMode,    &kHashedMode,       &kExactMode};
  return kModes;
}

std::uint32_t samples_for(const TransparencyMode& mode) { return &mode == &kExactMode ? 0 : 4; }

MaterialRecord shaded_material(const Asset& asset, ShadingModel model) {
  MaterialRecord material = own_material(asset);
  if (material.shading != model) material.light_cut = 0;
  material.shading = model;
  if (material.roughness < kLeastRoughness || model == ShadingModel::kVolume) {  // cooked for another, or without any
    material.tilt = 0.05f;
    material.roughness = model == ShadingModel::kVolume ? 0.29f : 0.14f;
    material.scatter = 0.8f;
  }
  return material;
}

}  // namespace coif::render
