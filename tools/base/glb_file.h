#pragma once

// Writing binary glTF 2.0: one JSON document, one buffer.
// Source: Khronos, "glTF 2.0 Specification", chapters 3.6 (binary data) and 4.4 (GLB).

#include "base/json.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// The types of numbers in glTF, with the values of the specification.
enum class GlbComponent : std::uint32_t {
  kUnsignedByte = 5121,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126
};

/// The GPU's use of a buffer view; kAny for animation data and images.
enum class GlbTarget : std::uint32_t { kAny = 0, kVertices = 34962, kIndices = 34963 };

struct GlbArray {
  GlbComponent component = GlbComponent::kFloat;
  const char* type = "SCALAR";  ///< "SCALAR", "VEC2", "VEC3", "VEC4" or "MAT4".
  GlbTarget target = GlbTarget::kAny;
  bool normalized = false;
};

/// `type` of floats, one for each vertex.
[[nodiscard]] constexpr GlbArray vertex_floats(const char* type) {
  return {GlbComponent::kFloat, type, GlbTarget::kVertices, false};
}

/// `Json` decides the order of members: nlohmann::json sorts by name, nlohmann::ordered_json keeps the order of
/// insertion.
template <class Json>
class GlbFile {
 public:
  /// Everything but buffers, bufferViews and accessors is the caller's to fill.
  Json document;

  /// Copies the elements into the buffer; returns the accessor's index. `Element` is one tightly packed element.
  template <typename Element>
  std::size_t add(std::span<const Element> elements, const GlbArray& array) {
    return add_accessor(std::as_bytes(elements), elements.size(), array);
  }
  template <typename Element>
  std::size_t add(const std::vector<Element>& elements, const GlbArray& array) {
    return add(std::span<const Element>(elements), array);
  }

  /// The joints that hold each vertex; as bytes where they `fit`, which is half the size.
  std::size_t add_joints(std::span<const std::array<std::uint16_t, 4>> joints, bool fit);

  /// Writes the smallest and largest value of each component, which glTF requires for positions and key times.
  /// `values`: the accessor's numbers, `width` per element.
  void add_bounds(std::size_t accessor, std::span<const float> values, std::size_t width);

  /// Copies raw bytes into the buffer; returns the buffer view's index.
  std::size_t add_view(std::span<const std::byte> bytes, GlbTarget target = GlbTarget::kAny);

  /// The finished file; empty above the container's limit of 4 GiB.
  [[nodiscard]] std::vector<std::byte> bytes() const;

 private:
  std::size_t add_accessor(std::span<const std::byte> bytes, std::size_t count, const GlbArray& array);

  std::vector<std::byte> buffer_;
};

extern template class GlbFile<nlohmann::json>;
extern template class GlbFile<nlohmann::ordered_json>;

}  // namespace coif
