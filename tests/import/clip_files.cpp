#include "base/encodings.h"
#include "import/model_files.h"

#include <cmath>
#include <cstdint>

namespace coif::importer::test {
namespace {

using nlohmann::json;

constexpr int kFloatComponent = 5126;

}  // namespace

ClipDocument::ClipDocument() {
  document = {
      {"asset", {{"version", "2.0"}}},
      {"nodes", json::array({{{"name", "head"}}})},
      {"animations", json::array({{{"name", "clip"}, {"samplers", json::array()}, {"channels", json::array()}}})},
      {"accessors", json::array()},
      {"bufferViews", json::array()}};
}

ClipDocument& ClipDocument::animate(std::size_t node, const std::string& path, const std::vector<float>& seconds,
                                    const std::vector<float>& values, const char* interpolation) {
  json& animation = document["animations"][0];
  const bool turns = path == "rotation";
  animation["channels"].push_back(
      {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
  const std::size_t input = add(seconds, "SCALAR", 1), output = add(values, turns ? "VEC4" : "VEC3", turns ? 4 : 3);
  animation["samplers"].push_back({{"input", input}, {"output", output}, {"interpolation", interpolation}});
  return *this;
}

std::size_t ClipDocument::add(const std::vector<float>& values, const char* type, std::size_t width) {
  const std::size_t begin = buffer_.size(), size = values.size() * sizeof(float);
  buffer_.append(reinterpret_cast<const char*>(values.data()), size);
  document["accessors"].push_back({{"bufferView", document["bufferViews"].size()},
                                   {"componentType", kFloatComponent},
                                   {"count", values.size() / width},
                                   {"type", type}});
  document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", begin}, {"byteLength", size}});
  document["buffers"] = json::array({{{"byteLength", buffer_.size()}}});
  return document["accessors"].size() - 1;
}

std::string ClipDocument::text() const {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(buffer_.data());
  return text_beside("data:application/octet-stream;base64," + base64({bytes, buffer_.size()}));
}

std::string ClipDocument::text_beside(const std::string& uri) const {
  json whole = document;
  if (whole.contains("buffers")) whole["buffers"][0]["uri"] = uri;
  return whole.dump();
}

std::string ClipDocument::glb() const { return glb_of(document.dump(), buffer_); }

std::vector<float> turns_about_x(const std::vector<float>& seconds, const std::function<double(double)>& radians) {
  std::vector<float> values;
  for (const float t : seconds) {
    const double half = 0.5 * radians(double(t));
    for (const double value : {std::sin(half), 0.0, 0.0, std::cos(half)}) values.push_back(float(value));
  }
  return values;
}

}  // namespace coif::importer::test
