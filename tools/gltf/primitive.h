#pragma once

// One primitive of a glTF mesh, in the mesh's own space.
// Source: Khronos, "glTF 2.0 Specification", chapter 3.7; "KHR_draco_mesh_compression"; "KHR_mesh_quantization".

#include "base/json.h"
#include "gltf/buffers.h"

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif::gltf {

inline constexpr std::size_t kMostPrimitiveVertices = std::size_t{1} << 25;

/// The topology of a primitive: glTF 2.0, 3.7.2.1.
enum class GltfMode : std::uint8_t { kPoints, kLines, kLineLoop, kLineStrip, kTriangles, kStrip, kFan };

/// kTriangles where the primitive has no mode; none for an unknown one.
[[nodiscard]] std::optional<GltfMode> gltf_mode(const nlohmann::json& primitive);

/// Arrays are empty or have an element for each position. Numbers need not be finite, nor indices in range.
struct GltfPrimitive {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector2f> uvs;     ///< The requested set.
  std::vector<Eigen::Vector4f> colors;  ///< COLOR_0, linear; alpha 1 where the file gives none.
  std::size_t influences = 0;           ///< Per vertex: a multiple of four.
  std::vector<std::uint32_t> joints;    ///< Places in the skin's list.
  std::vector<float> weights;
  std::vector<std::uint32_t> triangles;  ///< Three each; also from strips and fans.
};

/// `uv_set` is the N of TEXCOORD_N. Targets are added with their `morph_weights`. The error is the beginning of a
/// sentence that names the attribute: "NORMAL: accessor 3 is cut off". `primitive` must have triangles.
[[nodiscard]] tl::expected<GltfPrimitive, std::string> read_gltf_primitive(const nlohmann::json& document,
                                                                           GltfBuffers& buffers,
                                                                           const nlohmann::json& primitive,
                                                                           std::uint32_t uv_set,
                                                                           std::span<const double> morph_weights);

}  // namespace coif::gltf
