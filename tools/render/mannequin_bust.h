#pragma once

#include "render/stage_renderer.h"

#include <span>
#include <vector>

namespace coif::render {

/// A head with a face in place of the collider that stands for one, as large as that is: hair that comes without a body
/// is seen on somebody. Empty where there is no such collider. Made anew by each call, in a quarter of a second.
[[nodiscard]] std::vector<SolidMesh> bust_meshes(std::span<const ColliderRecord> colliders, bool faces_backwards);

/// Points that outline it, for framing: head space, metres.
[[nodiscard]] std::vector<Eigen::Vector3d> bust_outline(std::span<const ColliderRecord> colliders,
                                                        bool faces_backwards);

}  // namespace coif::render
