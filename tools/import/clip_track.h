#pragma once
// A glTF that is read for its animation, whatever is taken of that.

#include "base/json.h"
#include "base/tool_error.h"
#include "gltf/buffers.h"
#include "gltf/document.h"
#include "gltf/tree.h"

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace coif::importer {

/// Over all tracks, so that a buffer that is named often does not fill memory.
inline constexpr std::size_t kMostClipNumbers = 16'000'000;
inline constexpr const char* kExportAgain =
    "export the clip again as .glb";  ///< The cure for most of what ails a clip.

/// The parts of the document that animations need. Errors: those of check_readable(), kUnsupported for another format,
/// kBadInput.
[[nodiscard]] tl::expected<nlohmann::json, ToolError> read_clip_document(const std::filesystem::path& path);

// The changes of one property of one node: a sampler of a glTF animation.
// Source: Khronos, "glTF 2.0 Specification", chapter 3.11 and appendix C.

enum class NodeProperty : std::uint8_t { kTranslation, kRotation, kScale };

[[nodiscard]] std::optional<NodeProperty> find_node_property(const nlohmann::json& name);
[[nodiscard]] const char* name_of(NodeProperty property);

inline constexpr std::size_t kMostClipKeys = 100'000;

/// Linear between its keys, and as at the nearest one outside them.
struct ClipTrack {
  std::vector<float> seconds;  ///< Ascending; at least one, none before 0.
  std::vector<float> values;   ///< 3 per key, or 4 (x, y, z, w) for rotations.
  bool was_linear = true;      ///< False: the file has steps or splines through these values.

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
