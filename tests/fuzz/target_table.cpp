#include "fuzz/targets.h"

namespace coif::fuzz {

std::span<const Target> all_targets() {
  static constexpr Target kTargets[] = {{"asset", try_asset},
                                        {"cache_entry", try_cache_entry},
                                        {"can_fail", try_can_fail},
                                        {"clip", try_clip},
                                        {"fbx_objects", try_fbx_objects},
                                        {"gltf_lines", try_gltf_lines},
                                        {"groom_stream", try_groom_stream},
                                        {"hair_file", try_hair_file},
                                        {"manifest", try_manifest},
                                        {"model_stream", try_model_stream},
                                        {"obj_lines", try_obj_lines},
                                        {"recipe", try_recipe},
                                        {"tressfx", try_tressfx},
                                        {"vrm", try_vrm}};
  return kTargets;
}

}  // namespace coif::fuzz
