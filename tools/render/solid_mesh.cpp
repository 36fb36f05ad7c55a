#include "render/stage_renderer.h"

#include "base/collider_shapes.h"
#include "base/geometry.h"
#include "base/text.h"

#include <coif/skinning.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <unordered_map>

namespace coif {
namespace {

constexpr float kLargestHead = 0.5f;  // metres

// Hair rests on the collider; drawn at full size the two would fight for the same depth.
constexpr float kMannequinScale = 0.98f;

std::vector<Eigen::Vector3f> smooth_normals(const SourceMesh& mesh) {
  std::vector<Eigen::Vector3f> normals(mesh.positions.size(), Eigen::Vector3f::Zero());
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
    const std::uint32_t* corner = &mesh.triangles[i];
    const Eigen::Vector3f& a = mesh.positions[corner[0]];
    // Not normalised: large triangles shall count for more.
    const Eigen::Vector3f n = (mesh.positions[corner[1]] - a).cross(mesh.positions[corner[2]] - a);
    for (int k = 0; k < 3; ++k) normals[corner[k]] += n;
  }
  for (Eigen::Vector3f& n : normals) n = n.squaredNorm() > 0 ? n.normalized() : Eigen::Vector3f::UnitY();
  return normals;
}

constexpr std::uint32_t kRings = 48;  // even: one is the equator
constexpr std::uint32_t kSectors = 96;

/// From a unit sphere's axes, its poles on Y, to head space.
Eigen::Quaternionf orientation(const ColliderRecord& collider) {
  if (collider.shape != ColliderShape::kCapsule) return Eigen::Map<const Eigen::Quaternionf>(collider.rotation);
  const Eigen::Map<const Eigen::Vector3f> axis(collider.axis);
  return turn_between(Eigen::Vector3f(Eigen::Vector3f::UnitY()), Eigen::Vector3f(axis));
}

/// A sphere or ellipsoid; a capsule is a sphere whose upper half is moved to the segment's other end.
SolidMesh mannequin_mesh(const ColliderRecord& collider) {
  const Eigen::Map<const Eigen::Vector3f> center(collider.center);
  const Eigen::Map<const Eigen::Vector3f> axis(collider.axis);  // 0 unless a capsule
  const Eigen::Array3f radii = kMannequinScale * Eigen::Map<const Eigen::Array3f>(collider.radii);
  const Eigen::Quaternionf rotation = orientation(collider);

  SolidMesh mesh;
  for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
    const float polar = std::numbers::pi_v<float> * static_cast<float>(ring) / kRings;
    const float share = 2 * ring <= kRings ? 1.0f : 0.0f;
    const Eigen::Vector3f ring_center = center + share * axis;
    for (std::uint32_t sector = 0; sector <= kSectors; ++sector) {
      const float around = 2 * std::numbers::pi_v<float> * static_cast<float>(sector) / kSectors;
      const Eigen::Array3f unit(std::sin(polar) * std::sin(around), std::cos(polar),
                                std::sin(polar) * std::cos(around));
      mesh.vertices.push_back(
          {ring_center + rotation * (unit * radii).matrix(), (rotation * (unit / radii).matrix()).normalized()});
    }
  }
  constexpr std::uint32_t kRow = kSectors + 1;
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t sector = 0; sector < kSectors; ++sector) {
      const std::uint32_t a = ring * kRow + sector;
      const std::uint32_t b = a + kRow;
      mesh.triangles.insert(mesh.triangles.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  }
  return mesh;
}

}  // namespace

std::vector<SolidMesh> mannequin_meshes(std::span<const ColliderRecord> colliders) {
  std::vector<SolidMesh> meshes;
  for (const ColliderRecord& collider : colliders) {
    // A ball of a metre stands for a floor or a wall, not for anything to look at.
    const bool is_seen = is_solid(collider) && *std::ranges::max_element(collider.radii) < kLargestHead;
    if (is_seen) meshes.push_back(mannequin_mesh(collider));
  }
  return meshes;
}

std::vector<SolidMesh> moving_meshes(std::span<const MovingCollider> colliders, const HeadPose& head) {
  const auto from = [](const Quat& q) { return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized(); };
  const Eigen::Map<const Eigen::Vector3d> origin(head.position);
  const Eigen::Quaterniond to_head = from(head.rotation).conjugate();
  std::vector<SolidMesh> meshes;
  for (const MovingCollider& collider : colliders) {
    const bool is_ball = collider.shape == ColliderShape::kSphere;
    if (!is_ball && collider.shape != ColliderShape::kCapsule) continue;
    const Eigen::Map<const Eigen::Vector3d> place(collider.center);
    const Eigen::Vector3d own_axis(collider.axis.x, collider.axis.y, collider.axis.z);
    ColliderRecord record{};
    record.shape = collider.shape;
    record.rotation[3] = 1;
    Eigen::Map<Eigen::Vector3f>(record.center) = (to_head * (place - origin) / head.scale).cast<float>();
    if (!is_ball) {
      Eigen::Map<Eigen::Vector3f>(record.axis) =
          (to_head * (from(collider.rotation) * own_axis) / head.scale).cast<float>();
    }
    std::ranges::fill(record.radii, collider.radius / head.scale);
    meshes.push_back(mannequin_mesh(record));
  }
  return meshes;
}

