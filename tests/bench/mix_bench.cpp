// A scene of many assets with few heads each: all in one HairWorld, a Hair for each asset, and what full crowds of each
// asset cost.
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
constexpr std::uint32_t kCrowdHeads = 16;  ///< A full crowd: none of its lanes is idle.

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

/// Crowds, each a Hair of its own.
class MixedHairs {
 public:
  /// Its heads have numbers from `first` on, `apart` from each other.
  void add(const Asset& asset, std::uint32_t heads, std::uint32_t first, std::uint32_t apart) {
    const HairDesc desc{.instances = heads};
    auto crowd = std::make_unique<Crowd>(Hair::memory_need(asset, desc));
    is_sane_ = crowd->hair.create(asset, desc, crowd->memory.bytes()) == Status::kOk && is_sane_;
    for (std::uint32_t i = 0; i < heads; ++i) {
      crowd->numbers.push_back(first + i * apart);
      is_sane_ = crowd->hair.reset(i, head_pose_at(first + i * apart, 0)) == Status::kOk && is_sane_;
    }
    crowd->poses.resize(heads);
    crowds_.push_back(std::move(crowd));
  }

  void plan(double seconds) {
    for (const auto& crowd : crowds_) {
      for (std::size_t i = 0; i < crowd->poses.size(); ++i) crowd->poses[i] = head_pose_at(crowd->numbers[i], seconds);
    }
  }
  void frame(const StepSettings& settings) {
    for (const auto& crowd : crowds_) {
      is_sane_ = crowd->hair.set_heads(crowd->poses) == Status::kOk && is_sane_;
      is_sane_ = crowd->hair.step(settings) == Status::kOk && is_sane_;
    }
  }
  [[nodiscard]] bool is_sane() const { return is_sane_; }

 private:
  struct Crowd {
    explicit Crowd(const MemoryNeed& need) : memory(std::vector<std::byte>(need.bytes)) {}
    AlignedBytes memory;
    Hair hair;
    std::vector<std::uint32_t> numbers;
    std::vector<HeadPose> poses;
  };
  std::vector<std::unique_ptr<Crowd>> crowds_;
  bool is_sane_ = true;
};

/// All heads of the mix, asset after asset in turn.
class MixedWorld {
 public:
  MixedWorld(const Mix& mix, std::uint32_t heads)
      : desc_(desc_of(mix, heads)), memory_(memory_for(HairWorld::memory_need(desc_))) {
    is_sane_ = world_.create(desc_, memory_.bytes()) == Status::kOk;
    assets_.resize(mix.size());
    for (std::size_t a = 0; a < mix.size(); ++a)
      is_sane_ = world_.add_asset(mix[a]->asset, assets_[a]) == Status::kOk && is_sane_;
    heads_.resize(heads);
    poses_.resize(heads);
    for (std::uint32_t i = 0; i < heads; ++i) {
      is_sane_ = world_.add_head(assets_[i % assets_.size()], head_pose_at(i, 0), heads_[i]) == Status::kOk && is_sane_;
    }
  }

  void plan(double seconds) {
    for (std::uint32_t i = 0; i < poses_.size(); ++i) poses_[i] = head_pose_at(i, seconds);
  }
  void frame(const StepSettings& settings) {
    for (std::size_t i = 0; i < heads_.size(); ++i)
      is_sane_ = world_.set_head(heads_[i], poses_[i]) == Status::kOk && is_sane_;
    is_sane_ = world_.step(settings) == Status::kOk && is_sane_;
  }
  /// Seconds in which a head leaves and another of its asset comes.
  double replace(std::uint32_t i, Stopwatch& watch) {
    watch.start();
    is_sane_ = world_.remove_head(heads_[i]) == Status::kOk && is_sane_;
    is_sane_ = world_.add_head(assets_[i % assets_.size()], poses_[i], heads_[i]) == Status::kOk && is_sane_;
    return watch.seconds();
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
  std::vector<WorldAsset> assets_;
  std::vector<WorldHead> heads_;
  std::vector<HeadPose> poses_;
  bool is_sane_ = false;
};

constexpr int kFramesInTurn = 4;

/// One of the things that are timed in turns: some frames each, after one in which its numbers come back into the near
/// caches.
template <typename Scene>
class TimedScene {
 public:
  explicit TimedScene(Scene& scene) : scene_(scene) {}

