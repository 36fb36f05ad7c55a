#pragma once

#include "write/asset_writer.h"

#include <coif/asset.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace coif::lab {

/// One simulated bone in double precision. Head space, metres, seconds.
struct RigBone {
  int parent = -1;                                  ///< Index into Rig::bones; -1: hangs from the head.
  Eigen::Vector3d joint = Eigen::Vector3d::Zero();  ///< Start at rest; moves rigidly with the head where parent is -1.
  Eigen::Vector3d rest_direction = -Eigen::Vector3d::UnitY();  ///< Unit, in the parent's frame.
  double length = 1;
  double resistance = 0;  ///< Per step, for the solvers that are made of steps.
  double stiffness = 0;   ///< 1/s^2
  double damping = 0;     ///< 1/s, against the default pose's velocity.
  double friction = 0;    ///< 1/s, against the air's.
  double air_follow = 1;  ///< Share of the head's velocity that the air takes on.
  double gravity_scale = 1;
  double authoring_rate = 60;
  double hit_radius = 0;
  double torsion = 0;                          ///< 1/s; kShortestArc: never a twist.
  double angle_limit = double(kNoAngleLimit);  ///< Radians.
  LimitRecord limit{};                         ///< With its own axes, in the parent's frame.
  double parent_share = 1;
  /// Unit, in the parent's frame: where the bone is pulled to. Zero: to its rest direction.
  Eigen::Vector3d leaning = Eigen::Vector3d::Zero();
  std::uint32_t colliders = 0;
  ChainModel model = ChainModel::kCascade;  ///< The same for all bones of a tree.
  /// Set if the cook changed the artist's numbers of the chain.
  std::optional<AskedRecord> asked;

  [[nodiscard]] const Eigen::Vector3d& pull_direction() const { return leaning.isZero() ? rest_direction : leaning; }
};

/// Two bones of a rig whose particles stay together: LinkRecord.
struct RigLink {
  std::uint32_t bone = 0, to = 0;    ///< Indices into Rig::bones.
  double shortest = 0, longest = 0;  ///< Metres.
};

/// The moving parts of an asset, for solvers other than the runtime's. Parents come first.
struct Rig {
  std::vector<RigBone> bones;
  std::vector<ColliderRecord> colliders;
  std::vector<RigLink> links;  ///< By depth.
  /// Bones without children: where errors are measured.
  std::vector<std::uint32_t> tips;
  std::vector<double> tip_length;        ///< Length of the chain that ends there, joint to tip, metres.
  std::vector<std::uint32_t> tip_chain;  ///< Index of that chain in the asset.
  std::uint32_t rigid_count = 0;         ///< Bones of the asset before the first simulated one.
};

[[nodiscard]] Rig rig_of(const Asset& asset);

/// Ends of the bones at rest, head space.
[[nodiscard]] std::vector<Eigen::Vector3d> resting_ends(const Rig& rig);

/// The number of bones above each.
[[nodiscard]] std::vector<int> depths_of(std::span<const RigBone> bones);

/// The links of a part of the rig. `place`: the index in the part of each bone of the rig, -1 if it or the bone that it
/// is linked to is not in the part.
[[nodiscard]] std::vector<RigLink> links_among(const Rig& rig, std::span<const int> place);

/// The same bones, all moved by `model`.
[[nodiscard]] Rig in_model(Rig rig, ChainModel model);

/// The same bones with the artist's numbers.
[[nodiscard]] Rig as_asked(Rig rig);

/// A part of a rig, for measurements that would take too long on all of it.
struct RigSample {
  Rig rig;
  std::vector<std::uint32_t> bones;  ///< Indices in the whole rig, one for each bone of `rig`.
};

/// Whole trees of bones (trees_of()), evenly chosen over the head, with at most `most_bones` bones, but at least one
/// tree. Trees do not act on each other, so each moves as it does among all.
[[nodiscard]] RigSample sample_of(const Rig& rig, std::size_t most_bones);

/// Skeleton, bones, chains and dynamics of an open asset, without names: for assets that are that hair in other
/// circumstances.
[[nodiscard]] AssetContents moving_part(const Asset& asset);

/// The same, with bones that touch nothing.
[[nodiscard]] AssetContents untouched_part(const Asset& asset);

/// An asset made in memory, and its bytes: measured things run as in a game.
class OpenedAsset {
 public:
  /// Contents that the format does not allow leave asset() closed.
  explicit OpenedAsset(const AssetContents& contents) : OpenedAsset(write_asset(contents), {.verify_hash = false}) {}
  /// A copy of a file's bytes.
  explicit OpenedAsset(std::span<const std::byte> file, const OpenOptions& options = {});

  [[nodiscard]] const Asset& asset() const { return asset_; }
  /// Why asset() is closed, if it is.
  [[nodiscard]] const LoadStatus& status() const { return status_; }

 private:
  struct FreeMemory {
    void operator()(std::byte* bytes) const;
  };

  std::unique_ptr<std::byte[], FreeMemory> bytes_;
  Asset asset_;
  LoadStatus status_;
};

}  // namespace coif::lab
