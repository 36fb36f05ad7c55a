#pragma once

#include "import/import.h"
#include "import/source_format.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

struct aiScene;

namespace coif {

/// What takes the importer's coordinates to metres, Y up, right-handed.
///
/// What assimp 5.2 leaves to do, found by measuring real files: FBX is left in the file's unit (UnitScaleFactor
/// centimetres) and axes (metadata); COLLADA has both applied in the root node; glTF is metres, Y up by definition; OBJ
/// says nothing and is taken as Y up; guess_unit() finds its size. Settings override the file.
[[nodiscard]] Eigen::Affine3d model_from_scene(const aiScene& scene, SourceFormat format,
                                               const ImportSettings& settings, std::vector<std::string>& warnings);

/// OBJ has no unit. Takes the power of ten from a metre down to a millimetre at which the model is as deep as hair or a
/// body is, scales it, and says so; leaves models without depth alone.
void guess_unit(SourceModel& model);

/// Adds a warning when the model's height cannot be that of hair or of somebody who wears it.
void warn_of_implausible_height(SourceModel& model);

}  // namespace coif
