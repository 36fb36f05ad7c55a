#pragma once
// What a head has beside it while its hair is simulated: a character's hands, size and animation.

#include <coif/asset.h>
#include <coif/hair.h>

#include <functional>
#include <span>
#include <vector>

namespace coif::motion {

struct HairCompany {
  std::function<std::vector<MovingCollider>(double seconds)> colliders{};  ///< World. Empty: none.
  /// The pose at that time, rotations of all the asset's bones as Hair::set_pose() takes them. Empty: none.
  std::function<std::vector<Quat>(double seconds)> pose{};
  float pose_weight = 1;  ///< 1: the pose is what pulls, 0: the hair is the pose.
  float scale = 1;        ///< Of the head.
  Gusts gusts{};          ///< Of amplitude 0: none.

  /// Which solver it needs: `usual` where it asks for nothing more.
  [[nodiscard]] HairDesc description(const Asset& asset, const Solver* usual) const;
  /// Tells the hair of one head where all will be at the end of the coming step.
  [[nodiscard]] Status tell(Hair& hair, double seconds) const;
};

}  // namespace coif::motion
