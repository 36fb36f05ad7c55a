#pragma once

#include "base/glb_file.h"
#include "mannequin/head_shape.h"
#include "research/sample/strips.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace coif::research {

/// A joint in the rest pose. Joints have no rotation: their axes are the model's.
struct Joint {
  std::string name;
  int parent = -1;           ///< An earlier joint; -1 for the root.
  Eigen::Vector3d position;  ///< Model space, metres.
};

/// Weights of up to four joints, of which any may have none and one may occur twice, rounded to 1/256 so that they add
/// up to exactly one. No joint occurs twice in the result; of joints given once the largest come first.
[[nodiscard]] mannequin::SkinInfluences rounded_influences(std::array<std::pair<int, double>, 4> shares);

struct GltfMaterial {
  std::string name;
  double red = 1, green = 1, blue = 1;  ///< Linear base colour.
  double roughness = 0.6;
  bool is_hair = false;                ///< Textured with the document's first image, blended, two-sided.
  std::optional<std::size_t> image{};  ///< From add_image(), times the colour.
};

/// Builds one binary glTF 2.0 with one skeleton and any number of skinned meshes.
/// Source: Khronos glTF 2.0 specification, sections 3.6 (geometry), 3.7 (skins), 4 (GLB).
class GltfDocument {
 public:
  GltfDocument();

  /// Before the first mesh. Adds a node per joint. Places are rounded to 1/`per_metre`; decimal ones take fewer digits,
  /// which shows with many joints.
  void set_skeleton(const std::vector<Joint>& joints, double per_metre = 65536.0);
  /// Before the first hair material.
  void set_image(const std::string& name, const StrandTexture& image);
  /// Before the first material that shows it; returns its number.
  std::size_t add_image(const std::string& name, const mannequin::PaintedImage& image);
  /// Adds material, mesh and node of one name. The mesh has a skin.
  void add_mesh(const std::string& name, const mannequin::SurfaceMesh& mesh, const GltfMaterial& material);

  [[nodiscard]] std::vector<std::byte> to_glb() const { return file_.bytes(); }

 private:
  void add_skin_attributes(const std::vector<mannequin::SkinInfluences>& skin, nlohmann::ordered_json& attributes);
  std::size_t add_triangles(const std::vector<std::uint32_t>& triangles);
  std::size_t add_material(const GltfMaterial& material);

  GlbFile<nlohmann::ordered_json> file_;
};

}  // namespace coif::research
