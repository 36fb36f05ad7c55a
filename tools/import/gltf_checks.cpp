#include "import/gltf_checks.h"

#include "import/gltf_check_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <span>

namespace coif {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMostFaults = 40;            ///< Sentences.
constexpr std::size_t kMostPlaces = 3;             ///< Of one kind that are named.
constexpr std::size_t kMostCheckedNumbers = 1u << 28;  ///< Of an accessor: more is in no file that is read.

/// What lies at an address, in its own byte order, which is this machine's.
template <class Number>
double stored_number(const std::byte* at) {
  Number number;
  std::memcpy(&number, at, sizeof number);
  return double(number);
}

using NumberAt = double (*)(const std::byte*);

NumberAt reader_of(std::uint32_t component) {
  switch (component) {
    case 5120: return stored_number<std::int8_t>;
    case 5121: return stored_number<std::uint8_t>;
    case 5122: return stored_number<std::int16_t>;
    case 5123: return stored_number<std::uint16_t>;
    case 5125: return stored_number<std::uint32_t>;
    case 5126: return stored_number<float>;
    default: return nullptr;
  }
}

}  // namespace

namespace {

/// What is said of a place, without the place and without numbers.
std::string kind_of(const std::string& text) {
  const std::size_t place = text.find(": ");
  std::string kind = place == std::string::npos ? text : text.substr(place);
  std::erase_if(kind, [](char letter) { return letter >= '0' && letter <= '9'; });
  return kind;
}

}  // namespace

void GltfFaults::add(const char* code, std::string text) {
  const bool is_known = std::ranges::any_of(told_, [&](const SourceDoubt& told) { return told.text == text; });
  if (is_known) return;
  Kind& kind = kinds_[kind_of(text)];
  if (kind.named == kMostPlaces) {
    ++kind.more;
  } else if (told_.size() < kMostFaults) {
    ++kind.named;
    kind.last = told_.size();
    told_.push_back({code, std::move(text)});
  } else {
    ++more_;
  }
}

std::vector<SourceDoubt> GltfFaults::finish() && {
  for (const auto& [text, kind] : kinds_) {
    if (kind.more > 0) told_[kind.last].text += fmt::format(" (and the same in {})", counted(kind.more, "more place", "more places"));
  }
  if (more_ > 0) told_.push_back({gltf_code::kRules, fmt::format("{} more places break the rules of glTF", more_)});
  return std::move(told_);
}

double StoredNumbers::largest() const {
  switch (component) {
    case 5120: return 127;
    case 5121: return 255;
    case 5122: return 32767;
    case 5123: return 65535;
    case 5125: return 4294967295.0;
    default: return 0;
  }
}

double StoredNumbers::value(std::size_t i) const {
  return normalized && !is_float() ? std::max(numbers[i] / largest(), -1.0) : numbers[i];
}

std::size_t gltf_component_size(std::uint32_t component) {
  constexpr std::array<std::size_t, 7> kSizes{1, 1, 2, 2, 0, 4, 4};
  return component >= 5120 && component <= 5126 ? kSizes[component - 5120] : 0;
}

