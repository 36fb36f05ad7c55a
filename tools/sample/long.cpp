#include "sample/long.h"

#include "sample/gltf_document.h"
#include "sample/head_shape.h"
#include "sample/long_skeleton.h"
#include "sample/long_style.h"
#include "sample/rounded_influences.h"
#include "sample/smooth_step.h"
#include "sample/strand_texture.h"

namespace coif::sample {
namespace {

const StrandColors kHoney{{0.300, 0.200, 0.120}, {0.560, 0.410, 0.245}, {0.730, 0.590, 0.390}};

constexpr double kTenthMillimetres = 10000.0;  // Per metre.

/// With 64 values instead of 256 each, which nobody sees, colours pack to two thirds of the size.
StrandTexture coarsened(StrandTexture texture) {
  for (std::size_t i = 0; i < texture.rgba.size(); ++i) {
    const bool is_alpha = i % 4 == 3;
    if (!is_alpha) texture.rgba[i] = static_cast<std::uint8_t>(texture.rgba[i] / 4 * 4 + 2);
  }
  return texture;
}

/// The head turns, the foot of the neck stays with the neck's joint.
SurfaceMesh skinned_to_head(SurfaceMesh mesh) {
  constexpr int kNeck = 1, kHead = 2;
  for (const Eigen::Vector3d& p : mesh.positions) {
    const double head = smooth_step(1.440, 1.490, p.y());
    mesh.skin.push_back(rounded_influences({{{kHead, head}, {kNeck, 1.0 - head}, {0, 0.0}, {0, 0.0}}}));
  }
  return mesh;
}

}  // namespace

std::vector<std::uint8_t> make_long() {
  const std::vector<Lock> locks = make_locks();
  GltfDocument document;
  document.set_skeleton(make_long_skeleton(locks), kTenthMillimetres);
  document.set_image("strands", encode_png(coarsened(make_strand_texture(kHoney))));
  document.add_mesh("hair", make_long_hair(locks), {.name = "hair", .is_hair = true});
  // Not "head": the name must not be mistaken for the joint's.
  document.add_mesh("mannequin", skinned_to_head(make_bare_head()),
                    {.name = "head", .red = 0.56, .green = 0.46, .blue = 0.40, .roughness = 0.75});
  document.add_mesh("scalp", skinned_to_head(make_scalp_cap()),
                    {.name = "scalp", .red = 0.10, .green = 0.06, .blue = 0.03, .roughness = 0.9});
  return document.to_glb();
}

}  // namespace coif::sample
