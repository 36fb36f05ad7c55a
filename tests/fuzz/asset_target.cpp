#include "fuzz/play_asset.h"
#include "fuzz/promise.h"
#include "fuzz/targets.h"
#include "models/small_asset.h"
#include "write/strip_asset.h"

#include <coif/drawing.h>

#include <cmath>
#include <cstring>
#include <iterator>

namespace coif::fuzz {
namespace {

void check_description(const LoadStatus& status) {
  char text[64];
  const std::size_t length = describe(status, text, sizeof text);
  promise(length < sizeof text && std::strlen(text) == length, "a status describes itself in the room given");
}

/// What a renderer asks of an asset before it is drawn.
void prepare_to_draw(const Asset& asset) {
  if (asset.vertices().empty()) return;
  const Reach reach = reach_of(asset);
  promise(std::isfinite(reach.radius) && reach.radius >= 0, "hair reaches a finite distance");
  const AlphaRange alpha = alpha_range_of(asset);
  promise(alpha.lowest >= 0 && alpha.lowest <= alpha.highest && alpha.highest <= 1, "alpha lies in 0..1");
}

/// Without one of its chunks, which one depends on the input's size: one input is not to take the time of twenty.
void strip(const Asset& asset, std::span<const std::byte> file) {
  const std::uint32_t chunk = kChunkLayouts[file.size() % kChunkKinds].id;
  if (is_needed_chunk(chunk)) return;
  AlignedBytes stripped(strip_asset(asset, file, {&chunk, 1}).file);
  Asset rest;
  promise(bool(rest.open(stripped.bytes(), {.verify_hash = false})), "a stripped asset opens");
}

}  // namespace

bool try_asset(Input input) {
  AlignedBytes file(std::as_bytes(input));
  Asset verified;
  const LoadStatus status = verified.open(file.bytes());
  check_description(status);
  Asset asset;
  const bool opens = bool(asset.open(file.bytes(), {.verify_hash = false}));
  promise(asset.is_open() == opens && verified.is_open() == bool(status), "an asset is open where open() says so");
  promise(opens || !status, "hashes refuse, they never admit");
  if (!opens) return false;
  promise(std::isfinite(touch_asset(asset)), "all numbers are finite");
  check_description(asset.verify_draw_data());
  prepare_to_draw(asset);
  play_asset(asset);
  strip(asset, file.bytes());
  return true;
}

}  // namespace coif::fuzz
