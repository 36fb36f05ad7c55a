#include "render/transparency_modes.h"

namespace coif {

std::span<const TransparencyMode* const> transparency_modes() {
  static constexpr const TransparencyMode* kModes[] = {&kBlendMode,      &kOpaqueMode, &kCoverageMode,
                                                       &kScreenDoorMode, &kHashedMode, &kExactMode};
  return kModes;
}

std::uint32_t samples_for(const TransparencyMode& mode) { return &mode == &kExactMode ? 0 : 4; }

}  // namespace coif
