#include "render/studio.h"

#include "render/solid_mesh.h"

namespace coif {
namespace {

Vec3 to_vec3(const Eigen::Vector3d& v) { return {float(v.x()), float(v.y()), float(v.z())}; }

}  // namespace

std::vector<Eigen::Vector3d> framed_points(const Asset& asset) {
  std::vector<Eigen::Vector3d> points;
  for (const VertexRecord& vertex : asset.vertices()) {
    points.push_back(Eigen::Map<const Eigen::Vector3f>(vertex.position).cast<double>());
  }
  for (const SolidMesh& mesh : mannequin_meshes(asset.colliders())) {
    for (const SolidVertex& v : mesh.vertices) points.push_back(v.position.cast<double>());
  }
  return points;
}

// Photographer's lights. Shifted tangents want the half vector some 30 degrees above the normal, so only a light from
// the top puts both highlights where they are seen, around the head's widest part. Fill and rim come from low, where
// their own highlights miss the hair: more than two bands would read as noise.
std::array<Light, 3> studio_lights(const Camera& camera) {
  const auto light = [&](double right, double up, double back, Vec3 color) {
    return Light{Light::Kind::kDirectional, to_vec3(camera.right * right + camera.up * up + camera.back * back), color};
  };
  return {light(-0.3, 1.0, 0.2, {1.2f, 1.17f, 1.12f}), light(0.4, -0.3, 1.0, {0.22f, 0.23f, 0.25f}),
          light(0.9, 0.1, -0.6, {0.15f, 0.17f, 0.22f})};
}

}  // namespace coif
