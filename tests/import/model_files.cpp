#include "import/model_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <type_traits>

namespace coif::importer::test {
namespace {

namespace fs = std::filesystem;

// Collects arrays into one buffer and writes the JSON that refers to them.
class GltfBuffer {
 public:
  template <class T>
  int add(const std::vector<T>& values, const char* type, int components, int component_type) {
    const std::size_t start = bytes_.size();
    const std::size_t size = values.size() * sizeof(T);
    bytes_.append(reinterpret_cast<const char*>(values.data()), size);
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    views_.push_back(fmt::format(R"({{"buffer": 0, "byteOffset": {}, "byteLength": {}}})", start, size));
    std::string bounds;
    if constexpr (std::is_same_v<T, float>) bounds = components == 3 ? bounds_of(values) : "";
    accessors_.push_back(fmt::format(R"({{"bufferView": {}, "componentType": {}, "count": {}, "type": "{}"{}{}}})",
                                     views_.size() - 1, component_type, values.size() / std::size_t(components), type,
                                     bounds.empty() ? "" : ", ", bounds));
    return static_cast<int>(views_.size()) - 1;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] std::string json(const std::string& uri) const {
    return fmt::format(R"("buffers": [{{"byteLength": {}, "uri": "{}"}}], "bufferViews": [{}], "accessors": [{}])",
                       bytes_.size(), uri, fmt::join(views_, ", "), fmt::join(accessors_, ", "));
  }

 private:
  std::string bytes_;
  std::vector<std::string> views_, accessors_;
};

constexpr int kFloat = 5126;
constexpr int kUnsignedShort = 5123;

}  // namespace

std::string bounds_of(std::span<const float> places) {
  float least[3], most[3];
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!std::isfinite(places[i])) return "";
    least[i % 3] = i < 3 ? places[i] : std::min(least[i % 3], places[i]);
    most[i % 3] = i < 3 ? places[i] : std::max(most[i % 3], places[i]);
  }
  return fmt::format(R"("min": [{}], "max": [{}])", fmt::join(least, ", "), fmt::join(most, ", "));
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (fs::temp_directory_path() / "coif-import-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot create " + pattern);
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path TemporaryFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
  return path_ / name;
}

fs::path SmallGltf::write(const TemporaryFolder& folder, const std::string& name) const {
  GltfBuffer buffer;
  std::string attributes = fmt::format(R"("POSITION": {})", buffer.add(positions, "VEC3", 3, kFloat));
  if (!normals.empty()) attributes += fmt::format(R"(, "NORMAL": {})", buffer.add(normals, "VEC3", 3, kFloat));
  if (!uvs.empty()) attributes += fmt::format(R"(, "TEXCOORD_0": {})", buffer.add(uvs, "VEC2", 2, kFloat));
  if (!joints.empty()) {
    attributes += fmt::format(R"(, "JOINTS_0": {})", buffer.add(joints, "VEC4", 4, kUnsignedShort));
    attributes += fmt::format(R"(, "WEIGHTS_0": {})", buffer.add(weights, "VEC4", 4, kFloat));
  }
  const int index = buffer.add(indices, "SCALAR", 1, kUnsignedShort);
  // Written although identity is the default: assimp 5.2 crashes on a skin without bind matrices.
  std::vector<float> binds(2 * 16, 0.0f);
  for (std::size_t i = 0; i < binds.size(); ++i) binds[i] = i % 16 % 5 == 0 ? 1.0f : 0.0f;
  const std::string skins = joints.empty() ? ""
                                           : fmt::format(R"("skins": [{{"joints": {}, "inverseBindMatrices": {}}}],)",
                                                         skin_joints, buffer.add(binds, "MAT4", 16, kFloat));
  const std::string uri = name + ".bin";
  folder.write(uri, buffer.bytes());
  return folder.write(name, fmt::format(R"({{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": {}}}],
"nodes": {}, {} {} "materials": [{}], {},
"meshes": [{{"name": "card", "primitives": [{{"attributes": {{{}}}, "indices": {}, "material": 0}}]}}]}})",
                                        roots, nodes, skins, images, material, buffer.json(uri), attributes, index));
}

std::string fbx_int(const std::string& name, int value) {
  return fmt::format("P: \"{}\", \"int\", \"Integer\", \"\",{}\n", name, value);
}

std::string fbx_document(const std::string& settings, const std::string& objects, const std::string& connections) {
  return fmt::format(R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {{
  FBXHeaderVersion: 1003
  FBXVersion: 7400
}}
GlobalSettings:  {{
  Version: 1000
  Properties70:  {{
{}  }}
}}
Objects:  {{
{}}}
Connections:  {{
{}}}
)",
                     settings, objects, connections);
}

std::string fbx_triangle(int geometry, const std::string& name, int model, const std::string& properties) {
  return fmt::format(R"(  Geometry: {}, "Geometry::{}", "Mesh" {{
    Vertices: *9 {{
      a: 0,0,0,1,0,0,0,2,3
    }}
    PolygonVertexIndex: *3 {{
      a: 0,1,-3
    }}
    GeometryVersion: 124
  }}
)",
                     geometry, name) +
         fbx_model(model, name, "Mesh", properties);
}

