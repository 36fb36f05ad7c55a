#include "base/srgb.h"
#include "base/words.h"
#include "cook/texture/base_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace coif::cook {
namespace {

/// A material without a normal map may join one with a map: the part of the map that it shows is usually flat.
bool same(const SurfaceLook& a, const SurfaceLook& b) {
  const bool is_lit_alike = a.normals == nullptr || b.normals == nullptr ||
                            (a.normals == b.normals && a.normal_use.strength == b.normal_use.strength);
  return is_lit_alike && a.image == b.image && a.strands == b.strands && std::ranges::equal(a.wrap, b.wrap) &&
         a.lacks_image == b.lacks_image && a.factor == b.factor && a.alpha_use == b.alpha_use &&
         a.alpha_cutoff == b.alpha_cutoff;
}

/// Material of each triangle; without the triangles' meshes the hair's main one.
std::vector<std::uint32_t> material_of_triangle(const importer::SourceModel& source, const HairMesh& hair) {
  std::vector<std::uint32_t> materials(hair.triangle_count(), hair.material);
  for (std::size_t t = 0; t < hair.mesh_of_triangle.size(); ++t) {
    materials[t] = source.meshes[hair.mesh_of_triangle[t]].material;
  }
  return materials;
}

/// Names that an image of this hair may bear.
std::vector<std::string> names_of_hair(const importer::SourceModel& source, const HairMesh& hair,
                                       std::span<const std::uint32_t> materials) {
  std::set<std::string> names{std::filesystem::path(source.path).stem().string()};
  for (const std::uint32_t mesh : hair.mesh_of_triangle) names.insert(source.meshes[mesh].name);
  for (const std::uint32_t material : materials) {
    if (material < source.materials.size()) names.insert(source.materials[material].name);
  }
  return {names.begin(), names.end()};
}

bool names_texture(const importer::SourceModel& source, std::uint32_t material) {
  if (material >= source.materials.size()) return false;
  const importer::SourceTexture& texture = source.materials[material].base_texture;
  return texture.image != importer::kNoIndex || !texture.path.empty();
}

SurfaceLook look_of(const importer::SourceModel& source, SourceImages& images, const WantedMaps& wanted,
                    std::uint32_t index) {
  SurfaceLook look;
  if (index >= source.materials.size()) return look;
  const importer::SourceMaterial& material = source.materials[index];
  look.name = material.name;
  look.image = wanted.opacity ? images.with_opacity(material) : images.of(material);
  look.lacks_image = look.image == nullptr && names_texture(source, index);
  if (wanted.normals) look.normals = images.normals_of(material);
  look.normal_use.strength = double(material.normal_strength);
  look.strands = images.strands_of(material);
  const importer::SourceTexture& shown =
      material.base_texture.is_there() ? material.base_texture : material.opacity_texture;
  std::ranges::copy(shown.wrap, look.wrap);
  if (says_what_it_lacks(source)) look.normal_use.green = GreenAxis::kUp;  // glTF 2.0, 3.9.3
  look.factor = color_factor(material);
  look.alpha_use = material.alpha_use;
  if (material.alpha_use == importer::AlphaUse::kMask) look.alpha_cutoff = material.alpha_cutoff;
  return look;
}

std::array<float, 256> srgb_to_linear() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = float(decode_srgb(double(i) / 255));
  }
  return table;
}

std::uint8_t linear_to_srgb(float linear) {
  return std::uint8_t(std::lround(std::clamp(encode_srgb(double(linear)), 0.0, 1.0) * 255));
}

std::uint8_t painted_alpha(const SurfaceLook& look, const JointAlpha& joint, std::uint8_t stored) {
  if (look.alpha_use == importer::AlphaUse::kOpaque) return 255;
  const float alpha = float(stored) * look.factor.w();
  const bool cut = joint.cut_masks && look.alpha_use == importer::AlphaUse::kMask;
  return cut ? (alpha >= look.alpha_cutoff * 255 ? 255 : 0) : std::uint8_t(std::lround(alpha));
}

}  // namespace

bool says_what_it_lacks(const importer::SourceModel& source) {
  const std::string suffix = std::filesystem::path(source.path).extension().string();
  return matches_any(suffix, std::vector<std::string>{".gltf", ".glb", ".vrm"});
}

Eigen::Vector4f color_factor(const importer::SourceMaterial& material) {
  return material.base_color.cwiseMax(0.0f).cwiseMin(1.0f);
}

