#pragma once

// Properties of objects in an FBX file that assimp ignores: hidden models, groups of levels of detail, active shape
// keys, the placement and wrapping of textures, and their connections.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coif::importer {

enum class FbxKind : std::uint8_t {
  kModel,
  kLodAttribute,
  kLayer,
  kMesh,
  kShape,
  kBlendShape,
  kChannel,
  kMaterial,
  kTexture,
  kLayeredTexture,
  kCluster
};

/// The placement of a texture on the surface: scaled and turned about its pivots, then moved. V grows upwards.
struct FbxTexturePlace {
  bool swaps_axes = false;  ///< UVSwap: it runs along U where the surface has V.
  double scaling[2] = {1, 1};
  double scaling_pivot[2] = {0, 0};
  double degrees = 0;
  double rotation_pivot[2] = {0, 0};
  double translation[2] = {0, 0};
};

struct FbxObject {
  std::int64_t id = 0;
  std::string_view name;  ///< Points into the file.
  FbxKind kind = FbxKind::kModel;
  /// Model: its Visibility is not 0, and neither is Show of a layer that it is in. Layer: Show.
  bool is_visible = true;
  bool inherits_visibility = true;      ///< Model: hidden if its parent is.
  bool is_lod_group = false;            ///< Model: its children are levels of detail, the finest first.
  double percent = 0;                   ///< Channel: DeformPercent, 100 where the key is fully on.
  std::string_view file;                ///< Texture: RelativeFilename, or FileName if that is empty.
  bool is_clamped[2] = {false, false};  ///< Texture: along U and V.
  FbxTexturePlace place;                ///< The placement of a texture on the surface.
  std::string_view uv_set;              ///< The name of the UV set that a texture is looked up in; "": the first.
  std::uint32_t begin = 0;              ///< Mesh: index into shapes(); channel: index into the file's FullWeights.
  std::uint32_t end = 0;
};

/// An "OO" connection: an object and its parent.
struct FbxConnection {
  std::int64_t from = 0;
  std::int64_t to = 0;        ///< 0: the scene.
  std::string_view property;  ///< "" for "OO" connections. Points into the file.
};

/// One shape of a mesh, in the file's order, like assimp's anim meshes. A channel with several shapes uses them as
/// in-betweens.
struct FbxShape {
  std::string_view key;   ///< The channel's name, or the shape's where that has none. Points into the file.
  double key_weight = 0;  ///< The artist's value; 1: fully on. 0 for all shapes of a channel but its first.
  double weight = 0;      ///< Factor on this shape's difference from the mesh.
};

class FbxObjects {
 public:
  /// Empty where the file cannot be read. `file` must outlive the result, which takes memory in proportion to it.
  [[nodiscard]] static std::optional<FbxObjects> read(std::string_view file);

  /// Sorted by id.
  [[nodiscard]] std::span<const FbxObject> all() const { return objects_; }
  /// Null if it does not exist.
  [[nodiscard]] const FbxObject* find(std::int64_t id) const;
  /// In the file's order.
  [[nodiscard]] std::span<const FbxConnection> below(std::int64_t id) const;
  /// The "OP" connections to one of the object's properties: the textures of a material. In the file's order.
  [[nodiscard]] std::span<const FbxConnection> on_properties(std::int64_t id) const;
  [[nodiscard]] std::span<const FbxShape> shapes(const FbxObject& mesh) const {
    return std::span(shapes_).subspan(mesh.begin, mesh.end - mesh.begin);
  }

 private:
  class Collector;
  void sort();
  void mark_models();
  void collect_shapes();
  bool add_shapes_of(const FbxObject& mesh, std::size_t& steps_left);
  void add_channel(const FbxObject& channel, std::span<const FbxConnection> below_channel);

  std::vector<FbxObject> objects_;            // Sorted by id.
  std::vector<FbxConnection> connections_;    // Sorted by `to`.
  std::vector<FbxConnection> on_properties_;  // Sorted by `to`.
  std::vector<double> full_weights_;
  std::vector<FbxShape> shapes_;
};

/// An FBX in which bones of one name, which the format allows, have names of their own, as long as theirs: assimp knows
/// bones by name alone, and aborts.
struct UniqueFbxBones {
  std::string file;
  std::map<std::int64_t, std::string> names;  ///< The artist's names of the models, by id.
};

/// `objects` must be those of `file`. None where no two bones have the same name.
[[nodiscard]] std::optional<UniqueFbxBones> with_unique_bones(const FbxObjects& objects, std::string_view file);

/// The texture of this id, or those of a layered texture's layers; empty where it is neither.
[[nodiscard]] std::vector<const FbxObject*> textures_of(const FbxObjects& objects, std::int64_t id);

}  // namespace coif::importer
