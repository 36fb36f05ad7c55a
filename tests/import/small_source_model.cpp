#include "import/small_source_model.h"

namespace coif::test {

SourceModel small_source_model() {
  SourceModel model;
  model.path = "braid.glb";
  model.importer = "test 1.2.3";
  model.importer_version[0] = 1;
  SourceNode root{"root", kNoIndex, Eigen::Affine3d::Identity()};
  SourceNode tip{"tip", 0, Eigen::Affine3d(Eigen::Translation3d(0, 1, 0))};
  model.nodes = {root, tip};
  SourceMesh mesh;
  mesh.name = "strip";
  mesh.node = 1;
  mesh.material = 0;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
  mesh.influence_begin = {0, 1, 2, 4};
  mesh.influences = {{0, 1.0f}, {1, 1.0f}, {0, 0.75f}, {1, 0.25f}};
  mesh.triangles = {0, 1, 2};
  model.meshes = {mesh};
  SourceMaterial material;
  material.name = "hair";
  material.base_texture = {"hair.png", 0};
  material.alpha_use = AlphaUse::kMask;
  material.alpha_cutoff = 0.25f;
  material.double_sided = true;
  model.materials = {material};
  model.images = {{"hair.png", {1, 2, 3}}};
  SourceCollider collider;
  collider.radius = 0.5;
  model.colliders = {collider, collider};
  SourceSpring spring;
  spring.name = "tail";
  spring.joints.resize(2);
  spring.joints[0].length = 1;
  spring.joints[1].node = 1;
  spring.colliders = {0, 1};
  spring.center = 0;
  model.springs = {spring};
  model.head_node = 1;
  model.warnings = {"one", "two"};
  model.side_files = {"strip.bin"};
  return model;
}

}  // namespace coif::test
