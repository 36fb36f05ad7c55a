#pragma once

#include "cook/hair_mesh.h"
#include "cook/source_images.h"

namespace coif {

/// What a part of the hair looks like: materials that agree in it are one look.
struct SurfaceLook {
  std::string name;              ///< Of the first material; for messages.
  const Image* image = nullptr;  ///< Null: the factor alone.
  Eigen::Vector4f factor = Eigen::Vector4f::Ones();
  AlphaUse alpha_use = AlphaUse::kUnknown;
  float alpha_cutoff = 0.5f;
};

struct SurfaceLooks {
  std::vector<SurfaceLook> looks;  ///< At least one, in the order of the hair's triangles.
  std::vector<std::uint32_t> of_triangle;
  std::uint32_t main = 0;  ///< The one with most triangles.
};

/// Linear, 0..1.
[[nodiscard]] Eigen::Vector4f color_factor(const SourceMaterial& material);

/// The looks of the hair's triangles; their images live in `images`. Where the file cannot say (it names no image for any
/// part of the hair, and is no glTF, which would say so on purpose), an image beside the source may be taken.
[[nodiscard]] SurfaceLooks find_looks(const SourceModel& source, SourceImages& images, const HairMesh& hair);

/// True for glTF: a file without a texture or a colour means white, where other formats' exporters leave things out.
[[nodiscard]] bool says_what_it_lacks(const SourceModel& source);

/// How one image says what several looks do with alpha.
struct JointAlpha {
  AlphaUse use = AlphaUse::kUnknown;
  float cutoff = 0.5f;
  bool cut_masks = false;  ///< Alpha of masked looks becomes 0 or 1 by their own cutoff.
};

[[nodiscard]] JointAlpha join_alpha(std::span<const SurfaceLook> looks);

/// The look's image times its factor, with alpha as `joint` wants it; one texel where the look has no image.
[[nodiscard]] Image paint(const SurfaceLook& look, const JointAlpha& joint);

}  // namespace coif
