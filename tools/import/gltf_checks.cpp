#include "import/gltf_scene.h"

#include "import/gltf_check_parts.h"

#include <algorithm>

namespace coif::importer {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMostFaults = 40;                ///< Sentences.
constexpr std::size_t kMostPlaces = 3;                 ///< Places that are named for one kind.
constexpr std::size_t kMostCheckedNumbers = 1u << 28;  ///< Numbers of an accessor: no file that is read has more.

/// The text without the place and without numbers.
std::string kind_of(const std::string& text) {
  const std::size_t place = text.find(": ");
  std::string kind = place == std::string::npos ? text : text.substr(place);
  std::erase_if(kind, [](char letter) { return letter >= '0' && letter <= '9'; });
  return kind;
}

}  // namespace

void GltfFaults::add(const char* code, std::string text) {
  const bool is_known = std::ranges::any_of(told_, [&](const Diagnostic& told) { return told.message == text; });
  if (is_known) return;
  Kind& kind = kinds_[kind_of(text)];
  if (kind.named == kMostPlaces) {
    ++kind.more;
  } else if (told_.size() < kMostFaults) {
    ++kind.named;
    kind.last = told_.size();
    told_.emplace_back(code, std::move(text));
  } else {
    ++more_;
  }
}

Diagnostics GltfFaults::finish() && {
  for (const auto& [text, kind] : kinds_) {
    if (kind.more > 0)
      told_[kind.last].message += fmt::format(" (and the same in {})", counted(kind.more, "more place", "more places"));
  }
  if (more_ > 0) told_.emplace_back(gltf_code::kRules, fmt::format("{} more places break the rules of glTF", more_));
  return std::move(told_);
}

std::string gltf_part_name(const char* what, const json& object, std::size_t index) {
  const std::string name = printable_text_of(member(object, "name"));
  return name.empty() ? fmt::format("{} {}", what, index) : fmt::format("{} '{}'", what, name);
}

bool CheckedGltf::uses(std::string_view extension) const {
  return std::ranges::any_of(list("extensionsUsed"), [&](const json& used) { return used == extension; });
}

std::optional<std::size_t> CheckedGltf::buffer_size(std::size_t buffer, std::string& why) {
  const auto bytes = buffers_.bytes(buffer);
  if (bytes) return bytes->size();
  why = bytes.error();
  return std::nullopt;
}

std::optional<StoredNumbers> CheckedGltf::read(const json& accessor) {
  const json& accessors = list("accessors");
  const auto index = index_of(accessor, accessors.size());
  if (!index) return std::nullopt;
  const json &entry = accessors[*index], &views = list("bufferViews");
  const std::size_t width = gltf::gltf_type_width(member(entry, "type"));
  const bool is_float = member(entry, "componentType") == 5126;
  // Columns of matrices of small numbers are padded; no such matrix means anything to anyone.
  if (width == 0 || ((width > 4 || member(entry, "type") == "MAT2") && !is_float)) return std::nullopt;
  const json& view = member(entry, "bufferView");
  // Without a view it is all zeros, or the data of an extension.
  if (view.is_null() && !member(entry, "sparse").is_object()) return std::nullopt;
  const auto in_view = index_of(view, views.size());
  if (in_view && member(views[*in_view], "extensions").is_object()) return std::nullopt;
  const auto elements = gltf::read_gltf_elements(buffers_, entry, kMostCheckedNumbers / width);
  if (!elements) return std::nullopt;
  StoredNumbers out{elements->component, elements->normalized, elements->width, std::vector<double>(elements->count())};
  for (std::size_t i = 0; i < out.numbers.size(); ++i) out.numbers[i] = elements->stored(i);
  return out;
}

Diagnostics check_gltf(const fs::path& path) {
  const auto document = gltf::read_gltf_json(path);
  if (!document) {
    GltfFaults of_container;
    check_gltf_container(path, of_container);
    of_container.add(gltf_code::kRules, "its JSON breaks JSON's rules: {}; export it again", document.error());
    return std::move(of_container).finish();
  }
  gltf::GltfBuffers buffers(path, *document);
  return check_gltf(path, *document, buffers);
}

Diagnostics check_gltf(const fs::path& path, const json& document, gltf::GltfBuffers& buffers) {
  CheckedGltf file(document, buffers);
  check_gltf_container(path, file.faults);
  check_gltf_objects(file);
  check_gltf_accessors(file);
  check_gltf_meshes(file);
  check_gltf_skins(file);
  check_gltf_animations(file);
  return std::move(file.faults).finish();
}

}  // namespace coif::importer
