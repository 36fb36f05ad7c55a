#pragma once

#include "models/small_asset.h"
#include "write/asset_writer.h"

#include <coif/asset.h>
#include <coif/hair.h>

#include <cstdint>
#include <vector>

namespace coif {

/// One simulated bone as a test wants it. Defaults: hangs down, one metre long, nothing acts on it but gravity.
struct TestBone {
  std::uint32_t parent = 0;  ///< Bone 0 is the head.
  Vec3 joint{};              ///< Where a first bone starts; others start at their parent's particle.
  Vec3 rest_direction{0, -1, 0};
  float length = 1;
  float resistance = 0;
  float friction = 0;
  float hit_radius = 0;
  float stiffness = -1;  ///< 1/s^2; negative: what the resistance is baked into.
  float damping = -1;    ///< 1/s; negative: likewise.
  float torsion = 0;
  float angle_limit = kNoAngleLimit;
  float parent_share = 1;
};

/// The parts of an asset that the simulation reads: a head, and chains of bones in the order they are added.
class TestRig {
 public:
  TestRig();
  /// Returns the bone's index. A bone on the head begins a chain. Every bone may touch all colliders; change
  /// bones[i].colliders for less.
  std::uint32_t add(const TestBone& bone);
  /// So many bones end to end, each like `bone`, of which the first hangs from bone.parent. Returns the last.
  std::uint32_t add_strand(int count, const TestBone& bone);
  void add_sphere(const Vec3& center, float radius);
  void add_ellipsoid(const Vec3& center, const Vec3& radii, const Quat& rotation = {});
  void add_capsule(const Vec3& from, const Vec3& to, float radius);
  void add_tapered_capsule(const Vec3& from, float from_radius, const Vec3& to, float to_radius);
  void add_plane(const Vec3& point, const Vec3& normal);  ///< `normal` unit.
  /// On the last body bone; its centre in head space.
  void add_body_sphere(const Vec3& center, float radius);
  /// Bounds the bone's direction; `rotation` from the limit's axes to the parent's frame. Bones that are added later
  /// have none.
  void limit(std::uint32_t bone, LimitKind kind, float first, float second = 0, const Quat& rotation = {});

  /// Keeps the particles of two bones at 1 - `shrink` to 1 + `stretch` times their distance at rest.
  void link(std::uint32_t bone, std::uint32_t to, float stretch = 0.1f, float shrink = 0.5f);

  [[nodiscard]] std::size_t simulated_count() const { return bones.size() - 1; }
  /// Where the particles rest, head space.
  [[nodiscard]] std::vector<Vec3> rest_ends() const;
  [[nodiscard]] AssetContents contents() const;

  ChainModel model = ChainModel::kCascade;  ///< All chains'.
  std::vector<BoneRecord> bones;
  std::vector<DynamicsRecord> dynamics;
  std::vector<ColliderRecord> colliders;
  /// As colliders, but on the bones of a body, of which every simulated bone may touch all; names are made up.
  std::vector<BodyBoneRecord> body_bones;
  std::vector<ColliderRecord> body_colliders;
  std::vector<LimitRecord> limits;  ///< One for each bone, or empty: see limit().
  std::vector<LinkRecord> links;    ///< See link(); as LINK demands.
  float substep_rate = 0;           ///< Above 0: the asset is tuned, for this many sub-steps a second.
  /// In how many levels of detail each bone is simulated, bone 0's 0; empty for an asset with one level.
  std::vector<std::uint8_t> levels;
};

/// Three chains of three bones behind and beside a head sphere, as a small hair style has.
[[nodiscard]] TestRig nine_bone_rig();

/// `count` bones of `length` metres in all, from the back of the head down and backwards, stiff at the root and soft at
/// the tip, critically damped: hair whose motion does not depend on the last digit of anything.
[[nodiscard]] TestRig calm_strand(int count, float length);

/// A Hair with the asset and the memory it needs, whose heads stand at the identity pose: poses that they are told are
/// movement.
class TestHair {
 public:
  explicit TestHair(const TestRig& rig, std::uint32_t instances = 1)
      : TestHair(rig, HairDesc{.instances = instances}) {}
  TestHair(const TestRig& rig, const HairDesc& desc);
  [[nodiscard]] std::vector<std::byte> memory_copy();
  /// Bone ends of the simulated bones.
  [[nodiscard]] std::vector<Vec3> ends(std::uint32_t instance = 0) const;

  Asset asset;
  Hair hair;

 private:
  AlignedBytes file_;
  AlignedBytes memory_;
};

/// All that this build has and this processor knows, kScalar included.
[[nodiscard]] std::vector<InstructionSet> runnable_sets();
/// What the others are compared with: kScalar, or the only one of a build for one.
[[nodiscard]] InstructionSet plainest_set();

[[nodiscard]] float distance(const Vec3& a, const Vec3& b);
[[nodiscard]] float largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b);
/// Unit quaternion; `axis` unit.
[[nodiscard]] Quat turned_about(const Vec3& axis, double radians);
[[nodiscard]] Vec3 rotated(const Quat& rotation, const Vec3& v);
/// First b, then a.
[[nodiscard]] Quat product(const Quat& a, const Quat& b);
/// By which one is turned against the other, radians, 0..pi.
[[nodiscard]] double angle_between(const Quat& a, const Quat& b);
[[nodiscard]] Vec3 transformed(const Mat34& matrix, const Vec3& point);

// Hair that has everything an asset can have, and a game that does everything with it: for tests of what must not
// matter.

/// Chains of four shapes, one of them branching and one too frequent for a row; every shape of collider, in different
/// sets; bones with and without friction, limits, twist and a pull to the head; three levels of detail.
[[nodiscard]] TestRig feature_rig();

enum class JobOrder : std::uint8_t { kAscending, kDescending, kTwoThreads };

/// A game of `frames` frames, of different lengths and in up to three parts. Each instance's head lives its own life,
/// which depends on the instance's index alone: it wanders, stands still, is put elsewhere and reset. Made without
/// libm, so that it is the same game everywhere.
struct FeaturePlay {
  const Solver* solver = &kCoifSolver;
  InstructionSet set = InstructionSet::kBest;
  std::uint32_t instances = 1;
  int frames = 80;
  float sleep_after = 0.1f;
  bool changes_detail = false;  ///< Levels, intervals, out of sight and back.
  bool descending_heads = false;
  JobOrder jobs = JobOrder::kAscending;
};

/// For each instance a hash of all of its matrices and bone ends of all frames.
[[nodiscard]] std::vector<std::uint64_t> digests(const FeaturePlay& play);

}  // namespace coif