  /// Returns the seconds of the timed frames.
  double take_turn(double& seconds, const StepSettings& settings) {
    double sum = 0;
    for (int i = 0; i <= kFramesInTurn; ++i) {
      scene_.plan(seconds += kFrameSeconds);
      watch_.start();
      scene_.frame(settings);
      const double own = watch_.seconds();
      if (i == 0) continue;
      times_.add(own);
      sum += own;
    }
    return sum;
  }
  double median_seconds() { return times_.median_seconds(); }

 private:
  Scene& scene_;
  Stopwatch watch_;
  FrameTimes times_;
};

/// Median times of a mix, seconds.
struct MixTimes {
  double world = 0;    ///< A frame in one HairWorld.
  double hairs = 0;    ///< A frame with a Hair for each asset.
  double crowds = 0;   ///< A frame if each head lived in a full crowd of its asset.
  double replace = 0;  ///< A head leaves and another comes.
};

void report(benchmark::State& state, const MixTimes& times, double bones) {
  state.counters["bones"] = bones;
  state.counters["ns_per_bone"] = times.world * 1e9 / bones;
  state.counters["hairs_ns_per_bone"] = times.hairs * 1e9 / bones;
  state.counters["crowds_ns_per_bone"] = times.crowds * 1e9 / bones;
  state.counters["ratio"] = times.world / times.crowds;
  state.counters["hairs_ratio"] = times.hairs / times.crowds;
  state.counters["replace_us"] = times.replace * 1e6;
}

void time_mix(benchmark::State& state, const Mix& mix, std::uint32_t heads, std::uint32_t substeps) {
  const auto assets = std::uint32_t(std::min<std::size_t>(mix.size(), heads));
  const auto heads_of = [&](std::uint32_t a) { return (heads - a + assets - 1) / assets; };
  MixedWorld world(mix, heads);
  MixedHairs hairs;
  std::vector<MixedHairs> crowds(assets);
  double bones = 0;
  for (std::uint32_t a = 0; a < assets; ++a) {
    hairs.add(mix[a]->asset, heads_of(a), a, assets);
    crowds[a].add(mix[a]->asset, kCrowdHeads, a, assets);
    bones += heads_of(a) * simulated_bones(mix[a]->asset);
  }
  TimedScene in_world(world);
  TimedScene in_hairs(hairs);
  std::vector<TimedScene<MixedHairs>> in_crowds;
  for (MixedHairs& crowd : crowds) in_crowds.emplace_back(crowd);
  const StepSettings settings{.dt = float(kFrameSeconds), .substeps = substeps};
  std::vector<double> clocks(2 + assets);
  for (auto unused : state) {
    (void)unused;
    state.SetIterationTime(in_world.take_turn(clocks[0], settings) / kFramesInTurn);
    in_hairs.take_turn(clocks[1], settings);
    for (std::uint32_t a = 0; a < assets; ++a) in_crowds[a].take_turn(clocks[2 + a], settings);
  }
  MixTimes times{.world = in_world.median_seconds(), .hairs = in_hairs.median_seconds()};
  Stopwatch watch;
  FrameTimes replacements;
  for (std::uint32_t i = 0; i < heads; ++i) replacements.add(world.replace(i, watch));
  times.replace = replacements.median_seconds();
  bool is_sane = world.is_sane() && hairs.is_sane();
  for (std::uint32_t a = 0; a < assets; ++a) {
    is_sane = is_sane && crowds[a].is_sane();
    times.crowds += in_crowds[a].median_seconds() * heads_of(a) / kCrowdHeads;
  }
  if (!is_sane) return state.SkipWithError("the runtime refuses something");
  state.counters["heads"] = heads;
  state.counters["assets"] = assets;
  report(state, times, bones);
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
