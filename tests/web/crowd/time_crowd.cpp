// What a frame of a crowd costs natively, for crowd_test.mjs, which times the same in a browser:
//   coif_time_crowd ASSET HEADS FRAMES
// prints a line for each instruction set: its name, and the microseconds of a frame, least over blocks of FRAMES. A
// frame is what a host does: it writes each head's pose, hands them over, and steps.
#include "base/asset_refusal.h"
#include "base/files.h"
#include "base/hair_runtime.h"
#include "motion/head_path.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using namespace coif;

constexpr int kBlocks = 7;
constexpr double kRate = 60;

/// The first block also makes everything warm.
double least_microseconds(Hair& hair, std::uint32_t heads, int frames) {
  std::vector<HeadPose> poses(heads);
  double least = 1e30;
  int done = 0;
  for (int block = 0; block < kBlocks; ++block) {
    const auto begin = std::chrono::steady_clock::now();
    for (int frame = 0; frame < frames; ++frame) {
      HeadPose pose = motion::head_pose(motion::Motion::kTurn, ++done / kRate);
      for (std::uint32_t i = 0; i < heads; ++i) {
        poses[i] = pose;
        poses[i].position[0] += i % 15;
        poses[i].position[2] += i / 15;
      }
      if (hair.set_heads(poses) != Status::kOk || hair.step({.dt = float(1 / kRate)}) != Status::kOk) std::exit(1);
    }
    const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - begin;
    least = std::min(least, spent.count() / frames);
  }
  return least;
}

/// The file's bytes where the reader wants them; null, with a line on the standard error, where it does not take them.
HairMemory open_asset(const char* path, Asset& asset) {
  const auto file = FileBytes::read(path);
  if (!file) {
    std::fprintf(stderr, "coif_time_crowd: %s\n", file.error().message.c_str());
    return {nullptr, &std::free};
  }
  HairMemory memory = allocate({file->span().size(), 64});
  std::ranges::copy(file->span(), memory.get());
  if (open_whole({memory.get(), file->span().size()}, asset)) return memory;
  std::fprintf(stderr, "coif_time_crowd: %s is no cooked asset\n", path);
  return {nullptr, &std::free};
}

int time_with(const Asset& asset, std::uint32_t heads, int frames, InstructionSet set) {
  HairDesc desc;
  desc.instances = heads;
  desc.instruction_set = set;
  const MemoryNeed need = Hair::memory_need(asset, desc);
  const HairMemory memory = allocate(need);
  Hair hair;
  if (!memory || hair.create(asset, desc, {memory.get(), need.bytes}) != Status::kOk) return 1;
  std::printf("%s %.3f\n", name_of(set), least_microseconds(hair, heads, frames));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: coif_time_crowd ASSET HEADS FRAMES\n");
    return 2;
  }
  Asset asset;
  const HairMemory bytes = open_asset(argv[1], asset);
  if (!bytes) return 1;
  int failed = 0;
  for (const InstructionSet set : {InstructionSet::kSse4, InstructionSet::kAvx2, InstructionSet::kAvx512}) {
    if (can_run(set)) failed += time_with(asset, std::uint32_t(std::atoi(argv[2])), std::atoi(argv[3]), set);
  }
  return failed;
}
