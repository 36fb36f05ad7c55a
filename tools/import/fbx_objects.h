#pragma once

// What an FBX file says of its objects that assimp passes over: which models are hidden, which hold levels of detail,
// which shape keys are on, how textures lie and go on, and what they are connected to.

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

/// How a texture lies on the surface: scaled and turned about its pivots, then moved. V grows upwards.
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
  bool is_visible =
      true;  ///< Of a model: neither its Visibility is 0 nor Show of a layer that it is in. Of a layer: Show.
  bool inherits_visibility = true;      ///< Of a model: hidden where the one above it is.
  bool is_lod_group = false;            ///< Of a model: its children are levels of detail, the finest first.
  double percent = 0;                   ///< Of a channel: DeformPercent, 100 where the key is fully on.
  std::string_view file;                ///< Of a texture: RelativeFilename, or FileName where that is empty.
  bool is_clamped[2] = {false, false};  ///< Of a texture: along U and V.
  FbxTexturePlace place;                ///< How a texture lies on the surface.
  std::string_view uv_set;              ///< The name of the UV set that a texture is looked up in; "": the first.
  std::uint32_t begin = 0;              ///< Of a mesh, into shapes(); of a channel, into the file's FullWeights.
  std::uint32_t end = 0;
};

/// What is below what, as "OO" connections say.
struct FbxConnection {
  std::int64_t from = 0;
  std::int64_t to = 0;        ///< 0: the scene.
  std::string_view property;  ///< "" for "OO" connections. Points into the file.
};

/// One shape of a mesh, in the file's order, as assimp's anim meshes are. A channel with several shapes has them in
/// between.
struct FbxShape {
  std::string_view key;   ///< The channel's name, or the shape's where that has none. Points into the file.
  double key_weight = 0;  ///< What the artist set; 1: fully on. 0 for all shapes of a channel but its first.
  double weight = 0;      ///< How much of this shape's difference from the mesh is added.
};

class FbxObjects {
 public:
  /// Empty where the file cannot be read. `file` outlives what is returned, which takes memory in proportion to it.
  [[nodiscard]] static std::optional<FbxObjects> read(std::string_view file);

  /// By id.
  [[nodiscard]] std::span<const FbxObject> all() const { return objects_; }
  /// Null where there is none.
  [[nodiscard]] const FbxObject* find(std::int64_t id) const;
  /// In the file's order.
  [[nodiscard]] std::span<const FbxConnection> below(std::int64_t id) const;
  /// What is connected to one of the object's properties ("OP"): the textures of a material. In the file's order.
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

  std::vector<FbxObject> objects_;            // by id
  std::vector<FbxConnection> connections_;    // by `to`
  std::vector<FbxConnection> on_properties_;  // by `to`
  std::vector<double> full_weights_;
  std::vector<FbxShape> shapes_;
};

/// An FBX in which bones of one name, which the format allows, have names of their own, as long as theirs: assimp knows
/// bones by name alone, and aborts.
struct UniqueFbxBones {
  std::string file;
  std::map<std::int64_t, std::string> names;  ///< What the artist calls the models, by id.
};

/// `objects` are those of `file`. None where no two bones have one name.
[[nodiscard]] std::optional<UniqueFbxBones> with_unique_bones(const FbxObjects& objects, std::string_view file);

/// The texture of this id, or those of a layered one's layers; empty where it is neither.
[[nodiscard]] std::vector<const FbxObject*> textures_of(const FbxObjects& objects, std::int64_t id);

}  // namespace coif::importer
