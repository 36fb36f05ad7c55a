#pragma once

#include "import/gltf_buffers.h"

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace coif {

/// What an accessor has to be.
struct NumbersWanted {
  const char* type = "SCALAR";    ///< "SCALAR", "VEC3" or "VEC4".
  std::size_t width = 1;          ///< Numbers per element of that type.
  std::size_t most_elements = 1;  ///< More are refused.
};

/// All numbers of an accessor, element by element: floats, or normalized integers as the fractions that they mean. All
/// are finite. The error is a sentence without the file's name; sparse accessors are refused.
/// `document` needs the members `accessors` and `bufferViews`; `accessor` is an index in it, by somebody's word.
[[nodiscard]] tl::expected<std::vector<float>, std::string> read_gltf_numbers(const nlohmann::json& document,
                                                                              GltfBuffers& buffers,
                                                                              const nlohmann::json& accessor,
                                                                              const NumbersWanted& wanted);

}  // namespace coif
