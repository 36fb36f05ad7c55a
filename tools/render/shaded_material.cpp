#include "render/shaded_material.h"

#include "render/gallery_material.h"

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

}  // namespace coif
