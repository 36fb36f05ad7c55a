// Hands files to one target without libFuzzer: the corpora in every ordinary test run, a finding under a debugger.

#include "fuzz/targets.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

namespace coif::fuzz {
namespace {

namespace fs = std::filesystem;

struct NamedTarget {
  std::string_view name;
  bool (*run)(Input);
};

constexpr NamedTarget kTargets[] = {{"asset", try_asset},
                                    {"cache_entry", try_cache_entry},
                                    {"can_fail", try_can_fail},
                                    {"clip", try_clip},
                                    {"manifest", try_manifest},
                                    {"recipe", try_recipe},
                                    {"model_stream", try_model_stream},
                                    {"vrm", try_vrm}};

std::vector<fs::path> files_of(const fs::path& path) {
  std::vector<fs::path> files;
  if (!fs::is_directory(path)) return {path};
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

std::vector<std::uint8_t> bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// 1 where the target accepted nothing: seeds of a format that has changed since show nothing of what comes after the refusal.
int replay(const NamedTarget& target, std::span<char* const> paths) {
  std::size_t inputs = 0, accepted = 0;
  for (const fs::path path : paths) {
    for (const fs::path& file : files_of(path)) {
      std::fprintf(stderr, "%s\n", file.c_str());  // the last one before a crash
      ++inputs;
      accepted += target.run(bytes_of(file)) ? 1 : 0;
    }
  }
  std::printf("%.*s: %zu inputs, %zu accepted\n", int(target.name.size()), target.name.data(), inputs, accepted);
  return accepted > 0 ? 0 : 1;
}

}  // namespace
}  // namespace coif::fuzz

int main(int argc, char** argv) {
  using namespace coif::fuzz;
  const std::string_view name = argc > 1 ? argv[1] : "";
  for (const NamedTarget& target : kTargets) {
    if (target.name == name) return replay(target, {argv + 2, argv + argc});
  }
  std::fprintf(stderr, "usage: fuzz_replay TARGET FILE_OR_FOLDER...\ntargets:");
  for (const NamedTarget& target : kTargets) std::fprintf(stderr, " %s", target.name.data());
  std::fprintf(stderr, "\n");
  return 2;
}
