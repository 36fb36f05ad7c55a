#pragma once
// Strands side by side that hang together.

#include "models/playback.h"
#include "models/test_rig.h"

#include <coif/links.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace coif::links_test {

constexpr ChainModel kModels[] = {ChainModel::kCascade, ChainModel::kPassive};

struct Sheet {
  ChainModel model = ChainModel::kCascade;
  int strands = 5;
  int bones = 4;
  float gap = 0.03f;
  float stiffness = 60, damping = 4;
  bool twists = false;
};

/// Strands behind the head, each linked to the next towards the middle one.
inline TestRig sheet_rig(const Sheet& sheet = {}) {
  TestRig rig;
  rig.model = sheet.model;
  for (int strand = 0; strand < sheet.strands; ++strand) {
    const float side = sheet.gap * (float(strand) - 0.5f * float(sheet.strands - 1));
    TestBone bone{.joint = {side, 0.05f, -0.12f}, .rest_direction = {side, -0.9f, -0.2f}, .length = 0.05f};
    const float per_size = 1 / std::hypot(side, 0.9f, 0.2f);
    bone.rest_direction = {side * per_size, -0.9f * per_size, -0.2f * per_size};
    bone.stiffness = sheet.stiffness;
    bone.damping = sheet.damping;
    // Each has its own air, so that they would part.
    bone.friction = 0.2f + 1.5f * float(strand % 3);
    bone.torsion = sheet.twists ? 20 : kShortestArc;
    rig.add_strand(sheet.bones, bone);
  }
  const int middle = sheet.strands / 2;
  const auto at = [&](int strand, int depth) { return std::uint32_t(1 + strand * sheet.bones + depth); };
  for (int depth = 0; depth < sheet.bones; ++depth) {
    for (int strand = middle; strand-- > 0;) rig.link(at(strand, depth), at(strand + 1, depth));
    for (int strand = middle + 1; strand < sheet.strands; ++strand) rig.link(at(strand, depth), at(strand - 1, depth));
  }
  return rig;
}

/// How far the worst link is beyond its lengths, share of the longest.
inline double worst_excess(const TestRig& rig, const std::vector<Vec3>& ends) {
  double worst = 0;
  for (const LinkRecord& link : rig.links) {
    const double gap = double(distance(ends[link.bone - 1], ends[link.to - 1]));
    const double excess = std::max(gap - double(link.longest), double(link.shortest) - gap) / double(link.longest);
    if (!(excess <= worst)) worst = excess;  // a NaN wins
  }
  return worst;
}

inline StepSettings at_rate(double fps) {
  StepSettings settings;
  settings.dt = float(1 / fps);
  return settings;
}

}  // namespace coif::links_test
