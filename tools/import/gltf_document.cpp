#include "import/gltf_document.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

namespace coif {
namespace {

using nlohmann::json;

}  // namespace

const json& member(const json& value, const char* name) {
  static const json kNull;
  if (!value.is_object()) return kNull;
  const auto found = value.find(name);
  return found == value.end() ? kNull : *found;
}

const json& list_of(const json& value) {
  static const json kEmpty = json::array();
  return value.is_array() ? value : kEmpty;
}

std::optional<double> number_of(const json& value) {
  if (!value.is_number()) return std::nullopt;
  const auto number = value.get<double>();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<std::uint32_t> index_of(const json& value, std::size_t count) {
  const std::optional<double> number = number_of(value);
  if (!number || !(*number >= 0 && *number < double(count)) || std::floor(*number) != *number) return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

std::optional<Eigen::Vector3d> vector_of(const json& value) {
  const bool list = value.is_array() && value.size() == 3;
  if (!list && !value.is_object()) return std::nullopt;
  constexpr const char* kNames[] = {"x", "y", "z"};
  Eigen::Vector3d out;
  for (int k = 0; k < 3; ++k) {
    const std::optional<double> number = number_of(list ? value[std::size_t(k)] : member(value, kNames[k]));
    if (!number) return std::nullopt;
    out[k] = *number;
  }
  return out;
}

std::string printable_text_of(const json& value) {
  return value.is_string() ? printable_text(value.get_ref<const std::string&>()) : std::string();
}

namespace {

constexpr int kDeepestLevel = 32;  // VRM's own deepest value is about a dozen levels down

struct GlbStart {
  char magic[4];
  std::uint32_t version;
  std::uint32_t bytes;
  std::uint32_t chunk_bytes;
  char chunk_type[4];
};
static_assert(sizeof(GlbStart) == 20);

// The document's text: the whole file, or what the first chunk of a binary one says it is.
tl::expected<std::string, std::string> read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  GlbStart start{};
  file.read(reinterpret_cast<char*>(&start), sizeof start);
  const bool binary = file.gcount() == sizeof start && std::memcmp(start.magic, "glTF", 4) == 0;
  if (!binary) {
    file.clear();
    file.seekg(0);
    return std::string((std::istreambuf_iterator<char>(file)), {});
  }
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  if (std::memcmp(start.chunk_type, "JSON", 4) != 0) return tl::unexpected(std::string("the first chunk is not JSON"));
  if (code || start.chunk_bytes > size - sizeof start) return tl::unexpected(std::string("the JSON chunk is cut off"));
  std::string text(start.chunk_bytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file) return tl::unexpected(std::string("the JSON chunk cannot be read"));
  return text;
}

}  // namespace

tl::expected<json, std::string> read_gltf_json(const std::filesystem::path& path,
                                               std::span<const std::string_view> members) {
  auto text = read_text(path);
  if (!text) return tl::unexpected(text.error());
  const auto keep = [members](int depth, json::parse_event_t event, json& value) {
    if (depth > kDeepestLevel) return false;
    return event != json::parse_event_t::key || depth != 1 ||
           std::ranges::find(members, value.get_ref<const std::string&>()) != members.end();
  };
  try {
    json document = json::parse(*text, keep);
    return document.is_object() ? std::move(document) : json();
  } catch (const json::exception& error) {
    return tl::unexpected(printable_text(error.what(), 200));
  }
}

}  // namespace coif
