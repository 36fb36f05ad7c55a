// Bones sorted in each frame, in C.
#include "drawing_types.h"

#include <coif/triangle_order.h>

#include <new>

// Lies at the start of the caller's memory; the memory of coif::BoneOrder follows.
struct coif_bone_order {
  coif::BoneOrder order;
};

namespace {

constexpr std::size_t kAlignment = 64;
constexpr std::size_t kHeadBytes = (sizeof(coif_bone_order) + kAlignment - 1) / kAlignment * kAlignment;
static_assert(kAlignment % coif::BoneOrder::kAlignment == 0 && alignof(coif_bone_order) <= kAlignment);

}  // namespace

extern "C" {

size_t coif_bone_order_memory_need(const coif_asset* asset) {
  const std::size_t need = coif::BoneOrder::memory_bytes(coif::c::view_of(asset));
  return need == 0 ? 0 : kHeadBytes + need;
}

coif_status coif_bone_order_create(const coif_asset* asset, void* memory, size_t bytes, coif_bone_order** order) {
  if (order == nullptr) return COIF_BAD_ARGUMENT;
  *order = nullptr;
  const std::size_t need = coif_bone_order_memory_need(asset);
  if (need == 0) return COIF_ASSET_LACKS_DATA;
  const bool is_aligned = reinterpret_cast<std::uintptr_t>(memory) % kAlignment == 0;
  if (memory == nullptr || !is_aligned || bytes < need) return COIF_MEMORY_TOO_SMALL;
  auto* const made = new (memory) coif_bone_order;
  const std::span<std::byte> rest(static_cast<std::byte*>(memory) + kHeadBytes, bytes - kHeadBytes);
  const coif::Status status = made->order.create(coif::c::view_of(asset), rest);
  if (status == coif::Status::kOk) *order = made;
  return coif::c::code(status);
}

coif_status coif_bone_order_write(coif_bone_order* order, const coif_drawn_hair* hair, const coif_head_pose* head,
                                  const coif_mat34* palette, uint32_t palette_count, uint32_t lod, const coif_vec3* eye,
                                  void* out, size_t bytes) {
  if (order == nullptr) return COIF_NOT_CREATED;
  if (hair == nullptr || eye == nullptr) return COIF_BAD_ARGUMENT;
  if (head == nullptr) return COIF_BAD_POSE;
  const coif::DrawnHair drawn = coif::c::hair_of(*hair);
  if (!order->order.fits(drawn)) return COIF_BAD_ARGUMENT;
  const coif::HairInstance instance{coif::c::pose_of(*head), coif::c::matrices_of(palette, palette_count), lod};
  const coif::Status status = coif::check_instance(drawn, instance);
  if (status != coif::Status::kOk) return coif::c::code(status);
  if (out == nullptr || bytes != size_t{hair->lods[lod].count} * hair->index_bytes) return COIF_SIZE_MISMATCH;
  order->order.write(instance, coif::c::vector_of(*eye), static_cast<std::byte*>(out));
  return COIF_OK;
}

}  // extern "C"
