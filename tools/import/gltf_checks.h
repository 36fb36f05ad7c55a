#pragma once

#include "gltf/buffers.h"
#include "import/source_model.h"

#include <filesystem>
#include <vector>

namespace coif::importer {

/// What in a glTF, GLB or VRM file breaks the format's own rules of containers, references, meshes, skins and
/// animations: what the Khronos validator calls an error there. One sentence for each kind and place, however many
/// vertices it is true of; at most some dozens. Readers repair or skip what is told of, or refuse the file. Sums of
/// weights that are off by rounding are none, nor is what lies in compressed buffer views. Throws std::bad_alloc alone.
/// Reads the whole file: call it where files are parsed. Source: Khronos, "glTF 2.0 Specification", chapters 3.5
/// to 3.11, 4.4 and 5.
[[nodiscard]] Diagnostics check_gltf(const std::filesystem::path& path);
/// The same of a file whose document is read; `buffers` are its.
[[nodiscard]] Diagnostics check_gltf(const std::filesystem::path& path, const nlohmann::json& document,
                                     gltf::GltfBuffers& buffers);

}  // namespace coif::importer
