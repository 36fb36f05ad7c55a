#include "import/gltf_check_parts.h"

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <system_error>

// Checks of containers, and of references between JSON objects.

namespace coif::importer {
namespace {

using nlohmann::json;

constexpr const char* kExportAnew = "export it again, or repair it with a glTF tool such as gltf-transform";

/// A property that is an index into a list, or a list of such.
struct GltfReference {
  const char* from;
  const char* property;
  const char* to;
  bool is_list = false;
  bool is_needed = false;
};

constexpr GltfReference kGltfReferences[] = {
    {"accessors", "bufferView", "bufferViews"},
    {"bufferViews", "buffer", "buffers", false, true},
    {"images", "bufferView", "bufferViews"},
    {"nodes", "camera", "cameras"},
    {"nodes", "children", "nodes", true},
    {"nodes", "mesh", "meshes"},
    {"nodes", "skin", "skins"},
    {"scenes", "nodes", "nodes", true},
    {"skins", "inverseBindMatrices", "accessors"},
    {"skins", "joints", "nodes", true, true},
    {"skins", "skeleton", "nodes"},
    {"textures", "sampler", "samplers"},
    {"textures", "source", "images"},
};

constexpr const char* kGltfLists[] = {"accessors", "animations", "bufferViews", "buffers", "cameras",
                                      "images",    "materials",  "meshes",      "nodes",   "samplers",
                                      "scenes",    "skins",      "textures"};

/// A property that is a list with a fixed count of numbers.
constexpr std::pair<const char*, std::size_t> kNodeNumbers[] = {
    {"matrix", 16}, {"rotation", 4}, {"scale", 3}, {"translation", 3}};

class ObjectChecks {
 public:
  explicit ObjectChecks(CheckedGltf& file) : file_(file) {}

  void run() {
    check_asset();
    for (const char* name : kGltfLists) check_list(name);
    for (const GltfReference& reference : kGltfReferences) check_references(reference);
    check_index(member(file_.document, "scene"), "scenes", "'scene'", false);
    check_extensions(file_.document, "the document");
    check_nodes();
    for (std::size_t i = 0; i < file_.list("materials").size(); ++i) {
      check_textures(file_.list("materials")[i], gltf_part_name("material", file_.list("materials")[i], i));
    }
  }

 private:
  void wrong(const std::string& place, const std::string& what) {
    file_.faults.add(gltf_code::kRules, "{}: {}; {}", place, what, kExportAnew);
  }

  void check_asset() {
    const json& version = member(member(file_.document, "asset"), "version");
    if (!version.is_string()) wrong("'asset'", "it does not say which version of glTF it is");
  }

  void check_list(const char* name) {
    const json& list = member(file_.document, name);
    if (list.is_null()) return;
    if (!list.is_array() || list.empty()) return wrong(fmt::format("'{}'", name), "it is no list of objects, or empty");
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::string place = fmt::format("{} of '{}'", i, name);
      if (!list[i].is_object()) {
        wrong(place, "it is no object");
        continue;
      }
      const json& text = member(list[i], "name");
      if (!text.is_null() && !text.is_string()) wrong(place, "its name is no text");
      check_extensions(list[i], place);
    }
  }

  void check_extensions(const json& object, const std::string& place) {
    const json& extensions = member(object, "extensions");
    if (extensions.is_null()) return;
    if (!extensions.is_object()) return wrong(place, "its 'extensions' are no object");
    for (const auto& [name, value] : extensions.items()) {
      if (!value.is_object()) wrong(place, fmt::format("its extension '{}' is no object", printable_text(name, 60)));
    }
  }

  void check_index(const json& value, const char* list, const std::string& place, bool is_needed) {
    if (value.is_null() && !is_needed) return;
    if (index_of(value, file_.list(list).size())) return;
    wrong(place, value.is_null() ? fmt::format("it names none of '{}'", list)
                                 : fmt::format("it names {} of '{}', of which there are {}",
                                               printable_text(value.dump(), 40), list, file_.list(list).size()));
  }

  void check_references(const GltfReference& reference) {
    const json& list = file_.list(reference.from);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const json& value = member(list[i], reference.property);
      const std::string place = fmt::format("{} of '{}', '{}'", i, reference.from, reference.property);
      if (!reference.is_list) {
        check_index(value, reference.to, place, reference.is_needed);
        continue;
      }
      if (value.is_null() && !reference.is_needed) continue;
      if (!value.is_array() || value.empty()) {
        wrong(place, "it is no list, or empty");
        continue;
      }
      for (const json& entry : value) check_index(entry, reference.to, place, true);
    }
  }

