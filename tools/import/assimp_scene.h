#pragma once

// assimp's plain values as this project's.

#include "base/text.h"
#include "import/import.h"
#include "import/scene_surface.h"
#include "import/source_model.h"

#include <assimp/matrix4x4.h>
#include <assimp/types.h>
#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

struct aiNode;
struct aiScene;
struct aiMesh;

namespace coif::importer {

class FbxObjects;
struct FbxObject;
struct RawMesh;

/// As printable text. The length field is not trusted beyond the string's own buffer.
[[nodiscard]] inline std::string text_of(const aiString& text) {
  return printable_text({text.data, std::min<std::size_t>(text.length, sizeof text.data - 1)});
}

/// Both multiply column vectors; the last row is dropped, since node and bind transforms are affine.
[[nodiscard]] inline Eigen::Affine3d affine_of(const aiMatrix4x4& m) {
  Eigen::Affine3d out = Eigen::Affine3d::Identity();
  out.matrix().topRows<3>() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4;
  return out;
}

/// Parses the file in this process and converts it. Meant for a child process: assimp may crash, hang or eat memory.
/// Throws std::bad_alloc where memory runs out; other exceptions become errors.
[[nodiscard]] tl::expected<SourceModel, ToolError> read_with_assimp(const std::filesystem::path& path,
                                                                    const SourceSuffix& suffix,
                                                                    const ImportSettings& settings);

/// The node tree as a list, parents first, in the order of the file.
struct SceneNodes {
  std::vector<SourceNode> nodes;
  std::vector<const aiNode*> origin;  ///< Beside each node; owned by the scene.
  std::vector<Eigen::Affine3d>
      node_from_mesh;            ///< Beside each node, for the meshes that it carries: FBX's geometric transform.
  std::vector<bool> is_hidden;   ///< Beside each node: by FBX's Visibility or Show, its own or inherited.
  std::vector<bool> is_coarser;  ///< Beside each node: of a group of levels of detail, not in the finest.
  std::vector<const FbxObject*>
      model;                        ///< Beside each node where `fbx` is there: the file's model, null where unknown.
  const FbxObjects* fbx = nullptr;  ///< What an FBX says that assimp does not; outlives this.
  std::unordered_map<std::string, std::uint32_t> joint_named;  ///< By the importer's raw name.
};

/// `model_from_scene` is applied above the root. assimp's nodes for an FBX's pivots are folded into the node that has
/// them. A node whose transform is not finite takes its parent's place, with a warning. Where several nodes carry a
/// bone's name (a mesh 'head' beside a joint 'head'), the one without meshes and within a skeleton is the joint; a
/// warning says so where that does not decide.
[[nodiscard]] SceneNodes flatten_nodes(const aiScene& scene, const Eigen::Affine3d& model_from_scene,
                                       Diagnostics& warnings);

/// Matches the nodes to the file's models, by name and order below their parents, and marks what Visibility hides and
/// what is not the finest level of a LodGroup. `objects` outlives `nodes`.
void add_fbx_objects(const FbxObjects& objects, const aiScene& scene, SceneNodes& nodes);

/// Gives materials the colour and opacity textures that assimp passes over: of properties that it does not know, as
/// "Maya|opacity" or "3dsMax|Parameters|cutout_map", and of layered textures. Warns of layers that are not read.
void connect_fbx_textures(const FbxObjects& objects, const aiScene& scene, Diagnostics& warnings);

/// How textures go on outside 0..1 (WrapModeU, WrapModeV), which assimp does not hand on. A texture goes by the
/// material's name and its file's.
void apply_fbx_wraps(const FbxObjects& objects, std::span<SourceMaterial> materials);

/// Shape keys that an FBX has on. assimp gives their shapes, and not how much of each is on.
class FbxShapeKeys {
 public:
  /// `nodes` outlives this object.
  explicit FbxShapeKeys(const SceneNodes& nodes) : nodes_(nodes) {}
  /// Adds them to positions and normals of `out`, made of `mesh` on `node`; a warning names them, once for a geometry.
  void apply(const aiMesh& mesh, std::uint32_t node, RawMesh& out, Diagnostics& warnings);

 private:
  const SceneNodes& nodes_;
  std::set<const FbxObject*> told_;  // looked up only
};

/// What takes the importer's coordinates to metres, Y up, right-handed, as the file says; `space` gets what it says.
///
/// What assimp 5.2 leaves to do, found by measuring real files: FBX is left in the file's unit (UnitScaleFactor
/// centimetres) and axes (metadata); COLLADA has both applied in the root node; glTF is metres, Y up by definition; OBJ
/// says nothing and is taken as metres, Y up. Settings override the file. Whether the file is right is not judged here.
[[nodiscard]] Eigen::Affine3d model_from_scene(const aiScene& scene, SourceFormat format,
                                               const ImportSettings& settings, SourceSpace& space,
                                               Diagnostics& warnings);

/// One SourceMesh per mesh and node that shows it, in the order of nodes: instances are copied, since each stands
/// elsewhere. Points and lines, triangles with absent or non-finite vertices and vertices without a triangle are
/// dropped; meshes with no triangle left are too. Mesh names fall back to the node's. Points and lines are told of as
/// source_code::kLoose.
[[nodiscard]] std::vector<SourceMesh> convert_meshes(const aiScene& scene, const SceneNodes& nodes,
                                                     const SourceSurface& surface, Diagnostics& warnings);

/// Fills `materials`, one per material of the scene, and `images` with the embedded base-colour textures that they
/// use. Colours: the diffuse colour, which FBX and COLLADA replace by a texture where there is one. Alpha is not kept:
/// exporters disagree about what their opacity means (of an OBJ apply_obj_options() takes it). Its use is kBlend where
/// a texture is connected to the opacity, else kUnknown.
void convert_materials(const aiScene& scene, SourceFormat format, SourceModel& model);

/// SourceModel::named_images.
[[nodiscard]] std::vector<std::string> named_images(const aiScene& scene);

}  // namespace coif::importer
