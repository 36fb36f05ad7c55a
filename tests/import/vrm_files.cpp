#include "import/vrm_files.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <iterator>

namespace coif::test {
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

std::string as_glb(const std::filesystem::path& gltf) {
  const std::string uri = gltf.filename().string() + ".bin";
  std::string json = read_file(gltf);
  std::string buffer = read_file(gltf.parent_path() / uri);
  const std::string reference = fmt::format(R"(, "uri": "{}")", uri);
  json.erase(json.find(reference), reference.size());
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

}  // namespace coif::test
