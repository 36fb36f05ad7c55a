#include "import/gltf_builder.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

namespace coif::importer::test {
namespace {

using nlohmann::json;

template <class Integer>
void append_as(float number, bool normalized, std::string& out) {
  const double scale = normalized ? double(std::numeric_limits<Integer>::max()) : 1;
  const auto value = static_cast<Integer>(std::lround(double(number) * scale));
  out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void append_number(float number, const Storage& storage, std::string& out) {
  switch (storage.component) {
    case 5120: return append_as<std::int8_t>(number, storage.normalized, out);
    case 5121: return append_as<std::uint8_t>(number, storage.normalized, out);
    case 5122: return append_as<std::int16_t>(number, storage.normalized, out);
    case 5123: return append_as<std::uint16_t>(number, storage.normalized, out);
    case 5125: return append_as<std::uint32_t>(number, storage.normalized, out);
    default: out.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
}

std::size_t width_of(const std::string& type) {
  return type == "MAT4" ? 16 : type == "SCALAR" ? 1 : std::size_t(type.back() - '0');
}

/// Readers ask for the bounds of positions, some of them loudly; what they say is not used here.
void add_bounds(std::span<const float> numbers, json& accessor) {
  accessor.update(json::parse("{" + bounds_of(numbers) + "}"));
}

std::string compressed(const std::string& bytes, std::size_t count, std::size_t stride) {
  std::vector<unsigned char> out(meshopt_encodeVertexBufferBound(count, stride));
  out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), bytes.data(), count, stride));
  return {reinterpret_cast<const char*>(out.data()), out.size()};
}

}  // namespace

const std::vector<float> kStripPositions{0, 0, 0, 1, 0, 0, 0, 2, 0, 1, 2, 0};
const std::vector<float> kStripNormals{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
const std::vector<float> kStripUvs{0, 1, 1, 1, 0, 0, 1, 0};

GltfBuilder::GltfBuilder() {
  document = json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
                             "nodes": [{"name": "strip", "mesh": 0}], "meshes": [{"name": "hair", "primitives": [{"attributes": {}}]}],
                             "accessors": [], "bufferViews": []})");
  attribute("POSITION", kStripPositions, "VEC3")
      .attribute("NORMAL", kStripNormals, "VEC3")
      .attribute("TEXCOORD_0", kStripUvs, "VEC2");
  const std::vector<float> corners{0, 1, 2, 2, 1, 3};
  primitive()["indices"] = add(corners, "SCALAR", {.component = 5123});
}

std::size_t GltfBuilder::add_view(const std::string& bytes) {
  buffer.resize((buffer.size() + 3) / 4 * 4);
  document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
  buffer += bytes;
  return document["bufferViews"].size() - 1;
}

std::size_t GltfBuilder::add(std::span<const float> numbers, const std::string& type, const Storage& storage) {
  const std::size_t width = width_of(type), count = numbers.size() / width;
  std::string bytes, indices;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < width; ++k) append_number(numbers[i * width + k], storage, bytes);
    bytes.append(storage.padding, '\x7f');
    append_as<std::uint16_t>(float(i), false, indices);
  }
  json accessor{{"componentType", storage.component}, {"count", count}, {"type", type}};
  if (storage.normalized) accessor["normalized"] = true;
  const std::size_t stride = bytes.size() / count;
  const std::size_t view = add_view(storage.meshopt ? compressed(bytes, count, stride) : bytes);
  json& entry = document["bufferViews"][view];
  if (storage.meshopt) {
    entry["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                      {"byteOffset", entry["byteOffset"]},
                                                      {"byteLength", entry["byteLength"]},
                                                      {"byteStride", stride},
                                                      {"count", count},
                                                      {"mode", "ATTRIBUTES"}};
  }
  if (storage.padding != 0) entry["byteStride"] = stride;
  if (storage.sparse) {
    const std::size_t index_view = add_view(indices);
    accessor["sparse"] = {{"count", count},
                          {"indices", {{"bufferView", index_view}, {"componentType", 5123}}},
                          {"values", {{"bufferView", view}}}};
  } else {
    accessor["bufferView"] = view;
  }
  document["accessors"].push_back(accessor);
  return document["accessors"].size() - 1;
}

GltfBuilder& GltfBuilder::attribute(const std::string& name, std::span<const float> numbers, const std::string& type,
                                    const Storage& storage) {
  const std::size_t index = add(numbers, type, storage);
  primitive()["attributes"][name] = index;
  if (name == "POSITION") add_bounds(numbers, document["accessors"][index]);
  return *this;
}

std::size_t GltfBuilder::add_places(std::span<const float> numbers) {
  const std::size_t index = add(numbers, "VEC3");
  add_bounds(numbers, document["accessors"][index]);
  return index;
}

GltfBuilder& GltfBuilder::textured(const json& texture_info, const json& sampler) {
  document["images"] = {{{"uri", "hair.png"}}};
  document["samplers"] = json::array({sampler});
  document["textures"] = {{{"source", 0}, {"sampler", 0}}};
  document["materials"] = {{{"name", "hair"}, {"pbrMetallicRoughness", {{"baseColorTexture", texture_info}}}}};
  primitive()["material"] = 0;
  return *this;
}

std::string GltfBuilder::glb() const {
  json whole = document;
  whole["buffers"] = {{{"byteLength", buffer.size()}}};
  return glb_of(whole.dump(), buffer);
}

std::filesystem::path GltfBuilder::write(const TemporaryFolder& folder, const std::string& name) const {
  return folder.write(name, glb());
}

}  // namespace coif::importer::test