SurfaceLooks find_looks(const importer::SourceModel& source, SourceImages& images, const HairMesh& hair,
                        const WantedMaps& wanted) {
  const std::vector<std::uint32_t> materials = material_of_triangle(source, hair);
  SurfaceLooks result;
  std::vector<std::uint32_t> look_of_material(source.materials.size() + 1, importer::kNoIndex);
  std::vector<std::size_t> triangles;
  for (const std::uint32_t material : materials) {
    std::uint32_t& look = look_of_material[std::min<std::size_t>(material, source.materials.size())];
    if (look == importer::kNoIndex) {
      const SurfaceLook found = look_of(source, images, wanted, material);
      const auto known = std::ranges::find_if(result.looks, [&](const SurfaceLook& l) { return same(l, found); });
      look = std::uint32_t(known - result.looks.begin());
      if (known == result.looks.end()) {
        result.looks.push_back(found);
      } else if (known->normals == nullptr) {
        known->normals = found.normals;
        known->normal_use = found.normal_use;
      }
      triangles.resize(result.looks.size());
    }
    result.of_triangle.push_back(look);
    ++triangles[look];
  }
  result.main = std::uint32_t(std::ranges::max_element(triangles) - triangles.begin());
  const bool untold = result.looks.size() == 1 && !says_what_it_lacks(source) &&
                      std::ranges::none_of(materials, [&](std::uint32_t m) { return names_texture(source, m); });
  // Vertex colours and a map of opacity already describe the look.
  if (!untold || hair.uvs.empty() || !hair.colors.empty() || result.looks[0].image != nullptr) return result;
  SurfaceLook& only = result.looks[0];
  only.image = images.guess(names_of_hair(source, hair, materials));
  // The grey that exporters fill in where a texture was is no colour that anybody chose.
  if (only.image != nullptr) only.factor = Eigen::Vector4f::Ones();
  return result;
}

JointAlpha join_alpha(std::span<const SurfaceLook> looks) {
  const auto all = [&](auto holds) { return std::ranges::all_of(looks, holds); };
  if (all([](const SurfaceLook& l) { return l.alpha_use == importer::AlphaUse::kOpaque; }))
    return {importer::AlphaUse::kOpaque, 0.5f, false};
  const auto mask = std::ranges::find(looks, importer::AlphaUse::kMask, &SurfaceLook::alpha_use);
  const bool solid = all([](const SurfaceLook& l) {
    return l.alpha_use == importer::AlphaUse::kOpaque || l.alpha_use == importer::AlphaUse::kMask;
  });
  const bool one_cutoff = all([&](const SurfaceLook& l) {
    return l.alpha_use != importer::AlphaUse::kMask || l.alpha_cutoff == mask->alpha_cutoff;
  });
  if (solid && one_cutoff) return {importer::AlphaUse::kMask, mask->alpha_cutoff, false};
  return {solid ? importer::AlphaUse::kMask : importer::AlphaUse::kUnknown, 0.5f, true};
}

Eigen::Vector3f mean_color(const SurfaceLook& look) {
  const std::array<float, 256> linear = srgb_to_linear();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  const bool has_alpha = look.alpha_use != importer::AlphaUse::kOpaque;
  for (std::size_t i = 0; look.image != nullptr && i < look.image->texels.size(); i += 4) {
    const std::uint8_t* c = &look.image->texels[i];
    if (has_alpha && c[3] < 128) continue;
    sum += Eigen::Vector3d(double(linear[c[0]]), double(linear[c[1]]), double(linear[c[2]]));
    ++count;
  }
  const Eigen::Vector3f mean = count > 0 ? Eigen::Vector3f((sum / count).cast<float>()) : Eigen::Vector3f::Ones();
  return mean.cwiseProduct(look.factor.head<3>());
}

Image paint(const SurfaceLook& look, const JointAlpha& joint) {
  Image image = look.image != nullptr ? *look.image : Image{1, 1, 4, {255, 255, 255, 255}};
  const std::array<float, 256> linear = srgb_to_linear();
  std::array<std::uint8_t, 256> painted[3];
  for (int channel = 0; channel < 3; ++channel) {
    for (std::size_t i = 0; i < 256; ++i) painted[channel][i] = linear_to_srgb(linear[i] * look.factor[channel]);
  }
  for (std::size_t i = 0; i < image.texels.size(); i += 4) {
    for (std::size_t k = 0; k < 3; ++k) image.texels[i + k] = painted[k][image.texels[i + k]];
    image.texels[i + 3] = painted_alpha(look, joint, image.texels[i + 3]);
  }
  return image;
}

}  // namespace coif::cook
