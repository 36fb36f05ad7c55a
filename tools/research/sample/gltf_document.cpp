#include "research/sample/gltf_document.h"

#include "base/encodings.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace coif::research {
namespace {

using Json = nlohmann::ordered_json;

/// Rounds to 2^-16: the file's bytes then do not depend on the last bit of a platform's sin() or exp().
float rounded(double value) {
  constexpr double kSteps = 65536.0;
  return static_cast<float>(std::round(value * kSteps) / kSteps);
}

template <int size>
std::vector<Eigen::Matrix<float, size, 1>> rounded(const std::vector<Eigen::Matrix<double, size, 1>>& vectors) {
  std::vector<Eigen::Matrix<float, size, 1>> result;
  for (const auto& vector : vectors) result.push_back(vector.unaryExpr([](double value) { return rounded(value); }));
  return result;
}

}  // namespace

GltfDocument::GltfDocument() {
  file_.document["asset"] = {{"version", "2.0"}, {"generator", "coif_make_sample"}};
  file_.document["scene"] = 0;
  file_.document["scenes"] = {{{"nodes", Json::array()}}};
}

void GltfDocument::set_skeleton(const std::vector<Joint>& joints, double per_metre) {
  const auto stored = [per_metre](double metres) { return std::round(metres * per_metre) / per_metre; };
  Json indices = Json::array();
  std::vector<Eigen::Matrix4f> inverse_binds;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Joint& joint = joints[i];
    const bool is_root = joint.parent < 0;
    const Eigen::Vector3d parent =
        is_root ? Eigen::Vector3d::Zero() : joints[static_cast<std::size_t>(joint.parent)].position;
    const Eigen::Vector3d offset = (joint.position - parent).unaryExpr(stored);
    file_.document["nodes"].push_back({{"name", joint.name}, {"translation", {offset.x(), offset.y(), offset.z()}}});
    if (is_root)
      file_.document["scenes"][0]["nodes"].push_back(i);
    else
      file_.document["nodes"][static_cast<std::size_t>(joint.parent)]["children"].push_back(i);
    indices.push_back(i);
    inverse_binds.emplace_back(Eigen::Matrix4f::Identity());
    inverse_binds.back().topRightCorner<3, 1>() = -joint.position.unaryExpr(stored).cast<float>();
  }
  const std::size_t matrices = file_.add(inverse_binds, {.type = "MAT4"});
  file_.document["skins"] = {{{"inverseBindMatrices", matrices}, {"skeleton", 0}, {"joints", indices}}};
}

void GltfDocument::set_image(const std::string& name, const StrandTexture& image) {
  add_image(name, {StrandTexture::kWidth, StrandTexture::kHeight, image.rgba});
}

std::size_t GltfDocument::add_image(const std::string& name, const mannequin::PaintedImage& image) {
  const auto png = encode_png(image.rgba, image.width, image.height);
  const std::size_t view = file_.add_view(std::as_bytes(std::span(png)));
  Json& document = file_.document;
  const std::size_t number = document.contains("images") ? document["images"].size() : 0;
  document["images"].push_back({{"name", name}, {"bufferView", view}, {"mimeType", "image/png"}});
  // Linear with mips; strips must not repeat into the neighbouring window or from tip to root.
  document["samplers"] = {{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 33071}, {"wrapT", 33071}}};
  document["textures"].push_back({{"sampler", 0}, {"source", number}});
  return number;
}

void GltfDocument::add_mesh(const std::string& name, const mannequin::SurfaceMesh& mesh, const GltfMaterial& material) {
  Json attributes;
  const std::vector<Eigen::Vector3f> places = rounded(mesh.positions);
  attributes["POSITION"] = file_.add(places, vertex_floats("VEC3"));
  file_.add_bounds(attributes["POSITION"], {places.data()->data(), 3 * places.size()}, 3);
  attributes["NORMAL"] = file_.add(rounded(mesh.normals), vertex_floats("VEC3"));
  if (!mesh.uvs.empty()) attributes["TEXCOORD_0"] = file_.add(rounded(mesh.uvs), vertex_floats("VEC2"));
  add_skin_attributes(mesh.skin, attributes);
  const Json primitive = {
      {"attributes", attributes}, {"indices", add_triangles(mesh.triangles)}, {"material", add_material(material)}};
  file_.document["meshes"].push_back({{"name", name}, {"primitives", Json::array({primitive})}});
  file_.document["scenes"][0]["nodes"].push_back(file_.document["nodes"].size());
  file_.document["nodes"].push_back({{"name", name}, {"mesh", file_.document["meshes"].size() - 1}, {"skin", 0}});
}

void GltfDocument::add_skin_attributes(const std::vector<mannequin::SkinInfluences>& skin, Json& attributes) {
  std::vector<std::array<std::uint16_t, 4>> joints;
  std::vector<Eigen::Vector4f> weights;
  bool fit = true;
  for (const mannequin::SkinInfluences& vertex : skin) {
    joints.push_back(vertex.joints);
    weights.emplace_back(Eigen::Map<const Eigen::Vector4d>(vertex.weights.data()).cast<float>());
    fit = fit && std::ranges::max(vertex.joints) <= 0xFF;
  }
  attributes["JOINTS_0"] = file_.add_joints(joints, fit);
  attributes["WEIGHTS_0"] = file_.add(weights, vertex_floats("VEC4"));
}

std::size_t GltfDocument::add_triangles(const std::vector<std::uint32_t>& triangles) {
  const bool wide = !triangles.empty() && *std::ranges::max_element(triangles) > 0xFFFF;
  if (wide) return file_.add(triangles, {GlbComponent::kUnsignedInt, "SCALAR", GlbTarget::kIndices, false});
  const std::vector<std::uint16_t> narrow(triangles.begin(), triangles.end());
  return file_.add(narrow, {GlbComponent::kUnsignedShort, "SCALAR", GlbTarget::kIndices, false});
}

std::size_t GltfDocument::add_material(const GltfMaterial& material) {
  Json surface = {{"baseColorFactor", {material.red, material.green, material.blue, 1.0}},
                  {"metallicFactor", 0.0},
                  {"roughnessFactor", material.roughness}};
  if (material.is_hair) surface["baseColorTexture"] = {{"index", 0}};
  if (material.image) surface["baseColorTexture"] = {{"index", *material.image}};
  Json json = {{"name", material.name}, {"pbrMetallicRoughness", surface}};
  if (material.is_hair) {
    json["alphaMode"] = "BLEND";
    json["doubleSided"] = true;
  }
  file_.document["materials"].push_back(json);
  return file_.document["materials"].size() - 1;
}

mannequin::SkinInfluences rounded_influences(std::array<std::pair<int, double>, 4> shares) {
  constexpr double kSteps = 256.0;
  std::stable_sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  mannequin::SkinInfluences skin;
  double rest = 1.0;
  std::size_t used = 0;
  for (const auto& [joint, share] : shares) {
    const double weight = std::round(share * kSteps) / kSteps;
    if (weight <= 0.0) continue;
    rest -= weight;
    // glTF lets a joint hold a vertex once.
    const auto end = skin.joints.begin() + std::ptrdiff_t(used);
    const auto same = std::find(skin.joints.begin(), end, joint);
    if (same == end) skin.joints[used++] = static_cast<std::uint16_t>(joint);
    skin.weights[std::size_t(same - skin.joints.begin())] += weight;
  }
  skin.weights[0] += rest;
  return skin;
}

}  // namespace coif::research
