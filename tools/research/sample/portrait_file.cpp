#include "mannequin/portrait.h"

#include "mannequin/solid_shapes.h"
#include "research/sample/bob.h"
#include "research/sample/gltf_document.h"

#include <algorithm>

namespace coif::research {
namespace {

using Eigen::Vector3d;

constexpr int kPortraitRoot = 0, kPortraitNeck = 1, kPortraitHead = 2;

std::vector<Joint> portrait_skeleton() {
  return {{"root", -1, {0, 0, 0}},
          {"neck", kPortraitRoot, {0, 1.450, -0.034}},
          {"Head", kPortraitNeck, {0, 1.565, -0.012}}};
}

}  // namespace

// The head turns above the jaw's edge, the neck follows, the shoulders stay.
mannequin::SkinInfluences portrait_influences(const Vector3d& point) {
  const double head = mannequin::smooth_step(1.445, 1.515, point.y() + 0.45 * std::max(point.z(), 0.0));
  const double body = mannequin::smooth_step(1.445, 1.385, point.y());
  return rounded_influences({{{kPortraitHead, head},
                              {kPortraitRoot, (1.0 - head) * body},
                              {kPortraitNeck, (1.0 - head) * (1.0 - body)},
                              {kPortraitRoot, 0.0}}});
}

void add_portrait(std::vector<mannequin::PortraitPart> parts, const HeadFit& fit, GltfDocument& document) {
  for (mannequin::PortraitPart& part : parts) {
    const mannequin::PortraitMaterial& look = part.material;
    GltfMaterial material{
        .name = part.name, .red = look.red, .green = look.green, .blue = look.blue, .roughness = look.roughness};
    if (part.image) material.image = document.add_image(part.name, *part.image);
    for (Vector3d& point : part.mesh.positions) {
      part.mesh.skin.push_back(portrait_influences(point));
      point = fit.placed(point);
    }
    document.add_mesh(part.name, part.mesh, material);
  }
}

std::vector<std::byte> make_portrait() {
  GltfDocument document;
  document.set_skeleton(portrait_skeleton());
  add_portrait(mannequin::make_portrait_parts({.spacing = 1.5}), {}, document);
  return document.to_glb();
}

}  // namespace coif::research
