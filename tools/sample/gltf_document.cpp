#include "sample/gltf_document.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace coif::sample {
namespace {

using Json = nlohmann::ordered_json;

// Names from the specification, tables of section 3.6.
constexpr int kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
constexpr int kVertexTarget = 34962, kIndexTarget = 34963, kNoTarget = 0;

/// Rounds to 2^-16: the file's bytes then do not depend on the last bit of a platform's sin() or exp().
float rounded(double value) {
  constexpr double kSteps = 65536.0;
  return static_cast<float>(std::round(value * kSteps) / kSteps);
}

Json as_json(const Eigen::Vector3d& v) { return {rounded(v.x()), rounded(v.y()), rounded(v.z())}; }

void append_word(std::vector<std::uint8_t>& out, std::size_t value) {
  for (unsigned shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

void append_chunk(std::vector<std::uint8_t>& out, const char* type, const void* bytes, std::size_t size, char padding) {
  const std::size_t padded = (size + 3) / 4 * 4;
  append_word(out, padded);
  out.insert(out.end(), type, type + 4);
  const auto* begin = static_cast<const std::uint8_t*>(bytes);
  out.insert(out.end(), begin, begin + size);
  out.insert(out.end(), padded - size, static_cast<std::uint8_t>(padding));
}

}  // namespace

GltfDocument::GltfDocument() {
  json_["asset"] = {{"version", "2.0"}, {"generator", "coif_make_sample"}};
  json_["scene"] = 0;
  json_["scenes"] = {{{"nodes", Json::array()}}};
}

void GltfDocument::set_skeleton(const std::vector<Joint>& joints, double per_metre) {
  const auto stored = [per_metre](double metres) { return std::round(metres * per_metre) / per_metre; };
  Json indices = Json::array();
  std::vector<float> inverse_binds;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Joint& joint = joints[i];
    const bool is_root = joint.parent < 0;
    const Eigen::Vector3d parent =
        is_root ? Eigen::Vector3d::Zero() : joints[static_cast<std::size_t>(joint.parent)].position;
    const Eigen::Vector3d offset = (joint.position - parent).unaryExpr(stored);
    json_["nodes"].push_back({{"name", joint.name}, {"translation", {offset.x(), offset.y(), offset.z()}}});
    if (is_root)
      json_["scenes"][0]["nodes"].push_back(i);
    else
      json_["nodes"][static_cast<std::size_t>(joint.parent)]["children"].push_back(i);
    indices.push_back(i);
    const Eigen::Vector3f p = -joint.position.unaryExpr(stored).cast<float>();
    inverse_binds.insert(inverse_binds.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, p.x(), p.y(), p.z(), 1});
  }
  const std::size_t view = add_view(inverse_binds.data(), inverse_binds.size() * sizeof(float), kNoTarget);
  const std::size_t matrices = add_accessor(view, kFloat, "MAT4", joints.size());
  json_["skins"] = {{{"inverseBindMatrices", matrices}, {"skeleton", 0}, {"joints", indices}}};
}

void GltfDocument::set_image(const std::string& name, const std::vector<std::uint8_t>& png) {
  const std::size_t view = add_view(png.data(), png.size(), kNoTarget);
  json_["images"] = {{{"name", name}, {"bufferView", view}, {"mimeType", "image/png"}}};
  // Linear with mips; strips must not repeat into the neighbouring window or from tip to root.
  json_["samplers"] = {{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 33071}, {"wrapT", 33071}}};
  json_["textures"] = {{{"sampler", 0}, {"source", 0}}};
}

void GltfDocument::add_mesh(const std::string& name, const SurfaceMesh& mesh, const GltfMaterial& material) {
  Json attributes;
  attributes["POSITION"] = add_vectors(mesh.positions, true);
  attributes["NORMAL"] = add_vectors(mesh.normals, false);
  if (!mesh.uvs.empty()) {
    std::vector<float> uvs;
    for (const Eigen::Vector2d& uv : mesh.uvs) uvs.insert(uvs.end(), {rounded(uv.x()), rounded(uv.y())});
    const std::size_t view = add_view(uvs.data(), uvs.size() * sizeof(float), kVertexTarget);
    attributes["TEXCOORD_0"] = add_accessor(view, kFloat, "VEC2", mesh.uvs.size());
  }
  add_skin_attributes(mesh.skin, attributes);
  const Json primitive = {
      {"attributes", attributes}, {"indices", add_triangles(mesh.triangles)}, {"material", add_material(material)}};
  json_["meshes"].push_back({{"name", name}, {"primitives", Json::array({primitive})}});
  json_["scenes"][0]["nodes"].push_back(json_["nodes"].size());
  json_["nodes"].push_back({{"name", name}, {"mesh", json_["meshes"].size() - 1}, {"skin", 0}});
}

