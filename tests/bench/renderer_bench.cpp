// What renderers compute of each head on the processor, beside drawing it.

#include "bench/benches.h"

#include "models/skinned_asset.h"
#include "models/small_asset.h"

#include <coif/bone_transforms.h>
#include <coif/bounds.h>

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

namespace coif {
namespace {

constexpr std::uint32_t kRendererBones = 64;

/// Something hangs on each of the bones.
std::vector<std::byte> hair_on_bones() {
  std::vector<SkinRecord> skin(10 * kRendererBones);
  for (std::size_t i = 0; i < skin.size(); ++i) skin[i] = {{std::uint16_t(i / 10), 0, 0, 0}, {255, 0, 0, 0}};
  return write_asset(skinned_contents(kRendererBones, skin));
}

/// Times call(asset, palette), which tells whether it went well; `per_bone` is its share.
template <typename Call>
void time_per_bone(benchmark::State& state, const Call& call) {
  AlignedBytes bytes(hair_on_bones());
  Asset asset;
  if (!asset.open(bytes.bytes())) return state.SkipWithError("the reader refuses the workload");
  const std::vector<Mat34> palette = bent_palette(kRendererBones);
  bool is_good = true;
  for (auto unused : state) {
    (void)unused;
    is_good = call(asset, palette) && is_good;
    benchmark::ClobberMemory();
  }
  if (!is_good) return state.SkipWithError("the call refuses the workload");
  // Seconds; printed as 30ns.
  state.counters["per_bone"] =
      benchmark::Counter(kRendererBones, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace

void add_renderer_benchmarks() {
  benchmark::RegisterBenchmark("bound_hair", [](benchmark::State& state) {
    std::vector<BoneBox> boxes(kRendererBones);
    HairBounds bounds;
    bool has_boxes = false;
    time_per_bone(state, [&](const Asset& asset, std::span<const Mat34> palette) {
      has_boxes = has_boxes || find_bone_boxes(asset, boxes) == Status::kOk;
      const bool is_bound = bound_hair(boxes, palette, bounds) == Status::kOk;
      benchmark::DoNotOptimize(bounds);
      return has_boxes && is_bound;
    });
  });
  benchmark::RegisterBenchmark("bone_transforms", [](benchmark::State& state) {
    std::vector<BoneTransform> local(kRendererBones);
    time_per_bone(state, [&](const Asset& asset, std::span<const Mat34> palette) {
      return bone_transforms(asset, palette, local) == Status::kOk;
    });
  });
}

}  // namespace coif
