#pragma once

#include "sample/joint.h"
#include "sample/surface_mesh.h"

#include <Eigen/Core>

#include <vector>

namespace coif::sample {

/// root > neck > Head > scalp_{left,back,right} > hair_*_1 > _2 > _3 > _3_end. Parents first.
[[nodiscard]] std::vector<Joint> make_bob_skeleton();

/// Weights of a point of the hair: roots on the scalp joints, lengths on the one or two chains nearest around the head
/// and the two bones nearest in height.
[[nodiscard]] SkinInfluences hair_influences(const Eigen::Vector3d& point);

/// Weights of a point of the bust: head, neck and body.
[[nodiscard]] SkinInfluences bust_influences(const Eigen::Vector3d& point);

}  // namespace coif::sample
