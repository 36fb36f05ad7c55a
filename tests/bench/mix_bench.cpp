// A scene of many assets with few heads each: all in one HairWorld, a Hair for each asset, and what full crowds of each asset cost.
#include "bench/benches.h"

#include "bench/frame_times.h"
#include "bench/timed_crowd.h"
#include "models/small_asset.h"

#include <coif/hair_world.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace coif {
namespace {

constexpr std::uint32_t kMixedHeads = 40;
constexpr std::uint32_t kCrowdHeads = 48;  ///< Of a full crowd: no lane of it is idle.

/// An asset of the mix, opened.
struct MixedAsset {
  explicit MixedAsset(std::span<const std::byte> bytes) : file(bytes) { is_open = bool(asset.open(file.bytes())); }
  AlignedBytes file;
  Asset asset;
  bool is_open = false;
};
using Mix = std::vector<std::unique_ptr<MixedAsset>>;

AlignedBytes memory_for(const MemoryNeed& need) { return AlignedBytes(std::vector<std::byte>(need.bytes)); }

double simulated_bones(const Asset& asset) {
  double bones = 0;
  for (const ChainRecord& chain : asset.chains()) bones += chain.bone_count;
  return bones;
}

/// A Hair and its heads, which have numbers from `first` on, `apart` from each other.
class MixedCrowd {
 public:
  MixedCrowd(const Asset& asset, std::uint32_t heads, std::uint32_t first, std::uint32_t apart)
      : heads_(heads),
        first_(first),
        apart_(apart),
        memory_(memory_for(Hair::memory_need(asset, {.instances = heads}))) {
    is_sane_ = hair_.create(asset, {.instances = heads}, memory_.bytes()) == Status::kOk;
    for (std::uint32_t i = 0; i < heads; ++i) is_sane_ = hair_.reset(i, pose_of(i, 0)) == Status::kOk && is_sane_;
  }

  void frame(double seconds, const StepSettings& settings) {
    for (std::uint32_t i = 0; i < heads_; ++i)
      is_sane_ = hair_.set_head(i, pose_of(i, seconds)) == Status::kOk && is_sane_;
    is_sane_ = hair_.step(settings) == Status::kOk && is_sane_;
  }
  [[nodiscard]] bool is_sane() const { return is_sane_; }

 private:
  [[nodiscard]] HeadPose pose_of(std::uint32_t i, double seconds) const {
    return head_pose_at(first_ + i * apart_, seconds);
  }

  std::uint32_t heads_, first_, apart_;
  AlignedBytes memory_;
  Hair hair_;
  bool is_sane_ = false;
};

/// All heads of the mix, asset after asset in turn.
class MixedWorld {
 public:
  MixedWorld(const Mix& mix, std::uint32_t heads)
      : desc_(desc_of(mix, heads)), memory_(memory_for(HairWorld::memory_need(desc_))) {
    is_sane_ = world_.create(desc_, memory_.bytes()) == Status::kOk;
    std::vector<WorldAsset> assets(mix.size());
    for (std::size_t a = 0; a < mix.size(); ++a)
      is_sane_ = world_.add_asset(mix[a]->asset, assets[a]) == Status::kOk && is_sane_;
    heads_.resize(heads);
    for (std::uint32_t i = 0; i < heads; ++i) {
      is_sane_ = world_.add_head(assets[i % assets.size()], head_pose_at(i, 0), heads_[i]) == Status::kOk && is_sane_;
    }
  }

  void frame(double seconds, const StepSettings& settings) {
    for (std::uint32_t i = 0; i < heads_.size(); ++i) {
      is_sane_ = world_.set_head(heads_[i], head_pose_at(i, seconds)) == Status::kOk && is_sane_;
    }
    is_sane_ = world_.step(settings) == Status::kOk && is_sane_;
  }
  /// One head leaves and comes back.
  void replace(std::uint32_t i, WorldAsset asset, const HeadPose& pose) {
    is_sane_ = world_.remove_head(heads_[i]) == Status::kOk && is_sane_;
    is_sane_ = world_.add_head(asset, pose, heads_[i]) == Status::kOk && is_sane_;
  }
  [[nodiscard]] bool is_sane() const { return is_sane_; }

 private:
  static WorldDesc desc_of(const Mix& mix, std::uint32_t heads) {
    WorldDesc desc{.assets = std::uint32_t(mix.size()), .heads = heads, .hair_bytes = 0};
    const auto each = std::uint32_t(heads / mix.size() + 1);
    for (const auto& one : mix) desc.hair_bytes += HairWorld::bytes_for(one->asset, each);
    return desc;
  }

  WorldDesc desc_;
  AlignedBytes memory_;
  HairWorld world_;
  std::vector<WorldHead> heads_;
  bool is_sane_ = false;
};

/// Median seconds of one frame of each of several things, timed in turns.
class Turns {
 public:
  explicit Turns(std::size_t count) : times_(count) {}
  template <typename Work>
  double time(std::size_t index, const Work& work) {
    watch_.start();
    work();
    const double seconds = watch_.seconds();
    times_[index].add(seconds);
    return seconds;
  }
  double median_seconds(std::size_t index) { return times_[index].median_seconds(); }

