// Levels of detail in C.
#include "asset_view.h"

#include <coif/lod.h>

namespace {

using coif::c::list;
using coif::c::view_of;

COIF_SAME(coif_lod, first_patch, coif::LodRecord, first_patch);
COIF_SAME(coif_lod, patch_count, coif::LodRecord, patch_count);
COIF_SAME(coif_lod, screen_size, coif::LodRecord, screen_size);
COIF_SAME(coif_lod, error, coif::LodRecord, error);
static_assert(COIF_MAX_LODS == coif::kMaxLods);

}  // namespace

extern "C" {

uint32_t coif_asset_lod_count(const coif_asset* asset) { return view_of(asset).lod_count(); }

const coif_patch* coif_asset_lod_patches(const coif_asset* asset, uint32_t lod, uint32_t* count) {
  return list<coif_patch>(view_of(asset).lod_patches(lod), count);
}

const uint32_t* coif_asset_lod_indices(const coif_asset* asset, uint32_t lod, uint32_t* count) {
  return list<uint32_t>(view_of(asset).lod_indices(lod), count);
}

const coif_lod* coif_asset_stored_lods(const coif_asset* asset, uint32_t* count) {
  return list<coif_lod>(view_of(asset).stored_lods(), count);
}

const uint8_t* coif_asset_lod_bones(const coif_asset* asset, uint32_t* count) {
  return list<uint8_t>(view_of(asset).lod_bones(), count);
}

float coif_screen_share(float height, float distance, float fov) { return coif::screen_share(height, distance, fov); }

uint32_t coif_asset_choose_lod(const coif_asset* asset, float share, uint32_t current, float hysteresis) {
  return coif::choose_lod(view_of(asset).stored_lods(), share, current, hysteresis);
}

}  // extern "C"
