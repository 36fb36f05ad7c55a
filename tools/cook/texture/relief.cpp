#include "cook/texture/relief.h"

#include "cook/recipe/drawn_recipe.h"
#include "cook/texture/transparency.h"

#include <fmt/format.h>

namespace coif::cook {
namespace {

/// In numbers of two_sided(): nobody sees relief that is flatter or less certain than this.
constexpr double kLeastRms = 0.02;

/// Root mean square of both numbers where the hair shows them.
double rms_of(const Image& image, const Image& used) {
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < used.texels.size(); ++i) {
    if (used.texels[i] == 0) continue;
    for (const std::size_t channel : {0u, 1u}) {
      const double value = double(two_sided(float(image.texels[2 * i + channel]) / 255));
      squares += value * value;
    }
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

/// Blue and alpha of the map of known strands.
Image known_axes(const Image& strands) {
  Image axes{strands.width, strands.height, 2, {}};
  axes.texels.reserve(2 * axes.texel_count());
  for (std::size_t i = 0; i < axes.texel_count(); ++i) {
    axes.texels.insert(axes.texels.end(), {strands.texels[4 * i + 2], strands.texels[4 * i + 3]});
  }
  return axes;
}

}  // namespace

TexelFormat two_channel_format(const DrawnRecipe& recipe) {
  return recipe.shift_mask_format == ShiftMaskFormat::kEac ? TexelFormat::kRg11Eac : TexelFormat::kRg8;
}

StoredTextures bake_relief(const Image* normals, const Image* strands, const HairMesh& hair, const MapForm& form,
                           const platform::Threads& threads, Findings& findings) {
  StoredTextures stored;
  const auto keep = [&](TextureRole role, const char* name, Image image) {
    image = reduce(std::move(image), form.max_size, TexelMeaning::kNumbers);
    const Image used = used_texels(hair, image.width, image.height);
    if (rms_of(image, used) < kLeastRms) {
      return findings.leave_out({name, "it says nothing where the hair shows it", bytes_with_mips(form.format, image)});
    }
    DetailedImage detailed = reduce_to_detail(std::move(image), used, TexelMeaning::kNumbers);
    const std::vector<Image> mips = make_mips(std::move(detailed.image), form.max_size, TexelMeaning::kNumbers);
    findings.note(fmt::format("{}: {} x {} texels", name, mips[0].width, mips[0].height));
    stored.append(role, form.format, mips, threads);
  };
  if (normals != nullptr) keep(TextureRole::kNormal, "map of normals", *normals);
  const char* const axes = "map of how strands run";
  if (strands != nullptr) {
    keep(TextureRole::kStrandAxis, axes, known_axes(*strands));
  } else if (normals != nullptr) {
    keep(TextureRole::kStrandAxis, axes, strand_axes(*normals));
  }
  return stored;
}

}  // namespace coif::cook
