#include "import/gltf_document.h"

#include "base/encodings.h"
#include "base/files.h"
#include "base/text.h"
#include "import/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace coif {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Bytes = tl::expected<std::vector<std::byte>, std::string>;

constexpr std::size_t kMostBufferBytes = std::size_t{1} << 30;

Bytes read_part(std::ifstream& file, std::size_t size) {
  std::vector<std::byte> bytes(size);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (std::size_t(file.gcount()) != size) return fault("cut off: {} of {} bytes", file.gcount(), size);
  return bytes;
}

bool read_word(std::ifstream& file, std::uint32_t& word) {
  return bool(file.read(reinterpret_cast<char*>(&word), sizeof word));
}

/// The chunk after the JSON one. Sizes are checked against the file's, so that none makes the reader allocate more.
Bytes read_binary_chunk(const fs::path& path, std::size_t wanted) {
  constexpr std::streamoff kHeader = 12, kChunkHeader = 8;
  std::ifstream file(path, std::ios::binary);
  char magic[4] = {};
  std::uint32_t json_bytes = 0, size = 0, type = 0;
  file.read(magic, sizeof magic);
  if (!file || std::memcmp(magic, "glTF", sizeof magic) != 0) return fault("without a uri, and the file is no .glb");
  file.seekg(kHeader);
  if (!read_word(file, json_bytes)) return fault("cut off");
  file.seekg(kHeader + kChunkHeader + std::streamoff{json_bytes});
  if (!read_word(file, size) || !read_word(file, type) || std::memcmp(&type, "BIN", 4) != 0) {
    return fault("without a uri, and the .glb has no binary chunk");
  }
  std::error_code code;
  const std::uintmax_t whole = fs::file_size(path, code);
  const auto left = code ? 0 : whole - std::uintmax_t(file.tellg());
  if (wanted > size || wanted > left) {
    return fault("cut off: {} of {} bytes", std::min<std::uintmax_t>(size, left), wanted);
  }
  return read_part(file, wanted);
}

Bytes read_side_file(const fs::path& document, const std::vector<fs::path>& folders, const std::string& uri, std::size_t wanted) {
  const fs::path name = decoded_uri(uri);
  const bool inside = !name.empty() && name.is_relative() && *name.lexically_normal().begin() != ".." &&
                      name.native().find('\0') == std::string::npos && uri.find("://") == std::string::npos;
  const std::string shown = printable_text(uri, 100);
  if (!inside) return fault("in '{}', which is not in this file's folder", shown);
  const fs::path path = document.parent_path() / name;
  if (auto readable = check_readable(path, kMostBufferBytes); !readable) {
    return tl::unexpected(readable.error().message);
  }
  if (!folders.empty() && !lies_in(path, folders)) {
    return fault("in '{}', a link that leads out of this file's folder; allow with --root what it leads to", shown);
  }
  std::ifstream file(path, std::ios::binary);
  std::error_code code;
  const std::uintmax_t size = fs::file_size(path, code);
  if (code || size < wanted) return fault("cut off: '{}' has {} of {} bytes", shown, code ? 0 : size, wanted);
  return read_part(file, wanted);
}

Bytes read_buffer(const fs::path& path, const std::vector<fs::path>& folders, const json& buffer, std::size_t wanted) {
  const json& uri = member(buffer, "uri");
  if (!uri.is_string()) return read_binary_chunk(path, wanted);
  const auto& text = uri.get_ref<const std::string&>();
  if (!text.starts_with("data:")) return read_side_file(path, folders, text, wanted);
  const std::size_t comma = text.find(";base64,");
  if (comma == std::string::npos) return fault("a data: URI that is not base64");
  auto bytes = from_base64(std::string_view(text).substr(comma + std::strlen(";base64,")));
  if (!bytes) return fault("not base64");
  if (bytes->size() < wanted) return fault("cut off: {} of {} bytes", bytes->size(), wanted);
  bytes->resize(wanted);
  return std::move(*bytes);
}

}  // namespace

tl::expected<std::span<const std::byte>, std::string> GltfBuffers::bytes(std::size_t buffer) {
  if (const auto found = read_.find(buffer); found != read_.end()) return found->second;
  const json& entries = list_of(member(document_, "buffers"));
  if (buffer >= entries.size()) return fault("buffer {} is not one of {}", buffer, entries.size());
  const auto wanted = index_of(member(entries[buffer], "byteLength"), kMostBufferBytes + 1);
  if (!wanted) return fault("buffer {} has no byteLength of 0 to 1 GiB", buffer);
  Bytes bytes = read_buffer(path_, folders_, entries[buffer], *wanted);
  if (!bytes) return fault("buffer {} is {}", buffer, bytes.error());
  return read_.emplace(buffer, std::move(*bytes)).first->second;
}