  void check_nodes() {
    const json& nodes = file_.list("nodes");
    std::vector<std::size_t> parents(nodes.size(), 0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const std::string place = gltf_part_name("node", nodes[i], i);
      for (const auto& [name, count] : kNodeNumbers) {
        const json& value = member(nodes[i], name);
        const bool is_given = !value.is_null();
        bool fits = list_of(value).size() == count;
        for (const json& number : list_of(value)) fits = fits && number_of(number).has_value();
        if (is_given && !fits) wrong(place, fmt::format("its {} is no list of {} numbers", name, count));
      }
      check_rotation(nodes[i], place);
      if (!member(nodes[i], "skin").is_null() && member(nodes[i], "mesh").is_null())
        wrong(place, "it has a skin and no mesh");
      for (const json& child : list_of(member(nodes[i], "children"))) {
        const auto index = index_of(child, nodes.size());
        if (index && ++parents[*index] == 2)
          wrong(gltf_part_name("node", nodes[*index], *index), "it is the child of two nodes, or twice of one");
      }
    }
    check_loops();
  }

  void check_rotation(const json& node, const std::string& place) {
    constexpr double kMostOff = 0.00769;  // As in the Khronos validator.
    const json& rotation = list_of(member(node, "rotation"));
    if (rotation.size() != 4) return;
    double squares = 0;
    for (const json& number : rotation) squares += std::pow(number_of(number).value_or(0), 2);
    if (std::abs(std::sqrt(squares) - 1) <= kMostOff) return;
    file_.faults.add(
        gltf_code::kUnits,
        "{}: its rotation has the length {:.4g} and not 1; apply the rotation in the modelling tool and export again",
        place, std::sqrt(squares));
  }

  void check_loops() {
    const gltf::GltfTree tree(file_.document);
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
      if (const auto above = tree.with_parents(i); !above) return wrong("'nodes'", above.error());
    }
  }

  /// Checks that all members with "texture" in their name refer to one, at any depth.
  void check_textures(const json& value, const std::string& place) {
    if (!value.is_object()) return;
    for (const auto& [name, inner] : value.items()) {
      if (name == "extras") continue;
      if (name.ends_with("Texture")) {
        if (inner.is_object()) {
          check_index(member(inner, "index"), "textures", fmt::format("{}, '{}'", place, printable_text(name, 60)),
                      true);
        } else {
          wrong(place, fmt::format("its '{}' is no object", printable_text(name, 60)));
        }
      }
      if (name == "pbrMetallicRoughness" && !inner.is_object()) wrong(place, "its 'pbrMetallicRoughness' is no object");
      check_textures(inner, place);
    }
  }

  CheckedGltf& file_;
};

}  // namespace

void check_gltf_objects(CheckedGltf& file) { ObjectChecks(file).run(); }

void check_gltf_container(const std::filesystem::path& path, GltfFaults& faults) {
  const auto wrong = [&](const std::string& what) {
    faults.add(gltf_code::kRules, "the .glb: {}; {}", what, kExportAnew);
  };
  std::ifstream file(path, std::ios::binary);
  std::array<std::uint32_t, 3> head{};
  file.read(reinterpret_cast<char*>(head.data()), sizeof head);
  if (file.gcount() != sizeof head || std::memcmp(head.data(), "glTF", 4) != 0) return;
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  if (code) return;
  if (head[1] != 2) wrong(fmt::format("it is of version {} and not 2", head[1]));
  if (head[2] > size) wrong(fmt::format("it says that it has {} bytes, and has {}", head[2], size));
  std::size_t chunks = 0, binary = 0;
  std::uintmax_t at = sizeof head;
  const std::uintmax_t end = std::min<std::uintmax_t>(size, head[2]);
  while (at < end) {
    std::array<std::uint32_t, 2> chunk{};
    file.seekg(std::streamoff(at));
    file.read(reinterpret_cast<char*>(chunk.data()), sizeof chunk);
    if (file.gcount() != sizeof chunk || at + sizeof chunk > end) return wrong("it ends within the head of a chunk");
    const bool is_json = std::memcmp(&chunk[1], "JSON", 4) == 0, is_binary = std::memcmp(&chunk[1], "BIN", 4) == 0;
    if (chunk[0] > end - at - sizeof chunk) return wrong("a chunk is longer than the file");
    if (chunk[0] % 4 != 0) wrong("the length of a chunk is no multiple of 4");
    if ((chunks == 0) != is_json) wrong(is_json ? "it has two chunks of JSON" : "its first chunk is not JSON");
    if (is_binary && (++binary > 1 || chunks != 1)) wrong("its binary chunk is not the second, or there are several");
    at += sizeof chunk + chunk[0];
    ++chunks;
  }
}

}  // namespace coif::importer
