#pragma once

#include "base/json.h"
#include "import/source_model.h"

#include <Eigen/Geometry>

#include <bitset>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace coif::importer {

/// Colliders of a model, by their number there.
using ColliderSet = std::bitset<kMaxSourceColliders>;

/// Receives the results of the readers of both VRM versions. Checks every reference, converts lengths and directions to
/// model space and keeps the promises of source_model.h.
class SpringSink {
 public:
  /// Keeps references to both. `source_of` has the model's node for each of the document's, or kNoIndex; `model.nodes`
  /// is in depth-first order.
  SpringSink(const std::vector<std::uint32_t>& source_of, const Eigen::Affine3d& model_from_file, SourceModel& model);
  /// Reports how many sentences ignore() left out.
  ~SpringSink();
  SpringSink(const SpringSink&) = delete;
  SpringSink& operator=(const SpringSink&) = delete;

  /// The source's node for a node index of the document; none where that is not one or is not in the scene.
  [[nodiscard]] std::optional<std::uint32_t> find_node(const nlohmann::json& index) const;
  [[nodiscard]] const SourceModel& model() const { return model_; }
  [[nodiscard]] const std::vector<std::uint32_t>& children(std::uint32_t node) const { return children_[node]; }
  [[nodiscard]] bool descends_from(std::uint32_t node, std::uint32_t ancestor) const;
  [[nodiscard]] double distance(std::uint32_t a, std::uint32_t b) const;  ///< Metres at rest.
  [[nodiscard]] double metres(double in_file) const { return metres_per_unit_ * in_file; }

  void set_head(std::uint32_t node) { model_.head_node = node; }
  /// `collider` is in the space of its node; a capsule or sphere scales with the node's longest axis. Its number, or
  /// none, with the reason reported, where it has no usable size.
  std::optional<std::uint32_t> add_collider(SourceCollider collider);
  /// True, once, when `node` may be a joint of a spring.
  bool claim_joint(std::uint32_t node);
  [[nodiscard]] bool is_joint(std::uint32_t node) const { return is_joint_[node]; }
  /// Joints' settings are the file's; brought into range here, with a report, and to metres.
  void add_spring(SourceSpring spring, const ColliderSet& colliders);
  [[nodiscard]] bool full() const { return model_.springs.size() >= kMaxSourceSprings; }

  /// Adds a warning. After the first dozen only their number is reported: a damaged file can have millions of faults.
  void ignore(std::string sentence);

 private:
  void repair(SourceSpringJoint& joint, const std::string& spring);

  SourceModel& model_;
  Eigen::Matrix3d rotation_;
  double metres_per_unit_;
  const std::vector<std::uint32_t>& source_of_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<std::uint32_t> subtree_end_;  // One past a node's last descendant.
  std::vector<bool> is_joint_;
  std::size_t ignored_ = 0;
};

/// A joint's settings in the file's units, as both versions write them. `stiffness`: the key of the stiffness; `drag`:
/// the default drag.
[[nodiscard]] SourceSpringJoint read_settings(const nlohmann::json& value, const char* stiffness, double drag,
                                              const std::optional<Eigen::Vector3d>& gravity_direction);

/// Reads `VRMC_springBone_limit` of a joint, with its rotation still relative to the joint's own axes as limit_axes()
/// gives them. Source: vrm-c/vrm-specification, VRMC_springBone_limit-1.0 (draft), "Limits" and "glTF Schema Updates".
/// `whose` names the joint in a message about an unusable limit.
[[nodiscard]] SourceLimit read_limit(const nlohmann::json& joint, const std::string& whose, SpringSink& sink);

/// The axes of a limit without a rotation: model space at rest from the limit's axes, +Y along the bone. Source: the
/// same text, "Rotation": the shortest turn of +Y to the tail, in the joint's own space; half a turn about X where that
/// is -Y.
[[nodiscard]] Eigen::Quaterniond limit_axes(const SourceModel& model, std::uint32_t joint, std::uint32_t tail);

/// Fills `springs`, `colliders` and `head_node` of a glTF model from the document's `extensions`: VRM 0.x (`VRM`) and
/// 1.0 (`VRMC_vrm`, `VRMC_springBone`, `VRMC_springBone_extended_collider`, `VRMC_springBone_limit`). `model.nodes`
/// must be complete, depth first, and `source_of` as in SpringSink; `model_from_file` was applied above its root.
/// Faulty parts of the extensions are left out, with a warning; without the extensions nothing changes.
void read_vrm_extensions(const nlohmann::json& extensions, const std::vector<std::uint32_t>& source_of,
                         const Eigen::Affine3d& model_from_file, SourceModel& model);

/// Reads `secondaryAnimation` of VRM 0.x.
///
/// A bone group lists roots, and everything below a root swings. Each joint's tail is its first child; other children
/// start a chain of their own; so a root's tree becomes one spring per first-child path, all with the group's settings.
/// A leaf has a tail that is not in the file, 7 cm further along (VRMC_springBone-1.0, "For vrm0"). Vectors are written
/// in Unity's left-handed axes, unlike the rest of the file: z is negated, as UniVRM does on its way to VRM 1.0.
void read_vrm0_springs(const nlohmann::json& secondary_animation, SpringSink& sink);

/// Reads `VRMC_springBone` 1.0 (and its beta, which differs in nothing that is read), with the shapes of
/// `VRMC_springBone_extended_collider`, which replace a collider's plain shape. Joints that skip nodes keep skipping
/// them. The last joint of a spring is only the end of the one before it, and has no limit.
void read_vrm1_springs(const nlohmann::json& spring_bone, SpringSink& sink);

}  // namespace coif::importer
