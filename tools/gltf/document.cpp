#include "gltf/document.h"

#include "base/text.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

namespace coif::gltf {
namespace {

using nlohmann::json;

constexpr int kDeepestLevel = 32;  // VRM's own deepest value is about a dozen levels down

struct GlbStart {
  char magic[4];
  std::uint32_t version;
  std::uint32_t bytes;
  std::uint32_t chunk_bytes;
  char chunk_type[4];
};
static_assert(sizeof(GlbStart) == 20);

// The document's text: the whole file, or the first chunk of a binary one with the length that it states.
tl::expected<std::string, std::string> read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  GlbStart start{};
  file.read(reinterpret_cast<char*>(&start), sizeof start);
  const bool is_binary = file.gcount() >= 4 && std::memcmp(start.magic, "glTF", 4) == 0;
  if (!is_binary) {
    file.clear();
    file.seekg(0);
    return std::string((std::istreambuf_iterator<char>(file)), {});
  }
  if (!file) return fault("the header is cut off");
  if (start.version != 2)
    return fault(
        "it is binary glTF {}, and 2 is read; convert it, for example: npx gltf-pipeline -i OLD.glb -o NEW.glb",
        start.version);
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  if (std::memcmp(start.chunk_type, "JSON", 4) != 0) return fault("the first chunk is not JSON");
  if (code || start.chunk_bytes > size - sizeof start) return fault("the JSON chunk is cut off");
  std::string text(start.chunk_bytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file) return fault("the JSON chunk cannot be read");
  return text;
}

}  // namespace

tl::expected<json, std::string> read_gltf_json(const std::filesystem::path& path) {
  auto text = read_text(path);
  if (!text) return tl::unexpected(text.error());
  const auto keep = [](int depth, json::parse_event_t, json&) { return depth <= kDeepestLevel; };
  json document = json::parse(*text, keep, false);
  // Exporters write names as their system has them, which may be no UTF-8.
  if (document.is_discarded()) *text = printable_text(*text, text->size());
  try {
    if (document.is_discarded()) document = json::parse(*text, keep);
  } catch (const json::exception& error) {
    return tl::unexpected(printable_text(json_fault(error), 200));
  }
  if (!document.is_object()) return fault("the document is no JSON object");
  const std::string version = printable_text_of(member(member(document, "asset"), "version"));
  if (version.empty()) return fault("it has no asset.version, which every glTF 2.0 has");
  if (!version.starts_with("2")) {
    return fault("it is glTF {}, and 2.0 is read; convert it, for example: npx gltf-pipeline -i OLD.gltf -o NEW.glb",
                 excerpt(version, 20));
  }
  return document;
}

const json& extension(const json& object, const char* name) { return member(member(object, "extensions"), name); }

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

}  // namespace coif::gltf
