#include "sample/bob.h"

#include "sample/bob_skeleton.h"
#include "sample/gltf_document.h"
#include "sample/head_shape.h"
#include "sample/strand_texture.h"

namespace coif::sample {
namespace {

SurfaceMesh skinned(SurfaceMesh mesh, SkinInfluences (*influences)(const Eigen::Vector3d&)) {
  for (const Eigen::Vector3d& point : mesh.positions) mesh.skin.push_back(influences(point));
  return mesh;
}

}  // namespace

std::vector<std::uint8_t> make_bob(const BobDensity& density) {
  GltfDocument document;
  document.set_skeleton(make_bob_skeleton());
  document.set_image("strands", encode_png(make_strand_texture()));
  document.add_mesh("hair", skinned(make_bob_hair(density), hair_influences), {.name = "hair", .is_hair = true});
  // Not "head": the name must not be mistaken for the joint's.
  document.add_mesh("bust", skinned(make_bust(), bust_influences),
                    {.name = "head", .red = 0.56, .green = 0.46, .blue = 0.40, .roughness = 0.75});
  document.add_mesh("scalp", skinned(make_scalp_cap(), bust_influences),
                    {.name = "scalp", .red = 0.045, .green = 0.024, .blue = 0.013, .roughness = 0.9});
  return document.to_glb();
}

}  // namespace coif::sample