std::vector<std::uint8_t> GltfDocument::to_glb() const {
  Json whole = json_;
  whole["buffers"] = {{{"byteLength", binary_.size()}}};
  const std::string text = whole.dump();
  std::vector<std::uint8_t> chunks;
  append_chunk(chunks, "JSON", text.data(), text.size(), ' ');
  append_chunk(chunks, "BIN\0", binary_.data(), binary_.size(), '\0');
  std::vector<std::uint8_t> glb{'g', 'l', 'T', 'F'};
  append_word(glb, 2);
  append_word(glb, 12 + chunks.size());
  glb.insert(glb.end(), chunks.begin(), chunks.end());
  return glb;
}

std::size_t GltfDocument::add_view(const void* bytes, std::size_t size, int target) {
  binary_.resize((binary_.size() + 3) / 4 * 4);
  Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}};
  if (target != kNoTarget) view["target"] = target;
  const auto* begin = static_cast<const std::uint8_t*>(bytes);
  binary_.insert(binary_.end(), begin, begin + size);
  json_["bufferViews"].push_back(view);
  return json_["bufferViews"].size() - 1;
}

std::size_t GltfDocument::add_accessor(std::size_t view, int component, const char* type, std::size_t count) {
  json_["accessors"].push_back({{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
  return json_["accessors"].size() - 1;
}

std::size_t GltfDocument::add_vectors(const std::vector<Eigen::Vector3d>& vectors, bool with_bounds) {
  std::vector<float> floats;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
  Eigen::Vector3d high = -low;
  for (const Eigen::Vector3d& v : vectors) {
    for (int axis = 0; axis < 3; ++axis) floats.push_back(rounded(v[axis]));
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const std::size_t view = add_view(floats.data(), floats.size() * sizeof(float), kVertexTarget);
  const std::size_t accessor = add_accessor(view, kFloat, "VEC3", vectors.size());
  if (with_bounds) {
    json_["accessors"][accessor]["min"] = as_json(low);
    json_["accessors"][accessor]["max"] = as_json(high);
  }
  return accessor;
}

void GltfDocument::add_skin_attributes(const std::vector<SkinInfluences>& skin, Json& attributes) {
  std::vector<float> weights;
  for (const SkinInfluences& vertex : skin) {
    for (const double weight : vertex.weights) weights.push_back(static_cast<float>(weight));
  }
  attributes["JOINTS_0"] = add_joints(skin);
  const std::size_t weight_view = add_view(weights.data(), weights.size() * sizeof(float), kVertexTarget);
  attributes["WEIGHTS_0"] = add_accessor(weight_view, kFloat, "VEC4", skin.size());
}

std::size_t GltfDocument::add_joints(const std::vector<SkinInfluences>& skin) {
  std::vector<std::uint16_t> wide;
  for (const SkinInfluences& vertex : skin) wide.insert(wide.end(), vertex.joints.begin(), vertex.joints.end());
  if (std::ranges::max(wide) > 0xFF) {
    const std::size_t view = add_view(wide.data(), wide.size() * sizeof(std::uint16_t), kVertexTarget);
    return add_accessor(view, kUnsignedShort, "VEC4", skin.size());
  }
  std::vector<std::uint8_t> bytes;
  for (const std::uint16_t joint : wide) bytes.push_back(static_cast<std::uint8_t>(joint));
  return add_accessor(add_view(bytes.data(), bytes.size(), kVertexTarget), kUnsignedByte, "VEC4", skin.size());
}

std::size_t GltfDocument::add_triangles(const std::vector<std::uint32_t>& triangles) {
  const bool wide = !triangles.empty() && *std::ranges::max_element(triangles) > 0xFFFF;
  if (wide) {
    const std::size_t view = add_view(triangles.data(), triangles.size() * sizeof(std::uint32_t), kIndexTarget);
    return add_accessor(view, kUnsignedInt, "SCALAR", triangles.size());
  }
  const std::vector<std::uint16_t> narrow(triangles.begin(), triangles.end());
  const std::size_t view = add_view(narrow.data(), narrow.size() * sizeof(std::uint16_t), kIndexTarget);
  return add_accessor(view, kUnsignedShort, "SCALAR", narrow.size());
}

std::size_t GltfDocument::add_material(const GltfMaterial& material) {
  Json surface = {{"baseColorFactor", {material.red, material.green, material.blue, 1.0}},
                  {"metallicFactor", 0.0},
                  {"roughnessFactor", material.roughness}};
  if (material.is_hair) surface["baseColorTexture"] = {{"index", 0}};
  Json json = {{"name", material.name}, {"pbrMetallicRoughness", surface}};
  if (material.is_hair) {
    json["alphaMode"] = "BLEND";
    json["doubleSided"] = true;
  }
  json_["materials"].push_back(json);
  return json_["materials"].size() - 1;
}

}  // namespace coif::sample
