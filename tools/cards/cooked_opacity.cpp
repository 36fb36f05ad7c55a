#include "cards/make_cards.h"
#include "cook/recipe/recipe.h"
#include "cook/texture/alpha.h"
#include "cook/texture/transparency.h"

#include <algorithm>

namespace coif::cards {
namespace {

/// The opacity as alpha of a white image.
cook::Image image_of(const CardSurface& surface) {
  cook::Image image{surface.width, surface.height, 4, std::vector<std::uint8_t>(4 * surface.opacity.size(), 255)};
  for (std::size_t i = 0; i < surface.opacity.size(); ++i)
    image.texels[4 * i + 3] = std::uint8_t(std::clamp(surface.opacity[i], 0.0f, 1.0f) * 255 + 0.5f);
  return image;
}

cook::Image used_texels_of(const CardSurface& surface) {
  cook::HairMesh mesh;
  mesh.uvs = surface.uvs;
  mesh.triangles = surface.triangles;
  return cook::used_texels(mesh, surface.width, surface.height);
}

}  // namespace

void draw_as_cooked(CardSurface& surface) {
  using namespace cook;
  const Image image = image_of(surface), used = used_texels_of(surface);
  surface.discard_below = float(cook::default_recipe().discard_threshold);
  surface.opaque_from =
      float(choose_opaque_threshold(alpha_histogram(image, used, 1), double(surface.discard_below)).value);
  std::vector<Image> mips = make_mips(image, kMaxImageSide, TexelMeaning::kSrgbColorAlpha);
  keep_alpha_coverage(mips, make_mips(used, kMaxImageSide, TexelMeaning::kNumbers),
                      {double(surface.opaque_from), double(surface.discard_below)});
  surface.smaller_opacity.clear();
  for (std::size_t mip = 1; mip < mips.size(); ++mip) {
    std::vector<float>& opacity = surface.smaller_opacity.emplace_back();
    for (std::size_t i = 3; i < mips[mip].texels.size(); i += 4) opacity.push_back(float(mips[mip].texels[i]) / 255.0f);
  }
}

}  // namespace coif::cards
