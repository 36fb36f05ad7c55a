#pragma once

#include "cook/find_head_bone.h"
#include "cook/hair_mesh.h"
#include "cook/recipe.h"
#include "cook/skeleton.h"

namespace coif {

/// Splits the file's bones as the thesis does (5.2): the head bone is moved by the host; bones with the head as parent
/// are scalp bones, rigid; bones below are simulated. Simulated too are a bone alone below the head, which as a scalp
/// bone would only make the hair stiff, and one that the file's spring bones turn, unless the recipe wants curves. Nodes
/// that carry no hair are left out, but a last joint below a hair bone says where that bone ends. Errors: kBadInput for
/// patterns without a match, kUnsupported above kMaxBones bones.
tl::expected<Skeleton, ToolError> build_skeleton(const SourceModel& source, const HairMesh& hair, const HeadBone& head,
                                                 const Recipe& recipe);

/// The head bone, everything rigid to it: what chains are fitted to.
[[nodiscard]] Skeleton head_alone(const SourceModel& source, const HeadBone& head);

}  // namespace coif
