#include "base/glb_file.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

namespace coif {
namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67;     // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942;  // "BIN", zero

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

void append(std::vector<std::byte>& out, std::span<const std::byte> bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

void append_words(std::vector<std::byte>& out, std::initializer_list<std::size_t> words) {
  for (const std::size_t word : words) {
    const auto value = static_cast<std::uint32_t>(word);
    append(out, std::as_bytes(std::span(&value, 1)));
  }
}

}  // namespace

template <class Json>
std::size_t GlbFile<Json>::add_view(std::span<const std::byte> bytes, GlbTarget target) {
  buffer_.resize(padded(buffer_.size()));  // every component type starts at a multiple of its size
  Json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
  if (target != GlbTarget::kAny) view["target"] = target;
  append(buffer_, bytes);
  document["bufferViews"].push_back(std::move(view));
  return document["bufferViews"].size() - 1;
}

template <class Json>
std::size_t GlbFile<Json>::add_accessor(std::span<const std::byte> bytes, std::size_t count, const GlbArray& array) {
  Json accessor = {{"bufferView", add_view(bytes, array.target)},
                   {"componentType", array.component},
                   {"count", count},
                   {"type", array.type}};
  if (array.normalized) accessor["normalized"] = true;
  document["accessors"].push_back(std::move(accessor));
  return document["accessors"].size() - 1;
}

template <class Json>
std::size_t GlbFile<Json>::add_joints(std::span<const std::array<std::uint16_t, 4>> joints, bool fit) {
  if (!fit) return add(joints, {GlbComponent::kUnsignedShort, "VEC4", GlbTarget::kVertices, false});
  std::vector<std::array<std::uint8_t, 4>> narrow;
  for (const auto& [a, b, c, d] : joints) {
    narrow.push_back({std::uint8_t(a), std::uint8_t(b), std::uint8_t(c), std::uint8_t(d)});
  }
  return add(narrow, {GlbComponent::kUnsignedByte, "VEC4", GlbTarget::kVertices, false});
}

template <class Json>
void GlbFile<Json>::add_bounds(std::size_t accessor, std::span<const float> values, std::size_t width) {
  std::vector<float> low(width, std::numeric_limits<float>::max());
  std::vector<float> high(width, std::numeric_limits<float>::lowest());
  for (std::size_t i = 0; i < values.size(); ++i) {
    low[i % width] = std::min(low[i % width], values[i]);
    high[i % width] = std::max(high[i % width], values[i]);
  }
  document["accessors"][accessor]["min"] = low;
  document["accessors"][accessor]["max"] = high;
}

template <class Json>
std::vector<std::byte> GlbFile<Json>::bytes() const {
  Json complete = document;
  complete["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
  // Names come from artists' files and need not be UTF-8; a replaced character beats an exception.
  std::string text = complete.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  text.resize(padded(text.size()), ' ');

  const std::size_t total = 12 + 8 + text.size() + 8 + padded(buffer_.size());
  if (total > std::numeric_limits<std::uint32_t>::max()) return {};
  std::vector<std::byte> file;
  file.reserve(total);
  append_words(file, {kGlbMagic, 2, total, text.size(), kJsonChunk});
  append(file, std::as_bytes(std::span(text)));
  append_words(file, {padded(buffer_.size()), kBinaryChunk});
  append(file, buffer_);
  file.resize(total);
  return file;
}

template class GlbFile<nlohmann::json>;
template class GlbFile<nlohmann::ordered_json>;

}  // namespace coif
