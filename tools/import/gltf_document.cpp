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

constexpr std::size_t kMostLevels = 256;  // of nodes
constexpr int kDeepestLevel = 32;         // VRM's own deepest value is about a dozen levels down

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
  if (std::memcmp(start.chunk_type, "JSON", 4) != 0) return fault("the first chunk is not JSON");
  if (code || start.chunk_bytes > size - sizeof start) return fault("the JSON chunk is cut off");
  std::string text(start.chunk_bytes, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file) return fault("the JSON chunk cannot be read");
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

GltfTree::GltfTree(const json& document)
    : nodes_(list_of(member(document, "nodes"))), parents_(nodes_.size(), kNoIndex) {
  for (std::uint32_t parent = 0; parent < parents_.size(); ++parent) {
    for (const json& entry : list_of(member(nodes_[parent], "children"))) {
      const auto child = index_of(entry, parents_.size());
      if (child && parents_[*child] == kNoIndex) parents_[*child] = parent;
    }
  }
}

const json& GltfTree::node(std::uint32_t index) const { return nodes_[index]; }

std::string GltfTree::label(std::uint32_t index) const {
  const std::string name = printable_text_of(member(nodes_[index], "name"));
  return name.empty() ? fmt::format("node {}", index) : name;
}

std::vector<std::uint32_t> GltfTree::named(std::string_view name) const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < parents_.size(); ++i) {
    if (member(nodes_[i], "name") == name) found.push_back(i);
  }
  return found;
}

tl::expected<std::vector<std::uint32_t>, std::string> GltfTree::with_parents(std::uint32_t index) const {
  std::vector<std::uint32_t> chain;
  for (std::uint32_t node = index; node != kNoIndex; node = parents_[node]) {
    if (chain.size() == kMostLevels) {
      return fault("node '{}' is more than {} levels deep, or its own parent", label(index), kMostLevels);
    }
    chain.push_back(node);
  }
  return chain;
}

}  // namespace coif
