#pragma once

// The values of accessors in a glTF document.
// Source: Khronos, "glTF 2.0 Specification", chapter 3.6.2; "KHR_mesh_quantization".

#include "base/json.h"
#include "gltf/buffers.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace coif::gltf {

/// The required form of an accessor.
struct NumbersWanted {
  const char* type = "SCALAR";    ///< "SCALAR", "VEC2", "VEC3", "VEC4" or "MAT4".
  std::size_t width = 1;          ///< Numbers per element of that type.
  std::size_t most_elements = 1;  ///< More are refused.
  /// Integers that are not normalized are allowed, as their own values; else they are refused.
  bool may_be_quantized = false;
  bool may_be_infinite = false;  ///< Else values that are not finite are refused.
};

/// All numbers of an accessor, element by element: floats, or normalized integers as the fractions that they stand for;
/// also of sparse accessors. The error is a sentence without the file's name. `document` needs the members `accessors`
/// and `bufferViews`; `accessor` is an index in it that need not be valid.
[[nodiscard]] tl::expected<std::vector<float>, std::string> read_gltf_numbers(const nlohmann::json& document,
                                                                              GltfBuffers& buffers,
                                                                              const nlohmann::json& accessor,
                                                                              const NumbersWanted& wanted);

/// All numbers of an accessor of unsigned integers, such as indices, `width` per element ("SCALAR" or "VEC4"); at most
/// `most` elements. Otherwise as read_gltf_numbers().
[[nodiscard]] tl::expected<std::vector<std::uint32_t>, std::string> read_gltf_indices(const nlohmann::json& document,
                                                                                      GltfBuffers& buffers,
                                                                                      const nlohmann::json& accessor,
                                                                                      std::size_t most,
                                                                                      std::size_t width = 1);

/// The storage of an accessor's component.
struct GltfComponent {
  std::size_t size = 0;  ///< Bytes.
  double largest = 0;    ///< The largest integer, which stands for 1 if normalized; 0 for floats.
  bool is_unsigned = false;
  double (*stored)(const std::byte*) = nullptr;  ///< Reads the stored number.
};

/// `type` is a componentType of the document; size 0 for an unknown one.
[[nodiscard]] GltfComponent gltf_component(std::uint32_t type);

/// The value of a stored number: the number itself, or if normalized its fraction of the largest.
[[nodiscard]] double gltf_value(const GltfComponent& component, bool normalized, double stored);

/// Numbers per element of that type; 0 for an unknown type.
[[nodiscard]] std::size_t gltf_type_width(const nlohmann::json& type);

/// The stored elements of an accessor, one after another, with sparse replacements. Without a bufferView they are
/// zeros.
struct GltfElements {
  GltfComponent component;
  bool normalized = false;
  std::size_t width = 1;  ///< Numbers of an element.
  std::vector<std::byte> bytes;

  /// Counts numbers, not elements.
  [[nodiscard]] std::size_t count() const { return bytes.size() / component.size; }
  [[nodiscard]] double stored(std::size_t i) const { return component.stored(&bytes[i * component.size]); }
};

/// `accessor` is the object in the document, not its index; more than `most` elements are refused. The error is the end
/// of a sentence: "is cut off".
[[nodiscard]] tl::expected<GltfElements, std::string> read_gltf_elements(GltfBuffers& buffers,
                                                                         const nlohmann::json& accessor,
                                                                         std::size_t most);

}  // namespace coif::gltf
