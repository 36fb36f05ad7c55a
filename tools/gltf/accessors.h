#pragma once

// What accessors of a glTF document hold, as the numbers that they mean.
// Source: Khronos, "glTF 2.0 Specification", chapter 3.6.2; "KHR_mesh_quantization".

#include "base/json.h"
#include "gltf/buffers.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace coif::gltf {

/// What an accessor has to be.
struct NumbersWanted {
  const char* type = "SCALAR";    ///< "SCALAR", "VEC2", "VEC3", "VEC4" or "MAT4".
  std::size_t width = 1;          ///< Numbers per element of that type.
  std::size_t most_elements = 1;  ///< More are refused.
  bool may_be_quantized = false;  ///< Integers that are not normalized stand for themselves; else they are refused.
  bool may_be_infinite = false;   ///< Else what is not finite is refused.
};

/// All numbers of an accessor, element by element: floats, or normalized integers as the fractions that they mean;
/// sparse ones too. The error is a sentence without the file's name. `document` needs the members `accessors` and
/// `bufferViews`; `accessor` is an index in it, by somebody's word.
[[nodiscard]] tl::expected<std::vector<float>, std::string> read_gltf_numbers(const nlohmann::json& document,
                                                                              GltfBuffers& buffers,
                                                                              const nlohmann::json& accessor,
                                                                              const NumbersWanted& wanted);

/// All numbers of an accessor of unsigned integers, such as indices, `width` to the element ("SCALAR" or "VEC4"); at
/// most so many elements. As read_gltf_numbers() otherwise.
[[nodiscard]] tl::expected<std::vector<std::uint32_t>, std::string> read_gltf_indices(const nlohmann::json& document,
                                                                                      GltfBuffers& buffers,
                                                                                      const nlohmann::json& accessor,
                                                                                      std::size_t most,
                                                                                      std::size_t width = 1);

/// How a component of an accessor is stored.
struct GltfComponent {
  std::size_t size = 0;  ///< Bytes.
  double largest = 0;    ///< Of integers, which is 1 where they are normalized; 0 for floats.
  bool is_unsigned = false;
  double (*stored)(const std::byte*) = nullptr;  ///< The number as it stands there.
};

/// `type` is a componentType of the document; size 0 where there is none of that number.
[[nodiscard]] GltfComponent gltf_component(std::uint32_t type);

/// What a stored number means: itself, or where it is normalized the fraction of the largest.
[[nodiscard]] double gltf_value(const GltfComponent& component, bool normalized, double stored);

/// Numbers of an element of that type; 0 for what is no type.
[[nodiscard]] std::size_t gltf_type_width(const nlohmann::json& type);

/// The elements of an accessor as they are stored, one after another, replaced where it is sparse. Without a bufferView
/// they are zeros.
struct GltfElements {
  GltfComponent component;
  bool normalized = false;
  std::size_t width = 1;  ///< Numbers of an element.
  std::vector<std::byte> bytes;

  [[nodiscard]] std::size_t count() const { return bytes.size() / component.size; }  ///< Of numbers.
  [[nodiscard]] double stored(std::size_t i) const { return component.stored(&bytes[i * component.size]); }
};

/// `accessor` is one of the document's, not its index; more than `most` elements are refused. The error is a sentence's
/// end: "is cut off".
[[nodiscard]] tl::expected<GltfElements, std::string> read_gltf_elements(GltfBuffers& buffers,
                                                                         const nlohmann::json& accessor,
                                                                         std::size_t most);

}  // namespace coif::gltf
