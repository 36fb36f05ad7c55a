#pragma once
// The records that the chunks of a .coif are made of (coif/chunks.h: which chunk holds which). formats/SPECIFICATION.md
// describes the same layout in prose and changes together with this file. Everything is little-endian and used in
// place.
//
// Space: "head space" has its origin at the head bone's joint in the rest pose and the axes of the model:
// right-handed, +Y up, metres. Nothing in an asset is in any other space.

#include <coif/appearance_records.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace coif {

static_assert(std::endian::native == std::endian::little, "a .coif is used in place; big-endian hosts need a reader");

inline constexpr std::uint32_t kNone = 0xFFFFFFFFu;  ///< "No such bone, chain or name".
inline constexpr std::uint32_t kMaxBones = 4096;     ///< Keeps everything that has one value per bone small.
inline constexpr std::uint32_t kMaxColliders = 32;   ///< A bone's set of colliders is one word.
/// As kMaxColliders, for colliders that hang from the body's bones.
inline constexpr std::uint32_t kMaxBodyColliders = 32;
inline constexpr std::uint32_t kMaxLods = 8;
inline constexpr std::uint32_t kMaxOrders = 32;  ///< Draw orders of one asset, the stored one included.
inline constexpr std::uint32_t kViewCells = 96;  ///< Viewing directions that may have an order each: view_cells.h.
/// Most bones of a chain that may be open (see ChainRecord) at one place of the stored order. A solver keeps that many
/// at hand.
inline constexpr std::uint32_t kMaxOpenBones = 16;

/// The model looks along -Z at rest; otherwise along +Z. For pictures and names; the simulation does not care.
inline constexpr std::uint32_t kSkeletonFacesBackwards = 1;

struct SkeletonRecord {
  std::uint32_t bone_count;
  std::uint32_t simulated_count;
  std::uint32_t chain_count;
  std::uint32_t flags;  ///< kSkeletonFacesBackwards; other bits are zero.
  /// Head bone in the rest pose of the source model: its joint (metres) and the rotation (x, y, z, w) from the
  /// bone's own axes to the model's. A host whose head bone has the world pose (p, q) passes the head pose
  /// (p, q * conjugate(head_rotation)).
  float head_joint[3];
  float head_rotation[4];
  /// 0..1: the share of the head's velocity that the air around it does not take on. At 0 a head that moves steadily
  /// does not disturb its hair; at 1 the hair streams back as in still air.
  float air_lag;
};
static_assert(sizeof(SkeletonRecord) == 48);

enum class BoneKind : std::uint32_t {
  kHead = 0,       ///< Bone 0, and only bone 0: moved by the host.
  kScalp = 1,      ///< Rigid with the head.
  kSimulated = 2,  ///< A segment from the parent's tail (or a rigid parent's joint) to this bone's particle.
};

/// Bones are sorted: head, then scalp bones, then simulated bones chain by chain; parents come first.
/// In the rest pose every bone's frame has the axes of head space, so a rotation is always "from rest".
struct BoneRecord {
  std::uint32_t parent;  ///< Index of an earlier bone; kNone for bone 0.
  BoneKind kind;
  std::uint32_t chain;      ///< Index into CHAN; kNone for rigid bones.
  std::uint32_t name;       ///< Byte offset into NAME; kNone without a name.
  float joint[3];           ///< Rest position of the bone's start, head space, metres.
  float length;             ///< Start to particle, metres, > 0; 0 for rigid bones.
  float rest_direction[3];  ///< Unit, start to particle at rest, in the parent's frame; 0 for rigid bones.
  /// Bit i: the bone's particle may touch collider i. 0: it never does, and the runtime never tests it.
  std::uint32_t colliders;
};
static_assert(sizeof(BoneRecord) == 48);

/// The model in runtime/docs/MODEL.md that a chain's dynamics are meant for.
enum class ChainModel : std::uint32_t {
  kCascade = 0,  ///< Bones do not hold back their parents.
  kPassive = 1,  ///< Bones hold back their parents.
};

