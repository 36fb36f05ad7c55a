#include "cook/textured_hair.h"

#include "cook/built_models.h"
#include "cook/select_hair.h"

#include <gtest/gtest.h>

namespace coif {

SourceMesh strip_over(const Eigen::Vector2f& low, const Eigen::Vector2f& high) {
  SourceMesh mesh = make_strip({});
  for (Eigen::Vector2f& uv : mesh.uvs) uv = low + uv.cwiseProduct(high - low);
  return mesh;
}

SourceMaterial& add_surface(SourceModel& model, const std::string& material, const Eigen::Vector2f& low,
                            const Eigen::Vector2f& high) {
  if (model.nodes.empty()) add_node(model, "Head", kNoIndex, {0, 1.6, 0});
  SourceMesh mesh = strip_over(low, high);
  for (Eigen::Vector3f& p : mesh.positions) p.x() += 0.1f * float(model.meshes.size());
  mesh.material = std::uint32_t(model.materials.size());
  model.meshes.push_back(mesh);
  model.materials.emplace_back();
  model.materials.back().name = material;
  return model.materials.back();
}

HairMesh whole_hair(const SourceModel& model) {
  const auto selected = select_hair(model, default_recipe());
  EXPECT_TRUE(selected) << (selected ? "" : selected.error().message);
  return selected ? selected->mesh : HairMesh{};
}

}  // namespace coif
