// The gallery of hair on a character: a hand, sizes, gusts, an animation.

#include "render/gallery.h"

#include "base/geometry.h"
#include "motion/head_path.h"

#include <coif/hair.h>

#include <fmt/format.h>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>

namespace coif::render {
namespace {

/// The middle of the hair that hangs behind and below the head: the mean of everything drawn below the head's joint,
/// model axes.
Eigen::Vector3d hanging_hair(const Asset& asset) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), all = sum;
  std::size_t count = 0;
  for (const BoneRecord& bone : asset.bones()) {
    if (bone.kind != BoneKind::kSimulated) continue;
    const Eigen::Vector3d joint = Eigen::Map<const Eigen::Vector3f>(bone.joint).cast<double>();
    all += joint;
    if (joint.y() > 0.05) continue;
    sum += joint;
    ++count;
  }
  if (count > 0) return sum / double(count);
  return all / double(std::max<std::uint32_t>(asset.skeleton().simulated_count, 1));
}

/// An arm that strokes the hair from one side to the other and back, once in two seconds.
MovingCollider arm_at(const Eigen::Vector3d& hair, double seconds) {
  constexpr double kAside = 0.25, kLength = 0.3;
  const Eigen::Vector3d level(hair.x(), 0, hair.z());
  const Eigen::Vector3d out =
      level.norm() > 1e-3 ? Eigen::Vector3d(level.normalized()) : Eigen::Vector3d(-Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d aside = Eigen::Vector3d::UnitY().cross(out);
  const Eigen::Vector3d begin = hair - aside * (kAside * std::cos(std::numbers::pi * seconds)) - out * 0.06;
  MovingCollider arm;
  arm.shape = ColliderShape::kCapsule;
  std::copy_n(begin.data(), 3, arm.center);
  arm.axis = to_vec3(Eigen::Vector3d(out * kLength));
  arm.radius = 0.035f;
  return arm;
}

Gallery hand_through_hair(const Asset& asset, PictureSettings picture) {
  constexpr double kMoments[] = {0, 0.3, 0.5, 0.7, 1.0, 1.5};
  Gallery gallery{7, "On a character: a hand through hair", {}, "still"};
  motion::HairCompany company;
  company.colliders = [hair = hanging_hair(asset)](double seconds) { return std::vector{arm_at(hair, seconds)}; };
  picture.company = std::make_shared<motion::HairCompany>(company);
  picture.clip = motion::path_of(motion::Motion::kStill);
  picture.yaw_degrees = 150;
  for (const double moment : kMoments) {
    picture.time = moment;
    gallery.pictures.push_back({fmt::format("{:.1f} s", moment), picture});
  }
  return gallery;
}

/// A run moves hair of a large head less: its way is shorter in the hair's own metres.
Gallery sizes(PictureSettings picture) {
  Gallery gallery{7, "On a character: sizes in the same run", {}};
  picture.clip = motion::path_of(motion::Motion::kRun);
  for (const double moment : {0.9, 1.3}) {
    picture.time = moment;
    for (const float scale : {0.5f, 1.0f, 2.0f}) {
      motion::HairCompany company;
      company.scale = scale;
      picture.company = std::make_shared<motion::HairCompany>(company);
      gallery.pictures.push_back({fmt::format("scale {:g}, {:.1f} s", scale, moment), picture});
    }
  }
  return gallery;
}

/// The hair's simulated bones sway to one side and back, the same all along each chain.
std::vector<Quat> swaying(const Asset& asset, double seconds) {
  std::vector<Quat> rotations(asset.bones().size());
  const double half = 0.12 * std::sin(2 * std::numbers::pi * seconds);
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    if (asset.bones()[i].kind == BoneKind::kSimulated)
      rotations[i] = {0, 0, float(std::sin(half)), float(std::cos(half))};
  }
  return rotations;
}

Gallery pose_blend(const Asset& asset, PictureSettings picture) {
  Gallery gallery{7, "On a character: hair that follows an animation", {}};
  picture.clip = motion::path_of(motion::Motion::kStill);
  picture.yaw_degrees = 180;
  for (const double moment : {0.25, 0.75}) {
    picture.time = moment;
    for (const float weight : {1.0f, 0.5f, 0.0f}) {
      motion::HairCompany company;
      company.pose = [&asset](double seconds) { return swaying(asset, seconds); };
      company.pose_weight = weight;
      picture.company = std::make_shared<motion::HairCompany>(company);
      gallery.pictures.push_back({fmt::format("weight {:g}, {:.2f} s", weight, moment), picture});
    }
  }
  return gallery;
}

/// Hair in a breeze from the side that gusts, moment by moment.
Gallery gusts(PictureSettings picture) {
  constexpr double kMoments[] = {0.4, 0.8, 1.2, 1.6, 2.0, 2.4};
  Gallery gallery{7, "On a character: gusts of up to 6 m/s in a wind of 3", {}, "still"};
  motion::HairCompany company;
  company.gusts.amplitude = 6;
  company.gusts.direction = {1, 0, 0};
  picture.company = std::make_shared<motion::HairCompany>(company);
  picture.step.environment.wind = {3, 0, 0};
  picture.clip = motion::path_of(motion::Motion::kStill);
  picture.yaw_degrees = 150;
  for (const double moment : kMoments) {
    picture.time = moment;
    gallery.pictures.push_back({fmt::format("{:.1f} s", moment), picture});
  }
  return gallery;
}

}  // namespace

void add_character_galleries(const Asset& asset, PictureSettings picture, std::vector<Gallery>& galleries) {
  picture.solver = &kCoifSolver;
  galleries.push_back(hand_through_hair(asset, picture));
  galleries.push_back(sizes(picture));
  galleries.push_back(gusts(picture));
  galleries.push_back(pose_blend(asset, picture));
}

}  // namespace coif::render