/// A tree of simulated bones that hangs from one rigid bone. A bone is open from its own place in the stored order to
/// the place of its last child. At most kMaxOpenBones are open at any place; bones that open or close there count.
struct ChainRecord {
  std::uint32_t first_bone;
  std::uint32_t bone_count;
  std::uint32_t root;  ///< The head or scalp bone that carries it.
  ChainModel model;
};
static_assert(sizeof(ChainRecord) == 16);

inline constexpr float kNoAngleLimit = 3.14159274f;  ///< Half a turn: no direction is further away.

/// With this torsion a twist is gone at once: frames are the shortest arcs, and no twist is stored or computed.
inline constexpr float kShortestArc = 1e6f;

/// How a bone moves. `thesis` reads resistance; `coif` reads stiffness and damping, which were baked from it
/// (runtime/docs/MODEL.md). Both read friction, gravity and the hit radius.
struct DynamicsRecord {
  float resistance;      ///< Pull to the default pose per step of the authoring rate, 0..1 (thesis 5.2).
  float friction;        ///< Velocity loss relative to the air, 1/s, >= 0.
  float gravity_scale;   ///< Share of the scene's gravity that this bone feels.
  float authoring_rate;  ///< Steps per second at which the artist's resistance holds, > 0.
  float hit_radius;      ///< Distance that the bone keeps from every collider's surface, metres, >= 0.
  float stiffness;       ///< Pull to the default pose, acceleration per metre off it, 1/s^2, >= 0.
  float damping;         ///< Velocity loss relative to the default pose's own velocity, 1/s, >= 0.
  float torsion;         ///< Rate at which a twist against the parent decays, 1/s, 0..kShortestArc.
  float angle_limit;     ///< Largest angle to the default direction, radians, 0..kNoAngleLimit.
  float parent_share;    ///< Share of the pull that turns with the parent, 0..1; the rest turns with the head.
  /// Where the default direction is relative to the rest direction: see pull_direction(). Zero: both are the same.
  float lean[2];
};
static_assert(sizeof(DynamicsRecord) == 48);

/// The artist's own numbers, where DynamicsRecord has others: the cook changed them so that the chain has one
/// well-defined motion. `thesis` reads its friction from here; the comparisons of `coif report` read all of them.
struct AskedRecord {
  float friction;      ///< As DynamicsRecord::friction.
  float damping;       ///< As DynamicsRecord::damping.
  float parent_share;  ///< As DynamicsRecord::parent_share.
};
static_assert(sizeof(AskedRecord) == 12);

/// How a bone's direction is limited, as VRMC_springBone_limit 1.0 defines it.
enum class LimitKind : std::uint32_t {
  kUnlimited = 0,
  kCone = 1,       ///< At most angles[0] from the middle direction.
  kHinge = 2,      ///< In the plane at right angles to the limit's x, and at most angles[0] from the middle direction.
  kSpherical = 3,  ///< Pitch, about x, at most angles[0] to either side; yaw, towards x, at most angles[1].
};

/// Largest yaw of a spherical limit: a quarter turn.
inline constexpr float kMostYaw = kNoAngleLimit / 2;

/// Where a bone's particle may be, seen from its joint. d is the unit direction in the limit's own axes, whose y is the
/// middle direction. Cone: d.y >= cos(angles[0]). Hinge: d.x = 0, and the same. Spherical: d = (sin(yaw), cos(yaw)
/// cos(pitch), cos(yaw) sin(pitch)) with |pitch| <= angles[0] and |yaw| <= angles[1].
struct LimitRecord {
  LimitKind kind;
  /// Radians. The first is 0..kNoAngleLimit; the second is 0..kMostYaw and for spherical limits only. An unused angle
  /// is 0.
  float angles[2];
  float reserved;
  float rotation[4];  ///< Unit quaternion (x, y, z, w) from the limit's own axes to the parent's frame.
};
static_assert(sizeof(LimitRecord) == 32);

/// Two bones of equal depth in two chains, whose particles stay together as in one sheet of hair. The links of one
/// depth form trees: each link hangs `bone` on a bone that an earlier link named.
struct LinkRecord {
  std::uint32_t bone;
  std::uint32_t to;
  float shortest;  ///< Between their particles, metres, 0..longest.
  float longest;   ///< Metres, 1e-6 or more.
};
static_assert(sizeof(LinkRecord) == 16);

