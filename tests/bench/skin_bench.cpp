#include "bench/skin_bench.h"

#include "formats/aligned_bytes.h"
#include "skinning/skinned_asset.h"

#include <coif/skinning.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

namespace coif {
namespace {

constexpr std::uint32_t kBones = 64;
constexpr std::uint32_t kVertices = 6000;

/// Weight on `used` bones of each vertex; 0: hair without SKIN.
AssetContents hair_of(int used) {
  constexpr std::uint8_t kWeights[4][4] = {{255, 0, 0, 0}, {200, 55, 0, 0}, {150, 90, 15, 0}, {120, 80, 40, 15}};
  std::vector<SkinRecord> skin(kVertices);
  for (std::uint32_t i = 0; i < kVertices; ++i) {
    const std::uint32_t bone = i * kBones / kVertices;  // a patch has its bones one after the other
    for (std::uint32_t k = 0; k < 4; ++k) skin[i].bone[k] = std::uint16_t(std::min(bone + k, kBones - 1));
    std::copy_n(kWeights[std::max(used, 1) - 1], 4, skin[i].weight);
  }
  AssetContents contents = skinned_contents(kBones, skin);
  if (used == 0) contents.skin.clear();
  return contents;
}

void time_skinning(benchmark::State& state, const std::vector<std::byte>& file) {
  AlignedBytes bytes(file);
  Asset asset;
  if (!asset.open(bytes.bytes())) return state.SkipWithError("the reader refuses the workload");
  const auto palette = bent_palette(kBones);
  std::vector<SkinnedVertex> out(kVertices);
  bool skinned = true;
  for (auto unused : state) {
    (void)unused;
    skinned = skin_vertices(asset, palette, 0, out) == Status::kOk && skinned;
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  if (!skinned) return state.SkipWithError("skinning refuses the workload");
  // Seconds; printed as 30ns.
  state.counters["per_vertex"] =
      benchmark::Counter(kVertices, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

}  // namespace

void add_skin_benchmarks() {
  for (const auto& [name, used] : {std::pair{"skin_none", 0}, {"skin_one_bone", 1}, {"skin_four_bones", 4}}) {
    const auto file = write_asset(hair_of(used));
    benchmark::RegisterBenchmark(name, [file](benchmark::State& state) {
      time_skinning(state, file);
    })->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace coif
