#pragma once

// How one property of one node changes: a sampler of a glTF animation.
// Source: Khronos, "glTF 2.0 Specification", chapter 3.11 and appendix C.

#include "base/json.h"
#include "gltf/buffers.h"
#include "gltf/document.h"
#include "gltf/tree.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif::importer {

enum class NodeProperty : std::uint8_t { kTranslation, kRotation, kScale };

[[nodiscard]] std::optional<NodeProperty> find_node_property(const nlohmann::json& name);
[[nodiscard]] const char* name_of(NodeProperty property);

inline constexpr std::size_t kMostClipKeys = 100'000;

/// Linear between its keys, and as at the nearest one outside them.
struct ClipTrack {
  std::vector<float> seconds;  ///< Ascending; at least one, none before 0.
  std::vector<float> values;   ///< 3 per key, or 4 (x, y, z, w) for rotations.
  bool was_linear = true;      ///< False: the file asks for steps or splines through these values.

  [[nodiscard]] Eigen::Vector3d vector_at(double time) const;
  /// Unit, by the shortest way.
  [[nodiscard]] Eigen::Quaterniond rotation_at(double time) const;
};

/// The error is a sentence without the file's name.
[[nodiscard]] tl::expected<ClipTrack, std::string> read_track(const nlohmann::json& document,
                                                              gltf::GltfBuffers& buffers, const nlohmann::json& sampler,
                                                              NodeProperty property);

/// A node's place in its parent, at rest and while it is animated.
class ClipNode {
 public:
  /// Null unless the node's numbers are finite.
  static std::optional<ClipNode> from(const nlohmann::json& node);

  /// False where this property moves already, or the node is given as a matrix, which nothing can animate.
  bool animate(NodeProperty property, ClipTrack track);
  [[nodiscard]] const std::optional<ClipTrack>& track(NodeProperty property) const;

  [[nodiscard]] Eigen::Affine3d at_rest() const { return rest_.parent_from_node; }
  [[nodiscard]] Eigen::Affine3d at(double seconds) const;

 private:
  gltf::GltfPlace rest_;
  std::array<std::optional<ClipTrack>, 3> tracks_;
};

}  // namespace coif::importer
