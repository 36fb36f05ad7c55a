#include "gltf/accessors.h"

#include "gltf/document.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace coif::gltf {
namespace {

using nlohmann::json;
using Bytes = tl::expected<std::vector<std::byte>, std::string>;

template <class Number>
Number stored(const std::byte* at) {
  Number value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <class Number>
double stored_double(const std::byte* at) {
  return double(stored<Number>(at));
}

template <class Integer>
constexpr GltfComponent kInteger{sizeof(Integer), double(std::numeric_limits<Integer>::max()),
                                 std::is_unsigned_v<Integer>, stored_double<Integer>};

}  // namespace

GltfComponent gltf_component(std::uint32_t type) {
  switch (type) {
    case 5120: return kInteger<std::int8_t>;
    case 5121: return kInteger<std::uint8_t>;
    case 5122: return kInteger<std::int16_t>;
    case 5123: return kInteger<std::uint16_t>;
    case 5125: return kInteger<std::uint32_t>;
    case 5126: return {sizeof(float), 0, false, stored_double<float>};
    default: return {};
  }
}

double gltf_value(const GltfComponent& component, bool normalized, double stored) {
  return normalized && component.largest > 0 ? std::max(stored / component.largest, -1.0) : stored;
}

std::size_t gltf_type_width(const json& type) {
  constexpr std::pair<const char*, std::size_t> kWidths[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                                             {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};
  for (const auto& [name, width] : kWidths) {
    if (type == name) return width;
  }
  return 0;
}

namespace {

GltfComponent component_of(const json& accessor) {
  return gltf_component(index_of(member(accessor, "componentType"), 10000).value_or(0));
}

/// Copies `count` elements of `size` bytes out of a view, from `offset` on.
std::string copy_elements(const GltfView& view, const json& offset, std::size_t size, std::span<std::byte> out) {
  const std::size_t count = out.size() / size;
  const std::size_t stride = view.stride == 0 ? size : view.stride;
  const auto first = offset.is_null() ? std::optional<std::uint32_t>(0) : index_of(offset, kMostBufferBytes + 1);
  if (!first) return "has a byteOffset that is none";
  if (stride < size) return fmt::format("has elements of {} bytes that lie {} apart", size, stride);
  if (*first > view.bytes.size())
    return fmt::format("begins at byte {} of a bufferView of {}", *first, view.bytes.size());
  const std::span<const std::byte> bytes = view.bytes.subspan(*first);
  const std::size_t held = bytes.size() < size ? 0 : (bytes.size() - size) / stride + 1;
  if (held < count) return fmt::format("is cut off: {} of {} elements", held, count);
  for (std::size_t i = 0; i < count; ++i) std::memcpy(&out[i * size], &bytes[i * stride], size);
  return {};
}

/// Puts the elements of a sparse accessor that differ into `out`.
std::string replace_sparse(GltfBuffers& buffers, const json& sparse, std::size_t size, std::span<std::byte> out) {
  const std::size_t elements = out.size() / size;
  const auto count = index_of(member(sparse, "count"), elements + 1);
  if (!count) return "is sparse, with more replaced elements than it has";
  const json &indices = member(sparse, "indices"), &values = member(sparse, "values");
  const GltfComponent index = component_of(indices);
  if (!index.is_unsigned) return "is sparse, with indices that are no unsigned integers";
  const auto index_view = buffers.view(member(indices, "bufferView"));
  if (!index_view) return "is sparse, and its list of indices " + index_view.error();
  std::vector<std::byte> places(*count * index.size), replacements(*count * size);
  if (std::string bad = copy_elements(*index_view, member(indices, "byteOffset"), index.size, places); !bad.empty()) {
    return "is sparse, and its list of indices " + bad;
  }
  const auto value_view = buffers.view(member(values, "bufferView"));
  if (!value_view) return "is sparse, and its list of values " + value_view.error();
  if (std::string bad = copy_elements(*value_view, member(values, "byteOffset"), size, replacements); !bad.empty()) {
    return "is sparse, and its list of values " + bad;
  }
  for (std::size_t i = 0; i < *count; ++i) {
    const auto place = std::size_t(index.stored(&places[i * index.size]));
    if (place >= elements) return fmt::format("is sparse, and replaces element {} of {}", place, elements);
    std::memcpy(&out[place * size], &replacements[i * size], size);
  }
  return {};
}

/// The elements, one after another. Without a bufferView they are zeros.
Bytes packed_elements(GltfBuffers& buffers, const json& accessor, std::size_t size, std::size_t most) {
  const auto count = index_of(member(accessor, "count"), most + 1);
  if (!count || *count == 0) return fault("has no count of 1 to {}", most);
  const json& sparse = member(accessor, "sparse");
  const json& in_view = member(accessor, "bufferView");
  std::vector<std::byte> out;
  if (!in_view.is_null()) {
    const auto view = buffers.view(in_view);
    if (!view) return tl::unexpected(view.error());
    const std::size_t stride = std::max<std::size_t>(view->stride, 1);
    if (*count > view->bytes.size() / stride + 1)
      return fault("is cut off: bufferView of {} bytes for {} elements", view->bytes.size(), *count);
    out.resize(*count * size);
    if (std::string bad = copy_elements(*view, member(accessor, "byteOffset"), size, out); !bad.empty())
      return tl::unexpected(bad);
  } else {
    out.resize(*count * size);
  }
  if (sparse.is_null()) return out;
  if (std::string bad = replace_sparse(buffers, sparse, size, out); !bad.empty()) return tl::unexpected(bad);
  return out;
}

}  // namespace

tl::expected<GltfElements, std::string> read_gltf_elements(GltfBuffers& buffers, const json& accessor,
                                                           std::size_t most) {
  GltfElements out{
      component_of(accessor), member(accessor, "normalized") == true, gltf_type_width(member(accessor, "type")), {}};
  if (out.component.size == 0 || out.width == 0) return fault("is of no type of glTF's");
  auto bytes = packed_elements(buffers, accessor, out.component.size * out.width, most);
  if (!bytes) return tl::unexpected(bytes.error());
  out.bytes = std::move(*bytes);
  return out;
}

namespace {

tl::expected<std::vector<float>, std::string> read_numbers(GltfBuffers& buffers, const json& accessor,
                                                           const NumbersWanted& wanted) {
  if (member(accessor, "type") != wanted.type) return fault("is not of type {}", wanted.type);
  const GltfComponent component = component_of(accessor);
  const bool stands_for_itself = component.largest > 0 && member(accessor, "normalized") != true;
  if (component.size == 0 || (stands_for_itself && !wanted.may_be_quantized))
    return fault("has neither floats nor normalized integers");
  const auto elements = read_gltf_elements(buffers, accessor, wanted.most_elements);
  if (!elements) return tl::unexpected(elements.error());
  std::vector<float> numbers(elements->count());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = float(gltf_value(component, elements->normalized, elements->stored(i)));
    if (!wanted.may_be_infinite && !std::isfinite(numbers[i]))
      return fault("is not finite in element {}", i / wanted.width);
  }
  return numbers;
}

tl::expected<std::vector<std::uint32_t>, std::string> read_integers(GltfBuffers& buffers, const json& accessor,
                                                                    std::size_t most, std::size_t width) {
  if (!component_of(accessor).is_unsigned || member(accessor, "type") != (width == 1 ? "SCALAR" : "VEC4")) {
    return fault("has no plain list of unsigned numbers");
  }
  const auto elements = read_gltf_elements(buffers, accessor, most);
  if (!elements) return tl::unexpected(elements.error());
  std::vector<std::uint32_t> numbers(elements->count());
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = std::uint32_t(elements->stored(i));
  return numbers;
}

/// The entry that `accessor` names, read by `read`; its number begins the sentence of an error.
template <class Read>
auto with_accessor(const json& document, const json& accessor, Read read) -> decltype(read(accessor)) {
  const json& accessors = list_of(member(document, "accessors"));
  const auto index = index_of(accessor, accessors.size());
  if (!index) return fault("there is no such accessor among {}", accessors.size());
  auto numbers = read(accessors[*index]);
  if (!numbers) return fault("accessor {} {}", *index, numbers.error());
  return numbers;
}

}  // namespace

tl::expected<std::vector<float>, std::string> read_gltf_numbers(const json& document, GltfBuffers& buffers,
                                                                const json& accessor, const NumbersWanted& wanted) {
  return with_accessor(document, accessor, [&](const json& entry) { return read_numbers(buffers, entry, wanted); });
}

tl::expected<std::vector<std::uint32_t>, std::string> read_gltf_indices(const json& document, GltfBuffers& buffers,
                                                                        const json& accessor, std::size_t most,
                                                                        std::size_t width) {
  return with_accessor(document, accessor,
                       [&](const json& entry) { return read_integers(buffers, entry, most, width); });
}

}  // namespace coif::gltf
