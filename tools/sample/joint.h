#pragma once

#include <Eigen/Core>

#include <string>

namespace coif::sample {

/// A joint in the rest pose. Joints have no rotation: their axes are the model's.
struct Joint {
  std::string name;
  int parent = -1;           ///< An earlier joint; -1 for the root.
  Eigen::Vector3d position;  ///< Model space, metres.
};

}  // namespace coif::sample
