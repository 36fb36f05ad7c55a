#include "import/assimp_scene.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <unordered_set>

namespace coif {
namespace {

struct Pending {
  const aiNode* node;
  std::uint32_t parent;
};

void append(SceneNodes& out, const Pending& pending, const Eigen::Affine3d& model_from_scene,
            std::vector<std::string>& warnings) {
  const Eigen::Affine3d& above =
      pending.parent == kNoIndex ? model_from_scene : out.nodes[pending.parent].model_from_node;
  SourceNode node;
  node.name = text_of(pending.node->mName);
  node.parent = pending.parent;
  node.model_from_node = above * affine_of(pending.node->mTransformation);
  if (!node.model_from_node.matrix().allFinite()) {
    warnings.push_back(fmt::format("node '{}': transform is not finite; its parent's is used", node.name));
    node.model_from_node = above;
  }
  out.nodes.push_back(std::move(node));
  out.origin.push_back(pending.node);
}

std::unordered_set<std::string> bone_names(const aiScene& scene) {
  std::unordered_set<std::string> names;
  for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
    for (const aiBone* bone : std::span(mesh->mBones, mesh->mNumBones)) names.emplace(bone->mName.C_Str());
  }
  return names;
}

// How much a node of a bone's name looks like the joint rather than something else of that name.
int joint_likeness(const aiNode& node, const std::unordered_set<std::string>& bones) {
  const auto is_bone = [&](const aiNode* other) { return other != nullptr && bones.contains(other->mName.C_Str()); };
  const bool within_skeleton =
      is_bone(node.mParent) || std::ranges::any_of(std::span(node.mChildren, node.mNumChildren), is_bone);
  return (node.mNumMeshes == 0 ? 2 : 0) + (within_skeleton ? 1 : 0);
}

void name_joints(const aiScene& scene, SceneNodes& out, std::vector<std::string>& warnings) {
  const std::unordered_set<std::string> bones = bone_names(scene);
  std::vector<std::string> undecided;
  for (std::uint32_t i = 0; i < out.origin.size(); ++i) {
    const aiNode& node = *out.origin[i];
    if (!bones.contains(node.mName.C_Str())) continue;
    const auto [entry, is_new] = out.joint_named.emplace(node.mName.C_Str(), i);
    if (is_new) continue;
    const int gain = joint_likeness(node, bones) - joint_likeness(*out.origin[entry->second], bones);
    if (gain == 0) undecided.push_back(out.nodes[i].name);
    if (gain > 0) entry->second = i;
  }
  std::ranges::sort(undecided);
  undecided.erase(std::ranges::unique(undecided).begin(), undecided.end());
  for (const std::string& name : undecided) {
    warnings.push_back(fmt::format("several nodes are named '{}'; the first is taken for the bone", name));
  }
}

}  // namespace

SceneNodes flatten_nodes(const aiScene& scene, const Eigen::Affine3d& model_from_scene,
                         std::vector<std::string>& warnings) {
  SceneNodes out;
  // A list instead of recursion: a file may nest nodes deeper than the stack.
  std::vector<Pending> pending{{scene.mRootNode, kNoIndex}};
  while (!pending.empty()) {
    const Pending next = pending.back();
    pending.pop_back();
    const auto index = static_cast<std::uint32_t>(out.nodes.size());
    append(out, next, model_from_scene, warnings);
    for (unsigned child = next.node->mNumChildren; child-- > 0;) {
      if (next.node->mChildren[child] != nullptr) pending.push_back({next.node->mChildren[child], index});
    }
  }
  name_joints(scene, out, warnings);
  return out;
}

namespace {

constexpr double kShortest = 0.05;  // metres; a doll's fringe
constexpr double kTallest = 10.0;   // a giant
constexpr double kDeepest = 0.75;   // metres, of a head of hair or of a body, whichever way it faces
constexpr double kFlat = 0.05;      // share of the longest size; thinner is a card, and says nothing

std::optional<double> number(const aiMetadata* metadata, const char* key) {
  if (metadata == nullptr) return std::nullopt;
  double wide = 0;
  float narrow = 0;
  int whole = 0;
  if (metadata->Get(std::string(key), wide)) return wide;
  if (metadata->Get(std::string(key), narrow)) return double{narrow};
  if (metadata->Get(std::string(key), whole)) return double(whole);
  return std::nullopt;
}

// The file's axis, as a vector of file space, that an FBX "...Axis" and "...AxisSign" pair names.
std::optional<Eigen::Vector3d> axis(const aiMetadata* metadata, const std::string& name) {
  const double index = number(metadata, name.c_str()).value_or(-1);
  const double sign = number(metadata, (name + "Sign").c_str()).value_or(1);
  if (index != 0 && index != 1 && index != 2) return std::nullopt;
  return Eigen::Vector3d::Unit(static_cast<Eigen::Index>(index)) * (sign < 0 ? -1.0 : 1.0);
}

Eigen::Matrix3d y_up_from(UpAxis up) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  if (up == UpAxis::kX) rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  if (up == UpAxis::kZ) rotation << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return rotation;
}

