#pragma once

// The parts of a model whose size and attitude people know.

#include "cook/recipe/findings.h"
#include "cook/select/hair_mesh.h"
#include "cook/select/head.h"
#include "import/source_model.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace coif::cook {

struct HairRecipe;

/// The result and the messages of select_hair().
struct SelectedHair {
  HairMesh mesh;
  Findings findings;
};

/// A model with its hair, as far as it can be found.
struct KnownModel {
  /// Without images, and scaled to some metres if it was far from that; `scale` has the factor.
  importer::SourceModel model;
  double scale = 1;      ///< The factor that its lengths were multiplied with.
  HairMesh hair;         ///< Empty where nothing was found.
  Findings found;        ///< Messages about it.
  bool on_face = false;  ///< The hair is called brows, lashes or beard.
};

[[nodiscard]] KnownModel know_model(const importer::SourceModel& source, const HairRecipe& recipe);

/// Turns nodes, meshes, springs and colliders, and multiplies their lengths: the result of an import with another unit
/// and axis.
void transform_model(importer::SourceModel& model, double factor, const Eigen::Matrix3d& rotation);

/// transform_model() for hair, without a factor.
void turn_hair(HairMesh& hair, const Eigen::Matrix3d& rotation);

// Joints that a body's size and attitude are read from.

/// Places of the nodes, in their order, that are called such a part of a body and carry no mesh.
enum class BodyPart { kNeck, kTrunk, kFeet };
[[nodiscard]] std::vector<Eigen::Vector3d> joints_of(const importer::SourceModel& model, BodyPart part);

}  // namespace coif::cook
