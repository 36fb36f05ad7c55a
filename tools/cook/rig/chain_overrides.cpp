#include "cook/rig/skeleton.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace coif::cook {
namespace {

constexpr double kMostly = 0.5;  ///< Share of what a chain carries, or of a patch.

/// Area of each patch, by its number, that each chain carries, square metres.
using Carried = std::map<std::pair<std::uint32_t, std::uint32_t>, double>;  // chain, patch

Carried carried_hair(const HairStrips& hair, const HairRig& rig) {
  Carried carried;
  for (std::size_t t = 0; t < hair.mesh.triangle_count(); ++t) {
    const std::uint32_t patch = hair.patches.number_of(hair.patches.patch_of[t]);
    const double area = double(doubled_area(hair.mesh, 3 * t)) / 2;
    for (std::size_t k = 0; k < 3; ++k) {
      for (const BoneWeight& weight : rig.weights[hair.mesh.triangles[3 * t + k]]) {
        const std::uint32_t chain = rig.skeleton.bones[weight.bone].chain;
        if (chain != kNone) carried[{chain, patch}] += weight.weight * area / 3;
      }
    }
  }
  return carried;
}

}  // namespace

std::vector<PatchOverride> chain_overrides(const HairStrips& hair, const HairRig& rig, Findings& findings) {
  std::vector<PatchOverride> of_chain(rig.skeleton.chains.size());
  if (hair.overrides.of_patch.empty()) return of_chain;
  const Carried carried = carried_hair(hair, rig);
  std::vector<double> all(of_chain.size(), 0);
  for (const auto& [key, area] : carried) all[key.first] += area;
  for (std::uint32_t o = 0; o < hair.overrides.said.size(); ++o) {
    const PatchOverride& said = hair.overrides.said[o];
    if (!said.is_of_motion()) continue;
    std::vector<double> selected(of_chain.size(), 0);
    for (const auto& [key, area] : carried) {
      if (std::ranges::find(hair.overrides.of_patch[key.second], o) != hair.overrides.of_patch[key.second].end()) {
        selected[key.first] += area;
      }
    }
    std::vector<std::string> names;
    for (std::size_t c = 0; c < of_chain.size(); ++c) {
      if (!(selected[c] > kMostly * all[c])) continue;
      of_chain[c].add_motion(said);
      names.push_back(rig.skeleton.bones[rig.skeleton.chains[c].first_bone].name);
    }
    if (names.empty()) {
      findings.warn(
          "C122",
          fmt::format(
              "\"patches.overrides\" [{}] says how patches move, but they are not most of what any chain carries", o));
    } else {
      findings.note(
          fmt::format("\"patches.overrides\" [{}]: motion of {}", o, counted(names.size(), "chain", "chains")));
    }
  }
  return of_chain;
}

std::vector<std::uint32_t> chain_of_patches(const HairStrips& hair, const HairRig& rig, std::size_t count) {
  std::vector<std::uint32_t> chains(count, kNone);
  std::vector<double> most(count, 0), moved(count, 0), whole(count, 0);
  for (std::size_t t = 0; t < hair.mesh.triangle_count(); ++t) {
    whole[hair.patches.number_of(hair.patches.patch_of[t])] += double(doubled_area(hair.mesh, 3 * t)) / 2;
  }
  for (const auto& [key, area] : carried_hair(hair, rig)) {
    const auto& [chain, patch] = key;
    moved[patch] += area;
    if (!(area > most[patch])) continue;
    most[patch] = area;
    chains[patch] = chain;
  }
  for (std::size_t p = 0; p < count; ++p) {
    if (moved[p] < (1 - kMostly) * whole[p]) chains[p] = kNone;
  }
  return chains;
}

}  // namespace coif::cook
