#include "cook/select/hair_evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif::cook {
namespace {

using importer::SourceMesh, importer::SourceModel, importer::material_name;

const importer::SourceMaterial* material_of(const SourceModel& source, const SourceMesh& mesh) {
  return mesh.material < source.materials.size() ? &source.materials[mesh.material] : nullptr;
}

/// The file's own name of a texture, without the folders of the artist's machine.
std::string texture_name(const SourceModel& source, const SourceMesh& mesh) {
  const importer::SourceMaterial* material = material_of(source, mesh);
  if (!material) return "";
  const importer::SourceTexture& texture = material->base_texture;
  const std::string& name = texture.image < source.images.size() ? source.images[texture.image].name : texture.path;
  const std::size_t slash = name.find_last_of("/\\");
  return slash == std::string::npos ? name : name.substr(slash + 1);
}

/// Another part of the same mesh has a material with a hair name: then this part is worn in the hair.
bool has_hair_beside(const SourceModel& source, const SourceMesh& mesh) {
  return std::ranges::any_of(source.meshes, [&](const SourceMesh& other) {
    return other.node == mesh.node && is_called_hair(material_name(source, other));
  });
}

std::string why_hair(const SourceModel& source, const SourceMesh& mesh) {
  const std::string material = material_name(source, mesh), texture = texture_name(source, mesh);
  if (is_called_hair(material)) return fmt::format("its material is called '{}'", material);
  if (is_called_adornment(material) || has_hair_beside(source, mesh)) return "";
  if (is_called_hair(mesh.name)) return "its name says so";
  if (is_called_beard(material) || is_called_beard(mesh.name)) return "it is called a beard";
  if (!is_called_adornment(mesh.name) && is_called_hair(texture)) {
    return fmt::format("its texture is called '{}'", texture);
  }
  return "";
}

}  // namespace

HairNames names_of(const SourceModel& source, const SourceMesh& mesh) {
  HairNames names;
  names.why_hair = why_hair(source, mesh);
  const std::string material = material_name(source, mesh);
  names.say_otherwise = either_is_called(source, mesh, is_called_headwear) ||
                        either_is_called(source, mesh, is_called_adornment) || is_called_skin(material) ||
                        is_called_face_part(material) || is_called_face_part(mesh.name);
  return names;
}

bool is_transparent(const SourceModel& source, const SourceMesh& mesh) {
  const importer::SourceMaterial* material = material_of(source, mesh);
  if (!material) return false;
  return material->alpha_use == importer::AlphaUse::kBlend || material->alpha_use == importer::AlphaUse::kMask ||
         is_called_transparent(material->name) || is_called_transparent(texture_name(source, mesh));
}

std::optional<Eigen::Vector3f> color_without_texture(const SourceModel& source, const SourceMesh& mesh, std::size_t t) {
  if (mesh.material >= source.materials.size()) return std::nullopt;
  const importer::SourceMaterial& material = source.materials[mesh.material];
  if (material.base_texture.is_there()) return std::nullopt;
  Eigen::Vector3f linear = material.base_color.head<3>();
  if (!mesh.colors.empty()) {
    Eigen::Vector4f sum = Eigen::Vector4f::Zero();
    for (std::size_t k = 0; k < 3; ++k) sum += mesh.colors[mesh.triangles[3 * t + k]];
    linear = linear.cwiseProduct(sum.head<3>() / 3);
  }
  return linear.unaryExpr([](float value) { return std::pow(std::clamp(value, 0.0f, 1.0f), 1 / 2.2f); });
}

}  // namespace coif::cook