std::size_t gltf_type_width(const json& type) {
  constexpr std::pair<const char*, std::size_t> kWidths[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                             {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
  for (const auto& [name, width] : kWidths) {
    if (type == name) return width;
  }
  return 0;
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

/// `place` has a bufferView and may have a byteOffset.
std::optional<std::vector<double>> CheckedGltf::plain(const json& place, std::uint32_t component, std::size_t width,
                                                      std::size_t count) {
  constexpr std::size_t kAny = std::size_t{1} << 32;
  const json& views = list("bufferViews");
  const auto index = index_of(member(place, "bufferView"), views.size());
  if (!index || member(views[*index], "extensions").is_object()) return std::nullopt;
  const json& view = views[*index];
  const auto buffer = index_of(member(view, "buffer"), list("buffers").size());
  if (!buffer) return std::nullopt;
  const auto bytes = buffers_.bytes(*buffer);
  const std::size_t element = width * gltf_component_size(component);
  const std::size_t begin = index_of(member(view, "byteOffset"), kAny).value_or(0), first = index_of(member(place, "byteOffset"), kAny).value_or(0);
  const std::size_t length = index_of(member(view, "byteLength"), kAny).value_or(0);
  const std::size_t stride = index_of(member(view, "byteStride"), kAny).value_or(std::uint32_t(element));
  if (!bytes || begin > bytes->size() || length > bytes->size() - begin || first > length || count == 0) return std::nullopt;
  const std::span<const std::byte> held = bytes->subspan(begin + first, length - first);
  if (stride < element || held.size() < element || (held.size() - element) / stride + 1 < count) return std::nullopt;
  std::vector<double> numbers(count * width);
  const NumberAt at = reader_of(component);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = at(&held[i / width * stride + i % width * gltf_component_size(component)]);
  return numbers;
}

std::optional<StoredNumbers> CheckedGltf::read(const json& accessor) {
  const json& accessors = list("accessors");
  const auto index = index_of(accessor, accessors.size());
  if (!index) return std::nullopt;
  const json& entry = accessors[*index];
  StoredNumbers out;
  out.component = index_of(member(entry, "componentType"), 10000).value_or(0);
  out.width = gltf_type_width(member(entry, "type"));
  out.normalized = member(entry, "normalized") == true;
  const std::size_t count = index_of(member(entry, "count"), kMostCheckedNumbers).value_or(0);
  const bool is_matrix = out.width > 4 || member(entry, "type") == "MAT2";
  // Columns of matrices of small numbers are padded; no such matrix means anything to anyone.
  if (gltf_component_size(out.component) == 0 || out.width == 0 || count == 0 || (is_matrix && !out.is_float())) return std::nullopt;
  if (count > kMostCheckedNumbers / out.width) return std::nullopt;
  const json& sparse = member(entry, "sparse");
  if (!member(entry, "bufferView").is_null()) {
    auto numbers = plain(entry, out.component, out.width, count);
    if (!numbers) return std::nullopt;
    out.numbers = std::move(*numbers);
  } else if (sparse.is_object()) {
    out.numbers.assign(count * out.width, 0);
  } else {
    return std::nullopt;  // All zeros, or what an extension gives.
  }
  if (!sparse.is_object()) return out;
  const std::size_t changed = index_of(member(sparse, "count"), count + 1).value_or(0);
  const json& places = member(sparse, "indices");
  const auto kind = index_of(member(places, "componentType"), 10000).value_or(0);
  if (kind != 5121 && kind != 5123 && kind != 5125) return std::nullopt;
  const auto where = plain(places, kind, 1, changed);
  const auto what = plain(member(sparse, "values"), out.component, out.width, changed);
  if (!where || !what) return std::nullopt;
  for (std::size_t i = 0; i < changed; ++i) {
    if ((*where)[i] >= double(count)) return std::nullopt;
    std::copy_n(&(*what)[i * out.width], out.width, &out.numbers[std::size_t((*where)[i]) * out.width]);
  }
  return out;
}

std::vector<SourceDoubt> check_gltf(const fs::path& path) {
  GltfFaults of_container;
  check_gltf_container(path, of_container);
  auto document = read_gltf_json(path);
  if (!document || !document->is_object()) {
    of_container.add(gltf_code::kRules, "its JSON breaks JSON's rules{}; export it again",
                     document ? "" : ": " + document.error());
    return std::move(of_container).finish();
  }
  CheckedGltf file(path, *document);
  file.faults = std::move(of_container);
  check_gltf_objects(file);
  check_gltf_accessors(file);
  check_gltf_meshes(file);
  check_gltf_skins(file);
  check_gltf_animations(file);
  return std::move(file.faults).finish();
}

}  // namespace coif
