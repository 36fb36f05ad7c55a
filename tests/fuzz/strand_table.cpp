#include "fuzz/targets.h"

namespace coif::fuzz {

std::span<const Target> all_targets() {
  static constexpr Target kTargets[] = {{"can_fail", try_can_fail},         {"gltf_lines", try_gltf_lines},
                                        {"groom_stream", try_groom_stream}, {"hair_file", try_hair_file},
                                        {"obj_lines", try_obj_lines},       {"tressfx", try_tressfx}};
  return kTargets;
}

}  // namespace coif::fuzz
