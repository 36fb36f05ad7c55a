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

}  // namespace coif::render
