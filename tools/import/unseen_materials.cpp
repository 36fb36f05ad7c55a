#include "import/gltf_scene.h"
#include "import/source_warnings.h"

#include <algorithm>

namespace coif::importer {
namespace {

constexpr float kSeen = 1e-3f;  ///< Least alpha or colour of which anything is seen.

bool is_clear(const SourceMaterial& material) {
  const bool uses_alpha = material.alpha_use == AlphaUse::kBlend || material.alpha_use == AlphaUse::kMask;
  return uses_alpha && material.base_color.w() < kSeen;
}

void warn_of_factors(const SourceMaterial& material, Diagnostics& warnings) {
  if (is_clear(material)) {
    warn(warnings, source_code::kClear,
         "material '{}': it is wholly transparent (the alpha of its base colour is 0), so that nothing of it is seen; "
         "set it to 1 and export again",
         material.name);
  } else if (material.base_texture.is_there() && material.base_color.head<3>().maxCoeff() < kSeen) {
    warn(warnings, source_code::kClear,
         "material '{}': its base colour is black, so that nothing is seen of its texture '{}'; set it to white and "
         "export again",
         material.name, material.base_texture.path);
  }
}

}  // namespace

void settle_unseen_materials(std::span<SourceMaterial> materials, Diagnostics& warnings) {
  if (materials.empty() || !std::ranges::all_of(materials, is_clear)) {
    for (const SourceMaterial& material : materials) warn_of_factors(material, warnings);
    return;
  }
  for (SourceMaterial& material : materials) {
    material.base_color.w() = 1;
    if (!material.base_texture.is_there()) material.alpha_use = AlphaUse::kOpaque;
  }
  warn(warnings, source_code::kClear,
       "every material is wholly transparent (the alpha of its base colour is 0), and nothing would be seen; they are "
       "taken for opaque but for the alpha of their textures; set it to 1 and export again");
}

}  // namespace coif::importer
