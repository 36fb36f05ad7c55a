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

/// The string as printable text. The length field is not trusted beyond the string's own buffer.
[[nodiscard]] inline std::string text_of(const aiString& text) {
  return printable_text({text.data, std::min<std::size_t>(text.length, sizeof text.data - 1)});
}

/// Both libraries multiply column vectors; the last row is dropped, since node and bind transforms are affine.
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
  std::vector<const aiNode*> origin;  ///< Per node; owned by the scene.
  /// Per node, for the meshes that it carries: FBX's geometric transform.
  std::vector<Eigen::Affine3d> node_from_mesh;
  std::vector<bool> is_hidden;   ///< Per node: hidden by FBX's Visibility or Show, its own or inherited.
  std::vector<bool> is_coarser;  ///< Per node: in a group of levels of detail, but not in the finest.
  /// Per node if `fbx` is set: the file's model, null where unknown.
  std::vector<const FbxObject*> model;
  const FbxObjects* fbx = nullptr;  ///< Data of an FBX that assimp does not have; must outlive this.
  std::unordered_map<std::string, std::uint32_t> joint_named;  ///< By the importer's original name.
};

/// `model_from_scene` is applied above the root. assimp's nodes for an FBX's pivots are folded into the node that has
/// them. A node whose transform is not finite takes its parent's place, with a warning. If several nodes have a bone's
/// name (a mesh 'head' beside a joint 'head'), the joint is the one without meshes and within a skeleton; a warning
/// follows if that does not decide.
[[nodiscard]] SceneNodes flatten_nodes(const aiScene& scene, const Eigen::Affine3d& model_from_scene,
                                       Diagnostics& warnings);

/// Matches the nodes to the file's models, by name and order below their parents, and marks nodes that Visibility hides
/// and those that are not in the finest level of a LodGroup. `objects` must outlive `nodes`.
void add_fbx_objects(const FbxObjects& objects, const aiScene& scene, SceneNodes& nodes);

/// Gives materials the colour and opacity textures that assimp ignores: those of properties that it does not know, such
/// as "Maya|opacity" or "3dsMax|Parameters|cutout_map", and of layered textures. Warns of layers that are not read.
void connect_fbx_textures(const FbxObjects& objects, const aiScene& scene, Diagnostics& warnings);

/// Sets how textures continue outside 0..1 (WrapModeU, WrapModeV), which assimp does not report. A texture is found by
/// the names of the material and of its file.
void apply_fbx_wraps(const FbxObjects& objects, std::span<SourceMaterial> materials);

/// The shape keys that an FBX has on. assimp gives their shapes, but not their weights.
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

/// The transform from the importer's coordinates to metres, Y up, right-handed, by the file's statements, which are
/// written to `space`.
///
/// The remaining work after assimp 5.2, found by measuring real files: FBX is left in the file's unit (UnitScaleFactor
/// centimetres) and axes (metadata); COLLADA has both applied in the root node; glTF is metres, Y up by definition; OBJ
/// has no statement and is taken as metres, Y up. Settings override the file. Whether the file is right is not judged
/// here.
[[nodiscard]] Eigen::Affine3d model_from_scene(const aiScene& scene, SourceFormat format,
                                               const ImportSettings& settings, SourceSpace& space,
                                               Diagnostics& warnings);

/// One SourceMesh per mesh and node that shows it, in the order of nodes. Instances are copied, since each has another
/// place. Points and lines, triangles with absent or non-finite vertices and vertices without a triangle are dropped,
/// and so are meshes without a triangle. The node's name replaces a missing mesh name. Points and lines are reported as
/// source_code::kLoose.
[[nodiscard]] std::vector<SourceMesh> convert_meshes(const aiScene& scene, const SceneNodes& nodes,
                                                     const SourceSurface& surface, Diagnostics& warnings);

/// Fills `materials`, one per material of the scene, and `images` with the embedded base-colour textures that they use.
/// The colour is the diffuse colour, which FBX and COLLADA replace by a texture where there is one. Alpha is not kept,
/// since exporters disagree about the meaning of their opacity (apply_obj_options() reads an OBJ's). AlphaUse is kBlend
/// where a texture is connected to the opacity, else kUnknown.
void convert_materials(const aiScene& scene, SourceFormat format, SourceModel& model);

/// SourceModel::named_images.
[[nodiscard]] std::vector<std::string> named_images(const aiScene& scene);

}  // namespace coif::importer
