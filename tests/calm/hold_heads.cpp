// coif_hold_heads [--drawn] FILE.coif...: whether hair of heads that are held comes to rest, in 26 attitudes, one line
// for each way to run each asset. --drawn: two ways an asset, another two for each name. Exit code 1 where some hair is
// restless.

#include "base/files.h"
#include "lab/rig.h"
#include "report/stability/held_heads.h"

#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace coif;

/// Two of the ways, which the name chooses.
std::vector<report::HeldHeads> drawn(const std::vector<report::HeldHeads>& all, const std::string& name) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char letter : name) hash = (hash ^ std::uint8_t(letter)) * 1099511628211u;
  return {all[hash % all.size()], all[hash / all.size() % all.size()]};
}

/// How many ways were restless; -1 for a file that is no asset with hair that moves.
int hold(const std::string& path, bool is_drawn) {
  const auto bytes = FileBytes::read(path);
  if (!bytes) {
    std::fprintf(stderr, "%s\n", bytes.error().message.c_str());
    return -1;
  }
  const lab::OpenedAsset file(bytes->span());
  if (!file.asset().is_open()) {
    std::fprintf(stderr, "%s: no asset\n", path.c_str());
    return -1;
  }
  const std::string name = path.substr(path.find_last_of('/') + 1);
  if (file.asset().skeleton().simulated_count == 0) {
    std::printf("%s: nothing moves\n", name.c_str());
    return 0;
  }
  const auto all = report::ways_to_hold(file.asset(), std::numeric_limits<std::uint64_t>::max());
  int restless = 0;
  for (const report::HeldHeads& way : is_drawn ? drawn(all, name) : all) {
    const report::HeldHeadsFinding found = report::hold_heads(file.asset(), way);
    restless += found.is_restless();
    std::printf("%-20s %-36s %s settled after %5.2f s, then at most %.4f m/s (up to %d, %d, %d); fastest %.1f m/s\n",
                name.c_str(), report::name_of(way).c_str(), found.is_restless() ? "RESTLESS" : "at rest ",
                found.settled_after, found.rest_speed, found.up[0], found.up[1], found.up[2], found.max_speed);
    std::fflush(stdout);
  }
  return restless;
}

}  // namespace

int main(int count, char** words) {
  bool is_drawn = false, is_good = true;
  int files = 0;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--drawn") {
      is_drawn = true;
    } else {
      ++files;
      is_good = hold(word, is_drawn) == 0 && is_good;
    }
  }
  if (files == 0) std::fprintf(stderr, "usage: coif_hold_heads [--drawn] FILE.coif...\n");
  return is_good && files > 0 ? 0 : 1;
}