/// The default direction at rest, unit: the direction that a bone with this unit rest direction is pulled to. `lean`
/// (length at most 1) has its components along two directions at right angles to the rest direction (Duff et al. 2017,
/// "Building an Orthonormal Basis, Revisited"); the component along the rest direction completes it to unit length. A
/// bone whose pull leans against its weight rests where it was modelled. `solver thesis` knows no lean.
inline void pull_direction(const float (&rest)[3], const float (&lean)[2], float (&pull)[3]) {
  const float sign = rest[2] < 0.0f ? -1.0f : 1.0f;
  const float a = -1.0f / (sign + rest[2]), b = rest[0] * rest[1] * a;
  const float first[3] = {1.0f + sign * rest[0] * rest[0] * a, sign * b, -sign * rest[0]};
  const float second[3] = {b, sign + rest[1] * rest[1] * a, -rest[1]};
  const float left = 1.0f - lean[0] * lean[0] - lean[1] * lean[1];
  const float along = std::sqrt(left > 0.0f ? left : 0.0f);
  for (int k = 0; k < 3; ++k) pull[k] = rest[k] * along + first[k] * lean[0] + second[k] * lean[1];
}

enum class ColliderShape : std::uint32_t {
  kSphere = 0,
  kEllipsoid = 1,
  kCapsule = 2,  ///< All points nearer than the radius to the segment from `center` to `center + axis`.
  kPlane = 3,    ///< All points behind the plane through `center` with the normal `axis`.
  /// The convex hull of two balls: radii[0] around `center`, radii[1] around `center + axis`, neither inside the other.
  kTaperedCapsule = 4,
  kBox = 5,  ///< Never in a file: a shape that a game may add (coif/character.h).
};

/// Hair stays inside the shape instead of outside of it. Spheres and capsules only.
inline constexpr std::uint32_t kColliderKeepsInside = 1u << 0;

struct ColliderRecord {
  ColliderShape shape;
  std::uint32_t bone;  ///< A rigid bone; in BODC the number of a BodyBoneRecord.
  std::uint32_t flags;
  std::uint32_t reserved;
  float center[3];  ///< Head space, metres. Capsule: one end of its segment. Plane: a point on it.
  float reserved_center;
  /// Semi-axes, metres, > 0. All equal for spheres and capsules; 0 for a plane; a tapered capsule has the radii of both
  /// ends, then 0.
  float radii[3];
  float reserved_radii;
  float rotation[4];  ///< Unit quaternion (x, y, z, w) from the ellipsoid's axes to head space.
  float axis[3];      ///< Capsules: to the segment's other end, metres, not zero. Plane: unit normal. Others: 0.
  float reserved_axis;
};
static_assert(sizeof(ColliderRecord) == 80);

/// A bone of the body that wears the hair, with its name in the source. Body colliders hang from it. The host gives its
/// pose in each step. A point at x in head space at rest then is at pose * rest^-1 * x, where both are poses of this
/// bone.
struct BodyBoneRecord {
  std::uint32_t name;  ///< Byte offset into NAME; never kNone.
  float joint[3];      ///< Rest pose, head space, metres.
  float rotation[4];   ///< Rest pose: unit quaternion (x, y, z, w) from the bone's own axes to head space.
};
static_assert(sizeof(BodyBoneRecord) == 32);

struct VertexRecord {
  float position[3];  ///< Rest pose, head space, metres.
  /// xyz: snorm16. w: share of the ambient light that other hair and the head let through to here in the rest pose, 0
  /// none, 32767 all of it.
  std::int16_t normal[4];
  std::int16_t tangent[4];  ///< xyz: snorm16, root to tip; w: place along the strand, 0 root, 32767 tip.
  float uv[2];              ///< V grows downwards in the image (first row of texels is V = 0).
};
static_assert(sizeof(VertexRecord) == 36);

