// Hands files to one target without libFuzzer: the corpora in every ordinary test run, a finding under a debugger.

#include "fuzz/targets.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace coif::fuzz {
namespace {

namespace fs = std::filesystem;

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

/// 1 where the target accepted nothing: seeds of a format that has changed since show nothing of what comes after the
/// refusal.
int replay(const Target& target, std::span<char* const> paths) {
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
  const Target* const target = find_target(argc > 1 ? argv[1] : "", "usage: fuzz_replay TARGET FILE_OR_FOLDER...");
  return target ? replay(*target, {argv + 2, argv + argc}) : 2;
}
