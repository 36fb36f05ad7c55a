#pragma once
// Animations in model files, reduced to the motion of one node.

#include "base/tool_error.h"
#include "import/clip_track.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coif::importer {

/// A node at one time of an animation. World axes of the file: metres, Y up.
struct NodeKey {
  double seconds = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< World from the node's place at rest, unit.
};

struct ClipFile {
  std::string node;                ///< The node's name, printable.
  std::vector<NodeKey> keys;       ///< At least one, 0.1 ms or more apart, ascending from 0 or later; finite numbers.
  std::vector<std::string> notes;  ///< Deviations from the file, with the file's name.
};

/// Reads how a node of a .gltf, .glb or .vrm moves in the world, parents included, at all their keys together. `node`:
/// its name; empty: the file's only animated node. Rotations are relative to the file's pose without the animation,
/// since a head's bone may have any axes. Among several animations the first that moves the node is read. Steps and
/// splines are read as straight lines between their values. Errors: kFileAccess (absent, unreadable), kBadInput
/// (damaged, no animation, no such node, more than 100,000 keys), kUnsupported (another format).
[[nodiscard]] tl::expected<ClipFile, ToolError> read_clip(const std::filesystem::path& path, std::string_view node);

// Animations of model files, as how the bones of hair turn.

/// A bone to be found in a clip by its name.
struct PosedBone {
  std::string name;
  int parent = -1;  ///< Among the bones, before it; -1: none.
};

/// The rotations of bones during an animation.
class PoseClip {
 public:
  /// The rotation of each bone in its parent's frame, from rest, as Hair::set_pose() takes it: in the model's axes, Y
  /// up. Outside the animation that of the nearest key. The identity for bones that the clip lacks.
  [[nodiscard]] std::vector<Eigen::Quaterniond> at(double seconds) const;

  [[nodiscard]] std::size_t found() const;  ///< Bones that the clip has, moved or not; at least one.
  /// Deviations from the file, with the file's name.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  friend class PoseReader;
  static constexpr std::uint32_t kNoNode = 0xffffffff;

  struct Node {
    std::uint32_t parent;  ///< Among nodes_, before it; kNoNode: none.
    ClipNode moves;
  };
  [[nodiscard]] std::vector<Eigen::Quaterniond> turns(double seconds) const;

  std::vector<Node> nodes_;                ///< The nodes of bones and all nodes above them.
  std::vector<Eigen::Quaterniond> rests_;  ///< World rotation of each at rest.
  std::vector<std::uint32_t> of_bone_;     ///< The bone's node, or kNoNode.
  std::vector<std::uint32_t> from_;        ///< The node that its parent's frame turns with, or kNoNode: the world.
  std::vector<std::string> notes_;
};

/// Reads the rotations of those nodes of a .gltf, .glb or .vrm that have a bone's name. Rotations are relative to the
/// file's pose without the animation. Among several animations the first that turns one of the bones is read; positions
/// and scales of bones are ignored. A bone whose parent the clip lacks turns in its node's own parent. Errors:
/// kFileAccess (absent, unreadable), kBadInput (damaged, no node with a bone's name, none that turns), kUnsupported
/// (another format).
[[nodiscard]] tl::expected<std::shared_ptr<const PoseClip>, ToolError> read_pose_clip(const std::filesystem::path& path,
                                                                                      std::span<const PosedBone> bones);

}  // namespace coif::importer
