#include "render/body_textures.h"

#include "cook/texture/source_images.h"

#include <map>

namespace coif::render {

BodyTextures read_body_textures(const importer::SourceModel& model, cook::Findings& findings) {
  constexpr std::uint32_t kLargest = 2048;
  std::vector<bool> is_shown(model.materials.size());
  for (const importer::SourceMesh& mesh : model.meshes) {
    if (mesh.material < is_shown.size() && !mesh.uvs.empty()) is_shown[mesh.material] = true;
  }
  cook::SourceImages images(model);
  std::map<const cook::Image*, std::shared_ptr<const SolidTexture>> known;  // looked up only
  BodyTextures textures(model.materials.size());
  for (std::size_t m = 0; m < textures.size(); ++m) {
    const cook::Image* const image = is_shown[m] ? images.of(model.materials[m]) : nullptr;
    if (image == nullptr) continue;
    std::shared_ptr<const SolidTexture>& texture = known[image];
    if (texture == nullptr) {
      cook::Image small = cook::reduce(*image, kLargest, cook::TexelMeaning::kSrgbColorAlpha);
      texture = std::make_shared<SolidTexture>(small.width, small.height, std::move(small.texels));
    }
    textures[m] = texture;
  }
  for (const Diagnostic& warning : images.findings().warnings) findings.warnings.push_back(warning);
  return textures;
}

}  // namespace coif::render
