#pragma once
// Small glTF documents with VRM's extensions.

#include "import/model_files.h"

#include <filesystem>
#include <string>

namespace coif::test {

/// body > head > hair_1 > hair_2 > hair_end, straight up by 1 m, then down by 0.1 m each, and a strip beside them; the
/// nodes 0 to 5 of the document, in this order: strip, body, head, hair_1, hair_2, hair_end. `extensions` is JSON.
[[nodiscard]] SmallGltf small_vrm(const std::string& extensions);

/// A VRMC_springBone extension; the arguments are JSON lists.
[[nodiscard]] std::string spring_bone_1(const std::string& springs, const std::string& colliders = "[]",
                                        const std::string& groups = "[]");
/// A VRM 0.x extension with a humanoid whose head is node 2.
[[nodiscard]] std::string spring_bone_0(const std::string& bone_groups, const std::string& collider_groups = "[]");

/// A .gltf that SmallGltf wrote, as one binary file with its buffer inside.
[[nodiscard]] std::string as_glb(const std::filesystem::path& gltf);

}  // namespace coif::test
