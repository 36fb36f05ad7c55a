#pragma once

#include "mannequin/head_shape.h"
#include "mannequin/portrait.h"
#include "research/sample/gltf_document.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace coif::research {

/// The density of the sample; the sample itself has the defaults. Other values are for measuring how costs grow.
struct BobDensity {
  double quads = 1;  ///< Factor on the sample's rows and columns of each strip.
  int copies = 1;    ///< Strips in place of each, slightly apart.
};

/// The hair: five broad panels under twenty strips in two layers and a fringe. 2870 triangles in 25 connected groups
/// that share no vertex, or with another density accordingly more or fewer.
[[nodiscard]] mannequin::SurfaceMesh make_bob_hair(const BobDensity& density = {});

/// root > neck > Head > scalp_{left,back,right} > hair_*_1 > _2 > _3 > _3_end. Parents first.
[[nodiscard]] std::vector<Joint> make_bob_skeleton();

/// Weights of a point of the hair: roots on the scalp joints, lengths on the one or two chains nearest around the head
/// and the two bones nearest in height.
[[nodiscard]] mannequin::SkinInfluences hair_influences(const Eigen::Vector3d& point);

/// Size and place of the portrait's head in another model.
struct HeadFit {
  double scale = 1;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< Metres, of the point that keeps its place when scaled.
  static constexpr double kFixedHeight = 1.600;     ///< Its Y, in the middle of the head.

  /// Where a point of the portrait lies in the model.
  [[nodiscard]] Eigen::Vector3d placed(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d fixed(0, kFixedHeight, 0);
    return fixed + shift + scale * (point - fixed);
  }
  /// The point of the portrait that lies there.
  [[nodiscard]] Eigen::Vector3d unplaced(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d fixed(0, kFixedHeight, 0);
    return fixed + (point - fixed - shift) / scale;
  }
};

/// The portrait under the bob: as large as it can be below the strips, which were laid around the mannequin's bust.
inline const HeadFit kBobHead{0.93, {0, -0.018, 0.010}};

/// Weights of a point of the portrait on root, neck and head: the first three joints of both skeletons.
[[nodiscard]] mannequin::SkinInfluences portrait_influences(const Eigen::Vector3d& point);

/// Adds the portrait's parts, skinned, with their images.
void add_portrait(std::vector<mannequin::PortraitPart> parts, const HeadFit& fit, GltfDocument& document);

/// The bytes of sample_assets/bob/bob.glb, with the density's defaults: the same on every run.
[[nodiscard]] std::vector<std::byte> make_bob(const BobDensity& density = {});

/// A head and shoulders with a face on root > neck > Head, as the bytes of sample_assets/portrait/portrait.glb: the
/// same on every run.
[[nodiscard]] std::vector<std::byte> make_portrait();

}  // namespace coif::research
