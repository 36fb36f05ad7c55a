#include "gl/reach.h"

#include <cmath>
#include <cstddef>

namespace coif {
namespace {

constexpr float kSlack = 1.02f;  // Solvers hold lengths to a part in ten thousand; hosts with their own may not.

float distance(const float (&a)[3], const float (&b)[3]) {
  const float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return std::sqrt(x * x + y * y + z * z);
}

/// Furthest that the start of `bone` may be from `center`.
float reach_of_joint(std::span<const BoneRecord> bones, std::uint32_t bone, const float (&center)[3]) {
  float length = 0;
  while (bones[bone].kind == BoneKind::kSimulated) {
    const std::uint32_t parent = bones[bone].parent;
    length += distance(bones[bone].joint, bones[parent].joint);
    bone = parent;
  }
  return length + distance(bones[bone].joint, center);
}

/// Furthest that a vertex may be from `center`.
float reach_of_vertex(const Asset& asset, std::size_t v, const float (&center)[3]) {
  const VertexRecord& vertex = asset.vertices()[v];
  if (asset.skin().empty()) return distance(vertex.position, center);
  float reach = 0;
  const SkinRecord& skin = asset.skin()[v];
  for (int k = 0; k < 4; ++k) {
    if (skin.weight[k] == 0) continue;
    const BoneRecord& bone = asset.bones()[skin.bone[k]];
    const float own = bone.kind == BoneKind::kSimulated
                          ? reach_of_joint(asset.bones(), skin.bone[k], center) + distance(vertex.position, bone.joint)
                          : distance(vertex.position, center);
    if (own > reach) reach = own;
  }
  return reach;
}

void find_middle(std::span<const VertexRecord> vertices, float (&middle)[3]) {
  for (int i = 0; i < 3; ++i) {
    float low = vertices.front().position[i], high = low;
    for (const VertexRecord& vertex : vertices) {
      if (vertex.position[i] < low) low = vertex.position[i];
      if (vertex.position[i] > high) high = vertex.position[i];
    }
    middle[i] = 0.5f * (low + high);
  }
}

}  // namespace

Reach reach_of(const Asset& asset) {
  Reach reach{};
  find_middle(asset.vertices(), reach.center);
  for (std::size_t v = 0; v < asset.vertices().size(); ++v) {
    const float own = reach_of_vertex(asset, v, reach.center);
    if (own > reach.radius) reach.radius = own;
  }
  reach.radius *= kSlack;
  return reach;
}

}  // namespace coif
