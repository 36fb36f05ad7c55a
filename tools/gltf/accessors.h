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

namespace coif {

/// What an accessor has to be.
struct NumbersWanted {
  const char* type = "SCALAR";      ///< "SCALAR", "VEC2", "VEC3", "VEC4" or "MAT4".
  std::size_t width = 1;            ///< Numbers per element of that type.
  std::size_t most_elements = 1;    ///< More are refused.
  bool may_be_quantized = false;    ///< Integers that are not normalized stand for themselves; else they are refused.
  bool may_be_infinite = false;     ///< Else what is not finite is refused.
};

/// All numbers of an accessor, element by element: floats, or normalized integers as the fractions that they mean; sparse ones too.
/// The error is a sentence without the file's name. `document` needs the members `accessors` and `bufferViews`; `accessor` is an
/// index in it, by somebody's word.
[[nodiscard]] tl::expected<std::vector<float>, std::string> read_gltf_numbers(const nlohmann::json& document,
                                                                              GltfBuffers& buffers,
                                                                              const nlohmann::json& accessor,
                                                                              const NumbersWanted& wanted);

/// All numbers of an accessor of unsigned integers, such as indices, `width` to the element ("SCALAR" or "VEC4"); at most so many
/// elements. As read_gltf_numbers() otherwise.
[[nodiscard]] tl::expected<std::vector<std::uint32_t>, std::string> read_gltf_indices(const nlohmann::json& document,
                                                                                      GltfBuffers& buffers,
                                                                                      const nlohmann::json& accessor,
                                                                                      std::size_t most, std::size_t width = 1);

/// How a component of an accessor is stored.
struct GltfComponent {
  std::size_t size = 0;                      ///< Bytes.
  float (*number)(const std::byte*) = nullptr;    ///< What it means, normalized or not.
  std::uint32_t (*index)(const std::byte*) = nullptr;  ///< Null for floats and signed integers.
  bool stands_for_itself = false;            ///< An integer that is not normalized.
};

/// `type` is a componentType of the document; size 0 where there is none of that number.
[[nodiscard]] GltfComponent gltf_component(std::uint32_t type, bool normalized);

}  // namespace coif
