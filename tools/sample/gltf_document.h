#pragma once

#include "base/glb_file.h"
#include "sample/strips.h"
#include "sample/surface_mesh.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif::sample {

struct GltfMaterial {
  std::string name;
  double red = 1, green = 1, blue = 1;  ///< Linear base colour.
  double roughness = 0.6;
  bool is_hair = false;                ///< Textured with the document's first image, blended, two-sided.
  std::optional<std::size_t> image{};  ///< Of add_image(), times the colour.
};

/// RGBA, sRGB, straight alpha, rows top to bottom.
struct PaintedImage {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
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
  std::size_t add_image(const std::string& name, const PaintedImage& image);
  /// Adds material, mesh and node of one name. The mesh has a skin.
  void add_mesh(const std::string& name, const SurfaceMesh& mesh, const GltfMaterial& material);

  [[nodiscard]] std::vector<std::byte> to_glb() const { return file_.bytes(); }

 private:
  void add_skin_attributes(const std::vector<SkinInfluences>& skin, nlohmann::ordered_json& attributes);
  std::size_t add_triangles(const std::vector<std::uint32_t>& triangles);
  std::size_t add_material(const GltfMaterial& material);

  GlbFile<nlohmann::ordered_json> file_;
};

}  // namespace coif::sample