namespace {

/// For each node how much of the head's turning it does; empty where nothing follows the head's bone.
std::vector<float> turning_of_nodes(const SourceModel& model, const std::string& head_bone) {
  const auto head = std::ranges::find(model.nodes, head_bone, &SourceNode::name);
  if (head_bone.empty() || head == model.nodes.end()) return {};
  const auto head_node = std::size_t(head - model.nodes.begin());
  std::vector<float> turning(model.nodes.size(), 0);
  turning[head_node] = 1;
  for (std::size_t n = head_node + 1; n < model.nodes.size(); ++n) {
    const std::uint32_t parent = model.nodes[n].parent;
    if (parent != kNoIndex && turning[parent] == 1) turning[n] = 1;
  }
  const std::uint32_t above = head->parent;
  if (above != kNoIndex && matches(model.nodes[above].name, "*neck*")) turning[above] = 0.5f;
  const bool follows = std::ranges::any_of(model.meshes, [&](const SourceMesh& mesh) {
    return std::ranges::any_of(mesh.influences, [&](const SourceInfluence& i) { return turning[i.node] > 0; });
  });
  return follows ? turning : std::vector<float>{};
}

float turning_of(const SourceMesh& mesh, std::size_t vertex, std::span<const float> turning) {
  if (mesh.influences.empty()) return turning[mesh.node];
  float sum = 0, all = 0;
  for (std::uint32_t i = mesh.influence_begin[vertex]; i < mesh.influence_begin[vertex + 1]; ++i) {
    sum += mesh.influences[i].weight * turning[mesh.influences[i].node];
    all += mesh.influences[i].weight;
  }
  return all > 0 ? sum / all : 0;
}

/// Under the head's whole turning only `share` of it is left.
void turn_back(const Eigen::Quaternionf& turn, float share, SolidVertex& vertex) {
  const Eigen::Quaternionf back = turn.conjugate() * Eigen::Quaternionf::Identity().slerp(share, turn);
  vertex.position = back * vertex.position;
  vertex.normal = back * vertex.normal;
}

}  // namespace

SolidMesh body_mesh(const SourceModel& model, const SourceMesh& mesh, const Eigen::Vector3f& head_joint,
                    const BodyTurn& pose) {
  const std::vector<float> turning = turning_of_nodes(model, pose.head_bone);
  const Eigen::Quaternionf turn = Eigen::Quaternionf(pose.turn.w, pose.turn.x, pose.turn.y, pose.turn.z).normalized();
  const std::vector<Eigen::Vector3f> normals = mesh.normals.empty() ? smooth_normals(mesh) : mesh.normals;
  SolidMesh solid;
  solid.vertices.reserve(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    SolidVertex& vertex = solid.vertices.emplace_back();
    vertex = {mesh.positions[i] - head_joint, normals[i]};
    if (!turning.empty()) turn_back(turn, turning_of(mesh, i, turning), vertex);
  }
  solid.triangles = mesh.triangles;
  if (mesh.material < model.materials.size()) {
    const SourceMaterial& material = model.materials[mesh.material];
    const bool textured = !material.base_texture.path.empty() || material.base_texture.image != kNoIndex;
    // Textures are not drawn here, and the colour beneath one is white as a rule: clay then.
    if (!textured) solid.color = material.base_color.head<3>();
  }
  return solid;
}

namespace {

/// Turning the hue by the golden section keeps the first n colours as far apart as n colours can be, for any n; a slow
/// change of brightness tells apart those that come round to the same hue.
Eigen::Vector3f patch_color(std::size_t patch) {
  const double turn = std::fmod(double(patch) * std::numbers::phi, 1.0);
  const float brightness = 0.35f + 0.15f * float(patch % 4);
  Eigen::Vector3f color;
  for (int channel = 0; channel < 3; ++channel) {
    const double distance = std::abs(std::fmod(turn + channel / 3.0, 1.0) - 0.5) * 6;  // 0..3
    color[channel] = brightness * float(std::clamp(distance - 1, 0.03, 1.0));
  }
  return color;
}

/// Empty where the palette is not the asset's.
std::vector<SkinnedVertex> skin(const Asset& asset, std::span<const Mat34> palette) {
  std::vector<SkinnedVertex> skinned(asset.vertices().size());
  if (skin_vertices(asset, palette, 0, skinned) != Status::kOk) skinned.clear();
  return skinned;
}

SolidVertex solid(const SkinnedVertex& vertex) {
  return {to_eigen(vertex.position), to_eigen(vertex.normal).normalized()};
}

SolidMesh patch_surface(const Asset& asset, std::span<const SkinnedVertex> skinned, const PatchRecord& patch) {
  SolidMesh mesh;
  std::unordered_map<std::uint32_t, std::uint32_t> place_of;  // a patch uses few of the asset's vertices
  for (const std::uint32_t index : asset.indices().subspan(patch.first_index, patch.index_count)) {
    const auto [place, is_new] = place_of.try_emplace(index, std::uint32_t(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(solid(skinned[index]));
    mesh.triangles.push_back(place->second);
  }
  return mesh;
}

}  // namespace

std::vector<SolidMesh> patch_surfaces(const Asset& asset, std::span<const Mat34> palette, std::uint32_t lod) {
  const std::vector<SkinnedVertex> skinned = skin(asset, palette);
  std::vector<SolidMesh> meshes;
  if (skinned.empty()) return meshes;
  for (const PatchRecord& patch : asset.lod_patches(lod)) {
    meshes.push_back(patch_surface(asset, skinned, patch));
    meshes.back().color = patch_color(meshes.size() - 1);
  }
  return meshes;
}

void mark_patch(std::size_t marked, std::span<SolidMesh> patches) {
  for (std::size_t i = 0; i < patches.size(); ++i) {
    patches[i].color = i == marked ? Eigen::Vector3f(0.8f, 0.02f, 0.02f) : Eigen::Vector3f(0.25f, 0.25f, 0.25f);
  }
}

}  // namespace coif
