#include "cook/strands/strand_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace coif::cook {
namespace {

constexpr float kClearEnds = 3.0f;  ///< More evidence at the ends adds nothing for the axis.
/// Share of the head's radius: triangles, which may be large, are images of each other if their middles are this near.
constexpr double kMirroredTriangle = 0.2;

/// Along what the strands may run: the axes of the texture, or, where it says nothing, a walk over the surface; on a
/// shell also down from its top.
std::vector<StrandAxis> possible_axes(const HairStrips& hair, const PatchView& view, bool is_textured, bool is_shell) {
  std::vector<StrandAxis> axes;
  if (is_textured) {
    for (const int candidate : {0, 1}) axes.push_back(strand_axis(hair, view, candidate));
  } else {
    axes.push_back(strand_axis(hair, view, -1));
  }
  if (is_shell) axes.push_back(falling_axis(hair, view));
  return axes;
}

/// One of possible_axes(), and what speaks for it.
struct Candidate {
  StrandAxis axis;
  RootEvidence evidence;
  float mirrored = 0;  ///< PatchStrands::mirrored
  float score = 0;
};

/// The score is high for the axis the patch is longer along, along which the images have lines, whose ends differ more
/// as roots and tips do, which the other patches have, and which is the same on both sides of the head; no texture axis
/// where texture coordinates say nothing.
std::vector<Candidate> candidates_of(const HairStrips& hair, const Seeking& patch, const Surroundings& around,
                                     int common) {
  const RootWeights& weights = around.weights;
  const PatchStrands& known = patch.strands;
  const bool shell = is_shell(hair.mesh, patch.view, around.head);
  const auto reach = float(kMirroredTriangle * around.head.radii.mean());
  const bool is_textured = known.preference != 0;
  std::vector<Candidate> candidates;
  for (StrandAxis& axis : possible_axes(hair, patch.view, is_textured, shell)) {
    Candidate found;
    const int of_texture = axis.texture_axis;
    found.evidence = weigh_ends(hair.mesh, patch.view, patch.number, axis, known.seen, around);
    found.evidence.of_shell = shell;
    const float side = of_texture < 0 ? 0.0f : of_texture == 1 ? 1.0f : -1.0f;
    found.score = side * (weights.longer * known.preference + weights.lines * known.seen.lines) +
                  weights.ends * std::min(std::abs(found.evidence.of_axis(weights)), kClearEnds) +
                  (of_texture == common ? weights.common_axis : 0.0f);
    if (shell) {
      found.mirrored =
          mirror_agreement(hair.mesh, patch.view, axis, patch.view, axis, float(around.head.center.x()), reach);
    }
    found.score += weights.mirrored_axis * found.mirrored;
    if (is_textured && of_texture < 0) found.score -= weights.unwrapped;
    found.axis = std::move(axis);
    candidates.push_back(std::move(found));
  }
  return candidates;
}

void take(Candidate& chosen, PatchStrands& strands) {
  strands.axis = std::move(chosen.axis);
  strands.evidence = chosen.evidence;
  strands.mirrored = chosen.mirrored;
}

}  // namespace

void choose_axis(const HairStrips& hair, const Seeking& patch, const Surroundings& around, int common) {
  std::vector<Candidate> all = candidates_of(hair, patch, around, common);
  take(*std::ranges::max_element(all, {}, &Candidate::score), patch.strands);
}

void choose_axes(const HairStrips& hair, const Seeking& one, const Seeking& other, const Surroundings& around,
                 int common) {
  std::vector<Candidate> of_one = candidates_of(hair, one, around, common);
  std::vector<Candidate> of_other = candidates_of(hair, other, around, common);
  const auto middle = float(around.head.center.x()), reach = float(kMirroredTriangle * around.head.radii.mean());
  float best = -std::numeric_limits<float>::infinity(), best_agreement = 0;
  std::pair<Candidate*, Candidate*> chosen;
  for (Candidate& a : of_one) {
    for (Candidate& b : of_other) {
      const float agreement = mirror_agreement(hair.mesh, one.view, a.axis, other.view, b.axis, middle, reach);
      const float score = a.score + b.score + 2 * around.weights.mirrored_axis * std::abs(agreement);
      if (score <= best) continue;
      best = score;
      best_agreement = agreement;
      chosen = {&a, &b};
    }
  }
  take(*chosen.first, one.strands);
  take(*chosen.second, other.strands);
  one.strands.twin = {other.number, best_agreement};
  other.strands.twin = {one.number, best_agreement};
}

}  // namespace coif::cook
