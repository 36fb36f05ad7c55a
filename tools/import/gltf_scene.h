#pragma once

// Conversion of a glTF document's parts to a source model.

#include "base/json.h"
#include "base/tool_error.h"
#include "gltf/buffers.h"
#include "import/import.h"
#include "import/raw_mesh.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::importer {

/// Reads a .gltf, .glb or .vrm in this process. Meant for a child process, since the file may need much memory. Throws
/// std::bad_alloc where memory runs out.
[[nodiscard]] tl::expected<SourceModel, ToolError> read_gltf_model(const std::filesystem::path& path,
                                                                   const ImportSettings& settings);

/// Messages about extensions that a document needs or uses.
struct GltfExtensions {
  std::string refusal;  ///< A sentence with the cure, where it requires one that is not read; empty otherwise.
  Diagnostics warnings;
};
[[nodiscard]] GltfExtensions check_gltf_extensions(const nlohmann::json& document);

/// The mapping between nodes of the document and of the model.
struct GltfNodes {
  std::vector<std::uint32_t> in_file;  ///< For each of the model's nodes; kNoIndex for the one above the roots.
  std::vector<bool> is_hidden;         ///< For each of the model's nodes.
  /// For each of the document's nodes: index in the model, or kNoIndex outside the scene.
  std::vector<std::uint32_t> of_file;
};
/// Fills `nodes` with those of the document's scene, under a node of their own unless the scene has exactly one root.
[[nodiscard]] GltfNodes read_gltf_nodes(const nlohmann::json& document, const Eigen::Affine3d& model_from_file,
                                        SourceModel& model);

/// The set of UVs of a material's base texture, and its transform.
struct GltfUvs {
  std::uint32_t set = 0;
  Eigen::Affine2f image_from_uv = Eigen::Affine2f::Identity();
};

/// Fills `materials`, one per material of the document, and `images` with the embedded images that they use. Returns
/// how each material's base texture lies. The error is a sentence.
[[nodiscard]] tl::expected<std::vector<GltfUvs>, std::string> read_gltf_materials(const nlohmann::json& document,
                                                                                  gltf::GltfBuffers& buffers,
                                                                                  SourceModel& model);

/// Materials of which nothing would be seen: warned of; where that is so of all, their alpha is taken for 1.
void settle_unseen_materials(std::span<SourceMaterial> materials, Diagnostics& warnings);

/// Fills `meshes`: each primitive of triangles, once for each node and instance that shows it. The model has its nodes
/// and materials; a material is added where a primitive names none. `variant` is the name of one of
/// KHR_materials_variants, or empty. The error is a sentence.
[[nodiscard]] std::string read_gltf_meshes(const nlohmann::json& document, gltf::GltfBuffers& buffers,
                                           const GltfNodes& nodes, const std::vector<GltfUvs>& uvs,
                                           const std::string& variant, SourceModel& model);

/// Finds violations of the format's own rules of containers, references, meshes, skins and animations in a glTF, GLB or
/// VRM file, where the Khronos validator reports an error. One sentence for each kind and place, however many vertices
/// have it; at most some dozens. Readers repair or skip these parts, or refuse the file. Sums of weights with rounding
/// errors do not count, nor do compressed buffer views. Throws only std::bad_alloc. Reads the whole file: call it where
/// files are parsed. Source: Khronos, "glTF 2.0 Specification", chapters 3.5 to 3.11, 4.4 and 5.
[[nodiscard]] Diagnostics check_gltf(const std::filesystem::path& path);
/// The same for a file whose document and `buffers` have been read.
[[nodiscard]] Diagnostics check_gltf(const std::filesystem::path& path, const nlohmann::json& document,
                                     gltf::GltfBuffers& buffers);

}  // namespace coif::importer
