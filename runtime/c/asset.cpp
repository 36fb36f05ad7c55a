// coif_asset_*: records and lists of an open asset as they lie in its bytes.
#include "asset_view.h"

#include <new>

namespace {

using coif::c::list;
using coif::c::view_of;

COIF_SAME(coif_skeleton, chain_count, coif::SkeletonRecord, chain_count);
COIF_SAME(coif_skeleton, flags, coif::SkeletonRecord, flags);
COIF_SAME(coif_skeleton, head_joint, coif::SkeletonRecord, head_joint);
COIF_SAME(coif_skeleton, head_rotation, coif::SkeletonRecord, head_rotation);
COIF_SAME(coif_skeleton, air_lag, coif::SkeletonRecord, air_lag);
static_assert(COIF_FACES_BACKWARDS == coif::kSkeletonFacesBackwards && COIF_NONE == coif::kNone);

COIF_SAME(coif_bone, parent, coif::BoneRecord, parent);
COIF_SAME(coif_bone, kind, coif::BoneRecord, kind);
COIF_SAME(coif_bone, chain, coif::BoneRecord, chain);
COIF_SAME(coif_bone, name, coif::BoneRecord, name);
COIF_SAME(coif_bone, joint, coif::BoneRecord, joint);
COIF_SAME(coif_bone, length, coif::BoneRecord, length);
COIF_SAME(coif_bone, rest_direction, coif::BoneRecord, rest_direction);
COIF_SAME(coif_bone, colliders, coif::BoneRecord, colliders);
static_assert(COIF_BONE_SIMULATED == int(coif::BoneKind::kSimulated));

COIF_SAME(coif_chain, first_bone, coif::ChainRecord, first_bone);
COIF_SAME(coif_chain, bone_count, coif::ChainRecord, bone_count);
COIF_SAME(coif_chain, root, coif::ChainRecord, root);
COIF_SAME(coif_chain, model, coif::ChainRecord, model);

COIF_SAME(coif_collider, shape, coif::ColliderRecord, shape);
COIF_SAME(coif_collider, bone, coif::ColliderRecord, bone);
COIF_SAME(coif_collider, flags, coif::ColliderRecord, flags);
COIF_SAME(coif_collider, center, coif::ColliderRecord, center);
COIF_SAME(coif_collider, radii, coif::ColliderRecord, radii);
COIF_SAME(coif_collider, rotation, coif::ColliderRecord, rotation);
COIF_SAME(coif_collider, axis, coif::ColliderRecord, axis);
static_assert(COIF_BOX == int(coif::ColliderShape::kBox));
static_assert(COIF_KEEPS_INSIDE == coif::kColliderKeepsInside);

COIF_SAME(coif_limit, kind, coif::LimitRecord, kind);
COIF_SAME(coif_limit, angles, coif::LimitRecord, angles);
COIF_SAME(coif_limit, rotation, coif::LimitRecord, rotation);
static_assert(COIF_SPHERICAL == int(coif::LimitKind::kSpherical));
COIF_SAME(coif_link, bone, coif::LinkRecord, bone);
COIF_SAME(coif_link, longest, coif::LinkRecord, longest);
COIF_SAME(coif_body_bone, name, coif::BodyBoneRecord, name);
COIF_SAME(coif_body_bone, joint, coif::BodyBoneRecord, joint);
COIF_SAME(coif_body_bone, rotation, coif::BodyBoneRecord, rotation);

COIF_SAME(coif_vertex, position, coif::VertexRecord, position);
COIF_SAME(coif_vertex, normal, coif::VertexRecord, normal);
COIF_SAME(coif_vertex, tangent, coif::VertexRecord, tangent);
COIF_SAME(coif_vertex, uv, coif::VertexRecord, uv);
COIF_SAME(coif_skin, bone, coif::SkinRecord, bone);
COIF_SAME(coif_skin, weight, coif::SkinRecord, weight);

COIF_SAME(coif_patch, first_index, coif::PatchRecord, first_index);
COIF_SAME(coif_patch, index_count, coif::PatchRecord, index_count);
COIF_SAME(coif_patch, head_distance, coif::PatchRecord, head_distance);
COIF_SAME(coif_patch, bone, coif::PatchRecord, bone);
COIF_SAME(coif_patch, file_place, coif::PatchRecord, file_place);

COIF_SAME(coif_texture, role, coif::TextureRecord, role);
COIF_SAME(coif_texture, format, coif::TextureRecord, format);
COIF_SAME(coif_texture, width, coif::TextureRecord, width);
COIF_SAME(coif_texture, height, coif::TextureRecord, height);
COIF_SAME(coif_texture, mip_count, coif::TextureRecord, mip_count);
COIF_SAME(coif_texture, offset, coif::TextureRecord, offset);
COIF_SAME(coif_texture, bytes, coif::TextureRecord, bytes);
static_assert(COIF_STRAND_MAP == int(coif::TextureRole::kStrandAxis));
static_assert(COIF_RG11_EAC == int(coif::TexelFormat::kRg11Eac));
static_assert(COIF_SRGB8_ALPHA8_ETC2 == int(coif::TexelFormat::kSrgb8Alpha8Etc2));

/// Whether `texture` points into this list; an equal record elsewhere does not count.
bool is_in(std::span<const coif::TextureRecord> textures, const coif::TextureRecord* texture) {
  for (const coif::TextureRecord& own : textures) {
    if (&own == texture) return true;
  }
  return false;
}

/// Returns whether the asset is good; writes the reason to `why` where it is not.
bool tell(const coif::LoadStatus& status, char* why, std::size_t capacity) {
  if (!status && why != nullptr && capacity > 0) coif::describe(status, why, capacity);
  return bool(status);
}

}  // namespace

