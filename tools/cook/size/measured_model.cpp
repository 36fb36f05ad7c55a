#include "cook/size/measured_model.h"

#include "cook/recipe/hair_recipe.h"
#include "cook/select/hair_evidence.h"
#include "cook/select/select_hair.h"

#include <string>
#include <string_view>
#include <utility>

namespace coif::cook {
namespace {

// Hair is sought at such sizes: a length of its search is one of metres.
constexpr double kLeastSize = 0.05, kMostSize = 5;

double size_of_model(const importer::SourceModel& model) {
  Eigen::AlignedBox3f box;
  for (const importer::SourceMesh& mesh : model.meshes) {
    for (const Eigen::Vector3f& position : mesh.positions) box.extend(position);
  }
  return box.isEmpty() ? 0.0 : double(box.sizes().maxCoeff());
}

importer::SourceModel without_images(const importer::SourceModel& source) {
  importer::SourceModel model;
  model.path = source.path;
  model.nodes = source.nodes;
  model.meshes = source.meshes;
  model.materials = source.materials;
  model.springs = source.springs;
  model.head_node = source.head_node;
  model.facing = source.facing;
  model.scalp_radius = source.scalp_radius;
  model.space = source.space;
  for (const importer::SourceImage& image : source.images) model.images.push_back({image.name, {}});
  return model;
}

bool is_file_of_brows(std::string_view name) { return is_called_brow(name) && !is_called_hair(name); }

}  // namespace

KnownModel know_model(const importer::SourceModel& source, const HairRecipe& recipe) {
  KnownModel known{without_images(source), 1, {}, {}, false};
  const double size = size_of_model(source);
  if (size > 0 && !(size >= kLeastSize && size <= kMostSize)) {
    known.scale = 1 / size;
    transform_model(known.model, known.scale, Eigen::Matrix3d::Identity());
  }
  HairRecipe named = recipe;
  named.hair_parts.clear();  // Points in metres, which are not yet known.
  if (auto hair = select_hair(known.model, named, known.found)) {
    known.hair = std::move(*hair);
    known.on_face =
        hair_is_called(known.model, known.hair, is_called_brow, is_file_of_brows) || is_beard(known.model, known.hair);
  }
  return known;
}

void turn_hair(HairMesh& hair, const Eigen::Matrix3d& rotation) {
  const Eigen::Matrix3f turn = rotation.cast<float>();
  for (Eigen::Vector3f& position : hair.positions) position = turn * position;
  for (Eigen::Vector3f& normal : hair.normals) normal = turn * normal;
}

void transform_model(importer::SourceModel& model, double factor, const Eigen::Matrix3d& rotation) {
  Eigen::Affine3d change = Eigen::Affine3d::Identity();
  change.linear() = factor * rotation;
  const Eigen::Matrix3f turn = rotation.cast<float>(), move = change.linear().cast<float>();
  for (importer::SourceNode& node : model.nodes) node.model_from_node = change * node.model_from_node;
  const auto change_mesh = [&](importer::SourceMesh& mesh) {
    for (Eigen::Vector3f& position : mesh.positions) position = move * position;
    for (Eigen::Vector3f& normal : mesh.normals) normal = (turn * normal).normalized();
  };
  for (importer::SourceMesh& mesh : model.meshes) change_mesh(mesh);
  for (importer::SourceLevel& level : model.coarser) {
    change_mesh(level.mesh);
    for (Eigen::Vector3f& along : level.along) along = (turn * along).normalized();
  }
  model.scalp_radius *= factor;
  for (importer::SourceCollider& collider : model.colliders) {
    collider.center = change * collider.center;
    collider.tail = change * collider.tail;
    collider.normal = (rotation * collider.normal).normalized();
    collider.radius *= factor;
  }
  for (importer::SourceSpring& spring : model.springs) {
    for (importer::SourceSpringJoint& joint : spring.joints) {
      for (double* length : {&joint.length, &joint.stiffness, &joint.gravity_power, &joint.hit_radius})
        *length *= factor;
      joint.gravity_direction = (rotation * joint.gravity_direction).normalized();
      joint.limit.rotation = (Eigen::Quaterniond(rotation) * joint.limit.rotation).normalized();
    }
  }
}

std::vector<Eigen::Vector3d> joints_of(const importer::SourceModel& model, BodyPart part) {
  const auto is_part = part == BodyPart::kNeck    ? is_called_neck
                       : part == BodyPart::kTrunk ? is_called_trunk
                                                  : is_called_foot;
  std::vector<bool> carries_mesh(model.nodes.size(), false);
  for (const importer::SourceMesh& mesh : model.meshes) carries_mesh[mesh.node] = true;
  std::vector<Eigen::Vector3d> joints;
  for (std::uint32_t n = 0; n < model.nodes.size(); ++n) {
    const std::string& name = model.nodes[n].name;
    if (carries_mesh[n] || !is_part(name) || is_called_hair(name) || is_called_control(name)) continue;
    joints.push_back(model.nodes[n].model_from_node.translation());
  }
  return joints;
}

}  // namespace coif::cook