// FBX names the file's right (Coord), up and front axes; front points at the viewer, so (right, up, front) = (X, Y, Z).
Eigen::Matrix3d y_up_from_fbx(const aiMetadata* metadata, std::vector<std::string>& warnings) {
  const auto right = axis(metadata, "CoordAxis");
  const auto up = axis(metadata, "UpAxis");
  const auto front = axis(metadata, "FrontAxis");
  if (right && up && front) {
    Eigen::Matrix3d rows;
    rows << right->transpose(), up->transpose(), front->transpose();
    if (rows.determinant() < -0.5) warnings.emplace_back("left-handed axes in the file were mirrored");
    if (std::abs(rows.determinant()) > 0.5) return rows;
  }
  if (!up) return Eigen::Matrix3d::Identity();
  warnings.emplace_back("the file's axes contradict each other; only its up axis is used");
  return y_up_from(up->x() != 0 ? UpAxis::kX : up->z() != 0 ? UpAxis::kZ : UpAxis::kY);
}

double fbx_metres_per_unit(const aiMetadata* metadata, std::vector<std::string>& warnings) {
  constexpr double kMetresPerCentimetre = 0.01;
  const double centimetres = number(metadata, "UnitScaleFactor").value_or(1.0);
  if (std::isfinite(centimetres) && centimetres > 0) return kMetresPerCentimetre * centimetres;
  warnings.push_back(fmt::format("UnitScaleFactor {} is not a length; centimetres are assumed", centimetres));
  return kMetresPerCentimetre;
}

// assimp has put the COLLADA unit into the root node as a uniform scale.
double unit_in_root(const aiScene& scene) {
  const double unit = std::cbrt(std::abs(double(scene.mRootNode->mTransformation.Determinant())));
  return std::isfinite(unit) && unit > 0 ? unit : 1.0;
}

Eigen::AlignedBox3f box_of(const SourceModel& model) {
  Eigen::AlignedBox3f box;
  for (const SourceMesh& mesh : model.meshes) {
    for (const Eigen::Vector3f& position : mesh.positions) box.extend(position);
  }
  return box;
}

}  // namespace

Eigen::Affine3d model_from_scene(const aiScene& scene, SourceFormat format, const ImportSettings& settings,
                                 std::vector<std::string>& warnings) {
  double scale = settings.metres_per_unit.value_or(1.0);
  Eigen::Matrix3d rotation = y_up_from(settings.up_axis.value_or(UpAxis::kY));
  if (format == SourceFormat::kFbx) {
    if (!settings.metres_per_unit) scale = fbx_metres_per_unit(scene.mMetaData, warnings);
    if (!settings.up_axis) rotation = y_up_from_fbx(scene.mMetaData, warnings);
  }
  if (format == SourceFormat::kDae && settings.metres_per_unit) scale /= unit_in_root(scene);
  Eigen::Affine3d model_from_scene = Eigen::Affine3d::Identity();
  model_from_scene.linear() = scale * rotation;
  return model_from_scene;
}

void guess_unit(SourceModel& model) {
  const Eigen::Vector3d size = box_of(model).sizes().cast<double>();
  const double depth = std::min(size.x(), size.z());
  if (!(depth > kFlat * size.maxCoeff())) return;
  double unit = 1;
  while (unit > 0.0015 && depth * unit > kDeepest) unit /= 10;
  if (unit == 1) return;
  for (SourceMesh& mesh : model.meshes) {
    for (Eigen::Vector3f& position : mesh.positions) position *= float(unit);
  }
  for (SourceNode& node : model.nodes) node.model_from_node.translation() *= unit;
  model.warnings.push_back(
      fmt::format("OBJ has no unit; a model {:.4g} units deep is taken as one of {:.3g} m ({} m per unit): set "
                  "\"source.metres_per_unit\" in the recipe if that is wrong",
                  depth, depth * unit, unit));
}

void warn_of_implausible_height(SourceModel& model) {
  const double height = double(box_of(model).sizes().y());
  if (height >= kShortest && height <= kTallest) return;
  model.warnings.push_back(
      fmt::format("the model is {:.4g} m tall; if that is wrong, set \"source.metres_per_unit\" (and "
                  "\"source.up_axis\") in the recipe",
                  height));
}

}  // namespace coif