extern "C" {

coif_status coif_asset_open(coif_asset* asset, const void* bytes, size_t size, char* why, size_t capacity) {
  if (asset == nullptr) return COIF_BAD_ARGUMENT;
  coif::Asset opened;
  const bool is_good = tell(opened.open(coif::c::bytes_of(bytes, size)), why, capacity);
  *asset = {};
  new (asset->inside) coif::Asset(opened);
  return is_good ? COIF_OK : COIF_ASSET_LACKS_DATA;
}

int coif_asset_verify_draw_data(const coif_asset* asset, char* why, size_t capacity) {
  const coif::Asset& opened = view_of(asset);
  const coif::LoadStatus status = opened.is_open() ? opened.verify_draw_data() : coif::Asset().open({});
  return tell(status, why, capacity) ? 1 : 0;
}

int coif_check_asset(const void* asset, size_t bytes, char* why, size_t capacity) {
  coif::Asset opened;
  coif::LoadStatus status = opened.open(coif::c::bytes_of(asset, bytes));
  if (status) status = opened.verify_draw_data();
  return tell(status, why, capacity) ? 1 : 0;
}

const coif_skeleton* coif_asset_skeleton(const coif_asset* asset) {
  const coif::Asset& opened = view_of(asset);
  return opened.is_open() ? list<coif_skeleton>(std::span(&opened.skeleton(), 1), nullptr) : nullptr;
}

const coif_bone* coif_asset_bones(const coif_asset* asset, uint32_t* count) {
  return list<coif_bone>(view_of(asset).bones(), count);
}

const char* coif_asset_bone_name(const coif_asset* asset, uint32_t bone) { return view_of(asset).bone_name(bone); }

const coif_chain* coif_asset_chains(const coif_asset* asset, uint32_t* count) {
  return list<coif_chain>(view_of(asset).chains(), count);
}

const coif_collider* coif_asset_colliders(const coif_asset* asset, uint32_t* count) {
  return list<coif_collider>(view_of(asset).colliders(), count);
}

const coif_limit* coif_asset_limits(const coif_asset* asset, uint32_t* count) {
  return list<coif_limit>(view_of(asset).limits(), count);
}

const coif_link* coif_asset_links(const coif_asset* asset, uint32_t* count) {
  return list<coif_link>(view_of(asset).links(), count);
}

const coif_body_bone* coif_asset_body_bones(const coif_asset* asset, uint32_t* count) {
  return list<coif_body_bone>(view_of(asset).body_bones(), count);
}

const char* coif_asset_body_bone_name(const coif_asset* asset, uint32_t body_bone) {
  return view_of(asset).body_bone_name(body_bone);
}

const coif_collider* coif_asset_body_colliders(const coif_asset* asset, uint32_t* count) {
  return list<coif_collider>(view_of(asset).body_colliders(), count);
}

const uint32_t* coif_asset_body_sets(const coif_asset* asset, uint32_t* count) {
  return list<uint32_t>(view_of(asset).body_sets(), count);
}

const coif_vertex* coif_asset_vertices(const coif_asset* asset, uint32_t* count) {
  return list<coif_vertex>(view_of(asset).vertices(), count);
}

const coif_skin* coif_asset_skin(const coif_asset* asset, uint32_t* count) {
  return list<coif_skin>(view_of(asset).skin(), count);
}

const uint32_t* coif_asset_indices(const coif_asset* asset, uint32_t* count) {
  return list<uint32_t>(view_of(asset).indices(), count);
}

const coif_patch* coif_asset_patches(const coif_asset* asset, uint32_t* count) {
  return list<coif_patch>(view_of(asset).patches(), count);
}

const uint32_t* coif_asset_orders(const coif_asset* asset, uint32_t* count) {
  return list<uint32_t>(view_of(asset).orders(), count);
}

const uint8_t* coif_asset_order_views(const coif_asset* asset, uint32_t* count) {
  return list<uint8_t>(view_of(asset).order_views(), count);
}

const coif_material* coif_asset_material(const coif_asset* asset) {
  return reinterpret_cast<const coif_material*>(view_of(asset).material());
}

const coif_texture* coif_asset_textures(const coif_asset* asset, uint32_t* count) {
  return list<coif_texture>(view_of(asset).textures(), count);
}

const coif_texture* coif_asset_reliefs(const coif_asset* asset, uint32_t* count) {
  return list<coif_texture>(view_of(asset).reliefs(), count);
}

const coif_texture* coif_asset_texture(const coif_asset* asset, uint32_t role) {
  return reinterpret_cast<const coif_texture*>(view_of(asset).texture(static_cast<coif::TextureRole>(role)));
}

const void* coif_asset_texels(const coif_asset* asset, const coif_texture* texture, uint32_t mip, size_t* bytes) {
  const coif::Asset& opened = view_of(asset);
  const auto* const record = reinterpret_cast<const coif::TextureRecord*>(texture);
  if (bytes != nullptr) *bytes = 0;
  if (!is_in(opened.textures(), record) && !is_in(opened.reliefs(), record)) return nullptr;
  if (mip >= record->mip_count) return nullptr;
  const std::span<const std::byte> texels = opened.texels(*record, mip);
  if (bytes != nullptr) *bytes = texels.size();
  return texels.data();
}

}  // extern "C"
