#include "import/gltf_numbers.h"

#include "import/json_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

namespace coif {
namespace {

using nlohmann::json;

constexpr std::size_t kMostBytes = std::size_t{1} << 30;

tl::unexpected<std::string> fault(std::string text) { return tl::unexpected(std::move(text)); }

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
  return value.is_null() ? std::optional(otherwise) : std::optional<std::size_t>(index_of(value, kMostBytes + 1));
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
  if (member(view, "extensions").is_object()) return fault(fmt::format("is compressed (bufferView {})", *index));
  const auto buffer = index_of(member(view, "buffer"), kMostBytes);
  const auto begin = size_of(member(view, "byteOffset"), 0), size = size_of(member(view, "byteLength"), kMostBytes + 1);
  const auto stride = size_of(member(view, "byteStride"), element_size);
  const auto first = size_of(member(accessor, "byteOffset"), 0);
  if (!buffer || !begin || !size || !stride || !first || *stride < element_size) {
    return fault(fmt::format("has offsets or sizes that are no such numbers (bufferView {})", *index));
  }
  const auto bytes = buffers.bytes(*buffer);
  if (!bytes) return fault(fmt::format("is in bufferView {}, and {}", *index, bytes.error()));
  if (*begin > bytes->size() || *size > bytes->size() - *begin) {
    return fault(fmt::format("is in bufferView {}, which ends at byte {} of a buffer of {}", *index, *begin + *size,
                             bytes->size()));
  }
  if (*first > *size) return fault(fmt::format("begins at byte {} of a bufferView of {}", *first, *size));
  return Elements{bytes->subspan(*begin + *first, *size - *first), *stride};
}

tl::expected<std::vector<float>, std::string> read_numbers(const json& document, GltfBuffers& buffers,
                                                           const json& accessor, const NumbersWanted& wanted) {
  if (member(accessor, "type") != wanted.type) return fault(fmt::format("is not of type {}", wanted.type));
  if (!member(accessor, "sparse").is_null()) return fault("is sparse, which is not supported");
  const auto component = component_of(accessor);
  if (!component) return fault("has neither floats nor normalized integers of 8 or 16 bits");
  const auto count = index_of(member(accessor, "count"), wanted.most_elements + 1);
  if (!count || *count == 0) return fault(fmt::format("has no count of 1 to {}", wanted.most_elements));
  const std::size_t size = component->size * wanted.width;
  const auto elements = find_elements(document, buffers, accessor, size);
  if (!elements) return tl::unexpected(elements.error());
  const std::size_t held = elements->bytes.size() < size ? 0 : (elements->bytes.size() - size) / elements->stride + 1;
  if (held < *count) return fault(fmt::format("is cut off: {} of {} elements", held, *count));
  std::vector<float> numbers(*count * wanted.width);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t element = i / wanted.width;
    numbers[i] = component->read(&elements->bytes[element * elements->stride + i % wanted.width * component->size]);
    if (!std::isfinite(numbers[i])) return fault(fmt::format("is not finite in element {}", element));
  }
  return numbers;
}

}  // namespace

tl::expected<std::vector<float>, std::string> read_gltf_numbers(const json& document, GltfBuffers& buffers,
                                                                const json& accessor, const NumbersWanted& wanted) {
  const json& accessors = list_of(member(document, "accessors"));
  const auto index = index_of(accessor, accessors.size());
  if (!index) return fault(fmt::format("there is no such accessor among {}", accessors.size()));
  auto numbers = read_numbers(document, buffers, accessors[*index], wanted);
  if (!numbers) return fault(fmt::format("accessor {} {}", *index, numbers.error()));
  return numbers;
}

}  // namespace coif
