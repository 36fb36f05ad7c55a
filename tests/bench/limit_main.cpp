// What tests/bench/limit.py asks of the machine and of the runtime, as JSON.
//   coif_limit peaks BYTES...                     the machine's peaks; traffic over so many bytes
//   coif_limit sets                               the instruction sets that there are, the best first
//   coif_limit frames a|b HEADS SOLVER SET FRAMES so many frames of workload a or b; HEADS 0: as many as it has
#include "bench/frame_times.h"
#include "bench/machine_peak.h"
#include "bench/timed_crowd.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string_view>

namespace coif {
namespace {

constexpr int kWarmUpFrames = 30;

int print_peaks(std::span<char*> sizes) {
  std::printf("{\"instructions\": %.3f, \"widths\": [", peak_instructions());
  const char* separator = "";
  for (const VectorWidth width : {VectorWidth::k4, VectorWidth::k8, VectorWidth::k16}) {
    if (!has_width(width)) continue;
    std::printf("%s{\"floats\": %d, \"arithmetic\": %.3f, \"divisions\": %.3f}", separator, int(width),
                peak_arithmetic(width), peak_divisions(width));
    separator = ", ";
  }
  std::printf("], \"traffic\": [");
  separator = "";
  for (const char* size : sizes) {
    const auto bytes = std::size_t(std::strtoull(size, nullptr, 10));
    std::printf("%s{\"bytes\": %zu, \"bytes_per_ns\": %.3f}", separator, bytes, peak_traffic(bytes));
    separator = ", ";
  }
  std::printf("]}\n");
  return 0;
}

/// Frames after a few that learn what the later ones remember. Only those are inside TimedCrowd::step() that are asked
/// for and those few: a counter that is run with two numbers of frames finds what one costs.
int run_frames(const CrowdRun& run, int frames) {
  TimedCrowd crowd(run);
  Stopwatch watch = stopwatch_for(run.shape.bone_count());
  FrameTimes times;
  for (int frame = -kWarmUpFrames; frame < frames; ++frame) {
    crowd.plan(kFrameSeconds);
    crowd.set_heads();
    watch.start();
    crowd.step(float(kFrameSeconds));
    if (frame >= 0) times.add(watch.seconds());
  }
  if (!crowd.is_sane()) return 1;
  std::printf("{\"bones\": %.0f, \"bytes_per_bone\": %.3f, \"ns_per_bone\": %.3f}\n", run.shape.bone_count(),
              crowd.bytes_per_head() / run.shape.bones_per_head(),
              times.median_seconds() * 1e9 / run.shape.bone_count());
  return 0;
}

/// Reads the words a|b HEADS SOLVER SET.
CrowdRun run_of(std::span<char*> words) {
  CrowdRun run{std::string_view(words[0]) == "a" ? kCrowd : kOneHead, words[2], words[3]};
  if (const int heads = std::atoi(words[1]); heads > 0) run.shape.heads = std::uint32_t(heads);
  return run;
}

int print_sets() {
  const char* separator = "[";
  for (const std::string& name : instruction_set_names()) {
    std::printf("%s\"%s\"", separator, name.c_str());
    separator = ", ";
  }
  std::printf("]\n");
  return 0;
}

}  // namespace
}  // namespace coif

int main(int argc, char** argv) {
  if (argc >= 2 && std::strcmp(argv[1], "peaks") == 0) {
    return coif::print_peaks({argv + 2, std::size_t(argc) - 2});
  }
  if (argc == 2 && std::strcmp(argv[1], "sets") == 0) return coif::print_sets();
  if (argc == 7 && std::strcmp(argv[1], "frames") == 0) {
    return coif::run_frames(coif::run_of({argv + 2, 4}), std::atoi(argv[6]));
  }
  std::fprintf(stderr, "usage: coif_limit peaks BYTES... | sets | frames a|b HEADS SOLVER SET FRAMES\n");
  return 1;
}