std::string fbx_model(int model, const std::string& name, const std::string& model_class,
                      const std::string& properties) {
  return fmt::format("  Model: {}, \"Model::{}\", \"{}\" {{\n    Version: 232\n    Properties70:  {{\n{}    }}\n  }}\n",
                     model, name, model_class, properties);
}

std::string small_fbx(const std::string& settings) {
  return fbx_document(settings, fbx_triangle(1000, "strip", 2000), "  C: \"OO\",2000,0\n  C: \"OO\",1000,2000\n");
}

std::string small_dae(const std::string& unit_metres, const std::string& up_axis) {
  return fmt::format(R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="u" meter="{}"/><up_axis>{}</up_axis></asset>
<library_geometries><geometry id="g" name="strip"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 2 3</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s" name="s"><node id="n" name="strip"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
)",
                     unit_metres, up_axis);
}

namespace {

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

SmallGltf small_vrm(const std::string& extensions) {
  SmallGltf file;
  file.nodes = R"([{"name": "strip", "mesh": 0}, {"name": "body", "children": [2]},
    {"name": "head", "children": [3], "translation": [0, 1, 0]},
    {"name": "hair_1", "children": [4], "translation": [0, -0.1, 0]},
    {"name": "hair_2", "children": [5], "translation": [0, -0.1, 0]},
    {"name": "hair_end", "translation": [0, -0.1, 0]}])";
  file.roots = "[0, 1]";
  file.images = fmt::format(R"("extensions": {{{}}},)", extensions);
  return file;
}

std::string spring_bone_1(const std::string& springs, const std::string& colliders, const std::string& groups) {
  return fmt::format(
      R"("VRMC_springBone": {{"specVersion": "1.0", "springs": {}, "colliders": {}, "colliderGroups": {}}})", springs,
      colliders, groups);
}

std::string spring_bone_0(const std::string& bone_groups, const std::string& collider_groups) {
  return fmt::format(
      R"("VRM": {{"humanoid": {{"humanBones": [{{"bone": "hips", "node": 1}}, {{"bone": "head", "node": 2}}]}},
         "secondaryAnimation": {{"boneGroups": {}, "colliderGroups": {}}}}})",
      bone_groups, collider_groups);
}

std::string glb_of(std::string json, std::string buffer) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  buffer.resize((buffer.size() + 3) / 4 * 4);
  std::string out = "glTF";
  const auto append = [&](std::size_t number) {
    const auto word = static_cast<std::uint32_t>(number);
    out.append(reinterpret_cast<const char*>(&word), sizeof word);
  };
  append(2);
  append(12 + 8 + json.size() + 8 + buffer.size());
  append(json.size());
  out += "JSON" + json;
  append(buffer.size());
  return out + std::string("BIN\0", 4) + buffer;
}

std::string as_glb(const std::filesystem::path& gltf) {
  const std::string uri = gltf.filename().string() + ".bin";
  std::string json = read_file(gltf);
  const std::string reference = fmt::format(R"(, "uri": "{}")", uri);
  json.erase(json.find(reference), reference.size());
  return glb_of(std::move(json), read_file(gltf.parent_path() / uri));
}

SourceModel small_source_model() {
  SourceModel model;
  model.path = "braid.glb";
  model.importer = "test 1.2.3";
  model.importer_version[0] = 1;
  SourceNode root{"root", kNoIndex, Eigen::Affine3d::Identity()};
  SourceNode tip{"tip", 0, Eigen::Affine3d(Eigen::Translation3d(0, 1, 0))};
  model.nodes = {root, tip};
  SourceMesh mesh;
  mesh.name = "strip";
  mesh.node = 1;
  mesh.material = 0;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
  mesh.colors.assign(3, {1, 0.5f, 0.25f, 1});
  mesh.influence_begin = {0, 1, 2, 4};
  mesh.influences = {{0, 1.0f}, {1, 1.0f}, {0, 0.75f}, {1, 0.25f}};
  mesh.triangles = {0, 1, 2};
  model.meshes = {mesh};
  SourceMaterial material;
  material.name = "hair";
  material.base_texture = {"hair.png", 0};
  material.normal_texture = {"hair_n.png", kNoIndex};
  material.normal_strength = 0.5f;
  material.base_texture.wrap[1] = TextureWrap::kMirror;
  material.opacity_texture = {"hair_a.png", kNoIndex};
  material.opacity_channel = TextureChannel::kGreen;
  material.opacity_inverted = true;
  material.alpha_use = AlphaUse::kMask;
  material.alpha_cutoff = 0.25f;
  material.double_sided = true;
  model.materials = {material};
  model.images = {{"hair.png", {1, 2, 3}}};
  SourceCollider collider;
  collider.radius = 0.5;
  model.colliders = {collider, collider};
  SourceSpring spring;
  spring.name = "tail";
  spring.joints.resize(2);
  spring.joints[0].length = 1;
  spring.joints[1].node = 1;
  spring.colliders = {0, 1};
  spring.center = 0;
  model.springs = {spring};
  model.head_node = 1;
  model.facing = Facing::kBackwards;
  model.materials[0].other_textures = {"gloss map"};
  model.warnings = {{"S201", "one"}, {"S115", "two"}};
  model.side_files = {"strip.bin"};
  return model;
}

}  // namespace coif::importer::test
