#include "cook/chain_groups.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace coif {
namespace {

constexpr double kGravity = 9.81;  // m/s^2: a hanging bone is stiffened as a pendulum

double softness(const AssetContents& contents, std::uint32_t chain) {
  const ChainRecord& record = contents.chains[chain];
  double sum = 0;
  for (std::uint32_t b = record.first_bone; b < record.first_bone + record.bone_count; ++b) {
    sum += 1 / std::sqrt(contents.dynamics[b].stiffness + kGravity / contents.bones[b].length);
  }
  return sum;
}

double total_length(const AssetContents& contents, std::uint32_t chain) {
  const ChainRecord& record = contents.chains[chain];
  double sum = 0;
  for (std::uint32_t b = record.first_bone; b < record.first_bone + record.bone_count; ++b) {
    sum += contents.bones[b].length;
  }
  return sum;
}

}  // namespace

std::vector<ChainGroup> group_chains(const AssetContents& contents) {
  std::map<std::uint32_t, ChainGroup> by_bones;
  for (std::uint32_t c = 0; c < contents.chains.size(); ++c)
    by_bones[contents.chains[c].bone_count].chains.push_back(c);
  std::vector<ChainGroup> groups;
  for (auto& [bones, group] : by_bones) {
    const auto by = [&](auto measure) {
      return *std::ranges::max_element(group.chains, {}, [&](std::uint32_t c) { return measure(contents, c); });
    };
    group.telling = {by(softness), by(total_length)};
    if (group.telling[0] == group.telling[1]) group.telling.pop_back();
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace coif
