#pragma once
// Lines that show the simulation's state: bones, what they collide with, how far they may bend, where they touch. A
// function of the host gets them one by one and draws them. Nothing here allocates, uses a graphics interface or keeps
// its arguments; a program links only the functions that it calls.

#include <coif/asset.h>
#include <coif/character.h>
#include <coif/drawing.h>
#include <coif/export.h>
#include <coif/math.h>
#include <coif/status.h>

#include <cstdint>
#include <span>

namespace coif {

struct DebugLine {
  enum class Kind : std::uint8_t {
    kBone,       ///< A simulated bone, from its start to its particle.
    kRigidBone,  ///< From a rigid bone's parent to it.
    kCollider,
    kLimit,    ///< The border of the directions that a bone may take: by its angle_limit, and by its LimitRecord.
    kContact,  ///< A cross and a normal where a bone touches a collider.
  };
  double from[3];  ///< World, metres.
  double to[3];
  Kind kind;
  std::uint32_t index;  ///< The index of the bone, or of the collider.
};

/// Linear colour that tells the kinds apart.
[[nodiscard]] constexpr Vec3 debug_color(DebugLine::Kind kind) {
  constexpr Vec3 kColors[] = {
      {0.9f, 0.7f, 0.05f}, {0.3f, 0.3f, 0.3f}, {0.05f, 0.35f, 0.9f}, {0.1f, 0.7f, 0.15f}, {0.9f, 0.03f, 0.05f}};
  return kColors[static_cast<std::uint8_t>(kind)];
}

/// The receiver of lines. `draw` must not be null.
struct DebugLines {
  void (*draw)(const DebugLine& line, void* user) = nullptr;
  void* user = nullptr;
};

/// A collider of the asset or of a game. Head space, metres, radians; each member as in ColliderRecord.
struct DebugCollider {
  ColliderShape shape = ColliderShape::kSphere;
  Vec3 center{};
  Vec3 axis{};          ///< Capsules: to the segment's other end. Plane: unit normal.
  Vec3 radii{};         ///< Semi-axes; tapered capsule: both ends' radii. Box: x rounds it outwards by this much.
  Quat rotation{};      ///< From the ellipsoid's or box's own axes to head space.
  Vec3 half_extents{};  ///< Half the sides of a box.
  bool keeps_inside = false;
};

[[nodiscard]] COIF_API DebugCollider debug_collider(const ColliderRecord& collider);
/// A collider of the game, as for Hair::set_colliders(), seen from this head, whose pose must be valid.
[[nodiscard]] COIF_API DebugCollider debug_collider(const MovingCollider& collider, const HeadPose& head);
/// One of Asset::body_colliders(), placed by the pose `bone` as for Hair::set_body(). `index` is into body_colliders().
[[nodiscard]] COIF_API DebugCollider debug_body_collider(const Asset& asset, std::uint32_t index, const BodyPose& bone,
                                                         const HeadPose& head);

/// Draws a line for each bone but the head. `instance.lod` is ignored. Like the other functions for an instance:
/// kAssetLacksData where the asset is not open, kBadArgument without a function, kSizeMismatch unless the palette has
/// one matrix per bone, kBadPose and kBadScale as check_instance(); after an error no line was drawn.
COIF_API Status draw_bone_lines(const Asset& asset, const HairInstance& instance, const DebugLines& lines);

/// Draws for each bone with a limit the border of its particle's range, with lines to it from the bone's start: a cone,
/// a hinge's arc, or the range of pitch and yaw.
COIF_API Status draw_limit_lines(const Asset& asset, const HairInstance& instance, const DebugLines& lines);

/// Draws outlines; a plane is a square of 0.6 m with its normal. `first` is the index that the first collider's lines
/// get. kBadArgument without a function or for a size or place that is not finite, kBadPose, kBadScale.
COIF_API Status draw_collider_lines(std::span<const DebugCollider> colliders, const HeadPose& head,
                                    const DebugLines& lines, std::uint32_t first = 0);

/// Draws the asset's own colliders.
COIF_API Status draw_collider_lines(const Asset& asset, const HeadPose& head, const DebugLines& lines);

/// Draws a mark where a bone, as thick as its hit radius, comes nearer than `tolerance` (metres, head space, >= 0) to a
/// collider that it may touch. `more` are colliders of the game, which every bone may touch. DebugLine::index is the
/// bone's. Uses geometry alone, not the solver's contacts. A bone that starts inside a collider (roots in the scalp)
/// gets no mark there, since it cannot avoid it.
COIF_API Status draw_contact_lines(const Asset& asset, const HairInstance& instance, const DebugLines& lines,
                                   std::span<const DebugCollider> more = {}, float tolerance = 1e-3f);

}  // namespace coif