struct SkinRecord {
  std::uint16_t bone[4];
  std::uint8_t weight[4];  ///< unorm8; the four add up to 255.
};
static_assert(sizeof(SkinRecord) == 12);

struct PatchRecord {
  std::uint32_t first_index;  ///< Into INDX; patches follow each other without gap.
  std::uint32_t index_count;  ///< A multiple of 3, > 0.
  /// Distance from the patch's area centre to the head's centre, metres; the thesis sorts by it.
  float head_distance;
  std::uint32_t bone;        ///< The bone with the most weight on the patch.
  std::uint32_t file_place;  ///< The patch's place in the order of the source file; levels of detail share it.
};
static_assert(sizeof(PatchRecord) == 20);

// Draw orders. Order 0 is that of INDX. ORDR holds the others one after the other. Each lists all triangles, every
// level of detail in its own range of positions; triangle t is the three indices from 3 t on. VIEW has the number of
// the best order for each cell of directions (coif/view_cells.h, from the head towards the eye in head space).

/// A level of detail: consecutive patches, drawn in their order. Coarser levels simulate fewer bones. LODB says for
/// each bone in how many levels, counted from the finest, it is simulated; in the others it is rigid to its parent.
struct LodRecord {
  std::uint32_t first_patch;  ///< Into PTCH; levels follow each other without gap.
  std::uint32_t patch_count;  ///< > 0.
  /// The level fits where the head collider's height covers at least this share of the viewport's height. Falls from
  /// level to level; 0 for the last.
  float screen_size;
  float error;  ///< Largest distance of the surface from level 0's, metres; grows from level to level.
};
static_assert(sizeof(LodRecord) == 16);

/// Cooked quickly for a preview; a game must not ship it.
inline constexpr std::uint32_t kProvenanceDraft = 1;

struct ProvenanceRecord {
  std::uint64_t source_hash;      ///< XXH64 of the source file's bytes.
  std::uint64_t recipe_hash;      ///< XXH64 of the complete recipe in its canonical form.
  std::uint16_t tool_version[3];  ///< major, minor, patch.
  std::uint16_t importer_version[3];
  std::uint32_t flags;  ///< kProvenanceDraft; other bits are zero.
};
static_assert(sizeof(ProvenanceRecord) == 32);

/// How the asset should be simulated: the cheapest way that met the error asked for when it was cooked.
struct TuningRecord {
  float substep_rate;   ///< A step of dt is made of ceil(dt * substep_rate) parts, at least one. Hz, >= 0.
  float asked_error;    ///< RMS of the tips, share of the chain's length; 0: only a cost was asked for.
  float reached_error;  ///< In the worst case of the frame rates and motions measured.
  float asked_cost;     ///< Nanoseconds per head and frame; 0: any.
  float cost;           ///< Nominal nanoseconds, in the worst case of the frame rates; see QualityRecord.
  float slowest_rate;   ///< Frames per second that were asked for, > 0.
  float fastest_rate;   ///< At least slowest_rate.
  std::uint32_t met;    ///< 1 where the request was met, else 0.
};
static_assert(sizeof(TuningRecord) == 32);

/// The cost and the error of one way to simulate the asset, over the motions of the suite.
struct QualityRecord {
  float frame_rate;        ///< Frames per second, > 0.
  std::uint32_t substeps;  ///< In each frame, > 0.
  float rms_error;         ///< In the worst motion: tips against the converged solution, share of the chain's length.
  float max_error;         ///< Largest error of any motion.
  float stretch;           ///< Worst |length / rest - 1|.
  float penetration;       ///< Worst depth over the collider's radius.
  float cost;              ///< Nominal nanoseconds per head and frame: a fixed figure per bone, so that bytes repeat.
  std::uint32_t worst_motion;  ///< Index into the names of motions that the asset has.
};
static_assert(sizeof(QualityRecord) == 32);

/// The name of a motion that the cook tried.
struct MotionNameRecord {
  char name[16];  ///< UTF-8, not empty; the bytes behind it are zero, the last one always.
};
static_assert(sizeof(MotionNameRecord) == 16);

}  // namespace coif
