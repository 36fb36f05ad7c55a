#pragma once

#include "bench/timed_crowd.h"

#include <cstdint>
#include <string>

namespace coif {

/// Which lengths the frames of a benchmark have.
enum class BenchFrames {
  kSteady,   ///< All 1/60 s.
  kVarying,  ///< None as long as the one before, as on a screen without vertical sync: what depends on the step's
             ///< length alone is computed anew in every frame.
};

/// Adds the benchmark `name` to those of this program. Reported are medians over frames: `ns_per_bone` of set_head()
/// for all heads and step(), `step_ns_per_bone` and `set_head_ns` (per head) of each alone, `us_per_frame`,
/// `bytes_per_head`.
void add_crowd_benchmark(const std::string& name, const CrowdRun& run, BenchFrames lengths = BenchFrames::kSteady);

/// Adds what happens once for each asset: Asset::open() of the cooked samples in `folder`, with and without the
/// hashes, Asset::verify_draw_data(), and Hair::create(). Samples that are not there are left out.
void add_load_benchmarks(const std::string& folder);

/// Adds `mix_40`, forty heads of eleven made-up assets in one HairWorld, and `mix_40_cooked`, the same of the .coif
/// files in `folder`, where there are some: `ns_per_bone` of a frame, calls included; `hairs_ns_per_bone` with a Hair
/// for each asset; `crowds_ns_per_bone` where each head lived in a full crowd of its asset; all timed in turns. `ratio`
/// and `hairs_ratio` are of the first two to the last. And one head alone.
void add_mix_benchmarks(const std::string& folder);

/// Adds skin_vertices() over the vertices of a head of hair, by how many bones move each of them.
void add_skin_benchmarks();

/// Adds bound_hair() and bone_transforms() of a head with 64 bones.
void add_renderer_benchmarks();

/// Adds `asleep_HEADS`: a frame of workload (a) with so many heads, all asleep, that are told again where they stand.
/// `ratio` is its step over that of the same crowd with moving heads, each frame timed right after one of those:
/// whatever sleeping hair needs has left the near caches, as it would in a game.
void add_sleep_benchmark(std::uint32_t heads);

}  // namespace coif
