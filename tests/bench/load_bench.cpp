#include "bench/load_bench.h"

#include "bench/timed_crowd.h"

#include <benchmark/benchmark.h>

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

}  // namespace coif
