#include "bench/benches.h"

#include "bench/timed_crowd.h"
#include "models/skinned_asset.h"
#include "models/small_asset.h"

#include <coif/skinning.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace coif {
namespace {

/// Empty where there is no such file.
std::vector<std::byte> read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> chars{std::istreambuf_iterator<char>(file), {}};
  const auto bytes = std::as_bytes(std::span(chars));
  return {bytes.begin(), bytes.end()};
}

void time_open(benchmark::State& state, const std::vector<std::byte>& file, const OpenOptions& options) {
  AlignedBytes bytes(file);
  Asset asset;
  bool opened = true;
  for (auto unused : state) {
    (void)unused;
    opened = bool(asset.open(bytes.bytes(), options)) && opened;
    benchmark::DoNotOptimize(asset);
  }
  if (!opened) return state.SkipWithError("the reader refuses the sample");
  state.counters["file_bytes"] = double(file.size());
}

void time_verify(benchmark::State& state, const std::vector<std::byte>& file) {
  AlignedBytes bytes(file);
  Asset asset;
  bool verified = bool(asset.open(bytes.bytes()));
  for (auto unused : state) {
    (void)unused;
    verified = verified && bool(asset.verify_draw_data());
  }
  if (!verified) return state.SkipWithError("the sample's draw data is not what was cooked");
  state.counters["file_bytes"] = double(file.size());
}

void time_create(benchmark::State& state, const CrowdShape& shape) {
  AlignedBytes file(write_asset(crowd_contents(shape)));
  Asset asset;
  if (!asset.open(file.bytes())) return state.SkipWithError("the reader refuses the workload");
  AlignedBytes memory(std::vector<std::byte>(bytes_to_create(asset, shape.heads)));
  bool created = true;
  for (auto unused : state) {
    (void)unused;
    created = create_once(asset, shape.heads, memory.bytes()) && created;
  }
  if (!created) return state.SkipWithError("create() refuses the workload");
  state.counters["heads"] = shape.heads;
  state.counters["chains"] = shape.chains;
  state.counters["bones"] = shape.bones;
}

void add_open(const std::string& name, const std::vector<std::byte>& file, const OpenOptions& options) {
  benchmark::RegisterBenchmark(name.c_str(), [file, options](benchmark::State& state) {
    time_open(state, file, options);
  })->Unit(benchmark::kMicrosecond);
}

}  // namespace

void add_load_benchmarks(const std::string& folder) {
  for (const std::string sample : {"bob", "long"}) {
    const auto file = read_file(folder + "/" + sample + ".coif");
    if (file.empty()) continue;
    add_open("open_" + sample, file, {});
    add_open("open_" + sample + "_without_hash", file, {.verify_hash = false});
    benchmark::RegisterBenchmark(("verify_draw_data_" + sample).c_str(), [file](benchmark::State& state) {
      time_verify(state, file);
    })->Unit(benchmark::kMicrosecond);
  }
  for (const CrowdShape& shape : {kCrowd, kOneHead}) {
    const char* name = shape.heads == kCrowd.heads ? "create_a" : "create_b";
    benchmark::RegisterBenchmark(name, [shape](benchmark::State& state) {
      time_create(state, shape);
    })->Unit(benchmark::kMicrosecond);
  }
}

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