namespace {

template <class Integer>
float fraction(const std::byte* at) {
  Integer value;
  std::memcpy(&value, at, sizeof value);
  return std::max(float(value) / float(std::numeric_limits<Integer>::max()), -1.0f);
}

float number(const std::byte* at) {
  float value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

struct Component {
  std::size_t size;
  float (*read)(const std::byte* at);
};

std::optional<Component> component_of(const json& accessor) {
  const auto type = index_of(member(accessor, "componentType"), 10000);
  if (type == 5126) return Component{4, number};
  if (member(accessor, "normalized") != true) return std::nullopt;
  if (type == 5120) return Component{1, fraction<std::int8_t>};
  if (type == 5121) return Component{1, fraction<std::uint8_t>};
  if (type == 5122) return Component{2, fraction<std::int16_t>};
  if (type == 5123) return Component{2, fraction<std::uint16_t>};
  return std::nullopt;
}

std::optional<std::size_t> size_of(const json& value, std::size_t otherwise) {
  return value.is_null() ? std::optional(otherwise) : std::optional<std::size_t>(index_of(value, kMostBufferBytes + 1));
}

/// Where elements lie: the bytes from the first one on, and how far apart they are.
struct Elements {
  std::span<const std::byte> bytes;
  std::size_t stride;
};

tl::expected<Elements, std::string> find_elements(const json& document, GltfBuffers& buffers, const json& accessor,
                                                  std::size_t element_size) {
  const json& views = list_of(member(document, "bufferViews"));
  const auto index = index_of(member(accessor, "bufferView"), views.size());
  if (!index) return fault("has no bufferView");
  const json& view = views[*index];
  if (member(view, "extensions").is_object()) return fault("is compressed (bufferView {})", *index);
  const auto buffer = index_of(member(view, "buffer"), kMostBufferBytes);
  const auto begin = size_of(member(view, "byteOffset"), 0),
             size = size_of(member(view, "byteLength"), kMostBufferBytes + 1);
  const auto stride = size_of(member(view, "byteStride"), element_size);
  const auto first = size_of(member(accessor, "byteOffset"), 0);
  if (!buffer || !begin || !size || !stride || !first || *stride < element_size) {
    return fault("has offsets or sizes that are no such numbers (bufferView {})", *index);
  }
  const auto bytes = buffers.bytes(*buffer);
  if (!bytes) return fault("is in bufferView {}, and {}", *index, bytes.error());
  if (*begin > bytes->size() || *size > bytes->size() - *begin) {
    return fault("is in bufferView {}, which ends at byte {} of a buffer of {}", *index, *begin + *size, bytes->size());
  }
  if (*first > *size) return fault("begins at byte {} of a bufferView of {}", *first, *size);
  return Elements{bytes->subspan(*begin + *first, *size - *first), *stride};
}

tl::expected<std::vector<float>, std::string> read_numbers(const json& document, GltfBuffers& buffers,
                                                           const json& accessor, const NumbersWanted& wanted) {
  if (member(accessor, "type") != wanted.type) return fault("is not of type {}", wanted.type);
  if (!member(accessor, "sparse").is_null()) return fault("is sparse, which is not supported");
  const auto component = component_of(accessor);
  if (!component) return fault("has neither floats nor normalized integers of 8 or 16 bits");
  const auto count = index_of(member(accessor, "count"), wanted.most_elements + 1);
  if (!count || *count == 0) return fault("has no count of 1 to {}", wanted.most_elements);
  const std::size_t size = component->size * wanted.width;
  const auto elements = find_elements(document, buffers, accessor, size);
  if (!elements) return tl::unexpected(elements.error());
  const std::size_t held = elements->bytes.size() < size ? 0 : (elements->bytes.size() - size) / elements->stride + 1;
  if (held < *count) return fault("is cut off: {} of {} elements", held, *count);
  std::vector<float> numbers(*count * wanted.width);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t element = i / wanted.width;
    numbers[i] = component->read(&elements->bytes[element * elements->stride + i % wanted.width * component->size]);
    if (!std::isfinite(numbers[i])) return fault("is not finite in element {}", element);
  }
  return numbers;
}

}  // namespace

tl::expected<std::vector<float>, std::string> read_gltf_numbers(const json& document, GltfBuffers& buffers,
                                                                const json& accessor, const NumbersWanted& wanted) {
  const json& accessors = list_of(member(document, "accessors"));
  const auto index = index_of(accessor, accessors.size());
  if (!index) return fault("there is no such accessor among {}", accessors.size());
  auto numbers = read_numbers(document, buffers, accessors[*index], wanted);
  if (!numbers) return fault("accessor {} {}", *index, numbers.error());
  return numbers;
}

tl::expected<std::vector<std::uint32_t>, std::string> read_gltf_indices(const json& document, GltfBuffers& buffers,
                                                                        const json& accessor, std::size_t most) {
  const json& accessors = list_of(member(document, "accessors"));
  const auto index = index_of(accessor, accessors.size());
  if (!index) return fault("there is no such accessor among {}", accessors.size());
  const json& entry = accessors[*index];
  const auto type = index_of(member(entry, "componentType"), 10000);
  const std::size_t size = type == 5121 ? 1 : type == 5123 ? 2 : type == 5125 ? 4 : 0;
  if (size == 0 || member(entry, "type") != "SCALAR" || !member(entry, "sparse").is_null()) {
    return fault("accessor {} has no plain list of unsigned numbers", *index);
  }
  const auto count = index_of(member(entry, "count"), most + 1);
  if (!count || *count == 0) return fault("accessor {} has no count of 1 to {}", *index, most);
  const auto elements = find_elements(document, buffers, entry, size);
  if (!elements) return fault("accessor {} {}", *index, elements.error());
  const std::size_t held = elements->bytes.size() < size ? 0 : (elements->bytes.size() - size) / elements->stride + 1;
  if (held < *count) return fault("accessor {} is cut off: {} of {} elements", *index, held, *count);
  std::vector<std::uint32_t> numbers(*count, 0);
  for (std::size_t i = 0; i < numbers.size(); ++i) std::memcpy(&numbers[i], &elements->bytes[i * elements->stride], size);
  return numbers;
}

}  // namespace coif
