#include "fuzz/targets.h"

#include "models/small_asset.h"
#include "write/strip_asset.h"

#include <coif/drawing.h>
#include <coif/hair.h>
#include <coif/lod.h>
#include <coif/skinning.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <vector>

namespace coif::fuzz {
namespace {

constexpr std::uint32_t kHeads = 2;
constexpr int kFrames = 5;
constexpr std::size_t kMostBytesPerBone = 32 << 10;  // sixteen lanes of some hundred numbers, several times

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool is_finite(const Mat34& matrix) {
  for (const auto& row : matrix.m) {
    for (const float value : row) {
      if (!std::isfinite(value)) return false;
    }
  }
  return true;
}

HeadPose pose_at(int frame, std::uint32_t head) {
  const double angle = 0.4 * frame + head;
  HeadPose pose;
  pose.position[0] = 0.1 * frame * frame;
  pose.position[1] = 1.6;
  pose.rotation = {0, float(std::sin(angle / 2)), 0, float(std::cos(angle / 2))};
  return pose;
}

void move_heads(Hair& hair, const Asset& asset, int frame) {
  for (std::uint32_t head = 0; head < kHeads; ++head) {
    const std::uint32_t level = choose_lod(asset.stored_lods(), frame % 2 == 0 ? 1.0f : 0.01f, 0);
    promise(level < std::max<std::size_t>(1, asset.stored_lods().size()), "a level that is chosen exists");
    const Detail detail{.level = level, .interval = frame < 3 ? 1u : 4u, .simulated = frame != 2};
    promise(hair.set_detail(head, detail) == Status::kOk, "a level that was chosen can be set");
    const HeadPose pose = pose_at(frame, head);
    const Status moved = frame == 1 ? hair.teleport(head, pose) : hair.set_head(head, pose);
    promise(moved == Status::kOk, "a head can be moved");
  }
}

void check_bones(const Hair& hair, std::uint32_t head) {
  for (const Mat34& matrix : hair.palette(head)) promise(is_finite(matrix), "matrices are finite");
  std::vector<Vec3> ends(hair.bone_count());
  promise(hair.bone_ends(head, ends) == Status::kOk, "bones have ends");
  for (const Vec3& end : ends) promise(is_finite(end), "bones' ends are finite");
}

void skin(const Asset& asset, std::span<const Mat34> palette) {
  if (asset.vertices().empty()) return;
  std::vector<SkinnedVertex> vertices(asset.vertices().size());
  promise(skin_vertices(asset, palette, 0, vertices) == Status::kOk, "an asset with vertices can be skinned");
  for (const SkinnedVertex& vertex : vertices) promise(is_finite(vertex.position), "skinned vertices are finite");
}

void play_with(const Asset& asset, const Solver& solver) {
  const HairDesc desc{.instances = kHeads, .solver = &solver, .longest_interval = 4};
  const MemoryNeed need = Hair::memory_need(asset, desc);
  promise(need.bytes > 0, "an open asset can be simulated");
  promise(need.bytes <= kMostBytesPerBone * (asset.bones().size() + 1), "memory grows with bones alone");
  AlignedBytes memory(std::vector<std::byte>(need.bytes));
  Hair hair;
  promise(hair.create(asset, desc, memory.bytes()) == Status::kOk, "the memory asked for suffices");
  for (int frame = 0; frame < kFrames; ++frame) {
    move_heads(hair, asset, frame);
    const float dt = frame % 2 == 0 ? 1.0f / 60 : kMaxTimeStep;
    promise(hair.step({.dt = dt, .iterations = 2}) == Status::kOk, "a frame can be stepped");
    for (std::uint32_t head = 0; head < kHeads; ++head) check_bones(hair, head);
  }
  skin(asset, hair.palette(0));
}

/// Some frames of a game: a few heads that move, turn, jump and change their level of detail, stepped by all solvers
/// and skinned. Numbers are finite, and the memory asked for suits the asset.
void play_asset(const Asset& asset) {
  const std::uint32_t substeps = tuned_substeps(asset, kMaxTimeStep);
  promise(substeps >= 1 && substeps <= kMaxSubsteps, "the tuned sub-steps can be asked for");
  play_with(asset, kCoifSolver);
  play_with(asset, kPassiveSolver);
  play_with(asset, kThesisSolver);
}

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
