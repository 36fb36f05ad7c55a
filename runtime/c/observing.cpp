// Bounds, bones relative to their parents, the last frame's matrices and debug lines, in C.
#include "asset_view.h"
#include "drawing_types.h"

#include <coif/bone_transforms.h>
#include <coif/bounds.h>
#include <coif/debug_lines.h>
#include <coif/last_frame.h>

namespace {

COIF_SAME(coif_bone_box, half, coif::BoneBox, half);
COIF_SAME(coif_bounds, highest, coif::HairBounds, highest);
COIF_SAME(coif_world_bounds, radius, coif::WorldBounds, radius);
COIF_SAME(coif_bone_transform, rotation, coif::BoneTransform, rotation);
COIF_SAME(coif_debug_line, to, coif::DebugLine, to);
COIF_SAME(coif_debug_line, kind, coif::DebugLine, kind);
COIF_SAME(coif_debug_line, index, coif::DebugLine, index);
static_assert(int(COIF_LINE_CONTACT) == int(coif::DebugLine::Kind::kContact));

using coif::c::code;
using coif::c::matrices_of;
using coif::c::span_of;
using coif::c::view_of;

template <typename T, typename InC>
std::span<T> room_of(InC* list, std::size_t count) {
  static_assert(sizeof(InC) == sizeof(T) && alignof(InC) == alignof(T));
  return {reinterpret_cast<T*>(list), list == nullptr ? 0 : count};
}

/// The host's function and its argument.
struct Drawer {
  coif_draw_line draw;
  void* user;
};

void hand_over(const coif::DebugLine& line, void* user) {
  const Drawer& drawer = *static_cast<const Drawer*>(user);
  drawer.draw(reinterpret_cast<const coif_debug_line*>(&line), drawer.user);
}

}  // namespace

extern "C" {

coif_status coif_find_bone_boxes(const coif_asset* asset, coif_bone_box* boxes, uint32_t count) {
  return code(coif::find_bone_boxes(view_of(asset), room_of<coif::BoneBox>(boxes, count)));
}

coif_status coif_bound_hair(const coif_bone_box* boxes, const coif_mat34* palette, uint32_t count,
                            coif_bounds* bounds) {
  if (bounds == nullptr) return COIF_BAD_ARGUMENT;
  coif::HairBounds its;
  const coif::Status status = coif::bound_hair(span_of<coif::BoneBox>(boxes, count), matrices_of(palette, count), its);
  if (status == coif::Status::kOk) *bounds = coif::c::copied<coif_bounds>(its);
  return code(status);
}

coif_world_bounds coif_bounds_in_world(const coif_bounds* bounds, const coif_head_pose* head) {
  if (bounds == nullptr || head == nullptr) return {};
  return coif::c::copied<coif_world_bounds>(
      coif::bounds_in_world(coif::c::copied<coif::HairBounds>(*bounds), coif::c::pose_of(*head)));
}

coif_status coif_bone_transforms(const coif_asset* asset, const coif_mat34* palette, coif_bone_transform* transforms,
                                 uint32_t count) {
  return code(coif::bone_transforms(view_of(asset), matrices_of(palette, count),
                                    room_of<coif::BoneTransform>(transforms, count)));
}

coif_status coif_hair_keep_palettes(const coif_hair* hair, coif_mat34* kept, size_t count) {
  if (hair == nullptr) return COIF_NOT_CREATED;
  return code(coif::keep_palettes(hair->hair, room_of<coif::Mat34>(kept, count)));
}

coif_status coif_draw_debug_lines(const coif_asset* asset, const coif_head_pose* head, const coif_mat34* palette,
                                  uint32_t palette_count, uint32_t what, coif_draw_line draw, void* user) {
  if (head == nullptr) return COIF_BAD_POSE;
  if (draw == nullptr) return COIF_BAD_ARGUMENT;
  const coif::Asset& opened = view_of(asset);
  const coif::HairInstance instance{coif::c::pose_of(*head), matrices_of(palette, palette_count), 0};
  Drawer drawer{draw, user};
  const coif::DebugLines lines{&hand_over, &drawer};
  coif::Status status = coif::Status::kOk;
  if ((what & uint32_t{COIF_DRAW_BONES}) != 0) status = coif::draw_bone_lines(opened, instance, lines);
  if (status == coif::Status::kOk && (what & uint32_t{COIF_DRAW_COLLIDERS}) != 0) {
    status = coif::draw_collider_lines(opened, instance.head, lines);
  }
  if (status == coif::Status::kOk && (what & uint32_t{COIF_DRAW_LIMITS}) != 0) {
    status = coif::draw_limit_lines(opened, instance, lines);
  }
  if (status == coif::Status::kOk && (what & uint32_t{COIF_DRAW_CONTACTS}) != 0) {
    status = coif::draw_contact_lines(opened, instance, lines);
  }
  return code(status);
}

}  // extern "C"
