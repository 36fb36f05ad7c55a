#pragma once

// What a model has that people know the size and the attitude of.

#include "cook/recipe/findings.h"
#include "cook/select/hair_mesh.h"
#include "cook/select/head.h"
#include "import/source_model.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace coif::cook {

struct HairRecipe;

/// What select_hair() gave and said.
struct SelectedHair {
  HairMesh mesh;
  Findings findings;
};

/// A model with its hair found, as far as that can be.
struct KnownModel {
  importer::SourceModel
      model;             ///< Without images, and of some metres where it was not: only `scale` says how large it is.
  double scale = 1;      ///< What its lengths were multiplied with.
  HairMesh hair;         ///< Empty where nothing was found.
  Findings found;        ///< What there is to be said of it.
  bool on_face = false;  ///< The hair is called brows, lashes or beard.
};

[[nodiscard]] KnownModel know_model(const importer::SourceModel& source, const HairRecipe& recipe);

/// Turns nodes, meshes, springs and colliders, and multiplies their lengths: what an import with another unit and axis
/// would have given.
void transform_model(importer::SourceModel& model, double factor, const Eigen::Matrix3d& rotation);

/// The same for hair.
void turn_hair(HairMesh& hair, const Eigen::Matrix3d& rotation);

// Joints that a body's size and attitude are read from.

/// Places of the nodes, in their order, that are called such a part of a body and carry no mesh.
enum class BodyPart { kNeck, kTrunk, kFeet };
[[nodiscard]] std::vector<Eigen::Vector3d> joints_of(const importer::SourceModel& model, BodyPart part);

}  // namespace coif::cook
