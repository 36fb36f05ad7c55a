#include "cook/rig/colliders.h"

#include <fmt/format.h>

namespace coif::cook {
namespace {

constexpr double kShortestCapsule = 1.0e-5;  ///< Metres between its ends; shorter ones are spheres.
constexpr double kSmallestSize = 1.0e-5;     ///< Metres. Assets have none below a tenth of it.

bool is_below(const importer::SourceModel& source, std::uint32_t node, std::uint32_t ancestor) {
  while (node != importer::kNoIndex && node != ancestor) node = source.nodes[node].parent;
  return node != importer::kNoIndex;
}

}  // namespace

bool is_on_head(const importer::SourceModel& source, std::uint32_t head_node,
                const importer::SourceCollider& collider) {
  return head_node != importer::kNoIndex && is_below(source, collider.node, head_node);
}

bool has_size(const importer::SourceCollider& collider) {
  return collider.shape == importer::SourceCollider::Shape::kPlane || collider.radius >= kSmallestSize;
}

HeadCollider shape_of(const importer::SourceCollider& from) {
  HeadCollider to;
  to.keeps_inside = from.keeps_inside && from.shape != importer::SourceCollider::Shape::kPlane;
  to.center = from.center;
  to.radii.setConstant(from.radius);
  if (from.shape == importer::SourceCollider::Shape::kPlane) {
    to.shape = ColliderShape::kPlane;
    to.axis = from.normal;
    to.radii.setZero();
  }
  const bool is_capsule = from.shape == importer::SourceCollider::Shape::kCapsule;
  if (is_capsule && (from.tail - from.center).norm() > kShortestCapsule) {
    to.shape = ColliderShape::kCapsule;
    to.axis = from.tail - from.center;
  }
  return to;
}

namespace {

class ColliderPass {
 public:
  ColliderPass(const importer::SourceModel& source, std::uint32_t head_node, const Skeleton& skeleton,
               Findings& findings)
      : source_(source),
        head_node_(head_node),
        skeleton_(skeleton),
        shape_of_(source.colliders.size(), kUnseen),
        findings_(findings) {}

  Colliders run() && {
    const std::vector<BoneJoint> joints = joints_of_bones(source_, skeleton_);
    out_.of_bone.assign(skeleton_.bones.size(), 0);
    out_.hit_radius.assign(skeleton_.bones.size(), 0);
    for (std::size_t b = 0; b < joints.size(); ++b) {
      if (!joints[b]) continue;
      out_.hit_radius[b] = joints[b].joint->hit_radius;
      for (const std::uint32_t c : joints[b].spring->colliders) {
        if (shape_of_[c] == kUnseen) shape_of_[c] = place(c);
        if (shape_of_[c] != kNone) out_.of_bone[b] |= 1u << shape_of_[c];
      }
    }
    return std::move(out_);
  }

 private:
  static constexpr std::uint32_t kUnseen = kNone - 1;

  /// The number of the new shape, or kNone.
  std::uint32_t place(std::uint32_t collider) {
    const importer::SourceCollider& from = source_.colliders[collider];
    const auto leave_out = [&](const char* why) {
      findings_.leave_out(
          {fmt::format("the spring bones' collider {} on '{}'", collider, source_.nodes[from.node].name), why});
      return kNone;
    };
    if (!is_on_head(source_, head_node_, from)) return kNone;
    if (!has_size(from)) return leave_out("it has no size");
    if (out_.shapes.size() >= kMaxColliders) return leave_out("an asset has no room for it");
    out_.shapes.push_back(shape_of(from));
    std::uint32_t& bone = out_.shapes.back().bone = skeleton_.bone_of_node[from.node];
    while (skeleton_.bones[bone].kind == BoneKind::kSimulated) bone = skeleton_.bones[bone].parent;
    return std::uint32_t(out_.shapes.size() - 1);
  }

  const importer::SourceModel& source_;
  std::uint32_t head_node_;
  const Skeleton& skeleton_;
  std::vector<std::uint32_t> shape_of_;
  Findings& findings_;
  Colliders out_;
};

}  // namespace

Colliders spring_colliders(const importer::SourceModel& source, std::uint32_t head_node, const Skeleton& skeleton,
                           Findings& findings) {
  return ColliderPass(source, head_node, skeleton, findings).run();
}

}  // namespace coif::cook
