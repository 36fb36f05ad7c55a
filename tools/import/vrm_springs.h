#pragma once

#include "import/source_model.h"

#include <Eigen/Geometry>

#include <filesystem>

namespace coif {

/// Fills `springs`, `colliders` and `head_node` of a glTF model from its extensions, which assimp drops: VRM 0.x (`VRM`)
/// and 1.0 (`VRMC_vrm`, `VRMC_springBone`, `VRMC_springBone_extended_collider`). `model.nodes` is complete, depth first;
/// `model_from_file` is what was applied above its root. Whatever the extensions get wrong is left out, with a warning
/// that says what was ignored; without them nothing changes.
void read_vrm_extensions(const std::filesystem::path& path, const Eigen::Affine3d& model_from_file, SourceModel& model);

}  // namespace coif
