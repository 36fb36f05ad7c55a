#include "animation/glb_reader.h"

#include <cstring>
#include <string>

namespace coif::animation {
namespace {

std::uint32_t word(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

}  // namespace

bool GlbReader::read(std::span<const std::byte> file) {
  if (file.size() < 28 || std::memcmp(file.data(), "glTF", 4) != 0) return false;
  if (word(file, 4) != 2 || word(file, 8) != file.size()) return false;
  const std::size_t json_size = word(file, 12);
  if (std::memcmp(&file[16], "JSON", 4) != 0 || json_size % 4 != 0 || json_size > file.size() - 28) return false;
  const auto rest = file.subspan(20 + json_size);
  if (std::memcmp(&rest[4], "BIN\0", 4) != 0 || word(rest, 0) != rest.size() - 8) return false;
  document_ = nlohmann::json::parse(std::string(reinterpret_cast<const char*>(&file[20]), json_size), nullptr, false);
  binary_.assign(rest.begin() + 8, rest.end());
  if (document_.is_discarded()) return false;
  const std::size_t declared = document_["buffers"][0]["byteLength"];
  return declared <= binary_.size() && binary_.size() - declared < 4;
}

std::span<const std::byte> GlbReader::view(std::size_t index) const {
  const auto& view = document_.at("bufferViews").at(index);
  return std::span(binary_).subspan(view.at("byteOffset"), view.at("byteLength"));
}

std::vector<float> GlbReader::floats(std::size_t accessor) const {
  const auto bytes = view(document_.at("accessors").at(accessor).at("bufferView"));
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
  return values;
}

std::vector<std::uint8_t> GlbReader::bytes(std::size_t accessor) const {
  const auto bytes = view(document_.at("accessors").at(accessor).at("bufferView"));
  std::vector<std::uint8_t> values(bytes.size());
  std::memcpy(values.data(), bytes.data(), values.size());
  return values;
}

std::vector<float> GlbReader::key(std::size_t node, const char* path, std::size_t frame, std::size_t width) const {
  const auto& animation = document_.at("animations").at(0);
  for (const auto& channel : animation.at("channels")) {
    if (channel["target"]["node"] != node || channel["target"]["path"] != path) continue;
    const auto all = floats(animation.at("samplers").at(channel["sampler"].get<std::size_t>()).at("output"));
    return {all.begin() + std::ptrdiff_t(frame * width), all.begin() + std::ptrdiff_t((frame + 1) * width)};
  }
  return document_.at("nodes").at(node).value(path, std::vector<float>{});
}

Eigen::Affine3d GlbReader::local(std::size_t node, std::size_t frame) const {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  const auto t = key(node, "translation", frame, 3);
  if (t.size() == 3) transform.translate(Eigen::Vector3f(t[0], t[1], t[2]).cast<double>());
  const auto r = key(node, "rotation", frame, 4);
  if (r.size() == 4) transform.rotate(Eigen::Quaternionf(r[3], r[0], r[1], r[2]).cast<double>());
  return transform;
}

Eigen::Affine3d GlbReader::world_from_node(std::size_t node, std::size_t frame) const {
  const auto& nodes = document_.at("nodes");
  for (std::size_t parent = 0; parent < nodes.size(); ++parent) {
    for (const auto& child : nodes[parent].value("children", nlohmann::json::array())) {
      if (child == node) return world_from_node(parent, frame) * local(node, frame);
    }
  }
  return local(node, frame);
}

}  // namespace coif::animation
