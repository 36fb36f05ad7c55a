#include "import/gltf_json.h"

#include "import/printable_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>

namespace coif {
namespace {

using nlohmann::json;

constexpr int kDeepest = 32;  // VRM's own deepest value is about a dozen levels down

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
    if (depth > kDeepest) return false;
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
