#include "render/shadow_techniques.h"

#include <array>

namespace coif {

std::span<const ShadowTechnique* const> shadow_techniques() {
  static constexpr std::array kAll{&kPlainShadow, &kDeepOpacityShadow};
  return kAll;
}

}  // namespace coif
