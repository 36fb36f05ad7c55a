#pragma once

#include "base/json.h"
#include "sample/surface_mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace coif::sample {

struct GltfMaterial {
  std::string name;
  double red = 1, green = 1, blue = 1;  ///< Linear base colour.
  double roughness = 0.6;
  bool is_hair = false;  ///< Textured with the document's image, blended, two-sided.
};

/// Builds one binary glTF 2.0 with one skeleton, one image and any number of skinned meshes.
/// Source: Khronos glTF 2.0 specification, sections 3.6 (geometry), 3.7 (skins), 4 (GLB).
class GltfDocument {
 public:
  GltfDocument();

  /// Before the first mesh. Adds a node per joint. Places are rounded to 1/`per_metre`; decimal ones take fewer digits,
  /// which shows with many joints.
  void set_skeleton(const std::vector<Joint>& joints, double per_metre = 65536.0);
  /// Before the first hair material.
  void set_image(const std::string& name, const std::vector<std::uint8_t>& png);
  /// Adds material, mesh and node of one name. The mesh has a skin.
  void add_mesh(const std::string& name, const SurfaceMesh& mesh, const GltfMaterial& material);

  [[nodiscard]] std::vector<std::uint8_t> to_glb() const;

 private:
  std::size_t add_view(const void* bytes, std::size_t size, int target);
  std::size_t add_accessor(std::size_t view, int component, const char* type, std::size_t count);
  std::size_t add_vectors(const std::vector<Eigen::Vector3d>& vectors, bool with_bounds);
  void add_skin_attributes(const std::vector<SkinInfluences>& skin, nlohmann::ordered_json& attributes);
  std::size_t add_joints(const std::vector<SkinInfluences>& skin);
  std::size_t add_triangles(const std::vector<std::uint32_t>& triangles);
  std::size_t add_material(const GltfMaterial& material);

  nlohmann::ordered_json json_;
  std::vector<std::uint8_t> binary_;
};

}  // namespace coif::sample