 private:
  Stopwatch watch_;
  std::vector<FrameTimes> times_;
};

void time_mix(benchmark::State& state, const Mix& mix, std::uint32_t heads, std::uint32_t substeps) {
  const auto assets = std::uint32_t(mix.size());
  MixedWorld world(mix, heads);
  std::vector<std::unique_ptr<MixedCrowd>> alone, full;
  double bones = 0;
  for (std::uint32_t a = 0; a < assets && a < heads; ++a) {
    const std::uint32_t own = (heads - a + assets - 1) / assets;
    alone.push_back(std::make_unique<MixedCrowd>(mix[a]->asset, own, a, assets));
    full.push_back(std::make_unique<MixedCrowd>(mix[a]->asset, kCrowdHeads, a, assets));
    bones += own * simulated_bones(mix[a]->asset);
  }
  StepSettings settings{.dt = float(kFrameSeconds), .substeps = substeps};
  Turns turns(2 + full.size());
  int frame = 0;
  const auto run = [&](Turns& on) {
    const double seconds = ++frame * kFrameSeconds;
    const double own = on.time(0, [&] { world.frame(seconds, settings); });
    on.time(1, [&] {
      for (const auto& crowd : alone) crowd->frame(seconds, settings);
    });
    for (std::size_t a = 0; a < full.size(); ++a) on.time(2 + a, [&] { full[a]->frame(seconds, settings); });
    return own;
  };
  for (Turns warm_up(2 + full.size()); frame < 60;) run(warm_up);
  for (auto unused : state) {
    (void)unused;
    state.SetIterationTime(run(turns));
  }
  bool is_sane = world.is_sane();
  double crowds = 0;
  for (std::uint32_t a = 0; a < full.size(); ++a) {
    is_sane = is_sane && alone[a]->is_sane() && full[a]->is_sane();
    const std::uint32_t own = (heads - a + assets - 1) / assets;
    crowds += turns.median_seconds(2 + a) * own / kCrowdHeads;
  }
  if (!is_sane) return state.SkipWithError("the runtime refuses something");
  const double own = turns.median_seconds(0), hairs = turns.median_seconds(1);
  state.counters["heads"] = heads;
  state.counters["assets"] = assets;
  state.counters["bones"] = bones;
  state.counters["ns_per_bone"] = own * 1e9 / bones;
  state.counters["hairs_ns_per_bone"] = hairs * 1e9 / bones;
  state.counters["crowds_ns_per_bone"] = crowds * 1e9 / bones;
  state.counters["ratio"] = own / crowds;
  state.counters["hairs_ratio"] = hairs / crowds;
}

void add_mix(const std::string& name, const std::shared_ptr<Mix>& mix, std::uint32_t heads, std::uint32_t substeps) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { time_mix(state, *mix, heads, substeps); })
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond);
}

std::shared_ptr<Mix> made_up_mix() {
  auto mix = std::make_shared<Mix>();
  // Short hair, bobs, ponytails, braids, long hair: chains and bones of each.
  constexpr CrowdShape kShapes[] = {{1, 3, 3}, {1, 1, 6}, {1, 2, 4},  {1, 12, 2}, {1, 6, 3}, {1, 8, 4},
                                    {1, 2, 5}, {1, 5, 5}, {1, 20, 1}, {1, 4, 3},  {1, 10, 5}};
  for (const CrowdShape& shape : kShapes)
    mix->push_back(std::make_unique<MixedAsset>(write_asset(crowd_contents(shape))));
  return mix;
}

std::shared_ptr<Mix> mix_of_folder(const std::string& folder) {
  auto mix = std::make_shared<Mix>();
  std::vector<std::filesystem::path> paths;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".coif") paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    auto one = std::make_unique<MixedAsset>(std::as_bytes(std::span(bytes)));
    if (one->is_open) mix->push_back(std::move(one));
  }
  return mix;
}

}  // namespace

void add_mix_benchmarks(const std::string& folder) {
  add_mix("mix_40", made_up_mix(), kMixedHeads, 0);
  for (const CrowdShape& shape :
       {CrowdShape{1, kOneHead.chains, kOneHead.bones}, CrowdShape{1, kCrowd.chains, kCrowd.bones}}) {
    auto mix = std::make_shared<Mix>();
    mix->push_back(std::make_unique<MixedAsset>(write_asset(crowd_contents(shape))));
    add_mix(shape.chains == kOneHead.chains ? "mix_one_head_b" : "mix_one_head_a", mix, 1, 0);
  }
  const auto cooked = mix_of_folder(folder);
  if (cooked->empty()) return;
  add_mix("mix_40_cooked", cooked, kMixedHeads, 0);
  add_mix("mix_40_cooked_one_step", cooked, kMixedHeads, 1);
}

}  // namespace coif
