#pragma once
// Animations of model files, as what one node does.

#include "base/tool_error.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <tl/expected.hpp>

#include <filesystem>
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
  std::string node;                ///< Its name, printable.
  std::vector<NodeKey> keys;       ///< At least one, 0.1 ms or more apart, ascending from 0 or later; finite numbers.
  std::vector<std::string> notes;  ///< What was taken otherwise than the file says, with the file's name.
};

/// Reads how a node of a .gltf, .glb or .vrm moves in the world, parents included, at all their keys together. `node`:
/// its name; empty: the file's only animated one. Rotations count from the pose that the file gives the nodes beside
/// the animation, since a head's bone may lie in its head as it likes. Of several animations the first that moves the
/// node is read. Steps and splines are read as straight lines between their values. Errors: kFileAccess (absent,
/// unreadable), kBadInput (damaged, no animation, no such node, more than 100,000 keys), kUnsupported (another format).
[[nodiscard]] tl::expected<ClipFile, ToolError> read_clip(const std::filesystem::path& path, std::string_view node);

}  // namespace coif::importer
