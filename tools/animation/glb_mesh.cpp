#include "animation/glb_file.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace coif {
namespace {

using nlohmann::json;
using Byte4 = std::array<std::uint8_t, 4>;
using Short4 = std::array<std::uint16_t, 4>;

struct VertexArrays {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector2f> uvs;
  std::vector<Short4> joints;
  std::vector<Byte4> weights;
};

Eigen::Vector3f unit_normal(const VertexRecord& vertex) {
  const Eigen::Vector3f normal(vertex.normal[0], vertex.normal[1], vertex.normal[2]);
  // glTF demands unit length; a mesh may still have a vertex without a direction.
  return normal.squaredNorm() > 0 ? normal.normalized() : Eigen::Vector3f::UnitY();
}

VertexArrays unpack(const Asset& asset) {
  VertexArrays arrays;
  for (const VertexRecord& vertex : asset.vertices()) {
    arrays.positions.emplace_back(vertex.position[0], vertex.position[1], vertex.position[2]);
    arrays.normals.push_back(unit_normal(vertex));
    arrays.uvs.emplace_back(vertex.uv[0], vertex.uv[1]);
  }
  for (const SkinRecord& skin : asset.skin()) {
    Short4 joints{};
    Byte4 weights{};
    for (std::size_t k = 0; k < 4; ++k) {
      weights[k] = skin.weight[k];
      joints[k] = skin.weight[k] > 0 ? skin.bone[k] : std::uint16_t{0};  // glTF: an unused joint is joint 0
    }
    arrays.joints.push_back(joints);
    arrays.weights.push_back(weights);
  }
  return arrays;
}

/// As bytes where they are wide enough: half the size.
std::size_t add_joints(GlbFile& file, const std::vector<Short4>& joints, std::size_t bones) {
  if (bones > 256) return file.add(joints, {GlbComponent::kUnsignedShort, "VEC4", GlbTarget::kVertices, false});
  std::vector<Byte4> narrow;
  for (const Short4& four : joints) {
    narrow.push_back({std::uint8_t(four[0]), std::uint8_t(four[1]), std::uint8_t(four[2]), std::uint8_t(four[3])});
  }
  return file.add(narrow, {GlbComponent::kUnsignedByte, "VEC4", GlbTarget::kVertices, false});
}

json attributes(GlbFile& file, const VertexArrays& arrays, std::size_t bones) {
  const auto floats = [](const char* type) {
    return GlbArray{GlbComponent::kFloat, type, GlbTarget::kVertices, false};
  };
  json result;
  const std::size_t positions = file.add(arrays.positions, floats("VEC3"));
  file.add_bounds(positions, {arrays.positions.data()->data(), arrays.positions.size() * 3}, 3);
  result["POSITION"] = positions;
  result["NORMAL"] = file.add(arrays.normals, floats("VEC3"));
  result["TEXCOORD_0"] = file.add(arrays.uvs, floats("VEC2"));
  if (!arrays.joints.empty()) {
    const GlbArray shares{GlbComponent::kUnsignedByte, "VEC4", GlbTarget::kVertices, true};
    result["JOINTS_0"] = add_joints(file, arrays.joints, bones);
    result["WEIGHTS_0"] = file.add(arrays.weights, shares);
  }
  return result;
}

json hair_material(GlbFile& file, const MaterialRecord* record, std::span<const std::uint8_t> base_color_png) {
  json surface = {{"metallicFactor", 0}, {"roughnessFactor", 0.6}};
  if (record) surface["baseColorFactor"] = record->base_color;
  json material = {{"name", "hair"}, {"doubleSided", !record || (record->flags & kMaterialDoubleSided) != 0}};
  if (!base_color_png.empty()) {
    const std::size_t view = file.add_view(std::as_bytes(base_color_png));
    file.document["images"] = json::array({{{"bufferView", view}, {"mimeType", "image/png"}}});
    file.document["textures"] = json::array({{{"source", 0}}});
    surface["baseColorTexture"] = {{"index", 0}};
    // Viewers do not draw patches in the cooked order, so blending would show the far side through the near one.
    material["alphaMode"] = "MASK";
  }
  material["pbrMetallicRoughness"] = std::move(surface);
  return material;
}

}  // namespace

void add_hair_mesh(GlbFile& file, const Asset& asset, std::span<const std::uint8_t> base_color_png) {
  json primitive = {{"attributes", attributes(file, unpack(asset), asset.bones().size())}, {"material", 0}};
  primitive["indices"] =
      file.add(asset.lod_indices(0), {GlbComponent::kUnsignedInt, "SCALAR", GlbTarget::kIndices, false});
  file.document["meshes"] = json::array({{{"name", "hair"}, {"primitives", json::array({std::move(primitive)})}}});
  file.document["materials"] = json::array({hair_material(file, asset.material(), base_color_png)});
}

}  // namespace coif
