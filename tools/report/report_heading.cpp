#include "report/report_heading.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace coif {
namespace {

/// Way from the rigid bone to each bone's tail, metres; 0 for rigid bones.
std::vector<double> ways_to_tails(const Asset& asset) {
  const auto bones = asset.bones();
  std::vector<double> ways(bones.size(), 0.0);
  for (std::size_t i = 0; i < bones.size(); ++i) {
    if (bones[i].kind == BoneKind::kSimulated) ways[i] = ways[bones[i].parent] + double(bones[i].length);
  }
  return ways;
}

std::vector<double> sorted_chain_lengths(const Asset& asset) {
  const std::vector<double> ways = ways_to_tails(asset);
  std::vector<double> lengths;
  for (const ChainRecord& chain : asset.chains()) {
    if (chain.bone_count == 0) continue;
    const auto first = ways.begin() + chain.first_bone;
    lengths.push_back(*std::max_element(first, first + chain.bone_count));
  }
  std::ranges::sort(lengths);
  return lengths;
}

}  // namespace

ReportHeading heading_of(const Asset& asset, std::string name) {
  ReportHeading heading;
  heading.asset = std::move(name);
  heading.bones = asset.skeleton().bone_count;
  heading.simulated_bones = asset.skeleton().simulated_count;
  heading.chains = asset.skeleton().chain_count;
  heading.machine = describe_machine();
  const std::vector<double> lengths = sorted_chain_lengths(asset);
  if (lengths.empty()) return heading;
  heading.shortest_chain = lengths.front();
  heading.median_chain = lengths[lengths.size() / 2];
  heading.longest_chain = lengths.back();
  return heading;
}

std::string describe_machine() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const std::size_t value = line.find(": ");
    if (!line.starts_with("model name") || value == std::string::npos) continue;
    const unsigned cores = std::thread::hardware_concurrency();
    return line.substr(value + 2) + ", " + std::to_string(cores) + (cores == 1 ? " core" : " cores");
  }
  return "";
}

}  // namespace coif
