#include "render/transparency_modes.h"

namespace coif {

std::span<const TransparencyMode* const> transparency_modes() {
  static constexpr const TransparencyMode* kModes[] = {&kBlendMode, &kOpaqueMode, &kCoverageMode, &kScreenDoorMode,
                                                       &kHashedMode, &kExactMode};
  return kModes;
}

}  // namespace coif
